#include "panes/distance/distance_drawing.h"

#include <algorithm>
#include <cmath>

#include "painting/chart.h"
#include "panes/ray_geometry.h"

namespace reliefui {

namespace {

constexpr double kLow = 190;  // in points; lower panes have one row of text below the plot

// One direction of the window: the ray's extent and its surroundings, at least `least` and at most `most` around
// `center`.
struct Range {
    double low = 0;
    double high = 1;
    double size() const { return high - low; }
};
Range around(double a, double b, double center, double least, double most) {
    constexpr double kAround = 0.3;
    Range range{std::min(a, b), std::max(a, b)};
    const double margin = std::max(kAround * range.size(), (least - range.size()) / 2);
    range = {range.low - std::max(margin, 0.0), range.high + std::max(margin, 0.0)};
    if (range.size() <= most) return range;
    const double middle = std::clamp(center, range.low + most / 2, range.high - most / 2);
    return {middle - most / 2, middle + most / 2};
}
// Widens the range equally on both sides; if the picture does not repeat, it stays within the domain.
Range widened(const Range& range, double size, const Range& domain, bool wraps) {
    Range wide{range.low - (size - range.size()) / 2, range.high + (size - range.size()) / 2};
    if (wraps || size >= domain.size()) {
        return wraps ? wide : Range{std::max(wide.low, domain.low), std::min(wide.high, domain.high)};
    }
    const double shift = std::max(domain.low - wide.low, 0.0) - std::max(wide.high - domain.high, 0.0);
    return {wide.low + shift, wide.high + shift};
}

struct Windows {
    Range u;
    Range v;
};

Windows windowOf(const DistanceSource& source, const DistanceOptions& options, const DistanceFrame& frame,
                 const Place3& current, double aspect) {
    constexpr double kLeast = 12;       // in texels
    constexpr double kFlattest = 0.35;  // smallest height of a slice, as a share of its room
    constexpr double kMostPeriods = 3;
    const Box domain = cellDomain(*source.field);
    const bool upright = frame.axis != SliceAxis::Z;
    const bool wraps = source.field->address() == relief::Address::Repeat;
    const Range domainU = frame.axis == SliceAxis::X ? Range{domain.y0, domain.y1} : Range{domain.x0, domain.x1};
    const Range domainV = upright ? Range{0, frame.slab} : Range{domain.y0, domain.y1};
    Windows windows{domainU, domainV};
    const Point now = toSlice(frame.axis, frame.slab, current);
    if (!source.hasRay) {
        if (upright && options.nearRay) {
            const double most = std::max(kLeast, frame.slab / kFlattest / aspect);
            windows.u = widened({now.x, now.x}, std::min(most, domainU.size()), domainU, wraps);
        }
        return windows;
    }
    const Point from = toSlice(frame.axis, frame.slab, placeOnRay(source, 0));
    const Point to = toSlice(frame.axis, frame.slab, placeOnRay(source, rayEndOf(source)));
    if (!options.nearRay) {
        // The whole period, extended to those periodic copies that the ray reaches.
        const auto joined = [&](const Range& all, double a, double b, double center) {
            const double most = kMostPeriods * all.size();
            Range range{std::min({all.low, a, b}), std::max({all.high, a, b})};
            if (range.size() > most) range = {center - most / 2, center + most / 2};
            return range;
        };
        if (wraps) windows.u = joined(domainU, from.x, to.x, now.x);
        if (wraps && !upright) windows.v = joined(domainV, from.y, to.y, now.y);
        return windows;
    }
    if (upright) {
        windows.v = around(from.y, to.y, now.y, std::min(kLeast, frame.slab), frame.slab);
        windows.v = widened(windows.v, windows.v.size(), domainV, false);
        const double filling = std::max(windows.v.size(), 1e-9) * aspect;
        windows.u = around(from.x, to.x, now.x, kLeast, std::max(kLeast, filling / kFlattest));
        windows.u = widened(windows.u, std::max(windows.u.size(), filling), domainU, wraps);
        windows.v = widened(windows.v, std::max(windows.v.size(), windows.u.size() / aspect), domainV, false);
        return windows;
    }
    const double most = kMostPeriods * std::max(domainU.size(), domainV.size());
    windows.u = around(from.x, to.x, now.x, kLeast, most);
    windows.v = around(from.y, to.y, now.y, kLeast, most);
    const double width = std::max(windows.u.size(), windows.v.size() * aspect);
    windows.u = widened(windows.u, width, domainU, wraps);
    windows.v = widened(windows.v, std::max(windows.v.size(), width / aspect), domainV, wraps);
    return windows;
}

}  // namespace

double rayEndOf(const DistanceSource& source) {
    return rayEnd(source.hit, source.steps);
}

Place3 placeOnRay(const DistanceSource& source, double lambda) {
    const Point p = RayPath(*source.field, source.ray).at(lambda);
    return {p.x, p.y, (1 - lambda) * source.field->slabTexels()};
}

int sectorOf(const SlicedMap& map, const DistanceSource& source, const DistanceOptions& options) {
    const int rays = source.hasRay ? relief::azimuthSector(source.ray.a, source.ray.b, map.sectors()) : 0;
    return std::clamp(options.sector.value_or(rays), 0, map.sectors() - 1);
}

Place3 stepPlace(const DistanceSource& source, int step) {
    if (!source.hasRay) {
        return {source.field->width() / 2.0, source.field->height() / 2.0, source.field->slabTexels() / 2};
    }
    if (source.steps == nullptr || source.steps->empty()) return placeOnRay(source, 0);
    const auto last = static_cast<int>(source.steps->size()) - 1;
    const relief::Step& s = (*source.steps)[static_cast<std::size_t>(std::clamp(step, 0, last))];
    const StepBody body = stepBody(s);
    if (body) return placeOnRay(source, std::clamp(body.lambda, 0.0, 1.0));
    return placeOnRay(source, std::clamp(s.decision == relief::Decision::Hit ? s.lambdaAfter : s.lambdaIn, 0.0, 1.0));
}

namespace {

// Centre of the voxel that the step examines, if it examines one.
std::optional<double> voxelMiddle(const DistanceSource& source, int step, SliceAxis axis) {
    if (!source.hasRay || source.steps == nullptr || source.steps->empty()) return std::nullopt;
    const auto last = static_cast<int>(source.steps->size()) - 1;
    const relief::Step& s = (*source.steps)[static_cast<std::size_t>(std::clamp(step, 0, last))];
    if (!liesInVoxel(s)) return std::nullopt;
    const Box sides = stepBox(*source.field, s);
    const VoxelHeights heights = voxelHeights(s);
    const double middle = axis == SliceAxis::X   ? sides.center().x
                          : axis == SliceAxis::Y ? sides.center().y
                                                 : (heights.low + heights.high) / 2 * source.field->slabTexels();
    // The outermost cells of a clamped picture extend to infinity.
    return std::isfinite(middle) ? std::optional(middle) : std::nullopt;
}

}  // namespace

DistanceFrame distanceFrame(const DistanceSource& source, const DistanceOptions& options, int step, double width,
                            double height) {
    DistanceFrame frame;
    frame.slopes = source.first->slopes();
    frame.slab = source.field->slabTexels();
    const bool along = std::abs(source.ray.a) >= std::abs(source.ray.b);
    frame.axis = options.axis.value_or(along ? SliceAxis::Y : SliceAxis::X);
    if (frame.slopes) frame.axis = SliceAxis::Z;
    frame.whole = {0, 0, width, height};
    const Place3 current = stepPlace(source, step);
    frame.slices = frame.slopes ? 1 : source.first->slices(frame.axis);
    const auto axis = static_cast<std::size_t>(frame.axis);
    Place3 cut = current;
    if (options.slice) {
        frame.slice = std::clamp(*options.slice, 0, frame.slices - 1);
        frame.plane = source.first->planeOf(frame.axis, frame.slice, current);
        cut[axis] = frame.plane;
    } else {
        // The plane passes through the step, so that its sphere is cut through the centre; values are looked up in
        // the voxel that the step examines, on whose border the step may lie.
        frame.plane = current[axis];
        cut[axis] = voxelMiddle(source, step, frame.axis).value_or(frame.plane);
        frame.slice = source.first->sliceAt(frame.axis, cut);
    }
    frame.cut = cut[axis];
    frame.sectors = source.first->sectors();
    frame.sector = sectorOf(*source.first, source, options);
    const Box room = chart::plotIn(frame.whole, {.top = 19, .bottom = chart::bottomOf(height, kLow)});
    const Windows windows = windowOf(source, options, frame, current, room.width() / room.height());
    frame.window = {windows.u.low, windows.v.low, windows.u.high, windows.v.high};
    const double w = std::max(frame.window.width(), 1e-9);
    const double h = std::max(frame.window.height(), 1e-9);
    frame.scale = std::min(room.width() / w, room.height() / h);
    const Point middle = room.center();
    frame.plot = {middle.x - w * frame.scale / 2, middle.y - h * frame.scale / 2, middle.x + w * frame.scale / 2,
                  middle.y + h * frame.scale / 2};
    return frame;
}

}  // namespace reliefui
