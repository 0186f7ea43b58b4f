#include <cmath>

#include "measuring/verify/certificate.h"
#include "measuring/verify/certificate_rays.h"

namespace relief {

namespace {

constexpr int kDigits = 4;

std::string texels(double value) {
    return std::isfinite(value) ? numberText(value, kDigits) + " texels" : "a miss";
}

std::string valuesText(const Certificate& certificate) {
    std::string text = "values: ";
    if (!certificate.bounds) {
        const std::string why = certificate.map.empty()
                                    ? "none checked: the method walks no distance or cone map\n"
                                    : "none checked: " + certificate.map + " is interpolated, no bound holds for it\n";
        return text + why;
    }
    const BoundCheck& bounds = *certificate.bounds;
    text += "all " + std::to_string(bounds.values) + " of the map " + certificate.map +
            " held against an exact bound over the cells around: ";
    return text + (bounds.broken == 0 ? "none breaks it\n" : std::to_string(bounds.broken) + " break it\n");
}

std::string raysText(const Certificate& certificate) {
    std::string text =
        "rays: " + std::to_string(certificate.rays) + " against exact, seed " + std::to_string(certificate.seed) + " (";
    for (const std::string_view family : CertificateRays::families()) text += std::string(family) + ", ";
    text += "in turn; runs up to " + numberText(certificate.longest, kDigits) + " texels): ";
    text += certificate.overshoots == 0 ? std::string("none") : std::to_string(certificate.overshoots);
    text += " past the first hit";
    if (certificate.allowed > 0) text += " by more than " + numberText(certificate.allowed, kDigits) + " texels";
    if (certificate.overshoots > 0) text += ", at worst " + texels(certificate.worst);
    return text + "\n";
}

std::string exampleText(const CounterExample& example, const char* answered) {
    return "  ray: " + numberText(example.ray.s0) + "," + numberText(example.ray.t0) + "," + numberText(example.ray.a) +
           "," + numberText(example.ray.b) + "\n  surface: lambda " + numberText(example.surface) + "; " + answered +
           ": " + (std::isfinite(example.answered) ? "lambda " + numberText(example.answered) : "nothing") + ", " +
           texels(example.texels) + (std::isfinite(example.texels) ? " past it\n" : "\n");
}

}  // namespace

std::string certificateText(const Certificate& certificate, const HeightField& field) {
    std::string text = valuesText(certificate) + raysText(certificate);
    if (certificate.safe()) {
        return text + (certificate.proven() ? "safe: proven by the values, and no ray speaks against it\n"
                                            : "not decided: no ray speaks against it, which is evidence, no proof; "
                                              "answers before the first hit are not looked at\n");
    }
    text += "NOT SAFE\n";
    if (certificate.bounds && certificate.bounds->broken > 0) {
        text += "  first value: " + brokenBoundText(certificate.bounds->first.front(), field) + "\n";
    }
    if (certificate.first) {
        return text + "  first ray: " + certificate.first->where + "\n" + exampleText(*certificate.first, "answered");
    }
    if (certificate.byValue) {
        return text + "  no ray tried comes to ask a broken value where it would lead astray; one that would, there: " +
               certificate.byValue->where + "\n" + exampleText(*certificate.byValue, "the value leads to");
    }
    return text + "  no ray tried is led past the surface: the values are not proven, nor shown to be wrong\n";
}

}  // namespace relief
