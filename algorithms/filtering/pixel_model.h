// What a pixel of the display is, seen from the texture: how much light that falls at (dx, dy) from the pixel's centre
// counts in each colour channel. References are averaged with it, and filters may weigh texels by it.
//
// Frame and units: dx right, dy down, pixels; the pixel's square is [-1/2, 1/2]^2. Densities are not scaled: whoever
// sums divides by the sum of weights. Every model is a product of one factor in dx and one in dy, channel by channel.
//
// box: the square, evenly. gaussian: a bell of kGaussianSigma. lcd: three stripes of a third of the square each, R, G
// and B from the left. crt: three round Gaussian spots of kCrtSigma in a triangle, R and G above, B below.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace relief {

enum class PixelModel : std::uint8_t { Box, Gaussian, Lcd, Crt };
inline constexpr std::array<std::string_view, 4> kPixelModelNames{"box", "gaussian", "lcd", "crt"};

// Pixels.
inline constexpr double kGaussianSigma = 0.5;
inline constexpr double kCrtSigma = 0.25;
// From the pixel's centre to each spot's: an equilateral triangle of side 1/2.
inline constexpr double kCrtCircle = 0.28867513459481287;
// Nothing further from the centre than this counts: five sigma for the bells (4e-6 of the peak).
inline constexpr double kPixelReach = 2.5;

std::string_view pixelModelName(PixelModel model);
// Throws InputError("--pixel-model", ...) with the known names.
PixelModel parsePixelModel(std::string_view text);

// Channels 0, 1, 2: R, G, B.
double pixelFactorAcross(PixelModel model, int channel, double dx);
double pixelFactorDown(PixelModel model, int channel, double dy);
// Samples along each side of a pixel without which some channel would see none.
constexpr int fewestSamples(PixelModel model) {
    return model == PixelModel::Lcd ? 3 : 1;
}
// Whether all channels see alike.
constexpr bool sameInAllChannels(PixelModel model) {
    return model == PixelModel::Box || model == PixelModel::Gaussian;
}

}  // namespace relief
