// The surface under a pixel, in pieces that are small in the pixel: the sum over them stands for the integral over the
// visible surface.
//
// A piece is a texel of the footprint's level as long as its surface spans less than kLargestSpread pixels from its
// lowest to its highest point; otherwise its four texels of the next finer level; below level 0 a texel is cut into
// equal parts (its colour bilinear there). Columns: a texel's top is one piece, and each wall that faces the viewer is
// cut into pieces from foot to top, of the colour of the texel it belongs to.
// Bound of work: where that takes more than kMostLooks, as in views along the plane whose pixels see thousands of
// texels, the pixel is done again with texels in fewer parts, half as many along each side each time, then with every
// third, seventh, fifteenth, ... texel, counted row by row: a coarser sampling of the same sum.
#pragma once

#include <vector>

#include "filtering/elliptical_visible.h"

namespace relief {

// Pixels.
inline constexpr double kLargestSpread = 0.5;
// Parts of a texel along each side, at most; pieces of a wall, at most.
inline constexpr int kMostParts = 16;
// Texels looked at and pieces made for a pixel, at most.
inline constexpr int kMostLooks = 8192;

class SurfacePieces {
  public:
    SurfacePieces(const VisibleKernel& kernel, const LevelFootprint& f, const SeenPoint& seen);
    // under: bounds of all heights that may be seen.
    void gather(HeightBounds under, std::vector<VisibleKernel::Piece>& pieces);

  private:
    // A texel (i, j) of a level, centred at (u, v) from the footprint's centre (texels of its level), wide and high as
    // given (the same unit).
    struct Block {
        int level, i, j;
        double u, v;
        double width, height;
    };
    void gatherOnce(HeightBounds under);
    void add(const Block& block);
    void addParts(const Block& block, HeightBounds bounds, int most);  // along each side
    void addPiece(const Block& block, double u, double v, double width, double height, Color color);
    void addWalls(const Block& block, glm::dvec2 place, double h);
    void push(const Block& block, double u, double v, Color color, double share, glm::dvec3 point);
    bool reaches(const Block& block, HeightBounds bounds) const;
    void split(const Block& block);

    const VisibleKernel& kernel_;
    const LevelFootprint& f_;
    const SeenPoint& seen_;
    std::vector<VisibleKernel::Piece>* pieces_ = nullptr;
    double h0_;
    glm::dvec2 run_;      // of the view ray, texels of the footprint's level a unit of descent
    double runPixels_;    // its length in the pixel
    glm::dvec2 toField_;  // texels of the height map per texel of the footprint's level
    bool area_;
    bool columns_;
    int left_ = 0;                // looks; below 0: too many
    int mostParts_ = kMostParts;  // of a texel along each side, finer levels' texels among them
    int stride_ = 1;              // of the texels of the footprint's level
    std::int64_t texel_ = 0;      // of them, so far
};

}  // namespace relief
