#include "measuring/verify/certificate_bounds.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "measuring/verify/azimuth_geometry.h"
#include "measuring/verify/cell_search.h"
#include "measuring/verify/horizon_scan.h"

namespace relief {

namespace {

// Checks rows in parallel and joins the results in the order of rows.
template <class Row>
BoundCheck overRows(const char* what, int rows, Work& work, const Row& row) {
    std::vector<BoundCheck> parts(static_cast<std::size_t>(rows));
    work.progress().begin(what, rows);
    parallelFor(work, rows, [&](int y) {
        row(y, parts[static_cast<std::size_t>(y)]);
        work.progress().advance();
    });
    BoundCheck all;
    for (const BoundCheck& part : parts) {
        all.values += part.values;
        all.broken += part.broken;
        for (const BrokenBound& broken : part.first) {
            if (all.first.size() < kBrokenKept) all.first.push_back(broken);
        }
    }
    return all;
}

void note(BoundCheck& part, const BrokenBound& broken) {
    ++part.broken;
    if (part.first.size() < kBrokenKept) part.first.push_back(broken);
}

class DistanceCheck {
  public:
    DistanceCheck(const DistanceMap& map, const HeightField& field, Work& work)
        : map_(map),
          cells_(field, work),
          horizons_(field, map.slabTexels, map.maxRun, map.kind == DistanceKind::Refined ? map.parameters.horizons : 0),
          leastSlope_(map.kind == DistanceKind::Refined ? map.slabTexels / map.maxRun : 0) {}

    void row(int by, BoundCheck& part) const {
        HorizonGates gates;
        std::vector<double> slopes(static_cast<std::size_t>(std::max(horizons_.sectors(), 1)), 0.0);
        const int f = map_.parameters.footprint;
        const int width = cells_.highest().width();
        const int height = cells_.highest().height();
        for (int bx = 0; bx < map_.nx(); ++bx) {
            const CellBox box{bx * f, std::min((bx + 1) * f, width), by * f, std::min((by + 1) * f, height)};
            horizons_.collect(box.x0, box.x1, box.y0, box.y1, gates);
            for (int k = 0; k < map_.layers(); ++k) {
                const double z1 = static_cast<double>(k + 1) / map_.layers() * map_.slabTexels;
                for (int h = 0; h < horizons_.sectors(); ++h) {
                    slopes[static_cast<std::size_t>(h)] = gates.leastSlope(h, z1, leastSlope_);
                }
                for (int s = 0; s < sectors(); ++s) value(box, {.i = bx, .j = by, .k = k, .sector = s}, slopes, part);
            }
        }
    }

  private:
    int sectors() const { return map_.kind == DistanceKind::Refined ? map_.parameters.sectors : 1; }

    double highestIn(const CellBox& box) const {
        float highest = 0;
        for (int y = box.y0; y < box.y1; ++y) {
            for (int x = box.x0; x < box.x1; ++x) highest = std::max(highest, cells_.highest()(x, y));
        }
        return static_cast<double>(highest);
    }

    void value(const CellBox& box, BrokenBound place, const std::vector<double>& slopes, BoundCheck& part) const {
        ++part.values;
        place.stored = static_cast<double>(map_.at(place.i, place.j, place.k, place.sector));
        if (place.stored < 0) return;  // marked voxel: its cells are intersected one by one
        place.cellX = box.x0;
        place.cellY = box.y0;
        if (std::isnan(place.stored)) {
            place.what = BrokenBound::What::NotANumber;
            note(part, place);
            return;
        }
        const double z0 = static_cast<double>(place.k) / map_.layers();
        // Layer 0 includes height 0, where the surface may lie, so all of its voxels must be marked.
        if (place.k == 0 || z0 < highestIn(box)) {
            place.what = BrokenBound::What::Free;
            note(part, place);
            return;
        }
        place.bound = nearest(box, z0, place, slopes);
        if (place.stored > place.bound) note(part, place);
    }

    // Returns the bound if it is below the stored value, or else the stored value.
    double nearest(const CellBox& box, double z0, BrokenBound& place, const std::vector<double>& slopes) const {
        const int perSector = horizons_.sectors() / sectors();
        const int firstHorizon = place.sector * perSector;
        double flattest = perSector == 0 ? 0.0 : std::numeric_limits<double>::infinity();
        for (int h = firstHorizon; h < firstHorizon + perSector; ++h) {
            flattest = std::min(flattest, slopes[static_cast<std::size_t>(h)]);
        }
        double best = place.stored;
        const auto distance = [&](double way, double highest, double slope) {
            const double fall = std::max({(z0 - highest) * map_.slabTexels, way * slope, 0.0});
            return std::sqrt(way * way + fall * fall);
        };
        // No bound exceeds the distance straight down onto the box's own cells.
        const double reach = std::min(best, map_.slabTexels);
        cells_.visit(
            box, reach, [&](double gap, double highest) { return distance(gap, highest, flattest) < best; },
            [&](int x, int y, double gap, double highest) {
                double found = perSector == 0 ? distance(gap, highest, 0) : std::numeric_limits<double>::infinity();
                for (int h = firstHorizon; h < firstHorizon + perSector; ++h) {
                    const double way = wayTowards(box, x, y, h);
                    if (std::isinf(way)) continue;
                    found = std::min(found, distance(way, highest, slopes[static_cast<std::size_t>(h)]));
                }
                if (!(found < best)) return;
                best = found;
                place.cellX = x;
                place.cellY = y;
            });
        return best;
    }

    // Returns the distance from the box to the cell within a horizon sector. The quadrant of a direction is exact if
    // the tracers never determine sectors by a rounded angle across an axis.
    double wayTowards(const CellBox& box, int x, int y, int horizon) const {
        const bool byQuadrants = horizons_.sectors() % 4 == 0 && (sectors() == 1 || sectors() % 4 == 0);
        const VectorRange range{static_cast<double>(x - box.x1), static_cast<double>(x + 1 - box.x0),
                                static_cast<double>(y - box.y1), static_cast<double>(y + 1 - box.y0)};
        return shortestInSector(range, horizon, horizons_.sectors(), byQuadrants);
    }

    const DistanceMap& map_;
    CellSearch cells_;
    HorizonScan horizons_;
    double leastSlope_;
};

class ConeCheck {
  public:
    ConeCheck(const ConeMap& map, const HeightField& field, Work& work)
        : map_(map), cells_(field, work), unbounded_(field.address() == Address::Clamp) {}

    void row(int y, BoundCheck& part) const {
        for (int x = 0; x < map_.nx(); ++x) {
            for (int s = 0; s < map_.parameters.sectors; ++s) value({.i = x, .j = y, .sector = s}, part);
        }
    }

  private:
    void value(BrokenBound place, BoundCheck& part) const {
        ++part.values;
        const auto apex = static_cast<double>(map_.apex(place.i, place.j, 0));
        const auto kappa = static_cast<double>(map_.slopes(place.i, place.j, place.sector));
        place.cellX = place.i;
        place.cellY = place.j;
        place.stored = kappa;
        if (!(apex >= 0) || !(kappa >= 0)) {
            place.what = BrokenBound::What::NotANumber;
            place.stored = apex >= 0 ? kappa : apex;
            note(part, place);
            return;
        }
        // No cell is higher than this, so cells beyond rise / kappa cannot stand out of the cone.
        const double rise = cells_.highestOfAll() - apex;
        if (rise <= 0) return;
        const double farthest = kPeriods * (map_.nx() + map_.ny());
        const double reach = kappa * farthest > rise ? rise / kappa : farthest;
        const CellBox box{place.i, place.i + 1, place.j, place.j + 1};
        double worst = 0;  // largest height by which a cell stands out of the cone
        cells_.visit(
            box, reach, [&](double gap, double highest) { return highest - apex - kappa * gap > worst; },
            [&](int x, int y, double gap, double highest) {
                if (!seen(place, x, y)) return;
                worst = highest - apex - kappa * gap;
                place.what = gap > 0 ? BrokenBound::What::Slope : BrokenBound::What::Apex;
                place.stored = gap > 0 ? kappa : apex;
                place.bound = gap > 0 ? (highest - apex) / gap : highest;
                place.cellX = x;
                place.cellY = y;
            });
        if (worst > 0) note(part, place);
    }

    // Returns true if the cell is visible in the sector; under clamp the outermost cells extend to infinity.
    bool seen(const BrokenBound& place, int x, int y) const {
        if (map_.parameters.sectors == 1) return true;
        constexpr double kFar = 1e9;
        const auto side = [&](int from, int to, int cells, double& low, double& high) {
            low = to - (from + 1);
            high = to + 1 - from;
            if (unbounded_ && (from == cells - 1 || to == 0)) low = -kFar;
            if (unbounded_ && (from == 0 || to == cells - 1)) high = kFar;
        };
        double x0 = 0;
        double x1 = 0;
        double y0 = 0;
        double y1 = 0;
        side(place.i, x, map_.nx(), x0, x1);
        side(place.j, y, map_.ny(), y0, y1);
        return AzimuthRange({x0, x1, y0, y1}).meets(place.sector, map_.parameters.sectors);
    }

    // Within this many periods there is a copy of every cell in every sector of at least 45 degrees.
    static constexpr double kPeriods = 4;

    const ConeMap& map_;
    CellSearch cells_;
    bool unbounded_;
};

}  // namespace

BoundCheck checkDistanceBounds(const DistanceMap& map, const HeightField& field, Work& work) {
    assert(ofBoxes(map.kind) && map.fieldWidth == field.width() && map.fieldHeight == field.height());
    const DistanceCheck check(map, field, work);
    return overRows("checking voxels", map.ny(), work, [&](int by, BoundCheck& part) { check.row(by, part); });
}

BoundCheck checkConeBounds(const ConeMap& map, const HeightField& field, Work& work) {
    assert(map.kind == ConeKind::Conservative && map.fieldWidth == field.width() && map.fieldHeight == field.height());
    const ConeCheck check(map, field, work);
    return overRows("checking cones", map.ny(), work, [&](int y, BoundCheck& part) { check.row(y, part); });
}

std::string brokenBoundText(const BrokenBound& broken, const HeightField& field) {
    using What = BrokenBound::What;
    constexpr int kDigits = 6;
    const CellGrid grid(field);
    const auto cell = [&](int x, int y) {
        return "cell (" + std::to_string(x + grid.x.firstName) + ", " + std::to_string(y + grid.y.firstName) + ")";
    };
    const bool cone = broken.what == What::Apex || broken.what == What::Slope;
    const std::string sector = ", sector " + std::to_string(broken.sector) + ": ";
    const std::string voxel = "voxel (" + std::to_string(broken.i) + ", " + std::to_string(broken.j) + ", " +
                              std::to_string(broken.k) + ")" + sector;
    const std::string place = cone ? cell(broken.i, broken.j) + sector : voxel;
    const std::string numbers = numberText(broken.stored, kDigits) + " is stored, but must be at " +
                                (cone ? "least " : "most ") + numberText(broken.bound, kDigits) + " because of " +
                                cell(broken.cellX, broken.cellY);
    switch (broken.what) {
        case What::Free:
            return place + "marked as free, but contains a part of the surface";
        case What::NotANumber:
            return "value (" + std::to_string(broken.i) + ", " + std::to_string(broken.j) + ", " +
                   std::to_string(broken.k) + ")" + sector + numberText(broken.stored) +
                   " is stored, which is not a valid value";
        case What::Distance:
            return place + "distance " + numbers;
        case What::Apex:
            return place + "apex " + numbers;
        case What::Slope:
            return place + "slope " + numbers;
    }
    return place;
}

}  // namespace relief
