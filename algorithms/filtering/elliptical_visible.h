// elliptical-visible: anisotropic filtering of what the pixel really sees. Behind a relief the footprint contains
// texels that higher ground hides. Each texel's surface point is traced back towards the viewer, and the texel counts
// only if nothing blocks the way; the weights of the visible texels are normalised by their sum. [ANISO17], [TEX].
//
// Frame: the view ray runs (a, b) texels of the height map per unit of descent; texel (i, j) of the chosen level has
// its surface point at (s, t, h), its centre and the height there. It is hidden if the segment
//
//     (s - mu a, t - mu b, h + mu),  0 < mu <= 1 - h
//
// meets the surface. There are three forms, with U, V the offset of the texel from the hit and h0 the hit's height:
//   plane          weight by the plane's ellipse, at (U, V), as in the paper
//   position       weight at the texel's true place in the pixel, (U + (h - h0) a, V + (h - h0) b)
//   position-area  the same, times the projected area of the surface there, max(0, 1 + a h_s + b h_t)
//
// The last two sum over the surface itself. Where the relief under a texel is steep, so that its parts lie far apart in
// the pixel, the texel is divided: into texels of finer levels first, then into parts of texels. Two more forms, rays
// and grid (the default), are described in elliptical_rays.h and elliptical_grid.h; these and the last two are not from
// the paper. All forms equal plain filtering, bit for bit, where the map is flat. The ellipse is that of the plane at
// the hit's height. A channel without a visible texel of any weight gets the colour at the hit.
//
// Where nothing is hidden and the surface is nearly planar, position and position-area are plain SIMD filtering with
// that plane's Jacobian (tangent_footprint.h); plane is plain filtering wherever nothing is hidden.
//
// Lossless skipping of tests: no texel is tested where bounds of heights and slopes prove that nothing is hidden
// (tangent_footprint.h). A second proof uses the lowest height L under the footprint: to reach over a texel's border, a
// blocker must rise above L by more than 1/(|a| + |b|) (bilinear) or 1/(2 max(|a|, |b|)) (columns). If no height within
// reach of any back-traced segment does, no texel is tested. The reach is bounded by the highest point, in two
// iterations.
#pragma once

#include <memory>
#include <optional>

#include "filtering/elliptical.h"
#include "filtering/height_bounds.h"
#include "relief/ray.h"
#include "relief/visibility/any_hit.h"

namespace relief {

enum class VisibleForm : std::uint8_t { Plane, Position, PositionArea };

struct VisibleOptions : EllipticalOptions {
    std::string form = "grid";  // rays and grid need uniform or Gaussian weights; others use position-area
    int samples = 16;
    int points = 3;

    static std::vector<OptionField<VisibleOptions>> fields() {
        auto all = EllipticalOptions::fieldsOf<VisibleOptions>();
        all.push_back(
            {{"form",
              OptionKind::Choice,
              "",
              0,
              1,
              1,
              {"plane", "position", "position-area", "rays", "grid"},
              "place of a texel within the pixel. plane: its point on the polygon's plane, as in the paper; position: "
              "its point on the relief; position-area: the same, weighted by its visible area; rays, grid: the points "
              "that rays through parts of the pixel see, traced for each pixel alone or shared with its neighbours"},
             &VisibleOptions::form});
        all.push_back({{"samples",
                        OptionKind::Integer,
                        "rays",
                        8,
                        64,
                        1,
                        {},
                        "form=rays: rays through each pixel in which the relief is not planar"},
                       &VisibleOptions::samples});
        all.push_back({{"points",
                        OptionKind::Integer,
                        "",
                        2,
                        16,
                        1,
                        {},
                        "form=grid: points sampled for each pixel in which the relief is not planar"},
                       &VisibleOptions::points});
        return all;
    }
};

// Where a pixel's view ray hits the relief, in texels of the height map.
struct SeenPoint {
    ViewRay ray;
    double lambda = 0;
    glm::dvec2 place{0};  // where colours are sampled
};

class VisibleKernel {
  public:
    VisibleKernel(EllipticalKernel plain, VisibleForm form, const HeightField& field,
                  std::shared_ptr<const AnyHitQuery> query, std::shared_ptr<const HeightBoundsMap> range);

    // false: every test is made, to prove that skipping changes nothing.
    void setSkip(bool skip) { skip_ = skip; }
    // Filters one pixel. j, centre: in texels of the colour picture's level 0. log: may be null.
    Color filter(const Jacobian& j, glm::dvec2 centre, const SeenPoint& seen, FootprintCounts& counts, Work& work,
                 FootprintLog* log = nullptr) const;
    // Filters a block with the same bits. scale: texels of level 0 per texel of the height map. Returns early if the
    // work is stopped.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                Work& work) const;

  private:
    friend class SurfacePieces;
    struct Piece;
    struct Region;
    struct Scratch;
    // Returns the Jacobian, in texels of the colour picture, of a pixel that is filtered as a plane; std::nullopt if it
    // must be filtered by pieces. clear: set to true if nothing on the plane's footprint is hidden.
    std::optional<Jacobian> plainJacobian(const Jacobian& j, const SeenPoint& seen, bool& clear) const;
    Color filterPieces(const Jacobian& j, glm::dvec2 centre, const SeenPoint& seen, bool clear, Scratch& scratch,
                       FootprintCounts& counts, Work& work, FootprintLog* log) const;
    Region regionOf(const LevelFootprint& f, const SeenPoint& seen) const;
    void gatherTexels(const LevelFootprint& f, std::vector<Piece>& pieces) const;
    void test(Scratch& scratch, const SeenPoint& seen, FootprintCounts& counts, Work& work, bool log) const;
    Color summed(const LevelFootprint& f, glm::dvec2 centre, const std::vector<Piece>& pieces, FootprintCounts& counts,
                 FootprintLog* log, bool& none) const;
    bool outside(glm::dvec2 place) const;
    glm::dvec2 fieldTexels(glm::dvec2 levelPlace, int level) const;

    EllipticalKernel plain_;
    VisibleForm form_;
    HeightField field_;
    std::shared_ptr<const AnyHitQuery> query_;
    std::shared_ptr<const HeightBoundsMap> range_;
    glm::dvec2 perColor_;  // texels of the height map per texel of the colour picture
    bool skip_ = true;
};

}  // namespace relief
