// Divides the surface under a pixel into pieces that are small in the pixel; the sum over them approximates the
// integral over the visible surface.
//
// A piece is a texel of the footprint's level, if the projection of its surface extends less than kLargestSpread pixels
// from its lowest to its highest point. Otherwise the texel is replaced by its four texels of the next finer level; a
// texel of level 0 is cut into equal parts, with bilinear colours. Columns: the top of a texel is one piece, and each
// wall that faces the viewer is cut into pieces from foot to top, which have the colour of the texel.
//
// The work is bounded: if a pixel needs more than kMostVisits, as in grazing views whose pixels cover thousands of
// texels, it is repeated with texels in fewer parts, half the number along each side each time, and then with every
// third, seventh, fifteenth, ... texel, counted row by row. This is a coarser sampling of the same sum.
#pragma once

#include <vector>

#include "filtering/elliptical_visible.h"

namespace relief {

// Pixels.
inline constexpr double kLargestSpread = 0.5;
// Largest number of parts of a texel along each side, and of pieces of a wall.
inline constexpr int kMostParts = 16;
// Largest number of texels visited and pieces made for a pixel.
inline constexpr int kMostVisits = 8192;

class SurfacePieces {
  public:
    SurfacePieces(const VisibleKernel& kernel, const LevelFootprint& f, const SeenPoint& seen);
    // Appends the pieces. under: bounds of all heights that may be visible.
    void gather(HeightBounds under, std::vector<VisibleKernel::Piece>& pieces);

  private:
    // Texel (i, j) of a level. Its centre is at (u, v) from the footprint's centre; u, v, width and height are in
    // texels of the footprint's level.
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
    glm::dvec2 run_;      // of the view ray, texels of the footprint's level per unit of descent
    double runPixels_;    // length of run_ in the pixel, pixels
    glm::dvec2 toField_;  // texels of the height map per texel of the footprint's level
    bool area_;
    bool columns_;
    int visitsLeft_ = 0;          // remaining visits; below 0: exceeded
    int mostParts_ = kMostParts;  // parts of a texel of the footprint's level along each side, through all levels
    int stride_ = 1;              // takes every stride_-th texel of the footprint's level
    std::int64_t texel_ = 0;      // number of texels of the footprint's level so far
};

}  // namespace relief
