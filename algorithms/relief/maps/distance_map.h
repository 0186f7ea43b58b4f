// Distance maps of the slab: how far the surface is from each voxel. [DIST17]; Donnelly 2005; four kinds.
//
// Metric: X = (x, y, D z) in texels, D = relief_depth * W. Distances are in that metric; a ray moves
// |(a, b, D)| of it a unit of lambda. The metric and the flattest ray travel with the map.
// Voxels: nx x ny footprints, L layers of equal height, layer 0 at the bottom.
//   Centres: one value at the voxel's centre, meant to be interpolated (the papers'). Footprints tile W x H evenly. On
//   one grid the refined value is nowhere smaller than the Euclidean one: both measure to the surface.
//   Boxes: a bound for every point of the box, never to be interpolated. Footprints of F x F cells of the cell grid
//   (cell_grid.h), the last of a row clipped. Marks: surface (the patch must be tested), buried.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>

#include "relief/cell_grid.h"
#include "relief/describe.h"
#include "relief/map_cache.h"
#include "relief/maps/stored_values.h"
#include "relief/ray.h"

namespace relief {

// Which distance: to the surface (Euclidean), or the smallest to the first hit over the rays that reach the voxel from
// above without having hit anything (refined). Sampled ones are the papers' and not safe; the others are proven.
enum class DistanceKind : std::uint8_t { Euclidean, EuclideanConservative, RefinedSampled, Refined };
std::string_view distanceKindName(DistanceKind kind);

constexpr bool ofBoxes(DistanceKind kind) {
    return kind == DistanceKind::EuclideanConservative || kind == DistanceKind::Refined;
}

// What a Euclidean map measures to. Surface: the surface itself. Voxel: the centre of the nearest solid voxel, as in
// Donnelly's volume; a third of a texel too long on average.
enum class DistanceTo : std::uint8_t { Surface, Voxel };
std::string_view distanceToName(DistanceTo to);
// InputError("--set", ...) with the known names.
DistanceTo parseDistanceTo(std::string_view text);

// What a map is built with; those that its kind does not use stay at their defaults.
struct DistanceParameters {
    int footprint = 1;     // F, texels (cells) a side
    int layers = 32;       // L
    double flattest = 10;  // degrees below which rays are not served (refined): m_min = tan(flattest)
    int horizons = 16;     // K, azimuth sectors that horizons are kept for (refined)
    int sectors = 1;       // azimuth sectors that distances are stored for (refined)
    int directions = 64;   // rays a voxel (refined, sampled)
    Precision precision = Precision::Float;
    DistanceTo to = DistanceTo::Surface;  // (euclidean)

    bool operator==(const DistanceParameters&) const = default;
};

class DistanceMap {
  public:
    DistanceKind kind = DistanceKind::Euclidean;
    DistanceParameters parameters;
    Surface surface = Surface::Bilinear;
    Address address = Address::Repeat;
    int fieldWidth = 0;  // of the height map
    int fieldHeight = 0;
    double slabTexels = 0;                                    // D: the metric it was built in
    double maxRun = std::numeric_limits<double>::infinity();  // |(a, b)| of the flattest ray it serves
    double cap = 0;                                           // distances are cut there
    StoredValues values;                                      // layer of sector q: q * layers + k

    int nx() const { return values.width(); }
    int ny() const { return values.height(); }
    int layers() const { return parameters.layers; }
    std::size_t bytes() const { return values.bytes(); }
    RayClass rays() const {
        const bool any = kind == DistanceKind::Euclidean || kind == DistanceKind::EuclideanConservative;
        return any ? RayClass::AnyRays : RayClass::ViewRays;
    }
    float at(int bx, int by, int layer, int sector) const { return values(bx, by, sector * layers() + layer); }

    // Centres only: texels (s, t) and height z of a voxel's centre, and the trilinear value at a point, addressed.
    double centreS(int bx) const { return (bx + 0.5) * fieldWidth / nx(); }
    double centreT(int by) const { return (by + 0.5) * fieldHeight / ny(); }
    double centreZ(int layer) const { return (layer + 0.5) / layers(); }
    double trilinear(double s, double t, double z) const;
};

// The azimuth sector of a direction: sector q holds the angles from 2 pi q / n to 2 pi (q + 1) / n, of (x, y).
int azimuthSector(double x, double y, int sectors);

// Traces rays over one height field, exactly. The caller gives it to the builder of refined-sampled maps, because maps
// know no method.
using ExactHits = std::function<void(const RayBlock& rays, HitBlock& hits)>;
using MakeExactHits = ExactHits (*)(const HeightField& field, Work& work);

// From the cache, or built: in parallel, with progress; throws Cancelled, InputError if it would take more memory than
// the cache may hold, or if the kind is not proven for the field's addressing (refined: not under clamp).
// exactHits: needed for refined-sampled only; methods/distance_options.h has one.
std::shared_ptr<const DistanceMap> distanceMap(DistanceKind kind, const DistanceParameters& parameters,
                                               const HeightField& field, MapCache& cache, Work& work,
                                               MakeExactHits exactHits = nullptr);
// Built without a cache.
DistanceMap buildDistanceMap(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field,
                             Work& work, MakeExactHits exactHits = nullptr);
// Under which the cache keeps it.
MapKey distanceMapKey(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field);
// Of its values: voxels across, and layers times stored sectors.
struct DistanceShape {
    int nx;
    int ny;
    int planes;
};
DistanceShape distanceMapShape(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field);
// What it will take.
std::size_t distanceMapBytes(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field);

}  // namespace relief
