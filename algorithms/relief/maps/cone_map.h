// Cone maps: above each cell (texel) a cone that the relief around does not reach into. Dummer 2006; Policarpo &
// Oliveira 2007 (relaxed); Valasek & Ban 2022 (building by the max pyramid); Ban et al. 2024 (what makes them safe).
//
// Slopes are heights a texel of horizontal way, the steeper the narrower the cone; independent of the relief's depth.
#pragma once

#include <memory>
#include <string_view>

#include "relief/cell_grid.h"
#include "relief/describe.h"
#include "relief/map_cache.h"
#include "relief/maps/stored_values.h"

namespace relief {

// Conservative: apex A on the highest of 3 x 3 cells, kappa = max over other cells q of (Cmax(q) - A) / gap(q); holds
//   for every point of the cell and the interpolated surface. Stored up to kConeSlack steeper. Cells of cell_grid.h.
// Dummer: apex on the texel's height, texel centres only; as published. Texels.
// Relaxed: the widest cone within which a ray from outside crosses the surface at most once, from sampled directions.
enum class ConeKind : std::uint8_t { Conservative, Dummer, Relaxed };
std::string_view coneKindName(ConeKind kind);

struct ConeParameters {
    int sectors = 1;  // azimuth sectors with slopes of their own (conservative): 1, 4, 8
    Precision precision = Precision::Float;
    int radius = 64;      // texels that are looked at (relaxed)
    int directions = 16;  // azimuths that are looked along (relaxed)

    bool operator==(const ConeParameters&) const = default;
};

class ConeMap {
  public:
    ConeKind kind = ConeKind::Conservative;
    ConeParameters parameters;
    Surface surface = Surface::Bilinear;
    Address address = Address::Repeat;
    int fieldWidth = 0;
    int fieldHeight = 0;
    StoredValues apex;    // heights; rounded up
    StoredValues slopes;  // kappa, one layer a sector; rounded up

    int nx() const { return slopes.width(); }
    int ny() const { return slopes.height(); }
    std::size_t bytes() const { return apex.bytes() + slopes.bytes(); }
    RayClass rays() const { return kind == ConeKind::Relaxed ? RayClass::ViewRays : RayClass::AnyRays; }
};

// From the cache, or built: in parallel, with progress; throws Cancelled, InputError beyond the cache's memory.
std::shared_ptr<const ConeMap> coneMap(ConeKind kind, const ConeParameters& parameters, const HeightField& field,
                                       MapCache& cache, Work& work);
ConeMap buildConeMap(ConeKind kind, const ConeParameters& parameters, const HeightField& field, Work& work);
// Under which the cache keeps it.
MapKey coneMapKey(ConeKind kind, const ConeParameters& parameters, const HeightField& field);
// Of its values: cells or texels across, and stored sectors.
struct ConeShape {
    int nx;
    int ny;
    int sectors;
};
ConeShape coneMapShape(ConeKind kind, const ConeParameters& parameters, const HeightField& field);
std::size_t coneMapBytes(ConeKind kind, const ConeParameters& parameters, const HeightField& field);

}  // namespace relief
