#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "measuring/verify/stress_cases.h"

namespace relief {

namespace {

constexpr double kOrdinaryRun = 2000;  // texels

double zeroOfEitherSign(Random& random) {
    return random.below(2) == 0 ? 0.0 : -0.0;
}
double eitherSign(Random& random, double value) {
    return random.below(2) == 0 ? value : -value;
}
// Returns a number whose logarithm is uniform between those of low and high.
double logarithmic(Random& random, double low, double high) {
    return low * std::pow(high / low, random.unit());
}
double run(Random& random) {
    return eitherSign(random, logarithmic(random, 0.1, kOrdinaryRun));
}
// Returns a position on the lines of cells and columns: whole and half texels.
double onLine(Random& random, int size) {
    return random.below(2 * size + 1) / 2.0;
}
ViewRay entry(const HeightField& field, Random& random) {
    return {random.between(0, field.width()), random.between(0, field.height()), 0, 0};
}
ViewRay turned(ViewRay ray, double length, double azimuth) {
    ray.a = length * std::cos(azimuth);
    ray.b = length * std::sin(azimuth);
    return ray;
}
double azimuth(Random& random) {
    return random.between(0, 2 * std::numbers::pi);
}
double neighbour(Random& random, double value) {
    const int which = random.below(3);
    if (which == 0) return value;
    return std::nextafter(value, which == 1 ? -1e9 : 1e9);
}

ViewRay ordinary(const HeightField& field, Random& random) {
    return randomRay(random, field, 1);
}

ViewRay grazing(const HeightField& field, Random& random) {
    const ViewRay ray = entry(field, random);
    return turned(ray, logarithmic(random, 10, kMaxRun / 8), azimuth(random));
}

// The most grazing rays for which tracers are exact, and their neighbours on both sides of the limit.
ViewRay atLimit(const HeightField& field, Random& random) {
    ViewRay ray = entry(field, random);
    const int which = random.below(3);
    if (which == 2) return turned(ray, neighbour(random, kMaxRun), azimuth(random));
    const double length = eitherSign(random, neighbour(random, kMaxRun));
    ray.a = which == 0 ? length : zeroOfEitherSign(random);
    ray.b = which == 0 ? zeroOfEitherSign(random) : length;
    return ray;
}

ViewRay beyond(const HeightField& field, Random& random) {
    const ViewRay ray = entry(field, random);
    const double length = random.below(3) == 0 ? std::nextafter(kMaxRun, 1e9) * (1 + 1e-9) : kMaxRun;
    return turned(ray, length * logarithmic(random, 1.0000001, 1e9), azimuth(random));
}

ViewRay vertical(const HeightField& field, Random& random) {
    ViewRay ray = entry(field, random);
    if (random.below(2) == 0) ray.s0 = neighbour(random, onLine(random, field.width()));
    if (random.below(2) == 0) ray.t0 = neighbour(random, onLine(random, field.height()));
    ray.a = zeroOfEitherSign(random);
    ray.b = zeroOfEitherSign(random);
    return ray;
}

ViewRay axisParallel(const HeightField& field, Random& random) {
    ViewRay ray = entry(field, random);
    const bool across = random.below(2) == 0;
    ray.a = across ? run(random) : zeroOfEitherSign(random);
    ray.b = across ? zeroOfEitherSign(random) : run(random);
    return ray;
}

// Along a line between cells, or off by one rounding step.
ViewRay alongBorders(const HeightField& field, Random& random) {
    ViewRay ray = axisParallel(field, random);
    if (ray.a == 0) {
        ray.s0 = neighbour(random, onLine(random, field.width()));
    } else {
        ray.t0 = neighbour(random, onLine(random, field.height()));
    }
    return ray;
}

// Starts on a corner of cells or columns and passes through others.
ViewRay throughCorners(const HeightField& field, Random& random) {
    ViewRay ray{onLine(random, field.width()), onLine(random, field.height()), 0, 0};
    const double unit = random.below(2) == 0 ? 1 << random.below(10) : run(random);
    ray.a = unit * random.below(4) * (random.below(2) == 0 ? 1 : -1);
    ray.b = unit * random.below(4) * (random.below(2) == 0 ? 1 : -1);
    return ray;
}

ViewRay huge(const HeightField& field, Random& random) {
    constexpr std::array<double, 4> kLengths{1e300, 1e200, 1e155, 1e18};
    ViewRay ray = entry(field, random);
    const double length = kLengths[static_cast<std::size_t>(random.below(4))];
    const int which = random.below(3);
    ray.a = which == 1 ? zeroOfEitherSign(random) : eitherSign(random, length);
    ray.b = which == 0 ? eitherSign(random, random.unit()) : eitherSign(random, length * random.unit());
    return ray;
}

ViewRay denormalRun(const HeightField& field, Random& random) {
    constexpr std::array<double, 7> kLengths{1e-310, 5e-324, 1e-300, 2.3e-308, 1e-200, 1e-17, 1e-9};
    ViewRay ray = entry(field, random);
    if (random.below(2) == 0) ray.s0 = onLine(random, field.width());
    if (random.below(2) == 0) ray.t0 = onLine(random, field.height());
    const double length = kLengths[static_cast<std::size_t>(random.below(7))];
    ray.a = eitherSign(random, length);
    ray.b = random.below(2) == 0 ? eitherSign(random, length) : run(random);
    return ray;
}

// A million texels, or a million periods, away; on whole texels or between them.
ViewRay farStart(const HeightField& field, Random& random) {
    const ViewRay start = entry(field, random);
    const bool whole = random.below(2) == 0;
    const double texels = random.below(2) == 0 ? 1e6 : 1e6 * field.width();
    ViewRay ray = turned(start, logarithmic(random, 0.1, kOrdinaryRun), azimuth(random));
    ray.s0 = eitherSign(random, texels) + (whole ? std::floor(start.s0) : start.s0);
    ray.t0 = eitherSign(random, 1e6) + (whole ? std::floor(start.t0) : start.t0);
    return ray;
}

// Returns a ray that passes (s, t) at the height of texel (i, j).
ViewRay through(const HeightField& field, Random& random, int i, int j, double s, double t) {
    ViewRay ray = turned({}, logarithmic(random, 0.1, kOrdinaryRun), azimuth(random));
    if (random.below(3) == 0) (random.below(2) == 0 ? ray.a : ray.b) = zeroOfEitherSign(random);
    const double lambda = 1 - static_cast<double>(field.texel(i, j));
    ray.s0 = s - lambda * ray.a;
    ray.t0 = t - lambda * ray.b;
    return ray;
}

// Meets the edge or corner of a column exactly at the height of its top.
ViewRay plateauHeight(const HeightField& field, Random& random) {
    const int i = random.below(field.width());
    const int j = random.below(field.height());
    const double s = i + (random.below(2) == 0 ? random.below(2) : random.unit());
    const double t = j + (random.below(2) == 0 ? random.below(2) : random.unit());
    return through(field, random, i, j, s, t);
}

// Meets a node of the bilinear surface exactly.
ViewRay throughNodes(const HeightField& field, Random& random) {
    const int i = random.below(field.width());
    const int j = random.below(field.height());
    return through(field, random, i, j, i + 0.5, j + 0.5);
}

// Enters on the picture's edge, or one rounding step inside or outside it.
ViewRay onRim(const HeightField& field, Random& random) {
    ViewRay ray = entry(field, random);
    const int which = random.below(3);
    if (which != 1) ray.s0 = neighbour(random, random.below(2) * field.width());
    if (which != 0) ray.t0 = neighbour(random, random.below(2) * field.height());
    ray.a = random.below(4) == 0 ? zeroOfEitherSign(random) : run(random);
    ray.b = random.below(4) == 0 ? zeroOfEitherSign(random) : run(random);
    return ray;
}

}  // namespace

const std::vector<StressRayFamily>& stressRayFamilies() {
    static const std::vector<StressRayFamily> families{
        {"ordinary", 24, 1, ordinary},
        {"grazing", 3, 1, grazing},
        {"at-limit", 1, 3, atLimit},
        {"beyond", 1, 2, beyond},
        {"vertical", 24, 1, vertical},
        {"axis-parallel", 24, 1, axisParallel},
        {"along-borders", 24, 1, alongBorders},
        {"through-corners", 24, 1, throughCorners},
        {"huge", 1, 2, huge},
        {"denormal-run", 16, 1, denormalRun},
        {"far-start", 24, 1, farStart},
        {"plateau-height", 24, 1, plateauHeight},
        {"through-nodes", 24, 1, throughNodes},
        {"on-rim", 24, 1, onRim},
    };
    return families;
}

}  // namespace relief
