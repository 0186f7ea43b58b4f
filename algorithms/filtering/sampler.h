// Colour of the texture at a point: what every filter answers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "images/addressing.h"
#include "images/image.h"

namespace relief {

struct FilterChoice {
    std::string name = "bilinear";
    bool operator==(const FilterChoice&) const = default;
};

struct FilterDescription {
    std::string name;
    std::string help;
};

const std::vector<FilterDescription>& filterList();
// Throws InputError("--filter", ...) with the known names.
const FilterDescription& findFilter(std::string_view name);

// (s, t) in texels of `image`, unwrapped; texel (i, j) centred at (i + 1/2, j + 1/2). Linear values.
Color sampleNearest(const ColorImage& image, double s, double t, Address address);
Color sampleBilinear(const ColorImage& image, double s, double t, Address address);

}  // namespace relief
