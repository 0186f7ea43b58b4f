// Cone maps: above each cell (texel) a cone that the relief around it does not enter. Dummer 2006; Policarpo & Oliveira
// 2007 (relaxed); Valasek & Ban 2022 (construction by the max pyramid); Ban et al. 2024 (safety).
//
// Slopes are heights per texel of horizontal distance, steeper for narrower cones; independent of the relief's depth.
#pragma once

#include <memory>
#include <string_view>

#include "relief/cell_grid.h"
#include "relief/describe.h"
#include "relief/map_cache.h"
#include "relief/maps/stored_values.h"

namespace relief {

// Conservative: apex A at the height of the highest of 3 x 3 cells, kappa = max over other cells q of (Cmax(q) - A) /
// gap(q); valid for every point of the cell and the interpolated surface. Stored at most kConeSlack steeper. Cells of
// cell_grid.h.
// Dummer: apex at the texel's height, between texel centres only; as published. Texels.
// Robust: surface_cones.h, safe wherever the ray steps from; bilinear surface only. Texels.
// Relaxed: the widest cone within which a ray from outside crosses the surface at most once, along sampled directions.
// RelaxedRobust: robust_cones.h, which ends at falling edges; bilinear surface only.
enum class ConeKind : std::uint8_t { Conservative, Dummer, Robust, Relaxed, RelaxedRobust };
inline constexpr int kConeKinds = 5;
std::string_view coneKindName(ConeKind kind);
// Returns true if a ray may cross the surface once within a cone.
constexpr bool areRelaxed(ConeKind kind) {
    return kind == ConeKind::Relaxed || kind == ConeKind::RelaxedRobust;
}

struct ConeParameters {
    int sectors = 1;  // azimuth sectors with slopes of their own (conservative): 1 to 8
    Precision precision = Precision::Float;
    int radius = 64;      // distance to which texels are examined (relaxed)
    int directions = 16;  // number of azimuths that are examined (relaxed)

    bool operator==(const ConeParameters&) const = default;
};

// A cone map: immutable once built, may be shared by threads. Which rays it is valid for: rays().
class ConeMap {
  public:
    ConeKind kind = ConeKind::Conservative;
    ConeParameters parameters;
    Surface surface = Surface::Bilinear;
    Address address = Address::Repeat;
    int fieldWidth = 0;
    int fieldHeight = 0;
    StoredValues apex;    // heights; rounded up
    StoredValues slopes;  // kappa, one layer per sector; rounded up

    int nx() const { return slopes.width(); }
    int ny() const { return slopes.height(); }
    std::size_t bytes() const { return apex.bytes() + slopes.bytes(); }
    RayClass rays() const { return areRelaxed(kind) ? RayClass::ViewRays : RayClass::AnyRays; }
};

// Takes the map from the cache, or builds it in parallel, with progress. Throws Cancelled, and InputError if it exceeds
// the cache's memory, or if the kind does not serve the field's surface.
std::shared_ptr<const ConeMap> coneMap(ConeKind kind, const ConeParameters& parameters, const HeightField& field,
                                       MapCache& cache, Work& work);
// Builds the map without a cache. The kind must serve the field's surface.
ConeMap buildConeMap(ConeKind kind, const ConeParameters& parameters, const HeightField& field, Work& work);
// The key under which the cache stores the map.
MapKey coneMapKey(ConeKind kind, const ConeParameters& parameters, const HeightField& field);
// Size of the stored values: cells or texels on each axis, and stored sectors.
struct ConeShape {
    int nx;
    int ny;
    int sectors;
};
ConeShape coneMapShape(ConeKind kind, const ConeParameters& parameters, const HeightField& field);
// Memory of the stored values.
std::size_t coneMapBytes(ConeKind kind, const ConeParameters& parameters, const HeightField& field);

}  // namespace relief
