#include "measuring/verify/engine_bounds.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/parallel.h"
#include "measuring/verify/cell_search.h"
#include "relief/leaf.h"

namespace relief {

namespace {

class ConeProof {
  public:
    ConeProof(const HeightField& field, const FloatImage& codes, const ConeCoding& coding, Work& work)
        : grid_(field),
          address_(field.address()),
          cells_(field, work),
          lowest_(grid_.x.cells, grid_.y.cells),
          steepest_(grid_.x.cells, grid_.y.cells),
          slopes_(grid_.x.cells, grid_.y.cells) {
        parallelFor(work, grid_.y.cells, [&](int y) {
            for (int x = 0; x < grid_.x.cells; ++x) cell(field, codes, coding, x, y);
        });
    }

    int width() const { return grid_.x.cells; }
    int height() const { return grid_.y.cells; }

    void check(int x, int y, EngineBoundCheck& part) const {
        ++part.cells;
        const double slope = slopes_(x, y);
        const CellBox box{x, x + 1, y, y + 1};
        OpenBound open{x + grid_.x.firstName, y + grid_.y.firstName, slope, slope, 0, 0};
        const auto raise = [&](double needed, int otherX, int otherY) {
            if (!(needed > open.needed)) return;
            open.needed = needed;
            open.otherX = otherX + grid_.x.firstName;
            open.otherY = otherY + grid_.y.firstName;
        };
        std::array<double, kRings + 1> gradients{};
        int known = 0;
        gradients[0] = static_cast<double>(steepest_(x, y));
        const auto gradientWithin = [&](int ring) {
            for (; known < ring; ++known)
                gradients[static_cast<std::size_t>(known) + 1] =
                    around(x, y, known + 1, gradients[static_cast<std::size_t>(known)]);
            return gradients[static_cast<std::size_t>(ring)];
        };
        raise(gradientWithin(1), x, y);
        const double low = lowest_(x, y);
        const double rise = cells_.highestOfAll() - low;
        const double far = kPeriods * (width() + height());
        const double reach = slope * far > rise ? rise / slope : far;
        cells_.visit(
            box, reach, [&](double gap, double highest) { return highest - low > open.needed * gap; },
            [&](int cx, int cy, double gap, double highest) {
                if (!(gap > 0)) return;  // within the first ring
                double needed = (highest - low) / gap;
                const int ring = std::max(std::abs(cx - x), std::abs(cy - y));
                if (ring <= kRings) needed = std::min(needed, gradientWithin(ring));
                raise(needed, cx, cy);
            });
        if (!(open.needed > slope)) return;
        ++part.open;
        if (!part.first) part.first = open;
    }

  private:
    void cell(const HeightField& field, const FloatImage& codes, const ConeCoding& coding, int x, int y) {
        const auto [h00, h10, h01, h11] = cellCorners<double>(field.heights(), grid_, x, y);
        lowest_(x, y) = std::min(std::min(h00, h10), std::min(h01, h11));
        double steepest = 0;
        for (const double across : {h10 - h00, h11 - h01}) {
            for (const double down : {h01 - h00, h11 - h10}) steepest = std::max(steepest, std::hypot(across, down));
        }
        steepest_(x, y) = steepest;
        double least = std::numeric_limits<double>::infinity();
        for (const double code : cellCorners<double>(codes, grid_, x, y)) {
            least = std::min(least, coding.slope(code, field.width(), field.height()));
        }
        slopes_(x, y) = least;
    }

    // The steepest gradient of the cells at most `ring` away, those nearer being known.
    double around(int x, int y, int ring, double nearer) const {
        double steepest = nearer;
        const auto raise = [&](int dx, int dy) {
            const int i = addressIndex(x + dx, width(), address_);
            const int j = addressIndex(y + dy, height(), address_);
            steepest = std::max(steepest, steepest_(i, j));
        };
        for (int n = -ring; n <= ring; ++n) {
            raise(n, -ring), raise(n, ring), raise(-ring, n), raise(ring, n);
        }
        return steepest;
    }

    static constexpr int kRings = 8;
    static constexpr int kPeriods = 2;  // farther copies of a cell need less than its nearest

    CellGrid grid_;
    Address address_;
    CellSearch cells_;
    Image<double> lowest_;
    Image<double> steepest_;
    Image<double> slopes_;
};

// Searches for the texel that stands highest above a cone. A cone in texture coordinates is an ellipse in texels; its
// slope is that of the longer axis, so distances along the shorter one count more.
class TexelSearch {
  public:
    TexelSearch(const HeightField& field, const ConeCoding& coding, Work& work)
        : pyramid_(PyramidKind::Max, field.sharedHeights(), work),
          wraps_(field.address() == Address::Repeat),
          perX_(coding.texels(field.width(), field.height()) /
                coding.texelsAlong(field.width(), field.height(), false)),
          perY_(coding.texels(field.width(), field.height()) /
                coding.texelsAlong(field.width(), field.height(), true)) {}

    struct Found {
        double above = 0;  // height above the cone
        int dx = 0;
        int dy = 0;
        double height = 0;
    };
    Found highest(int x, int y, double slope) const {
        Found found;
        const FloatImage& heights = pyramid_.level(0);
        const int around = wraps_ ? 1 : 0;
        visit(x, y, slope, pyramid_.levels() - 1, 0, 0, 0, 0, found);
        for (int py = -around; py <= around; ++py) {
            for (int px = -around; px <= around; ++px) {
                if (px == 0 && py == 0) continue;
                visit(x, y, slope, pyramid_.levels() - 1, 0, 0, px * heights.width(), py * heights.height(), found);
            }
        }
        return found;
    }

  private:
    void visit(int x, int y, double slope, int level, int i, int j, int shiftX, int shiftY, Found& found) const {
        const FloatImage& heights = pyramid_.level(0);
        const int x0 = (i << level) + shiftX - x;
        const int x1 = std::min((i + 1) << level, heights.width()) - 1 + shiftX - x;
        const int y0 = (j << level) + shiftY - y;
        const int y1 = std::min((j + 1) << level, heights.height()) - 1 + shiftY - y;
        const double gap = std::hypot(perX_ * std::max({0, x0, -x1}), perY_ * std::max({0, y0, -y1}));
        const auto top = static_cast<double>(pyramid_.level(level)(i, j));
        const double above = top - static_cast<double>(heights(x, y)) - slope * gap;
        if (!(above > found.above)) return;
        if (level == 0) {
            found = {above, x0, y0, top};
            return;
        }
        const FloatImage& below = pyramid_.level(level - 1);
        for (int n = 0; n < 4; ++n) {
            const int ci = 2 * i + (n & 1);
            const int cj = 2 * j + (n >> 1);
            if (ci < below.width() && cj < below.height()) visit(x, y, slope, level - 1, ci, cj, shiftX, shiftY, found);
        }
    }

    Pyramid pyramid_;
    bool wraps_;
    double perX_, perY_;  // texels of the longer axis per texel along each axis
};

struct RowViolations {
    std::uint64_t texels = 0;
    double above = 0;
    std::optional<ViewRay> ray;
};

// The ray from the top of the slab above a texel to a point below the top of the higher one.
std::optional<ViewRay> rayTo(int x, int y, const TexelSearch::Found& found, double longestRun) {
    const double away = std::hypot(found.dx, found.dy);
    const double z = std::min(found.height - 0.5 * found.above, 1 - away / longestRun);
    const double cone = found.height - found.above;
    if (!(z > cone)) return std::nullopt;
    const double perDescent = 1 / (1 - z);
    return ViewRay{x + 0.5, y + 0.5, found.dx * perDescent, found.dy * perDescent};
}

}  // namespace

EngineBoundCheck checkEngineCones(const HeightField& field, const FloatImage& codes, const ConeCoding& coding,
                                  Work& work) {
    assert(field.surface() == Surface::Bilinear && codes.width() == field.width() && codes.height() == field.height());
    const ConeProof proof(field, codes, coding, work);
    std::vector<EngineBoundCheck> parts(static_cast<std::size_t>(proof.height()));
    work.progress().begin("checking cones", proof.height());
    parallelFor(work, proof.height(), [&](int y) {
        for (int x = 0; x < proof.width(); ++x) proof.check(x, y, parts[static_cast<std::size_t>(y)]);
        work.progress().advance();
    });
    EngineBoundCheck all;
    for (const EngineBoundCheck& part : parts) {
        all.cells += part.cells;
        all.open += part.open;
        if (!all.first) all.first = part.first;
    }
    return all;
}

EngineViolations violationsOfTexels(const HeightField& field, const FloatImage& codes, const ConeCoding& coding,
                                    double longestRun, Work& work) {
    const TexelSearch search(field, coding, work);
    std::vector<RowViolations> rows(static_cast<std::size_t>(field.height()));
    work.progress().begin("searching texels in cones", field.height());
    parallelFor(work, field.height(), [&](int y) {
        RowViolations& row = rows[static_cast<std::size_t>(y)];
        for (int x = 0; x < field.width(); ++x) {
            const double slope = coding.slope(static_cast<double>(codes(x, y)), field.width(), field.height());
            const TexelSearch::Found found = search.highest(x, y, slope);
            // Less than the rounding error of a shader's floats.
            constexpr double kNegligible = 1e-7;
            if (!(found.above > kNegligible)) continue;
            ++row.texels;
            if (!(found.above > row.above)) continue;
            if (const auto ray = rayTo(x, y, found, longestRun)) {
                row.above = found.above;
                row.ray = ray;
            }
        }
        work.progress().advance();
    });
    EngineViolations all;
    for (const RowViolations& row : rows) {
        all.texels += row.texels;
        if (row.ray) all.rays.push(*row.ray);
    }
    return all;
}

LowMaxima checkEngineMaxima(const FloatImage& heights, const std::vector<FloatImage>& levels, Work& work) {
    const Pyramid exact(PyramidKind::Max, heights, work);
    LowMaxima check;
    for (int l = 0; l < static_cast<int>(levels.size()) && l < exact.levels(); ++l) {
        const FloatImage& stored = levels[static_cast<std::size_t>(l)];
        for (int y = 0; y < stored.height(); ++y) {
            for (int x = 0; x < stored.width(); ++x) {
                ++check.values;
                if (stored(x, y) >= exact.level(l)(x, y)) continue;
                if (check.low++ > 0) continue;
                check.level = l, check.x = x, check.y = y;
                check.stored = static_cast<double>(stored(x, y));
                check.height = static_cast<double>(exact.level(l)(x, y));
            }
        }
    }
    return check;
}

}  // namespace relief
