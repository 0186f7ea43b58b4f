#include "relief/maps/distance_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/parallel.h"
#include "base/scratch_pool.h"
#include "relief/leaf.h"
#include "relief/maps/lower_envelope.h"
#include "relief/maps/map_field.h"
#include "relief/maps/map_memory.h"
#include "relief/maps/refined.h"
#include "relief/maps/surface_distance.h"
#include "relief/maps/window_lanes.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, 4> kKindNames{"euclidean", "euclidean-conservative", "refined-sampled",
                                                     "refined"};

constexpr std::array<std::string_view, 2> kToNames{"surface", "voxel"};

int voxelsAcross(int cells, int footprint) {
    return (cells + footprint - 1) / footprint;
}

using Shape = DistanceShape;

// The buffers of one thread.
struct LayerScratch {
    EnvelopeScratch envelope;
    FloatImage squares;
};

// Calls body(k, scratch) for each layer, in parallel.
template <class Body>
void overLayers(int layers, Work& work, const Body& body) {
    ScratchPool<LayerScratch> scratch;
    parallelFor(work, layers, [&](int k) {
        body(k, *scratch.borrow());
        work.progress().advance();
    });
}

float* plane(UnfilledVector<float>& values, const Shape& shape, int layer) {
    return values.data() +
           static_cast<std::size_t>(layer) * static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny);
}

// Distances from each voxel's centre to the surface. The distance of the previous voxel of the row, and of the one
// below, plus the distance between the centres, is an upper bound that shortens the search.
void toSurface(DistanceMap& map, const Shape& shape, const HeightField& field, UnfilledVector<float>& values,
               Work& work) {
    MapCache own;
    const SurfaceDistance distance(field, maxPyramidMap(field, own, work));
    const double across = static_cast<double>(field.width()) / shape.nx;
    const double along = static_cast<double>(field.height()) / shape.ny;
    const double up = field.slabTexels() / map.layers();
    parallelFor(work, shape.ny, [&](int y) {
        constexpr double kNone = std::numeric_limits<double>::infinity();
        for (int x = 0; x < shape.nx; ++x) {
            double below = kNone;
            for (int k = 0; k < map.layers(); ++k) {
                float* const row =
                    plane(values, shape, k) + static_cast<std::size_t>(y) * static_cast<std::size_t>(shape.nx);
                const double beside = x > 0 ? static_cast<double>(row[x - 1]) + across : kNone;
                constexpr double kRounding = 1e-4;  // in texels: rounding of the stored floats
                const double known = std::min(below + up, beside) + kRounding;
                below = distance.at((x + 0.5) * across, (y + 0.5) * along, map.centreZ(k), known);
                row[x] = static_cast<float>(below);
            }
        }
        work.progress().advance();
    });
}

// A voxel is solid if its centre is not above the surface; everything below the slab is solid. The distance of a voxel
// is that of its centre to the nearest solid centre.
void toVoxel(DistanceMap& map, const Shape& shape, const HeightField& field, UnfilledVector<float>& values,
             Work& work) {
    const int layers = map.layers();
    Image<int> top(shape.nx, shape.ny);  // the highest solid layer
    parallelFor(work, shape.ny, [&](int y) {
        const double t = (y + 0.5) * field.height() / shape.ny;
        for (int x = 0; x < shape.nx; ++x) {
            const double s = (x + 0.5) * field.width() / shape.nx;
            top(x, y) = static_cast<int>(std::floor(field.at(s, t) * layers - 0.5));
        }
    });
    const double dz = field.slabTexels() / layers;
    std::vector<float> drops;  // squared, by the number of layers
    for (int k = 0; k <= layers; ++k) drops.push_back(static_cast<float>((k * dz) * (k * dz)));
    overLayers(layers, work, [&](int k, LayerScratch& scratch) {
        FloatImage& squares = scratch.squares;
        if (squares.empty()) squares = FloatImage(shape.nx, shape.ny);
        for (std::size_t i = 0; i < squares.size(); ++i) {
            squares.pixels()[i] = drops[static_cast<std::size_t>(std::max(k - top.pixels()[i], 0))];
        }
        envelope2D(squares, static_cast<double>(field.width()) / shape.nx,
                   static_cast<double>(field.height()) / shape.ny, field.address() == Address::Repeat,
                   scratch.envelope);
        float* const out = plane(values, shape, k);
        for (int y = 0; y < shape.ny; ++y) rootsOf(&squares(0, y), shape.nx, 1, out + std::ptrdiff_t{y} * shape.nx);
    });
}

// The bound for whole boxes: the gap between box and cell, and the drop from the bottom of the box to the cell's
// highest point.
void euclideanConservative(DistanceMap& map, const Shape& shape, const CellHeights& cells, bool wraps, double slab,
                           UnfilledVector<float>& values, Work& work) {
    const int layers = map.layers();
    const int f = map.parameters.footprint;
    // The rounding of squares and roots in float is far below this factor.
    constexpr float kShorter = 1 - 1e-6F;
    const BoxHeights boxes(cells, f, shape.nx, shape.ny, work);
    overLayers(layers, work, [&](int k, LayerScratch& scratch) {
        const double z0 = static_cast<double>(k) / layers;
        FloatImage& squares = scratch.squares;
        if (squares.empty()) squares = cells.highest;
        for (std::size_t i = 0; i < squares.size(); ++i) {
            const double drop = std::max(z0 - static_cast<double>(cells.highest.pixels()[i]), 0.0) * slab;
            squares.pixels()[i] = static_cast<float>(drop * drop);
        }
        gapEnvelope2D(squares, wraps, scratch.envelope);
        float* out = plane(values, shape, k);
        for (int by = 0; by < shape.ny; ++by, out += shape.nx) {
            for (int bx = 0; bx < shape.nx; ++bx) {
                float least = squares(bx * f, by * f);
                for (int y = by * f; f > 1 && y < std::min((by + 1) * f, squares.height()); ++y) {
                    for (int x = bx * f; x < std::min((bx + 1) * f, squares.width()); ++x) {
                        least = std::min(least, squares(x, y));
                    }
                }
                out[bx] = least;
            }
            rootsOf(out, shape.nx, kShorter, out);
            for (int bx = 0; bx < shape.nx; ++bx) {
                const float mark = boxes.mark(bx, by, k, layers);
                out[bx] = mark < 0 ? mark : out[bx];
            }
        }
    });
}

}  // namespace

std::string_view distanceKindName(DistanceKind kind) {
    return kKindNames[static_cast<std::size_t>(kind)];
}

std::string_view distanceToName(DistanceTo to) {
    return kToNames[static_cast<std::size_t>(to)];
}

DistanceTo parseDistanceTo(std::string_view text) {
    for (std::size_t n = 0; n < kToNames.size(); ++n) {
        if (kToNames[n] == text) return static_cast<DistanceTo>(n);
    }
    throw InputError("--set",
                     unknownName({"what", MessageId::WordDistanceTarget}, std::string(text), "surface, voxel"));
}

int azimuthSector(double x, double y, int sectors) {
    if (sectors <= 1) return 0;
    if (sectors % 4 == 0 && (x != 0 || y != 0)) {
        // The quadrant is chosen by signs, so that rounding cannot move a direction into the next quadrant; the maps
        // rely on this.
        const int quarter = sectors / 4;
        const bool right = y < 0 ? x >= 0 : x > 0;
        const int quadrant = right ? (y >= 0 ? 0 : 3) : (y > 0 ? 1 : 2);
        const double along = quadrant % 2 == 0 ? std::abs(x) : std::abs(y);
        const double aside = quadrant % 2 == 0 ? std::abs(y) : std::abs(x);
        const int within = static_cast<int>(std::atan2(aside, along) / (0.5 * std::numbers::pi) * quarter);
        return quadrant * quarter + std::min(within, quarter - 1);
    }
    const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
    const int q = static_cast<int>(std::floor((turn < 0 ? turn + 1 : turn) * sectors));
    return std::min(q, sectors - 1);
}

CellHeights::CellHeights(const HeightField& field, Work& work) {
    const CellGrid grid(field);
    highest = FloatImage(grid.x.cells, grid.y.cells);
    lowest = highest;
    const bool bilinear = field.surface() == Surface::Bilinear;
    parallelFor(work, grid.y.cells, [&](int y) {
        for (int x = 0; x < grid.x.cells; ++x) {
            highest(x, y) = bilinear ? cellMaximum<Surface::Bilinear>(field.heights(), grid, x, y)
                                     : cellMaximum<Surface::Columns>(field.heights(), grid, x, y);
            lowest(x, y) = bilinear ? cellMinimum<Surface::Bilinear>(field.heights(), grid, x, y)
                                    : cellMinimum<Surface::Columns>(field.heights(), grid, x, y);
        }
    });
}

BoxHeights::BoxHeights(const CellHeights& cells, int footprint, int nx, int ny, Work& work)
    : highest(nx, ny), lowest(nx, ny, 1) {
    parallelFor(work, ny, [&](int by) {
        for (int y = by * footprint; y < std::min((by + 1) * footprint, cells.highest.height()); ++y) {
            for (int x = 0; x < cells.highest.width(); ++x) {
                float& high = highest(x / footprint, by);
                float& low = lowest(x / footprint, by);
                high = std::max(high, cells.highest(x, y));
                low = std::min(low, cells.lowest(x, y));
            }
        }
    });
}

float BoxHeights::mark(int bx, int by, int layer, int layers) const {
    const double z0 = static_cast<double>(layer) / layers;
    const double z1 = static_cast<double>(layer + 1) / layers;
    // Also in layer 0, since a ray would leave through a floor of height 0. A floor at the height of the cell counts as
    // well.
    if (z0 <= static_cast<double>(highest(bx, by)) || layer == 0) {
        return z1 <= static_cast<double>(lowest(bx, by)) ? StoredValues::kBuried : StoredValues::kSurface;
    }
    return 0;
}

double DistanceMap::trilinear(double s, double t, double z) const {
    const double x = s * nx() / fieldWidth - 0.5;
    const double y = t * ny() / fieldHeight - 0.5;
    const double w = std::clamp(z * layers() - 0.5, 0.0, layers() - 1.0);
    const double x0 = std::floor(x);
    const double y0 = std::floor(y);
    const int k0 = static_cast<int>(w);
    const int k1 = std::min(k0 + 1, layers() - 1);
    const auto whole = [](double i) { return static_cast<std::int64_t>(std::clamp(i, -0x1p53, 0x1p53)); };
    const auto column = [&](double i, double j) {
        const int bx = addressIndex(whole(i), nx(), address);
        const int by = addressIndex(whole(j), ny(), address);
        const double below = static_cast<double>(values(bx, by, k0));
        return below + (w - k0) * (static_cast<double>(values(bx, by, k1)) - below);
    };
    const double top = column(x0, y0) + (x - x0) * (column(x0 + 1, y0) - column(x0, y0));
    const double bottom = column(x0, y0 + 1) + (x - x0) * (column(x0 + 1, y0 + 1) - column(x0, y0 + 1));
    return top + (y - y0) * (bottom - top);
}

DistanceShape distanceMapShape(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field) {
    const CellGrid grid(field);
    const bool boxes = ofBoxes(kind);
    const int sectors = kind == DistanceKind::Refined ? parameters.sectors : 1;
    return {voxelsAcross(boxes ? grid.x.cells : field.width(), parameters.footprint),
            voxelsAcross(boxes ? grid.y.cells : field.height(), parameters.footprint), parameters.layers * sectors};
}

std::size_t distanceMapBytes(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field) {
    const Shape shape = distanceMapShape(kind, parameters, field);
    return static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny) *
           static_cast<std::size_t>(shape.planes) * bytesEach(parameters.precision);
}

namespace {

// Estimated memory for building. All values are floats until the last is known. Scratch memory: for Euclidean maps some
// pictures of a layer per thread, for conservative ones the heights of the cells, for refined ones tables of the
// smallest height along rows and columns.
std::uint64_t distanceBuildBytes(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field,
                                 Work& work) {
    const Shape shape = distanceMapShape(kind, parameters, field);
    const std::size_t codes = parameters.precision == Precision::Float ? 0 : bytesEach(parameters.precision);
    constexpr std::uint64_t kFloat = sizeof(float), kCells = 4 * kFloat, kLayers = 3 * kFloat;
    const bool euclidean = kind == DistanceKind::Euclidean || kind == DistanceKind::EuclideanConservative;
    std::uint64_t each = kCells;
    if (euclidean) each += kLayers * static_cast<std::uint64_t>(work.threads().size());
    if (kind == DistanceKind::Refined) {
        const auto levels = [](int size) {
            return static_cast<std::uint64_t>(std::bit_width(static_cast<unsigned>(size)));
        };
        each += kFloat * (levels(field.width()) + levels(field.height()) + 1);
    }
    return byteSum({byteProduct({static_cast<std::uint64_t>(shape.nx), static_cast<std::uint64_t>(shape.ny),
                                 static_cast<std::uint64_t>(shape.planes), kFloat + codes}),
                    bytesForTexels(field, each)});
}

}  // namespace

DistanceMap buildDistanceMap(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field,
                             Work& work, MakeExactHits exactHits) {
    if (kind == DistanceKind::Refined && field.address() == Address::Clamp) {
        throw InputError("--address",
                         Message(MessageId::MapNotUnderClamp, {{"map", std::string(distanceKindName(kind))}}));
    }
    const Shape shape = distanceMapShape(kind, parameters, field);
    DistanceMap map;
    map.kind = kind;
    map.parameters = parameters;
    setField(map, field);
    map.slabTexels = field.slabTexels();
    map.cap = std::numeric_limits<double>::infinity();
    if (map.rays() == RayClass::ViewRays) {
        map.maxRun = field.slabTexels() / std::tan(parameters.flattest * std::numbers::pi / 180);
    }
    UnfilledVector<float> values(static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny) *
                                 static_cast<std::size_t>(shape.planes));
    const bool byRows = kind == DistanceKind::Euclidean && parameters.to == DistanceTo::Surface;
    work.progress().begin(std::string("map ") + std::string(distanceKindName(kind)), byRows ? shape.ny : map.layers());
    switch (kind) {
        case DistanceKind::Euclidean:
            parameters.to == DistanceTo::Surface ? toSurface(map, shape, field, values, work)
                                                 : toVoxel(map, shape, field, values, work);
            break;
        case DistanceKind::EuclideanConservative:
            euclideanConservative(map, shape, CellHeights(field, work), field.address() == Address::Repeat,
                                  field.slabTexels(), values, work);
            break;
        case DistanceKind::RefinedSampled:
            if (exactHits == nullptr) throw std::logic_error("refined-sampled: nothing traces its rays");
            refinedSampled(map, shape.nx, shape.ny, field, exactHits(field, work), values, work);
            break;
        case DistanceKind::Refined:
            refinedConservative(map, shape.nx, shape.ny, field, CellHeights(field, work), values, work);
            break;
    }
    map.values =
        StoredValues(shape.nx, shape.ny, shape.planes, std::move(values), parameters.precision, Rounding::Down);
    return map;
}

MapKey distanceMapKey(DistanceKind kind, const DistanceParameters& parameters, const HeightField& field) {
    std::string key(distanceKindName(kind));
    for (const std::string_view name : {surfaceName(field.surface()), addressName(field.address())}) {
        key.append("/").append(name);
    }
    for (const double number : {field.reliefDepth(), parameters.flattest, static_cast<double>(parameters.footprint),
                                static_cast<double>(parameters.layers), static_cast<double>(parameters.horizons),
                                static_cast<double>(parameters.sectors), static_cast<double>(parameters.directions)}) {
        key.append("/").append(numberText(number));
    }
    key.append("/").append(precisionName(parameters.precision)).append("/").append(distanceToName(parameters.to));
    return {key, field.sharedHeights()};
}

std::shared_ptr<const DistanceMap> distanceMap(DistanceKind kind, const DistanceParameters& parameters,
                                               const HeightField& field, MapCache& cache, Work& work,
                                               MakeExactHits exactHits) {
    checkMapMemory(std::string(distanceKindName(kind)), distanceMapBytes(kind, parameters, field), cache);
    return cache.get<DistanceMap>(distanceMapKey(kind, parameters, field),
                                  distanceBuildBytes(kind, parameters, field, work), work,
                                  [&](Work& w) { return buildDistanceMap(kind, parameters, field, w, exactHits); });
}

}  // namespace relief
