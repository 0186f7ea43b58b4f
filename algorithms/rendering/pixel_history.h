// Why a pixel has its colour: the numbers of its way through the stages of a frame - coverage, ray, hit, filter, light
// - which multiply out to the pixel that was drawn.
//
//     pixel = sum over rays of share * lit,    lit = filtered * amount (a hit), sky (nothing hit), black (step limit)
//     filtered = sum over texels of weight * colour,
//     amount = intensity * (ambient + (1 - ambient) * max(0, n . l)); in shadow only the ambient part.
//
// One ray with share 1 for all filters but `supersample`, which traces, filters and lights N x N rays for each pixel.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "rendering/frame.h"

namespace relief {

// Largest difference between the product and the drawn colour, per channel, for texels of at most 1 and light of at
// most 1; it grows in proportion with larger ones. Filters sum in float, and round weights to 16 bits: half a step, and
// sums in float, are 1.2e-5 (FilterLaws.weightsOfTheLogMakeTheColour).
inline constexpr double kHistoryBound = 2e-5;

// A texel of the colour picture, or of the heights in grey; weight: its share of the filtered colour in each channel.
struct HistoryTexel {
    int level = 0;
    int i = 0;
    int j = 0;
    glm::dvec3 weight{0};
    Color color{0};  // linear
};

struct HistoryRay {
    glm::dvec2 sample{0.5, 0.5};  // where the ray passes through the square of its pixel
    glm::ivec2 pixel{0};          // the ray's own pixel: with gaussian and crt also one nearby
    glm::dvec3 share{1};          // of the pixel's colour, per channel
    // Coverage: the polygon that the pixel shows; none: sky, and the members below are unset.
    std::optional<int> polygon;
    ViewRay ray;
    double entryDepth = 0;  // of the point where the ray enters the slab, from the eye along its direction, world units
    Hit hit;
    HitBy by = HitBy::Traced;
    // Filter, of a hit. height: of the relief at the hit, where the colour is a grey of the height; texels is then
    // empty.
    std::optional<double> height;
    std::vector<HistoryTexel> texels;
    std::int64_t hidden = 0;  // texels under the filter that the relief hides; they have no weight
    bool allHidden = false;   // no texel was visible: the colour is that at the hit
    Color filtered{0};        // as drawn, linear, without light
    glm::dvec3 sum{0};        // of the texels: weight * colour
    // Light, of a hit.
    glm::dvec3 normal{0};  // world space, unit length
    double cosine = 0;     // between the normal and the light; negative: turned away
    bool shadowed = false;
    double amount = 0;
    Color lit{0};           // as drawn
    glm::dvec3 product{0};  // sum * amount, the sky, or black
};

struct PixelHistory {
    int x = 0;
    int y = 0;
    std::string method;  // that found the hits; with `cone` in place of another exact method, as in Frame::tracedBy
    std::vector<HistoryRay> rays;
    Color drawn{0};         // of the frame
    glm::dvec3 product{0};  // sum of share * product
    double bound = kHistoryBound;
    std::array<std::uint8_t, 3> srgb{};  // 8-bit codes of the drawn colour

    // Largest difference between the product and the drawn colour in a channel.
    double difference() const;
    bool multipliesOut() const { return difference() <= bound; }
};

// Draws the rows of the pixel again, with the same bits as in the whole picture, and explains the pixel. Throws
// InputError if it lies outside the picture, what FrameRenderer::picture() throws, and Cancelled. Cost: a few rows of
// the frame; with supersampling of every pass.
PixelHistory pixelHistory(const FrameRequest& request, int x, int y, const std::shared_ptr<MapCache>& maps, Work& work);

}  // namespace relief
