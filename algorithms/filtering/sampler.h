// Colour of the texture at a point: what every filter answers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "images/addressing.h"
#include "images/image.h"

namespace relief {

// What a pixel sees. Box: its square, evenly. Gaussian: a bell of kGaussianSigma round its centre, beyond its square.
enum class PixelModel : std::uint8_t { Box, Gaussian };
// Pixels.
inline constexpr double kGaussianSigma = 0.5;
// Samples along each side of a pixel, at most.
inline constexpr int kMaxSamples = 64;

std::string_view pixelModelName(PixelModel model);
// Throws InputError("--pixel-model", ...) with the known names.
PixelModel parsePixelModel(std::string_view text);

// The filter whose samples are rays: the renderer's, not the texture's.
inline constexpr std::string_view kSupersample = "supersample";

struct FilterChoice {
    std::string name = "bilinear";
    int samples = 8;                          // supersample: along each side of a pixel, 1 to kMaxSamples
    PixelModel pixelModel = PixelModel::Box;  // supersample
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
