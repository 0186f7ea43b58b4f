// Pictures, footprints and filters for the tests of texture filtering: seeded, the same on every machine.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "filtering/filters/filters.h"
#include "measuring/random_rays.h"

namespace relief::test {

using Picture = std::shared_ptr<const ColorImage>;

inline Picture randomPicture(int width, int height, std::uint64_t seed) {
    Random random(seed);
    auto image = std::make_shared<ColorImage>(width, height);
    for (Color& c : image->pixels()) {
        for (int k = 0; k < 3; ++k) c[k] = static_cast<float>(random.unit());
    }
    return image;
}

inline Picture constantPicture(int width, int height, Color color) {
    return std::make_shared<ColorImage>(width, height, color);
}

// Returns a pixel's Jacobian. major, minor: semi-axes in texels. angle: of the major axis on the texture. pixelAngle:
// rotation in the pixel. mirrored: with a negative determinant.
inline Jacobian jacobian(double major, double minor, double angle, double pixelAngle = 0, bool mirrored = false) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double pc = std::cos(pixelAngle), ps = std::sin(pixelAngle);
    const double m = mirrored ? -minor : minor;
    // [u1 u2] diag(major, m) [v1 v2]^T
    return {major * c * pc + m * s * ps, major * s * pc - m * c * ps, major * c * ps - m * s * pc,
            major * s * ps + m * c * pc};
}

inline Jacobian randomJacobian(Random& random, double largest = 20) {
    const double major = std::exp(random.between(std::log(0.05), std::log(largest)));
    const double minor = major * std::exp(random.between(std::log(0.02), 0));
    return jacobian(major, minor, random.between(0, 6.3), random.between(0, 6.3), random.below(2) == 1);
}

// Returns every texture filter, the elliptical ones with each value of each of their options.
inline std::vector<FilterChoice> allFilters() {
    std::vector<FilterChoice> all;
    for (const FilterDescription& filter : filterList()) {
        if (filter.name == kSupersample) continue;
        all.push_back({filter.name, {}});
        for (const OptionDescription& option : filter.options) {
            for (const std::string& value : option.choices) all.push_back({filter.name, {{option.name, value}}});
        }
        if (!filter.ellipse) continue;
        for (const char* source : {"table", "map"}) {
            all.push_back({filter.name, {{"weights", "uniform"}, {"source", source}, {"resolution", "16"}}});
        }
    }
    return all;
}

// Returns a relief with the picture's sides.
inline HeightField fieldFor(const ColorImage& picture, Address address, float height = 1,
                            Surface surface = Surface::Bilinear) {
    return HeightField(std::make_shared<const FloatImage>(picture.width(), picture.height(), height), surface, address);
}

struct MadeFilter {
    Work work{1};
    MapCache maps;
    std::unique_ptr<const TextureFilter> filter;
    FootprintCounts counts;

    MadeFilter(const FilterChoice& choice, const Picture& picture, const HeightField& field, bool skip = true)
        : filter(makeFilter(choice, {picture, nullptr, field, skip}, maps, work)) {}
    Color at(glm::dvec2 place, const Jacobian& j, FootprintLog* log = nullptr) {
        return at({place, j, {place.x, place.y, 0, 0}, 0}, log);
    }
    Color at(const FilterQuery& query, FootprintLog* log = nullptr) { return filter->color(query, counts, work, log); }
};

}  // namespace relief::test
