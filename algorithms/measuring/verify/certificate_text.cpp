#include <cmath>

#include "measuring/verify/certificate.h"
#include "measuring/verify/certificate_rays.h"

namespace relief {

namespace {

constexpr int kDigits = 4;

std::string valuesText(const Certificate& certificate) {
    std::string text = "values: ";
    if (!certificate.bounds) {
        const std::string why =
            certificate.map.empty()
                ? "none checked, because the method uses no distance or cone map\n"
                : "none checked, because the map " + certificate.map + " is interpolated and has no bounds\n";
        return text + why;
    }
    const BoundCheck& bounds = *certificate.bounds;
    text += "all " + std::to_string(bounds.values) + " of the map " + certificate.map +
            " compared with exact bounds from the surrounding cells; violated bounds: ";
    return text + (bounds.broken == 0 ? "none" : std::to_string(bounds.broken)) + "\n";
}

std::string raysText(const Certificate& certificate) {
    std::string text = "rays: " + std::to_string(certificate.rays) + " compared with exact, seed " +
                       std::to_string(certificate.seed) + " (";
    for (const std::string_view family : CertificateRays::families()) text += std::string(family) + ", ";
    text += "in turn; horizontal lengths up to " + numberText(certificate.longest, kDigits) + " texels); rays that end";
    if (certificate.allowed > 0) text += " more than " + numberText(certificate.allowed, kDigits) + " texels";
    text += " past the first hit: ";
    text += certificate.overshoots == 0 ? std::string("none") : std::to_string(certificate.overshoots);
    if (certificate.overshoots > 0) text += ", at worst " + texelsPastText(certificate.worst);
    return text + "\n";
}

}  // namespace

std::string texelsPastText(double texels) {
    return std::isfinite(texels) ? numberText(texels, kDigits) + " texels" : "a miss";
}

std::string exampleText(const CounterExample& example, const char* answered) {
    return "  ray: " + numberText(example.ray.s0) + "," + numberText(example.ray.t0) + "," + numberText(example.ray.a) +
           "," + numberText(example.ray.b) + "\n  surface: lambda " + numberText(example.surface) + "; " + answered +
           ": " +
           (std::isfinite(example.answered)
                ? "lambda " + numberText(example.answered) + ", " + texelsPastText(example.texels) + " past it\n"
                : "a miss\n");
}

std::string certificateText(const Certificate& certificate, const HeightField& field) {
    std::string text = valuesText(certificate) + raysText(certificate);
    if (certificate.safe()) {
        return text + (certificate.proven()
                           ? "safe: proven by the values; no ray contradicts it\n"
                           : "not decided: no ray contradicts safety, but rays are evidence, not a proof; "
                             "answers before the first hit were not checked\n");
    }
    text += "NOT SAFE\n";
    if (certificate.bounds && certificate.bounds->broken > 0) {
        text += "  first value: " + brokenBoundText(certificate.bounds->first.front(), field) + "\n";
    }
    if (certificate.first) {
        return text + "  first ray: " + certificate.first->where + "\n" + exampleText(*certificate.first, "answer");
    }
    if (certificate.byValue) {
        return text + "  no ray tried was led past the surface by a violating value; this ray would be, at " +
               certificate.byValue->where + "\n" + exampleText(*certificate.byValue, "the value leads to");
    }
    return text + "  no ray tried was led past the surface: the values are neither proven nor refuted\n";
}

}  // namespace relief
