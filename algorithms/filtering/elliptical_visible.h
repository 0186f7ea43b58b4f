// elliptical-visible: anisotropic filtering of what the pixel really sees. Behind a relief the footprint contains
// texels that higher ground hides; each texel is traced back from its surface point towards the viewer and counts only
// if nothing is in the way; the weights of the others are divided by their own sum. [ANISO17], [TEX].
//
// Frame: the view ray (a, b) in texels of the height map a unit of descent; texel (i, j) of the level chosen has its
// surface point at (s, t, h), its centre and the height there. It is hidden if the segment
//
//     (s - mu a, t - mu b, h + mu),  0 < mu <= 1 - h
//
// meets the surface. Three forms, U, V the texel less the hit, h0 the hit's height:
//   plane          weight by the plane's ellipse, at (U, V): the paper's
//   position       weight at the texel's true place in the pixel, (U + (h - h0) a, V + (h - h0) b)
//   position-area  times the projected area of the surface there, max(0, 1 + a h_s + b h_t)
// The last two sum over the surface itself: where the relief under a texel is steep, so that its parts lie far apart in
// the pixel, it is taken in parts, first the finer levels' texels, then parts of texels.
// Two more, rays and grid (the default), are ours as well: elliptical_rays.h, elliptical_grid.h.
// All equal plain filtering, bit for bit, where the map is flat. The ellipse is that of the plane at the hit's height.
// None visible: the colour at the hit.
//
// Where nothing hides anything and the surface is nearly a plane, the last two are plain filtering with that plane's
// Jacobian (tangent_footprint.h), in lanes; the first is plain filtering where nothing is hidden.
//
// Skip, lossless: where bounds of heights and slopes say that nothing is hidden (tangent_footprint.h), no texel is
// tested; nor where, with L the lowest height under the footprint, a blocker must rise above L by more than 1/(|a| +
// |b|) (bilinear; 1/(2 max(|a|, |b|)) for columns) to reach over a texel's border; if no height within reach of any
// back-traced segment does, no texel is tested. The reach is bounded by the highest point, twice over.
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
    std::string form = "grid";  // interactive; weights with a shape of their own: position-area
    int samples = 16;
    int points = 3;

    static std::vector<OptionField<VisibleOptions>> fields() {
        auto all = EllipticalOptions::fieldsOf<VisibleOptions>();
        all.push_back({{"form",
                        OptionKind::Choice,
                        "",
                        0,
                        1,
                        1,
                        {"plane", "position", "position-area", "rays", "grid"},
                        "where in the pixel a texel counts: its place on the plane (the paper's), its own, and with "
                        "its area seen (ours); or what rays through parts of the pixel see, of its own or on a grid "
                        "that neighbours share (ours; grid: the default)"},
                       &VisibleOptions::form});
        all.push_back({{"samples",
                        OptionKind::Integer,
                        "rays",
                        8,
                        64,
                        1,
                        {},
                        "form=rays: through a pixel in which the relief is no plane"},
                       &VisibleOptions::samples});
        all.push_back({{"points",
                        OptionKind::Integer,
                        "",
                        2,
                        16,
                        1,
                        {},
                        "form=grid: looked at for each pixel where the relief is no plane"},
                       &VisibleOptions::points});
        return all;
    }
};

// Where a pixel's view ray met the relief, in texels of the height map.
struct SeenPoint {
    ViewRay ray;
    double lambda = 0;
    glm::dvec2 place{0};  // where colours are looked up
};

class VisibleKernel {
  public:
    VisibleKernel(EllipticalKernel plain, VisibleForm form, const HeightField& field,
                  std::shared_ptr<const AnyHitQuery> query, std::shared_ptr<const HeightBoundsMap> range);

    // False: every test is made, for proving that skipping changes nothing.
    void setSkip(bool skip) { skip_ = skip; }
    // j, centre: in texels of the colour picture's level 0.
    Color filter(const Jacobian& j, glm::dvec2 centre, const SeenPoint& seen, FootprintCounts& counts, Work& work,
                 FootprintLog* log = nullptr) const;
    // The same bits for a whole block; scale: texels of level 0 per texel of the height map.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                Work& work) const;

  private:
    friend class SurfacePieces;
    struct Piece;
    struct Region;
    struct Scratch;
    // What is filtered as a plane: the Jacobian to do it with, texels of the colour picture. Nothing: by pieces.
    std::optional<Jacobian> plainJacobian(const Jacobian& j, const SeenPoint& seen, bool& clear) const;
    Color filterPieces(const Jacobian& j, glm::dvec2 centre, const SeenPoint& seen, bool clear, Scratch& scratch,
                       FootprintCounts& counts, Work& work, FootprintLog* log) const;
    Region regionOf(const LevelFootprint& f, const SeenPoint& seen) const;
    void gatherTexels(const LevelFootprint& f, std::vector<Piece>& pieces) const;
    void test(Scratch& scratch, const SeenPoint& seen, FootprintCounts& counts, Work& work, bool log) const;
    Color summed(const LevelFootprint& f, const std::vector<Piece>& pieces, FootprintCounts& counts, FootprintLog* log,
                 bool& none) const;
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
