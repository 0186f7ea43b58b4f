// What the filter did for the chosen pixel, and what it read from, ready to be drawn.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filtering/footprint_log.h"
#include "mapping/rows/coefficients.h"
#include "rendering/frame.h"

namespace reliefui {

// The colours that a frame's filter reads, and their mean pyramid where a level above 0 is asked for. Kept from frame
// to frame.
class FilteredPicture {
  public:
    // Heights without colours that would take too much as a picture.
    static bool tooLarge(const relief::FrameRequest& request);
    // Not for such.
    void use(const relief::FrameRequest& request);
    const std::shared_ptr<const relief::ColorImage>& picture() const { return picture_; }
    // Throws Cancelled.
    std::shared_ptr<const relief::ColorImage> level(int l, relief::Work& work);

  private:
    std::shared_ptr<const relief::ColorImage> picture_;
    std::shared_ptr<const relief::FloatImage> greyOf_;  // null: the picture is a given one
    std::shared_ptr<const relief::ColorLevels> levels_;
};

// A pixel's circle on the texture: of this radius in pixels, centre and Jacobian in texels of level 0.
struct PixelCircle {
    relief::Jacobian jacobian;
    glm::dvec2 centre{0};
    double radius = 1;
    bool beside = false;  // of a neighbour that shares a side, not only a corner
};

// Where one of the pixel's rays met the relief, texels of the footprint's level, and its part of the pixel.
struct RayHit {
    glm::dvec2 at{0};
    double share = 0;
};

struct PixelFootprint {
    relief::FilterChoice filter;
    // Texels: those that the filter logged, those that readings at points take otherwise. Each once with its whole
    // weight, at its centre, and once more with the weight that is hidden.
    relief::FootprintLog log;
    relief::FootprintCounts counts;
    bool listed = true;  // false: there were too many texels to write each of them down
    double weightSum = 0;
    double greatest = 0;                  // weight of all that count; of the hidden where nothing else is listed
    relief::Jacobian seen;                // of the pixel as the filter saw it, texels of the level
    relief::PixelCoefficients behind;     // the numbers behind the pixel, of the top plane, texels of the height map
    bool bounded = true;                  // the pixel's circle is finite
    std::vector<RayHit> rays;             // of supersample: those that met the relief
    std::vector<PixelCircle> neighbours;  // of the eight pixels around
    std::shared_ptr<const relief::ColorImage> colors;    // of the level, linear
    relief::LevelAxis across, down;                      // of the level
    glm::dvec2 perHeight{1};                             // texels of the level a texel of the height map
    std::optional<relief::EllipticalSettings> weighing;  // of filters that weigh the texels of an ellipse

    int level() const { return log.footprint.level; }
    glm::dvec2 centre() const { return log.footprint.centre; }
    // All channels' mean.
    static double weightOf(const relief::FootprintTexel& texel) { return meanOf(texel.weight); }
    static double meanOf(const relief::Color& c) { return static_cast<double>(c.r + c.g + c.b) / 3; }
    // Its side in texels of the footprint's level.
    double sideOf(const relief::FootprintTexel& texel) const {
        return std::ldexp(1.0, texel.level - log.footprint.level);
    }
};

// Of pixel (x, y) of the frame; null where it meets no relief, and for heights
// that are too large to be looked at as a picture. scale: pixels of the frame per pixel of the picture that
// is shown (below 1 for coarse frames, whose footprints are not told of). tracer: of the frame. Throws Cancelled.
std::shared_ptr<const PixelFootprint> pixelFootprint(const relief::Frame& frame, const relief::FrameRequest& request,
                                                     const relief::Tracer& tracer, int x, int y, double scale,
                                                     FilteredPicture& picture, relief::Work& work);

}  // namespace reliefui
