// Distance maps against all pairs of voxels and cells, and their bounds against the surface itself.
#include "relief/maps/distance_map.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <unistd.h>

#include "brute_cells.h"
#include "relief/errors.h"
#include "relief/maps/refined.h"
#include "relief/methods/distance_options.h"
#include "resource_limit.h"

namespace relief::test {
namespace {

// Squares, roots and the envelope are computed in float.
constexpr double kFloatRounding = 1e-5;

const std::vector<std::pair<int, int>>& sizes() {
    static const std::vector<std::pair<int, int>> all{{13, 9}, {16, 8}, {1, 5}};
    return all;
}

DistanceMap built(DistanceKind kind, int footprint, int layers, const HeightField& field,
                  DistanceTo to = DistanceTo::Surface) {
    Work work(2);
    DistanceParameters parameters;
    parameters.to = to;
    parameters.footprint = footprint;
    parameters.layers = layers;
    return buildDistanceMap(kind, parameters, field, work, &exactHits);
}

// Some layers are free everywhere.
constexpr float kHighest = 0.7F;

// Calls body(field, footprint, layers) over surfaces, addresses, sizes and voxel shapes.
template <class Body>
void overFields(const Body& body) {
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const auto& [width, height] : sizes()) {
                FloatImage heights = *randomHeights(width, height, 31);
                for (float& h : heights.pixels()) h *= kHighest;
                const HeightField field(share(std::move(heights)), surface, address, 0.4);
                for (const auto& [footprint, layers] : {std::pair(1, 8), std::pair(3, 10)}) {
                    SCOPED_TRACE(describe(field) + ", F " + std::to_string(footprint));
                    body(field, footprint, layers);
                    if (testing::Test::HasFatalFailure()) return;
                }
            }
        }
    }
}

TEST(EuclideanMap, IsTheDistanceBetweenVoxelCentres) {
    overFields([](const HeightField& field, int footprint, int layers) {
        const DistanceMap map = built(DistanceKind::Euclidean, footprint, layers, field, DistanceTo::Voxel);
        const int nx = (field.width() + footprint - 1) / footprint;
        const int ny = (field.height() + footprint - 1) / footprint;
        ASSERT_EQ(map.nx(), nx);
        ASSERT_EQ(map.ny(), ny);
        const double dx = static_cast<double>(field.width()) / nx;
        const double dy = static_cast<double>(field.height()) / ny;
        const double dz = field.slabTexels() / layers;
        const bool wraps = field.address() == Address::Repeat;
        const auto axisWay = [&](int a, int b, int n) {
            const int d = std::abs(a - b);
            return wraps ? std::min(d, n - d) : d;
        };
        const auto distance = [&](int x, int y, int k) {
            double least = 1e30;
            for (int j = 0; j < ny; ++j) {
                for (int i = 0; i < nx; ++i) {
                    // Solid voxels of the column: those whose centre is not above the surface, and all below the slab.
                    const double surface = field.at((i + 0.5) * dx, (j + 0.5) * dy);
                    for (int q = -1; q < layers; ++q) {
                        if (q >= 0 && (q + 0.5) / layers > surface) break;
                        least = std::min(least, std::hypot(axisWay(x, i, nx) * dx, axisWay(y, j, ny) * dy,
                                                           std::max(k - q, q - k) * dz));
                    }
                }
            }
            return least;
        };
        for (int k = 0; k < layers; ++k) {
            for (int y = 0; y < ny; ++y) {
                for (int x = 0; x < nx; ++x) {
                    const double want = distance(x, y, k);
                    ASSERT_NEAR(map.at(x, y, k, 0), want, kFloatRounding * (1 + want)) << x << ", " << y << ", " << k;
                }
            }
        }
    });
}

// The distance lies between two bounds from small squares of the surface: the box under a square's highest corner is at
// most as far, its corners at least.
TEST(EuclideanMap, IsTheDistanceToTheSurface) {
    constexpr int kSquares = 8;  // per texel; the borders of patches coincide with square borders
    constexpr double kSide = 1.0 / kSquares;
    double widest = 0;
    overFields([&](const HeightField& field, int footprint, int layers) {
        const DistanceMap map = built(DistanceKind::Euclidean, footprint, layers, field);
        const double slab = field.slabTexels();
        const bool wraps = field.address() == Address::Repeat;
        const bool columns = field.surface() == Surface::Columns;
        struct Square {
            double s, t, low, high;
        };
        std::vector<Square> squares;
        for (int y = 0; y < field.height() * kSquares; ++y) {
            for (int x = 0; x < field.width() * kSquares; ++x) {
                const double s = (x + 0.5) * kSide;
                const double t = (y + 0.5) * kSide;
                Square square{s, t, 1, 0};
                for (const auto& [u, v] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}}) {
                    const double h = columns ? field.at(s, t) : field.at(s + u * kSide, t + v * kSide);
                    square.low = std::min(square.low, h);
                    square.high = std::max(square.high, h);
                }
                squares.push_back(square);
            }
        }
        const auto apart = [&](double a, double b, double size) {
            const double d = std::abs(a - b);
            return wraps ? std::min(d, size - d) : d;
        };
        for (int k = 0; k < layers; k += 3) {
            const double z = (k + 0.5) / layers;
            for (int by = 0; by < map.ny(); by += 2) {
                for (int bx = 0; bx < map.nx(); ++bx) {
                    const double s = map.centreS(bx);
                    const double t = map.centreT(by);
                    double nearest = 1e30;
                    double farthest = 1e30;
                    for (const Square& square : squares) {
                        const double ds = apart(s, square.s, field.width());
                        const double dt = apart(t, square.t, field.height());
                        nearest =
                            std::min(nearest, std::hypot(std::max(ds - kSide / 2, 0.0), std::max(dt - kSide / 2, 0.0),
                                                         std::max(z - square.high, 0.0) * slab));
                        farthest = std::min(
                            farthest, std::hypot(ds + kSide / 2, dt + kSide / 2, std::max(z - square.low, 0.0) * slab));
                    }
                    const auto got = static_cast<double>(map.at(bx, by, k, 0));
                    if (field.at(s, t) >= z) {
                        ASSERT_EQ(got, 0);
                        continue;
                    }
                    constexpr double kPatchSearch = 1e-4;  // SurfaceDistance
                    ASSERT_GE(got, nearest - kPatchSearch) << bx << ", " << by << ", " << k;
                    ASSERT_LE(got, farthest + kPatchSearch) << bx << ", " << by << ", " << k;
                    widest = std::max(widest, got);
                }
            }
        }
    });
    EXPECT_GT(widest, 0.5);
}

// Beside a wall, and farther from the floor: no rounding adds up along the row.
TEST(EuclideanMap, GrowsEvenlyAlongARowAwayFromAWall) {
    FloatImage image(1301, 1, 0.0F);
    image(0, 0) = 1;
    const HeightField field(share(std::move(image)), Surface::Columns, Address::Clamp, 10);
    const DistanceMap map = built(DistanceKind::Euclidean, 2, 1, field);
    for (int x = 1; x < map.nx(); ++x) ASSERT_EQ(map.at(x, 0, 0, 0), static_cast<float>(map.centreS(x) - 1)) << x;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // the sanitizers reserve terabytes
// The gigabytes that building a map of 2048 x 2048 texels is refused for, when 32 MiB are free.
std::string gigabytesRefused(DistanceKind kind) {
    const HeightField field(constantHeights(2048, 2048, 0.5F), Surface::Bilinear, Address::Repeat, 0.1);
    DistanceParameters parameters;
    parameters.footprint = 64;
    Work work(2);
    MapCache cache;
    std::ifstream statm("/proc/self/statm");
    rlim_t pages = 0;  // the sixth number: data
    for (int n = 0; n < 6; ++n) statm >> pages;
    const ResourceLimit limit(RLIMIT_DATA, pages * static_cast<rlim_t>(getpagesize()) + (rlim_t{32} << 20U));
    try {
        distanceMap(kind, parameters, field, cache, work, &exactHits);
    } catch (const MemoryError& error) {
        const std::string text = error.what();
        const auto begin = text.find(": ") + 2;
        return text.substr(begin, text.find(" GB") - begin);
    }
    ADD_FAILURE() << "was not refused";
    return "0";
}

// Both Euclidean kinds keep pictures of a layer for each thread.
TEST(DistanceMap, EuclideanKindsAreRefusedForTheMemoryOfTheirLayers) {
    const std::string needed = gigabytesRefused(DistanceKind::Euclidean);
    EXPECT_EQ(needed, gigabytesRefused(DistanceKind::EuclideanConservative));
    EXPECT_GT(std::stod(needed), 1.5 * std::stod(gigabytesRefused(DistanceKind::RefinedSampled)));
}
#endif

// [DIST17]: the distance along the remaining rays is never smaller than the distance to the surface.
TEST(RefinedSampledMap, IsNowhereSmallerThanTheEuclideanOne) {
    int larger = 0;
    overFields([&](const HeightField& field, int footprint, int layers) {
        const DistanceMap euclidean = built(DistanceKind::Euclidean, footprint, layers, field);
        const DistanceMap refined = built(DistanceKind::RefinedSampled, footprint, layers, field);
        ASSERT_EQ(euclidean.nx(), refined.nx());
        ASSERT_EQ(euclidean.ny(), refined.ny());
        for (int k = 0; k < layers; ++k) {
            for (int y = 0; y < euclidean.ny(); ++y) {
                for (int x = 0; x < euclidean.nx(); ++x) {
                    constexpr float kPatchSearch = 1e-4F;  // SurfaceDistance
                    const float plain = euclidean.at(x, y, k, 0);
                    ASSERT_GE(refined.at(x, y, k, 0), plain - kPatchSearch) << x << ", " << y << ", " << k;
                    larger += refined.at(x, y, k, 0) > plain + 0.1F ? 1 : 0;
                }
            }
        }
    });
    EXPECT_GT(larger, 100);
}

// From the flattest ray downwards in equal steps of the sine, each turned from s to t by the golden angle.
TEST(RefinedSampledMap, DirectionsFollowAGoldenSpiral) {
    constexpr int kCount = 30;
    constexpr double kSlab = 5, kRun = 12, kSinFlattest = 5.0 / 13, kGoldenDegrees = 137.50776405003785;
    const std::vector<SampledDirection> directions = sampledDirections(kCount, kSlab, kRun);
    ASSERT_EQ(directions.size(), std::size_t{kCount});
    for (int i = 0; i < kCount; ++i) {
        const SampledDirection& one = directions[static_cast<std::size_t>(i)];
        EXPECT_NEAR(one.length, std::hypot(one.a, one.b, kSlab), 1e-12);
        EXPECT_NEAR(kSlab / one.length, kSinFlattest + (1 - kSinFlattest) * (i + 0.5) / kCount, 1e-12);
        const double degrees = std::atan2(one.b, one.a) * 180 / std::numbers::pi;
        EXPECT_NEAR(std::remainder(degrees - kGoldenDegrees * i, 360), 0, 1e-9) << i;
    }
}

struct BoxCells {
    int x0, x1, y0, y1;
};
BoxCells cellsOf(const BruteCells& cells, int bx, int by, int f) {
    return {bx * f, std::min((bx + 1) * f, cells.nx), by * f, std::min((by + 1) * f, cells.ny)};
}

TEST(ConservativeMap, IsTheBoundOfEveryBoxWithItsMarks) {
    overFields([](const HeightField& field, int footprint, int layers) {
        const DistanceMap map = built(DistanceKind::EuclideanConservative, footprint, layers, field);
        const BruteCells cells(field);
        ASSERT_EQ(map.nx(), (cells.nx + footprint - 1) / footprint);
        for (int k = 0; k < layers; ++k) {
            const double z0 = static_cast<double>(k) / layers;
            const double z1 = static_cast<double>(k + 1) / layers;
            for (int by = 0; by < map.ny(); ++by) {
                for (int bx = 0; bx < map.nx(); ++bx) {
                    const BoxCells box = cellsOf(cells, bx, by, footprint);
                    double high = 0;
                    double low = 1;
                    double least = 1e30;
                    cells.each([&](int i, int j, double top) {
                        if (i >= box.x0 && i < box.x1 && j >= box.y0 && j < box.y1) {
                            high = std::max(high, top);
                            low = std::min(low, static_cast<double>(cells.lowest(i, j)));
                        }
                        const double wayX = std::max({0, box.x0 - (i + 1), i - box.x1});
                        const double wayY = std::max({0, box.y0 - (j + 1), j - box.y1});
                        const double drop = std::max(z0 - top, 0.0) * field.slabTexels();
                        least = std::min(least, std::hypot(wayX, wayY, drop));
                    });
                    const float got = map.at(bx, by, k, 0);
                    if (z0 <= high || k == 0) {
                        ASSERT_EQ(got, z1 <= low ? StoredValues::kBuried : StoredValues::kSurface) << bx << ", " << by;
                        continue;
                    }
                    ASSERT_NEAR(got, least, kFloatRounding * (1 + least)) << bx << ", " << by << ", " << k;
                    ASSERT_LE(got, least) << bx << ", " << by << ", " << k;
                }
            }
        }
    });
}

// Dense points of the surface, including the walls of columns.
struct SurfacePoint {
    double s, t, z;
};
std::vector<SurfacePoint> surfacePoints(const HeightField& field, const BruteCells& cells) {
    constexpr int kEach = 4;    // per texel
    constexpr int kBeyond = 8;  // texels beyond the picture
    std::vector<SurfacePoint> points;
    for (int j = -kBeyond * kEach; j <= (field.height() + kBeyond) * kEach; ++j) {
        for (int i = -kBeyond * kEach; i <= (field.width() + kBeyond) * kEach; ++i) {
            const double s = static_cast<double>(i) / kEach;
            const double t = static_cast<double>(j) / kEach;
            if (!cells.holds(s, t)) continue;
            // On the line between columns the higher one counts: the nearest point may lie on the edge of a wall.
            double z = 0;
            for (const double x : {-1e-9, 1e-9}) {
                for (const double y : {-1e-9, 1e-9}) z = std::max(z, field.at(s + x, t + y));
            }
            points.push_back({s, t, z * field.slabTexels()});
        }
    }
    return points;
}

TEST(ConservativeMap, IsNeverAboveTheDistanceOfAPointOfTheBox) {
    overFields([](const HeightField& field, int footprint, int layers) {
        constexpr int kPointsEach = 3;
        const DistanceMap map = built(DistanceKind::EuclideanConservative, footprint, layers, field);
        const BruteCells cells(field);
        const std::vector<SurfacePoint> surface = surfacePoints(field, cells);
        Random random(9);
        int looked = 0;
        for (int k = 1; k < layers; ++k) {
            for (int by = 0; by < map.ny(); ++by) {
                for (int bx = 0; bx < map.nx(); ++bx) {
                    const double bound = static_cast<double>(map.at(bx, by, k, 0));
                    if (bound < 0) continue;
                    const BoxCells box = cellsOf(cells, bx, by, footprint);
                    for (int n = 0; n < kPointsEach; ++n) {
                        const double s = random.between(box.x0, box.x1) - cells.shift;
                        const double t = random.between(box.y0, box.y1) - cells.shift;
                        if (!cells.holds(s, t)) continue;
                        const double z = (k + (n == 0 ? 0 : random.unit())) / layers * field.slabTexels();
                        double squared = 1e30;
                        for (const SurfacePoint& p : surface) {
                            const double drop = std::max(z - p.z, 0.0);  // below a surface point everything is solid
                            squared = std::min(squared, (s - p.s) * (s - p.s) + (t - p.t) * (t - p.t) + drop * drop);
                        }
                        ASSERT_LE(bound, std::sqrt(squared)) << bx << ", " << by << ", " << k;
                        ++looked;
                    }
                }
            }
        }
        EXPECT_GT(looked, 5);
    });
}

TEST(RefinedMap, IsRefusedUnderClamp) {
    const HeightField field(randomHeights(8, 8, 1), Surface::Bilinear, Address::Clamp, 0.2);
    EXPECT_THROW(built(DistanceKind::Refined, 4, 8, field), InputError);
    MapCache cache;
    Work work(1);
    EXPECT_THROW(distanceMap(DistanceKind::Refined, {}, field, cache, work), InputError);
    EXPECT_NO_THROW(built(DistanceKind::EuclideanConservative, 4, 8, field));
}

// Interpolation between the centres of eight voxels by its definition, in any cell and across the seam.
TEST(DistanceMap, trilinearWeighsTheEightVoxelsAround) {
    const HeightField field(randomHeights(12, 8, 17), Surface::Bilinear, Address::Repeat, 0.3);
    const DistanceMap map = built(DistanceKind::Euclidean, 2, 5, field);
    Random random(18);
    for (int n = 0; n < 500; ++n) {
        const double s = random.between(-15, 30), t = random.between(-10, 20), z = random.between(0, 1);
        const double at[3] = {s / 2 - 0.5, t / 2 - 0.5, std::clamp(z * 5 - 0.5, 0.0, 4.0)};
        double expected = 0;
        for (int corner = 0; corner < 8; ++corner) {
            double weight = 1;
            int voxel[3];
            for (int axis = 0; axis < 3; ++axis) {
                const double first = std::floor(at[axis]), share = at[axis] - first;
                const bool second = (corner >> axis & 1) != 0;
                voxel[axis] = static_cast<int>(first) + (second ? 1 : 0);
                weight *= second ? share : 1 - share;
            }
            const auto around = [](int i, int size) { return ((i % size) + size) % size; };
            const float value =
                map.at(around(voxel[0], map.nx()), around(voxel[1], map.ny()), std::min(voxel[2], 4), 0);
            expected += weight * static_cast<double>(value);
        }
        EXPECT_NEAR(map.trilinear(s, t, z), expected, 1e-12 * (1 + std::abs(expected)));
    }
    // At the top only the last layer counts, whatever is stored behind it.
    DistanceMap followed = map;
    followed.parameters.layers = 4;
    auto values = std::get<0>(map.values.codes());
    std::fill(values.end() - std::ptrdiff_t{map.nx()} * map.ny(), values.end(), std::numeric_limits<float>::infinity());
    followed.values = StoredValues(map.nx(), map.ny(), 5, std::move(values), 0);
    EXPECT_DOUBLE_EQ(followed.trilinear(map.centreS(1), map.centreT(2), 1), static_cast<double>(map.at(1, 2, 3, 0)));
}

}  // namespace
}  // namespace relief::test
