// The filter's work for the chosen pixel and the colours it read, ready to be drawn.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filtering/footprint_log.h"
#include "mapping/rows/coefficients.h"
#include "rendering/frame.h"

namespace reliefui {

// The colours that a frame's filter reads, and their mean pyramid if a level above 0 is needed. Cached between frames.
class FilteredPicture {
  public:
    // Returns true for heights without a colour picture that would need too much memory as one.
    static bool tooLarge(const relief::FrameRequest& request);
    // Sets the picture; must not be called if tooLarge().
    void use(const relief::FrameRequest& request);
    const std::shared_ptr<const relief::ColorImage>& picture() const { return picture_; }
    // Returns level l of the mean pyramid, building it if necessary. Throws Cancelled.
    std::shared_ptr<const relief::ColorImage> level(int l, relief::Work& work);

  private:
    std::shared_ptr<const relief::ColorImage> picture_;
    // heights from which the grey picture was made; null for a colour picture
    std::shared_ptr<const relief::FloatImage> greyOf_;
    std::shared_ptr<const relief::ColorLevels> levels_;
};

// The image on the texture of a circle around the pixel, of this radius in pixels; centre and Jacobian are in texels of
// level 0.
struct PixelCircle {
    relief::Jacobian jacobian;
    glm::dvec2 centre{0};
    double radius = 1;
    bool sharesSide = false;  // the neighbour shares a side with the pixel, not only a corner
};

// Hit of one of the pixel's rays, in texels of the footprint's level, and its share of the pixel's weight.
struct RayHit {
    glm::dvec2 at{0};
    double share = 0;
};

struct PixelFootprint {
    relief::FilterChoice filter;
    // All texels with a weight: those logged by the filter, or those of its point samples. Each occurs once, at its
    // centre with its whole weight, and a second time with the hidden part of its weight, if any.
    relief::FootprintLog log;
    relief::FootprintCounts counts;
    bool listed = true;  // false: too many texels to list each of them
    double weightSum = 0;
    // largest weight of a visible texel; of a hidden one if only hidden ones are listed
    double greatest = 0;
    relief::Jacobian seen;                // of the pixel as used by the filter, in texels of the level
    relief::PixelCoefficients behind;     // the pixel's coefficients on the top plane, in texels of the height map
    bool bounded = true;                  // the image of the pixel's circle is finite
    std::vector<RayHit> rays;             // supersample only: rays that hit the relief
    std::vector<PixelCircle> neighbours;  // circles of the eight neighbouring pixels
    std::shared_ptr<const relief::ColorImage> colors;    // picture of the footprint's level, linear colours
    relief::LevelAxis across, down;                      // axes of the level
    glm::dvec2 perHeight{1};                             // texels of the level per texel of the height map
    std::optional<relief::EllipticalSettings> weighing;  // for filters that weight the texels of an ellipse
    std::size_t texelCount = 0;                          // number of different texels listed

    int level() const { return log.footprint.level; }
    glm::dvec2 centre() const { return log.footprint.centre; }
    // Mean over the three channels.
    static double weightOf(const relief::FootprintTexel& texel) { return meanOf(texel.weight); }
    static double meanOf(const relief::Color& c) { return static_cast<double>(c.r + c.g + c.b) / 3; }
    // Side of the texel, in texels of the footprint's level.
    double sideOf(const relief::FootprintTexel& texel) const {
        return std::ldexp(1.0, texel.level - log.footprint.level);
    }
};

// Computes the footprint of pixel (x, y) of the frame. Returns null if it does not hit the relief, or if the heights
// are too large to be used as a picture. scale: pixels of the frame per pixel of the full picture; neighbours'
// footprints are computed only at scale 1, not for coarse frames. tracer: the frame's tracer. Throws Cancelled.
std::shared_ptr<const PixelFootprint> pixelFootprint(const relief::Frame& frame, const relief::FrameRequest& request,
                                                     const relief::Tracer& tracer, int x, int y, double scale,
                                                     FilteredPicture& picture, relief::Work& work);

}  // namespace reliefui
