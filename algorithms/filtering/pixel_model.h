// Models of a display pixel: the weight, per colour channel, of light that falls at (dx, dy) from the pixel's centre.
// References are averaged with it, and filters may weight texels by it.
//
// Frame and units: dx right, dy down, in pixels; the pixel's square is [-1/2, 1/2]^2. Densities are not normalised:
// divide a weighted sum by the sum of weights. Every model is a product of one factor in dx and one in dy, per channel.
//
// box: uniform on the square. gaussian: a Gaussian of kGaussianSigma. lcd: three stripes of a third of the square each,
// R, G and B from the left. crt: three round Gaussian spots of kCrtSigma in a triangle, R and G above, B below.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace relief {

enum class PixelModel : std::uint8_t { Box, Gaussian, Lcd, Crt };
inline constexpr std::array<std::string_view, 4> kPixelModelNames{"box", "gaussian", "lcd", "crt"};

// Standard deviations in pixels.
inline constexpr double kGaussianSigma = 0.5;
inline constexpr double kCrtSigma = 0.25;
// Distance, in pixels, of each spot from the pixel's centre: an equilateral triangle of side 1/2.
inline constexpr double kCrtCircle = 0.28867513459481287;
// Weights are 0 farther from the centre than this, in pixels: five sigma for the Gaussians (4e-6 of the peak).
inline constexpr double kPixelReach = 2.5;

std::string_view pixelModelName(PixelModel model);
// Throws InputError("--pixel-model", ...) with a list of the known names.
PixelModel parsePixelModel(std::string_view text);

// The two factors of the density. channel: 0, 1, 2 for R, G, B.
double pixelFactorAcross(PixelModel model, int channel, double dx);
double pixelFactorDown(PixelModel model, int channel, double dy);
// The fewest samples along each side of a pixel for which every channel has a weight above 0.
constexpr int fewestSamples(PixelModel model) {
    return model == PixelModel::Lcd ? 3 : 1;
}
// Returns true if the weights are the same in all channels.
constexpr bool sameInAllChannels(PixelModel model) {
    return model == PixelModel::Box || model == PixelModel::Gaussian;
}

}  // namespace relief
