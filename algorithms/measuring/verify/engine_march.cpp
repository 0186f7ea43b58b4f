#include "measuring/verify/engine_march.h"

#include <algorithm>
#include <cmath>

#include "relief/describe.h"
#include "relief/messages.h"

namespace relief {

namespace {

constexpr int kMostSteps = 100'000;
constexpr int kHalvings = 40;
constexpr int kDigits = 6;

}  // namespace

std::string_view coneFetchName(ConeFetch fetch) {
    return fetch == ConeFetch::Bilinear ? "bilinear" : "nearest";
}

ConeFetch parseConeFetch(std::string_view text, const std::string& option) {
    for (const ConeFetch fetch : {ConeFetch::Bilinear, ConeFetch::Nearest}) {
        if (text == coneFetchName(fetch)) return fetch;
    }
    throw InputError(option, unknownName({"what", option}, std::string(text), "bilinear, nearest"));
}

double EngineMarch::codeAt(double s, double t) const {
    const auto at = [&](double x, double y) {
        return static_cast<double>(
            codes_(addressIndex(static_cast<std::int64_t>(x), codes_.width(), field_.address()),
                   addressIndex(static_cast<std::int64_t>(y), codes_.height(), field_.address())));
    };
    if (fetch_ == ConeFetch::Nearest) return at(std::floor(s), std::floor(t));
    const double x = std::floor(s - 0.5);
    const double y = std::floor(t - 0.5);
    const double u = s - 0.5 - x;
    const double v = t - 0.5 - y;
    return (1 - v) * ((1 - u) * at(x, y) + u * at(x + 1, y)) + v * ((1 - u) * at(x, y + 1) + u * at(x + 1, y + 1));
}

template <class Step>
EngineMarch::Advance EngineMarch::walk(const SampledSurface& surface, const ViewRay& ray, const Step& step) const {
    const double run = std::hypot(ray.a / coding_.texelsAlong(field_.width(), field_.height(), false),
                                  ray.b / coding_.texelsAlong(field_.width(), field_.height(), true));
    const double length = std::hypot(ray.a, ray.b, field_.slabTexels());
    Advance last;
    for (int n = 0; n < kMostSteps; ++n) {
        const double lambda = last.after;
        if (!surface.inside(lambda)) break;
        const auto [s, t] = surface.placeAt(lambda);
        const double height = surface.heightAt(lambda);
        const double above = 1 - lambda - height;
        if (above <= 0 || lambda >= 1) break;
        const double ratio = coding_.ratio(codeAt(s, t));
        const double free = std::isinf(ratio) ? above : above * ratio / (ratio + run);
        if (free * length < kShortestStep) break;
        last = {lambda, std::min(1.0, lambda + free), height, ratio};
        if (!step(last)) break;
    }
    return last;
}

Hit EngineMarch::trace(const ViewRay& ray) const {
    if (!ray.finite()) return Hit::none(Outcome::Miss);
    const SampledSurface surface(field_, ray);
    const Advance last = walk(surface, ray, [](const Advance&) { return true; });
    if (!surface.inside(last.after)) return Hit::none(Outcome::Miss);
    double lambda = last.after;
    if (relaxed_ && surface.gapAt(lambda) > 0) {
        double above = last.before;
        for (int n = 0; n < kHalvings; ++n) {
            const double middle = 0.5 * (above + lambda);
            (surface.gapAt(middle) < 0 ? above : lambda) = middle;
        }
    }
    return Hit::at(ray, lambda);
}

std::string EngineMarch::stepPast(const ViewRay& ray, double truth) const {
    const SampledSurface surface(field_, ray);
    std::string text;
    int number = 0;
    walk(surface, ray, [&](const Advance& step) {
        ++number;
        if (!(step.after > truth)) return true;
        const auto [s, t] = surface.placeAt(step.before);
        text = "step " + std::to_string(number) + ", from the point " + numberText(s, kDigits) + ", " +
               numberText(t, kDigits) + " (texels): height " + numberText(step.height, kDigits) + ", cone ratio " +
               numberText(step.ratio, kDigits) + ": goes from lambda " + numberText(step.before, kDigits) + " to " +
               numberText(step.after, kDigits);
        return false;
    });
    return text;
}

}  // namespace relief
