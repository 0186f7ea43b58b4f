// Height maps and rays for the tests of the relief methods: seeded, the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "measuring/random_rays.h"
#include "relief/reliefs.h"
#include "relief/tracers.h"

namespace relief::test {

using Heights = std::shared_ptr<const FloatImage>;

inline Heights share(FloatImage image) {
    return std::make_shared<FloatImage>(std::move(image));
}

inline Heights randomHeights(int width, int height, std::uint64_t seed) {
    Random random(seed);
    FloatImage image(width, height);
    for (float& h : image.pixels()) h = static_cast<float>(random.unit());
    return share(std::move(image));
}

inline Heights constantHeights(int width, int height, float value) {
    return share(FloatImage(width, height, value));
}

inline const std::vector<Surface>& allSurfaces() {
    static const std::vector<Surface> all{Surface::Bilinear, Surface::Columns};
    return all;
}
inline const std::vector<Address>& allAddresses() {
    static const std::vector<Address> all{Address::Repeat, Address::Clamp, Address::Border};
    return all;
}

// Returns every listed tracer with its default options, and with options that change its algorithm or its guarantee.
inline std::vector<MethodChoice> allChoices() {
    std::vector<MethodChoice> all;
    for (const MethodDescription& method : tracerList()) {
        if (method.kind != MethodKind::Tracer) continue;
        all.push_back({method.name, {}});
        for (const OptionDescription& option : method.options) {
            if (option.name == "base") all.push_back({method.name, {{"base", "1"}}});
            if (option.name == kLayoutOption) all.push_back({method.name, {{option.name, std::string(kStoredLayout)}}});
            if (option.kind != OptionKind::Method) continue;
            for (const std::string& inner : option.choices) {
                for (const char* level : {"0", "2"}) all.push_back({method.name, {{"inner", inner}, {"level", level}}});
            }
        }
    }
    return all;
}
// Returns the choices with the given guarantee.
inline std::vector<MethodChoice> choicesThatPromise(Guarantee guarantee) {
    MapCache cache;
    Work work(1);
    const HeightField field(constantHeights(4, 4, 0.5F));
    std::vector<MethodChoice> some;
    for (const MethodChoice& choice : allChoices()) {
        if (makeTracer(choice, field, cache, work)->guarantee() == guarantee) some.push_back(choice);
    }
    return some;
}

inline std::string describe(const MethodChoice& choice) {
    std::string text = choice.name;
    for (const auto& [name, value] : choice.options) text += " " + name + "=" + value;
    return text;
}
inline std::string describe(const HeightField& field) {
    return std::to_string(field.width()) + " x " + std::to_string(field.height()) + " " +
           std::string(surfaceName(field.surface())) + " " + std::string(addressName(field.address())) + " depth " +
           numberText(field.reliefDepth());
}
inline std::string describe(const ViewRay& ray) {
    return numberText(ray.s0) + "," + numberText(ray.t0) + "," + numberText(ray.a) + "," + numberText(ray.b);
}

// A ray traced with a complete log.
struct Logged {
    Hit hit;
    std::vector<Step> steps;
};
inline Logged traceLogged(const Tracer& tracer, const ViewRay& ray) {
    Work work(1);
    RayBlock rays(1);
    rays.set(0, ray);
    HitBlock hits;
    StepLog log;
    tracer.trace(rays, hits, log, work);
    return {hits[0], std::move(log.steps)};
}

// Returns true if both hits have the same bits; NaN equals NaN.
inline bool sameBits(const Hit& a, const Hit& b) {
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return a.outcome == b.outcome && same(a.lambda, b.lambda) && same(a.s, b.s) && same(a.t, b.t);
}

}  // namespace relief::test
