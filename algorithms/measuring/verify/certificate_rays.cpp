#include "measuring/verify/certificate_rays.h"

#include <array>
#include <cmath>
#include <numbers>

namespace relief {

namespace {

// Offsets of rays from a line, texels, and from an edge, heights.
constexpr std::array<double, 4> kBeside{0, 1e-9, 1e-3, 0.1};

double beside(Random& random) {
    const double off = kBeside[static_cast<std::size_t>(random.below(static_cast<int>(kBeside.size())))];
    return random.below(2) == 0 ? off : -off;
}

}  // namespace

const std::vector<std::string_view>& CertificateRays::families() {
    static const std::vector<std::string_view> names{"any direction", "grazing", "along walls", "into walls",
                                                     "at edges"};
    return names;
}

ViewRay CertificateRays::ray(Random& random, std::size_t family) const {
    // Near the edge of a picture that does not repeat, some rays would enter outside it.
    constexpr int kTries = 8;
    for (int n = 0; n < kTries; ++n) {
        std::optional<ViewRay> made;
        switch (family) {
            case 1:
                return grazing(random);
            case 2:
                made = alongWall(random);
                break;
            case 3:
                made = intoWall(random);
                break;
            case 4:
                made = atEdge(random);
                break;
            default:
                return anyDirection(random);
        }
        if (made) return *made;
    }
    return anyDirection(random);
}

RayBlock CertificateRays::block(std::uint64_t seed, std::size_t count) const {
    Random random(seed);
    RayBlock rays(count);
    for (std::size_t r = 0; r < count; ++r) rays.set(r, ray(random, r % families().size()));
    return rays;
}

std::optional<ViewRay> CertificateRays::through(double s, double t, double z, double a, double b) const {
    ViewRay ray{s - (1 - z) * a, t - (1 - z) * b, a, b};
    if (field_.address() == Address::Repeat) {
        ray.s0 -= std::floor(ray.s0 / field_.width()) * field_.width();
        ray.t0 -= std::floor(ray.t0 / field_.height()) * field_.height();
        return ray;
    }
    const bool enters = ray.s0 >= 0 && ray.s0 <= field_.width() && ray.t0 >= 0 && ray.t0 <= field_.height();
    return enters ? std::optional(ray) : std::nullopt;
}

CertificateRays::Wall CertificateRays::wall(Random& random) const {
    constexpr int kCandidates = 4;  // number of random walls of which the steepest is taken
    constexpr std::array<std::array<int, 2>, 4> kSides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    Wall best{0, 0, 1, 0, 0, 0};
    for (int n = 0; n < kCandidates; ++n) {
        const int i = random.below(field_.width());
        const int j = random.below(field_.height());
        const auto& [dx, dy] = kSides[static_cast<std::size_t>(random.below(4))];
        const auto here = static_cast<double>(field_.texel(i, j));
        const auto there = static_cast<double>(field_.texel(i + dx, j + dy));
        if (n > 0 && std::abs(here - there) <= best.high - best.low) continue;
        const bool up = here >= there;
        best = {up ? i : i + dx, up ? j : j + dy,       up ? dx : -dx,
                up ? dy : -dy,   std::min(here, there), std::max(here, there)};
    }
    return best;
}

double CertificateRays::run(Random& random) const {
    constexpr double kShortest = 0.1;
    return longest_ <= kShortest ? longest_ * random.unit()
                                 : kShortest * std::pow(longest_ / kShortest, random.unit()) * (1 - 1e-12);
}

ViewRay CertificateRays::anyDirection(Random& random) const {
    const double lowest = std::atan(field_.slabTexels() / longest_) * 180 / std::numbers::pi;
    ViewRay ray = randomRay(random, field_, lowest);
    const double length = std::hypot(ray.a, ray.b);
    const double shorter = length > longest_ ? longest_ / length * (1 - 1e-12) : 1;
    ray.a *= shorter;
    ray.b *= shorter;
    return ray;
}

ViewRay CertificateRays::grazing(Random& random) const {
    const double azimuth = random.between(0, 2 * std::numbers::pi);
    const double length = longest_ * random.between(0.5, 1 - 1e-12);
    return {random.between(0, field_.width()), random.between(0, field_.height()), length * std::cos(azimuth),
            length * std::sin(azimuth)};
}

// Returns a ray next to the wall's face, nearly parallel to it, and below its top.
std::optional<ViewRay> CertificateRays::alongWall(Random& random) const {
    const Wall w = wall(random);
    const double off = 0.5 + beside(random);
    const double place = random.between(-0.5, 0.5);
    const double s = w.i + 0.5 + off * w.dx + place * w.dy;
    const double t = w.j + 0.5 + off * w.dy + place * w.dx;
    const double length = run(random) * (random.below(2) == 0 ? 1 : -1);
    const double tilt = length * beside(random);
    const double z = random.between(w.low, w.high);
    // so that the run is at most `length` even with the largest tilt
    const double shorter = 1 / std::sqrt(1 + 0.1 * 0.1);
    return through(s, t, z, (tilt * w.dx + length * w.dy) * shorter, (tilt * w.dy + length * w.dx) * shorter);
}

// Returns a ray from the low side onto the wall's face.
std::optional<ViewRay> CertificateRays::intoWall(Random& random) const {
    const Wall w = wall(random);
    const double off = random.between(0, 1);
    const double place = random.between(-0.5, 0.5);
    const double s = w.i + 0.5 + off * w.dx + place * w.dy;
    const double t = w.j + 0.5 + off * w.dy + place * w.dx;
    const double length = run(random);
    const double angle = random.between(-0.45, 0.45) * std::numbers::pi;
    const double towards = -length * std::cos(angle);
    const double sideways = length * std::sin(angle);
    const double z = w.high - off * (w.high - w.low);
    return through(s, t, z, towards * w.dx + sideways * w.dy, towards * w.dy + sideways * w.dx);
}

// Returns a ray just above or below the upper edge of a wall.
std::optional<ViewRay> CertificateRays::atEdge(Random& random) const {
    const Wall w = wall(random);
    const bool columns = field_.surface() == Surface::Columns;
    const double off = columns ? 0.5 : 0.0;
    const double place = columns ? random.between(-0.5, 0.5) : 0.0;
    const double s = w.i + 0.5 + off * w.dx + place * w.dy + beside(random);
    const double t = w.j + 0.5 + off * w.dy + place * w.dx + beside(random);
    const double z = std::clamp(w.high + beside(random), 0.0, 1.0);
    const double azimuth = random.between(0, 2 * std::numbers::pi);
    const double length = run(random);
    return through(s, t, z, length * std::cos(azimuth), length * std::sin(azimuth));
}

}  // namespace relief
