#include <array>
#include <cmath>

#include "measuring/verify/stress_part_checks.h"
#include "measuring/verify/stress_parts.h"
#include "rendering/pinhole.h"

namespace relief {

namespace {

constexpr double kRoundoff = 0x1p-53;
// Texel coordinates up to which homography.h avoids overflow.
constexpr double kLargestTexel = 1e9;
// Step of central differences, pixels: a power of two, so that x + h and x - h are exact.
constexpr double kStep = 0x1p-6;
// Differences are trusted only if q changes by at most this share of itself over a step.
constexpr double kStepShare = 0.25;

// Sums of the absolute values of the terms of a homography's numerators, denominator and minors, to which rounding
// errors are relative.
struct Sizes {
    Homography of;

    explicit Sizes(const Homography& map)
        : of{std::abs(map.sx), std::abs(map.sy), std::abs(map.s1), std::abs(map.tx), std::abs(map.ty),
             std::abs(map.t1), std::abs(map.qx), std::abs(map.qy), std::abs(map.q1)} {}
    double s(double x, double y) const { return of.sx * std::abs(x) + of.sy * std::abs(y) + of.s1; }
    double t(double x, double y) const { return of.tx * std::abs(x) + of.ty * std::abs(y) + of.t1; }
    double q(double x, double y) const { return of.qx * std::abs(x) + of.qy * std::abs(y) + of.q1; }
    // For the adjugate: each minor k l - r s becomes |k l| + |r s|.
    Sizes adjugate() const {
        const auto sum = [](double k, double l, double r, double s) { return k * l + r * s; };
        const Homography& m = of;
        return Sizes({sum(m.ty, m.q1, m.t1, m.qy), sum(m.s1, m.qy, m.sy, m.q1), sum(m.sy, m.t1, m.s1, m.ty),
                      sum(m.t1, m.qx, m.tx, m.q1), sum(m.sx, m.q1, m.s1, m.qx), sum(m.s1, m.tx, m.sx, m.t1),
                      sum(m.tx, m.qy, m.ty, m.qx), sum(m.sy, m.qx, m.sx, m.qy), sum(m.sx, m.ty, m.sy, m.tx)});
    }
};

// The texel of a homography at a pixel, with its error bounds.
struct RoundedTexel {
    TexelPoint at;
    double s = 0, t = 0;  // error bounds, texels
    double q = 0;

    RoundedTexel(const Homography& map, double x, double y) : at(map.at(x, y)) {
        const Sizes sizes(map);
        q = kStressSlack * kRoundoff * sizes.q(x, y);
        s = (kStressSlack * kRoundoff * sizes.s(x, y) + std::abs(at.s) * q) / std::abs(at.q);
        t = (kStressSlack * kRoundoff * sizes.t(x, y) + std::abs(at.t) * q) / std::abs(at.q);
    }
    bool trusted() const { return at.q > 0 && q <= kTrustedShare * at.q; }
    bool moderate() const { return std::abs(at.s) <= kLargestTexel && std::abs(at.t) <= kLargestTexel; }
};

std::string mapText(const Homography& map, double x, double y) {
    std::string text = "map";
    for (const double c : map.coefficients<double>()) text += " " + numberText(c);
    return text + " at pixel " + numberText(x) + "," + numberText(y);
}

}  // namespace

std::optional<StressFault> roundTripFault(const Homography& map, const Homography& inverse, double x, double y) {
    const RoundedTexel texel(map, x, y);
    if (!texel.trusted()) return std::nullopt;
    if (!std::isfinite(texel.at.s) || !std::isfinite(texel.at.t)) {
        return StressFault{"not-finite",
                           "s " + numberText(texel.at.s) + ", t " + numberText(texel.at.t) + "; " + mapText(map, x, y)};
    }
    if (!texel.moderate()) return std::nullopt;
    // The adjugate at the texel is (x, y, 1) det / q. The errors of its numerators stem from rounding of its own terms
    // and from the error of the texel.
    const Homography adjugate = map.adjugate();
    const Sizes exact(adjugate);
    const Sizes terms = Sizes(map).adjugate();
    const double s = texel.at.s;
    const double t = texel.at.t;
    const double unit = kStressSlack * kRoundoff;
    const double offX = unit * terms.s(s, t) + exact.of.sx * texel.s + exact.of.sy * texel.t;
    const double offY = unit * terms.t(s, t) + exact.of.tx * texel.s + exact.of.ty * texel.t;
    const double offQ = unit * terms.q(s, t) + exact.of.qx * texel.s + exact.of.qy * texel.t;
    const double q = std::abs(adjugate.denominator(s, t));
    if (!(offQ <= kTrustedShare * q)) return std::nullopt;
    const TexelPoint back = inverse.at(s, t);
    const double allowedX = (offX + std::abs(x) * offQ) / (q - offQ);
    const double allowedY = (offY + std::abs(y) * offQ) / (q - offQ);
    if (back.q > 0 && std::abs(back.s - x) <= allowedX && std::abs(back.t - y) <= allowedY) return std::nullopt;
    return StressFault{"round-trip", "back at " + numberText(back.s) + "," + numberText(back.t) + ", q " +
                                         numberText(back.q) + ", allowed " + numberText(allowedX) + "," +
                                         numberText(allowedY) + "; " + mapText(map, x, y)};
}

std::optional<StressFault> derivativeFault(const Homography& map, const DerivativeTerms<double>& terms, double x,
                                           double y) {
    const RoundedTexel here(map, x, y);
    if (!here.trusted() || !here.moderate()) return std::nullopt;
    const Jacobian direct = directDerivatives(terms, x, y);
    const Sizes minors = Sizes(map).adjugate();
    const double square = here.at.q * here.at.q;
    const double share = 2 * here.q / here.at.q;
    // Checks one derivative. minor: error terms of its minors; dx, dy: the step to either side, pixels.
    const auto fault = [&](const char* name, double value, double minor, bool ofS, double dx,
                           double dy) -> std::optional<StressFault> {
        const double change = (dx * map.qx + dy * map.qy) / here.at.q;
        const RoundedTexel after(map, x + dx, y + dy);
        const RoundedTexel before(map, x - dx, y - dy);
        if (!(std::abs(change) <= kStepShare) || !after.trusted() || !before.trusted()) return std::nullopt;
        const double difference = (ofS ? after.at.s - before.at.s : after.at.t - before.at.t) / (2 * kStep);
        const double off = (ofS ? after.s + before.s : after.t + before.t) / (2 * kStep);
        const double expected = difference * (1 - change * change);
        const double allowed = off + kStressSlack * kRoundoff * minor / square + share * std::abs(value);
        if (std::abs(value - expected) <= allowed) return std::nullopt;
        return StressFault{"derivatives", std::string(name) + " " + numberText(value) + ", by differences " +
                                              numberText(expected) + ", allowed " + numberText(allowed) + "; " +
                                              mapText(map, x, y)};
    };
    // The minors of u_x = (M y + A I - C G) / q^2 are in the second and third row of the adjugate; likewise for the
    // others.
    const double height = std::abs(y);
    const double width = std::abs(x);
    const Homography& m = minors.of;
    if (const auto f = fault("u_x", direct.ux, m.qy * height + m.ty, true, kStep, 0)) return f;
    if (const auto f = fault("v_x", direct.vx, m.qx * height + m.tx, false, kStep, 0)) return f;
    if (const auto f = fault("u_y", direct.uy, m.qy * width + m.sy, true, 0, kStep)) return f;
    return fault("v_y", direct.vy, m.qx * width + m.sx, false, 0, kStep);
}

namespace stress_detail {

namespace {

constexpr int kPixels = 12;  // pixels tested per homography
constexpr int kScreenWidth = 800;
constexpr int kScreenHeight = 600;

void checkMap(const CaseRun& run, const StressCameraFamily& family, const Homography& map, Random& random) {
    const auto report = [&](const std::optional<StressFault>& fault) {
        if (!fault) return;
        run.result.report({*fault, StressPart::Homographies, {"homography", {}}, family.name, ViewRay{}, nullptr});
    };
    std::optional<Homography> inverse;
    try {
        inverse = run.subjects.inverse(map);
    } catch (const InputError&) {
        ++run.result.parts["homographies"].refused;
    }
    const auto terms = run.subjects.derivatives(map);
    for (int n = 0; n < kPixels; ++n) {
        const double x = random.below(kScreenWidth) + 0.5;
        const double y = random.below(kScreenHeight) + 0.5;
        if (inverse) report(roundTripFault(map, *inverse, x, y));
        report(derivativeFault(map, terms, x, y));
    }
}

}  // namespace

void stressHomographies(const CaseRun& run) {
    const HeightField& field = run.of.field;
    const auto& families = run.subjects.cameras;
    for (std::size_t f = 0; f < families.size(); ++f) {
        run.work.throwIfStopped();
        Random random = partRandom(run, StressPart::Homographies, run.of.number * families.size() + f);
        const auto scene = static_cast<SceneKind>(random.below(3));
        const Camera camera = families[f].make(scene, random);
        for (const TexturedQuad& quad : makeScene(scene, field.width(), field.height())) {
            StressPartCoverage& coverage = run.result.parts["homographies"];
            ++coverage.tried[std::string(families[f].name)];
            try {
                const PinholeCamera pinhole = pinholeCamera(camera, kScreenWidth, kScreenHeight);
                checkMap(run, families[f], fromCameraAndPlane(pinhole, quad.plane), random);
            } catch (const InputError&) {
                ++coverage.refused;
            }
        }
    }
}

}  // namespace stress_detail

}  // namespace relief
