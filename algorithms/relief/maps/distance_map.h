// Distance maps of the slab: the distance from each voxel to the surface. [DIST17]; Donnelly 2005; four kinds.
//
// Metric: X = (x, y, D z) in texels, D = relief_depth * W. Distances are in that metric; a ray covers |(a, b, D)| of it
// per unit of lambda. The metric and the flattest ray are stored with the map.
// Voxels: nx x ny footprints, L layers of equal height, layer 0 at the bottom.
//   Centres: one value at the voxel's centre, meant to be interpolated (as in the papers). Footprints tile W x H
//   uniformly. On the same grid a refined value is never smaller than the Euclidean one, since both measure to the
//   surface.
//   Boxes: a bound for every point of the box, not to be interpolated. Footprints of F x F cells of the cell grid
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

// Euclidean: distance to the surface. Refined: the smallest distance to the first hit over the rays that reach the
// voxel from above without having hit anything. RefinedSampled is that of the papers and not safe;
// EuclideanConservative and Refined are proven bounds.
enum class DistanceKind : std::uint8_t { Euclidean, EuclideanConservative, RefinedSampled, Refined };
std::string_view distanceKindName(DistanceKind kind);

// True for kinds of boxes, false for kinds of centres.
constexpr bool ofBoxes(DistanceKind kind) {
    return kind == DistanceKind::EuclideanConservative || kind == DistanceKind::Refined;
}

// The target of a Euclidean map. Surface: the surface itself. Voxel: the centre of the nearest solid voxel, as in
// Donnelly's volume; on average a third of a texel too long.
enum class DistanceTo : std::uint8_t { Surface, Voxel };
std::string_view distanceToName(DistanceTo to);
// Throws InputError("--set", ...), which lists the known names.
DistanceTo parseDistanceTo(std::string_view text);

// The parameters with which a map is built. Those that its kind does not use keep their defaults.
struct DistanceParameters {
    int footprint = 1;     // F, texels (cells) per side
    int layers = 32;       // L
    double flattest = 10;  // degrees from the plane below which rays are not served (refined): m_min = tan(flattest)
    int horizons = 16;     // K, azimuth sectors in which horizons are computed (refined)
    int sectors = 1;       // azimuth sectors in which distances are stored (refined)
    int directions = 64;   // rays per voxel (refined, sampled)
    Precision precision = Precision::Float;
    DistanceTo to = DistanceTo::Surface;  // (euclidean)

    bool operator==(const DistanceParameters&) const = default;
};

// A distance map: immutable once built, may be shared by threads. Which rays it is valid for: rays(), maxRun.
class DistanceMap {
  public:
    DistanceKind kind = DistanceKind::Euclidean;
    DistanceParameters parameters;
    Surface surface = Surface::Bilinear;
    Address address = Address::Repeat;
    int fieldWidth = 0;  // of the height map
    int fieldHeight = 0;
    double slabTexels = 0;                                    // D: the metric in which the map was built
    double maxRun = std::numeric_limits<double>::infinity();  // |(a, b)| of the flattest ray it serves
    double cap = 0;                                           // upper limit of the distances
    StoredValues values;                                      // values of sector q, layer k: layer q * layers + k

    int nx() const { return values.width(); }
    int ny() const { return values.height(); }
    int layers() const { return parameters.layers; }
    std::size_t bytes() const { return values.bytes(); }
    RayClass rays() const {
        const bool any = kind == DistanceKind::Euclidean || kind == DistanceKind::EuclideanConservative;
        return any ? RayClass::AnyRays : RayClass::ViewRays;
    }
    bool refined() const { return rays() == RayClass::ViewRays; }
    float at(int bx, int by, int layer, int sector) const { return values(bx, by, sector * layers() + layer); }

    // For kinds of centres only: texels (s, t) and height z of a voxel's centre, and the trilinearly interpolated value
    // at a point, with addressing.
    double centreS(int bx) const { return (bx + 0.5) * fieldWidth / nx(); }
    double centreT(int by) const { return (by + 0.5) * fieldHeight / ny(); }
    double centreZ(int layer) const { return (layer + 0.5) / layers(); }
    double trilinear(double s, double t, double z) const;
};

// The azimuth sector of a direction (x, y): sector q contains the angles from 2 pi q / n to 2 pi (q + 1) / n.
int azimuthSector(double x, double y, int sectors);

// Traces rays exactly over one height field. The caller passes it to the builder of refined-sampled maps, because maps
// do not depend on methods.
using ExactHits = std::function<void(const RayBlock& rays, HitBlock& hits)>;
using MakeExactHits = ExactHits (*)(const HeightField& field, Work& work);

// Takes the map from the cache, or builds it in parallel, with progress. Throws Cancelled, and InputError if it would
// exceed the cache's memory or if the kind is not proven for the field's addressing (refined: not under clamp).
// exactHits: required for refined-sampled only; methods/distance_options.h provides one.
std::shared_ptr<const DistanceMap> distanceMap(DistanceKind kind, const DistanceParameters& parameters,
                                               const HeightField& field, MapCache& cache, Work& work,
                                               MakeExactHits exactHits = nullptr);
// Builds the map without a cache.
DistanceMap buildDistanceMap(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field,
                             Work& work, MakeExactHits exactHits = nullptr);
// The key under which the cache stores the map.
MapKey distanceMapKey(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field);
// Size of the stored values: voxels on each axis, and layers times stored sectors.
struct DistanceShape {
    int nx;
    int ny;
    int planes;
};
DistanceShape distanceMapShape(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field);
// Memory of the stored values.
std::size_t distanceMapBytes(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field);

}  // namespace relief
