#include "panes/ray_geometry.h"

#include <algorithm>
#include <cmath>

namespace reliefui {

RayPath::RayPath(const relief::HeightField& field, const relief::ViewRay& ray) {
    const relief::CellGrid grid(field);
    const relief::GridRay inCells(grid, ray);
    start = {inCells.x.start - grid.x.shift, inCells.y.start - grid.y.shift};
    run = {ray.a, ray.b};
}

Box stepBox(const relief::HeightField& field, const relief::Step& step, int baseLevel) {
    if (const auto* const quad = step.as<relief::subject::Quad>()) {
        return {quad->s, quad->t, quad->s + quad->width, quad->t + quad->height};
    }
    if (step.namesTexelUnderRay()) {
        const auto x = static_cast<double>(step.i + step.periodX * field.width());
        const auto y = static_cast<double>(step.j + step.periodY * field.height());
        return {x, y, x + 1, y + 1};
    }
    const auto* const voxel = step.tests() ? nullptr : step.as<relief::subject::Voxel>();
    const auto side = [&](int texels, std::int64_t name, std::int64_t period, double& low, double& high) {
        if (voxel != nullptr) {
            const relief::GridAxis axis(texels, field.surface(), field.address());
            const auto first = static_cast<int>(name) * voxel->footprint;
            low = axis.edge(first, period * axis.cells) - axis.shift;
            high = axis.edge(std::min(first + voxel->footprint, axis.cells), period * axis.cells) - axis.shift;
            return;
        }
        int base = texels;
        for (int level = 0; level < baseLevel; ++level) base = (base + 1) / 2;
        const relief::GridAxis axis(base, field.surface(), field.address());
        const int level = step.level - baseLevel;
        const std::int64_t index = level == 0 ? name - axis.firstName : name;
        const std::int64_t first = index << level;
        const std::int64_t last = std::min<std::int64_t>((index + 1) << level, axis.cells);
        const double scale = static_cast<double>(texels) / base;
        low = (axis.edge(static_cast<int>(first), period * axis.cells) - axis.shift) * scale;
        high = (axis.edge(static_cast<int>(last), period * axis.cells) - axis.shift) * scale;
    };
    Box box;
    side(field.width(), step.i, step.periodX, box.x0, box.x1);
    side(field.height(), step.j, step.periodY, box.y0, box.y1);
    return box;
}

double rayEnd(const relief::Hit& hit, const std::vector<relief::Step>* steps) {
    if (hit.outcome == relief::Outcome::Hit) return hit.lambda;
    return steps == nullptr || steps->empty() ? 1 : std::clamp(steps->back().lambdaAfter, 0.0, 1.0);
}

Box cellDomain(const relief::HeightField& field) {
    const relief::CellGrid grid(field);
    const auto side = [](const relief::GridAxis& axis, double& low, double& high) {
        low = axis.edge(0, 0) - axis.shift;
        high = axis.edge(axis.cells, 0) - axis.shift;
        if (!std::isfinite(low)) low = -axis.shift;
        if (!std::isfinite(high)) high = axis.cells - axis.shift;
    };
    Box box;
    side(grid.x, box.x0, box.x1);
    side(grid.y, box.y0, box.y1);
    return box;
}

Box texelDomain(const relief::HeightField& field) {
    return {0, 0, static_cast<double>(field.width()), static_cast<double>(field.height())};
}

namespace {

// Adds the parameters in [0, 1] at which the segment crosses borders of periods.
void crossings(double origin, double run, double low, double period, std::vector<double>& out) {
    constexpr std::int64_t kEachEnd = 60;
    if (run == 0 || period <= 0) return;
    const double a = (origin - low) / period;
    const double b = (origin + run - low) / period;
    const auto first = static_cast<std::int64_t>(std::floor(std::min(a, b))) + 1;
    const auto last = static_cast<std::int64_t>(std::ceil(std::max(a, b))) - 1;
    for (std::int64_t k = first; k <= last; ++k) {
        if (k - first >= kEachEnd && last - k >= kEachEnd) {
            k = last - kEachEnd;
            continue;
        }
        out.push_back((low + static_cast<double>(k) * period - origin) / run);
    }
}

}  // namespace

std::vector<Segment> wrapped(const Segment& segment, const Box& domain, bool wraps) {
    std::vector<Segment> pieces;
    if (!wraps) {
        Segment piece = segment;
        if (clip(piece, domain)) pieces.push_back(piece);
        return pieces;
    }
    const double dx = segment.second.x - segment.first.x;
    const double dy = segment.second.y - segment.first.y;
    std::vector<double> cuts{0, 1};
    crossings(segment.first.x, dx, domain.x0, domain.width(), cuts);
    crossings(segment.first.y, dy, domain.y0, domain.height(), cuts);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 1; k < cuts.size(); ++k) {
        const double from = cuts[k - 1];
        const double to = cuts[k];
        const double middle = (from + to) / 2;
        // A piece longer than a period stands for crossings that were omitted.
        if ((to - from) * std::abs(dx) > domain.width() * 1.5 || (to - from) * std::abs(dy) > domain.height() * 1.5) {
            continue;
        }
        const double shiftX = std::floor((segment.first.x + middle * dx - domain.x0) / domain.width()) * domain.width();
        const double shiftY =
            std::floor((segment.first.y + middle * dy - domain.y0) / domain.height()) * domain.height();
        const auto at = [&](double f) {
            return Point{segment.first.x + f * dx - shiftX, segment.first.y + f * dy - shiftY};
        };
        pieces.push_back({at(from), at(to)});
    }
    return pieces;
}

std::vector<Box> wrapped(const Box& box, const Box& domain, bool wraps) {
    std::vector<Box> pieces;
    const double px = domain.width();
    const double py = domain.height();
    const double shiftX = wraps ? std::floor((box.x0 - domain.x0) / px) * px : 0;
    const double shiftY = wraps ? std::floor((box.y0 - domain.y0) / py) * py : 0;
    const int more = wraps ? 1 : 0;
    for (int m = 0; m <= more; ++m) {
        for (int n = 0; n <= more; ++n) {
            const double x = shiftX + n * px;
            const double y = shiftY + m * py;
            const Box piece = Box{box.x0 - x, box.y0 - y, box.x1 - x, box.y1 - y}.cut(domain);
            if (piece.width() > 0 && piece.height() > 0) pieces.push_back(piece);
        }
    }
    return pieces;
}

std::pair<int, int> periodsSeen(double low, double high, double start, double period, bool wraps) {
    if (!wraps) return {0, 0};
    constexpr double kRounding = 1e-9;
    return {static_cast<int>(std::floor((low - start) / period + kRounding)),
            static_cast<int>(std::ceil((high - start) / period - kRounding)) - 1};
}

bool coversStretch(relief::Decision decision) {
    switch (decision) {
        case relief::Decision::Skip:
        case relief::Decision::Advance:
        case relief::Decision::Test:
        case relief::Decision::Refine:
        case relief::Decision::Hit:
            return true;
        default:
            return false;
    }
}

}  // namespace reliefui
