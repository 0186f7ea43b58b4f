#include "specimens.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "images/pyramid.h"
#include "measuring/random_rays.h"
#include "relief/files.h"
#include "relief/reliefs.h"
#include "relief/tracers.h"

namespace relief::test {

namespace {

void turn(Patient& patient, double degrees) {
    const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
    for (std::size_t r = 0; r < patient.rays.size(); ++r) {
        const double a = patient.rays.a[r], b = patient.rays.b[r];
        patient.rays.a[r] = c * a - s * b;
        patient.rays.b[r] = s * a + c * b;
    }
}

void overHeights(Patient& patient, const std::function<float(float)>& change) {
    for (float& height : patient.heights.pixels()) height = std::clamp(change(height), 0.0F, 1.0F);
}

// Replaces the map by a level of its mean pyramid, and rays and answers by those in its texels.
void coarsen(Patient& patient, int level) {
    Work work(1);
    const Pyramid means(PyramidKind::Mean, patient.heights, work);
    patient.heights = means.level(level);
    const double scale = std::exp2(-level);
    for (auto* column : {&patient.rays.s0, &patient.rays.t0, &patient.rays.a, &patient.rays.b}) {
        for (double& value : *column) value *= scale;
    }
}

// Adds a change of the answers after those that there are.
void afterwards(Patient& patient, std::function<void(HitBlock&, const RayBlock&)> change) {
    patient.answer = [before = patient.answer, change = std::move(change)](HitBlock& hits, const RayBlock& rays) {
        if (before) before(hits, rays);
        change(hits, rays);
    };
}

void layers(Patient& patient, const std::string& name, int count) {
    patient.method = {name, {{"layers", std::to_string(count)}}};
}

std::vector<Specimen> made() {
    std::vector<Specimen> all;
    const auto add = [&](std::string name, std::function<void(Patient&)> infect, std::set<std::string> company = {}) {
        all.push_back({std::move(name), std::move(infect), std::move(company)});
    };
    add("missed-spike", [](Patient& p) { p.method = {"layers-bisection", {{"layers", "10"}, {"bisections", "20"}}}; });
    add("stair-steps", [](Patient& p) { layers(p, "layers", 12); }, {"missed-spike"});
    add("no-refinement", [](Patient& p) { layers(p, "layers", 200); }, {"missed-spike"});
    add("unsafe-map", [](Patient& p) { p.method = {"cone-dummer", {}}; }, {"step-limit", "missed-spike"});
    add("swapped-axes", [](Patient& p) { std::swap(p.rays.a, p.rays.b); });
    add("direction-sign", [](Patient& p) {
        for (double& a : p.rays.a) a = -a;
    });
    add("inverted-heights", [](Patient& p) { overHeights(p, [](float h) { return 1 - h; }); });
    add("zero-level", [](Patient& p) { overHeights(p, [](float h) { return h - 0.25F; }); });
    add("relief-depth", [](Patient& p) {
        for (double& a : p.rays.a) a *= 1.6;
        for (double& b : p.rays.b) b *= 1.6;
    });
    add("half-texel-shift", [](Patient& p) {
        for (double& s : p.rays.s0) s += 0.5;
        for (double& t : p.rays.t0) t += 0.5;
    });
    add("y-flipped", [](Patient& p) {
        for (int y = 0; y < p.heights.height() / 2; ++y) {
            for (int x = 0; x < p.heights.width(); ++x) {
                std::swap(p.heights(x, y), p.heights(x, p.heights.height() - 1 - y));
            }
        }
    });
    add("wrap-against-clamp", [](Patient& p) { p.address = Address::Clamp; });
    add("8-bit-terraces", [](Patient& p) { overHeights(p, [](float h) { return std::round(h * 255) / 255; }); });
    add("mip-level", [](Patient& p) { coarsen(p, 2); });
    add("offset-limiting", [](Patient& p) { p.method = {"offset-limited", {}}; }, {"no-search"});
    add("tangent-frame", [](Patient& p) { turn(p, 30); });
    add("step-limit", [](Patient& p) {
        afterwards(p, [](HitBlock& hits, const RayBlock& rays) {
            // A loop of 40 steps of half a texel.
            for (std::size_t r = 0; r < hits.size(); ++r) {
                const double run = std::hypot(rays.a[r], rays.b[r]);
                const double reach = 20 / std::max(run, 1e-9);
                hits.steps[r] = static_cast<std::uint32_t>(std::min(40.0, std::ceil(hits.lambda[r] * run * 2)));
                if (hits.lambda[r] > reach) hits.set(r, Hit::at(rays[r], reach));
            }
        });
    });
    add("self-shadow-bias", [](Patient& p) {
        afterwards(p, [](HitBlock& hits, const RayBlock& rays) {
            for (std::size_t r = 0; r < hits.size(); ++r) {
                if (hits.outcome[r] == Outcome::Hit)
                    hits.set(r, Hit::at(rays[r], std::max(0.0, hits.lambda[r] - 0.01)));
            }
        });
    });
    add("height-curve", [](Patient& p) { overHeights(p, [](float h) { return linearFromSrgb(h); }); });
    add("no-search", [](Patient& p) { p.method = {"offset", {}}; });
    return all;
}

}  // namespace

const std::vector<Specimen>& specimens() {
    static const std::vector<Specimen> all = made();
    return all;
}

const Specimen& specimen(const std::string& name) {
    for (const Specimen& one : specimens()) {
        if (one.name == name) return one;
    }
    throw std::logic_error("no specimen " + name);
}

HeightField specimenField(const std::string& relief) {
    return {std::make_shared<const FloatImage>(makeRelief(relief, 128, 128, 3)), Surface::Bilinear, Address::Repeat,
            0.15};
}

RayBlock specimenRays(const HeightField& field, std::size_t count) {
    return randomRays(11, field, count, 12);
}

TracerRecord record(const std::vector<Specimen>& faults, const HeightField& field, const RayBlock& rays) {
    Patient patient{field.heights(), rays, field.address(), {"exact", {}}};
    for (const Specimen& fault : faults) fault.infect(patient);
    Work work(1);
    MapCache maps;
    const HeightField read(std::make_shared<const FloatImage>(patient.heights), field.surface(), patient.address,
                           field.reliefDepth());
    TracerRecord out;
    out.rays = rays;
    BlockCounts counts;
    makeTracer(patient.method, read, maps, work)->trace(patient.rays, out.hits, counts, work);
    if (patient.answer) patient.answer(out.hits, patient.rays);
    // Half of the tracers of others write only lambda.
    for (auto* column : {&out.hits.s, &out.hits.t}) {
        std::fill(column->begin(), column->end(), std::numeric_limits<double>::quiet_NaN());
    }
    std::fill(out.hits.steps.begin(), out.hits.steps.end(), 0U);
    return out;
}

}  // namespace relief::test
