#include "panes/distance/distance_drawing.h"

#include <algorithm>
#include <cmath>

#include "painting/chart.h"
#include "painting/iso_lines.h"
#include "painting/style.h"
#include "panes/ray_geometry.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

constexpr double kIsoLines = 8;  // largest number of iso-lines

void addCells(DistancePicture& picture, const DistanceSource& source) {
    const MapSlice& slice = picture.slice;
    const DistanceFrame& frame = picture.frame;
    const bool upright = frame.axis != SliceAxis::Z;
    const Box ends = cellDomain(*source.field);
    const std::pair<double, double> endsU =
        frame.axis == SliceAxis::X ? std::pair(ends.y0, ends.y1) : std::pair(ends.x0, ends.x1);
    const std::pair<double, double> endsV = upright ? std::pair(0.0, frame.slab) : std::pair(ends.y0, ends.y1);
    const auto [i0, i1] = periodsSeen(frame.window.x0, frame.window.x1, slice.start.x, slice.periodU, slice.wrapsU);
    const auto [j0, j1] = periodsSeen(frame.window.y0, frame.window.y1, slice.start.y, slice.periodV, slice.wrapsV);
    for (int j = j0; j <= j1; ++j) {
        for (int i = i0; i <= i1; ++i) {
            const Point start{slice.start.x + i * slice.periodU, slice.start.y + j * slice.periodV};
            Box part{start.x, start.y, start.x + slice.periodU, start.y + slice.periodV};
            if (!slice.wrapsU) part = part.cut({endsU.first, part.y0, endsU.second, part.y1});
            if (!slice.wrapsV) part = part.cut({part.x0, endsV.first, part.x1, endsV.second});
            part = part.cut(frame.window);
            if (part.empty()) continue;
            const Point low = frame.at(Point{part.x0, part.y0});
            const Point high = frame.at(Point{part.x1, part.y1});
            const Point origin = frame.at(start);
            picture.drawing.add({ItemKind::Level, 0, 0, 0}, Role::HeightFill,
                                Cells{.values = slice.values,
                                      .x = origin.x,
                                      .y = origin.y,
                                      .cellWidth = slice.cellWidth * frame.scale,
                                      .cellHeight = slice.cellHeight * frame.scale,
                                      .clip = {low.x, low.y, high.x, high.y},
                                      .map = picture.values.map,
                                      .scale = picture.values.scale,
                                      .print = true});
        }
    }
}

// The visible range of cells of the slice's grid; unwrapped indices.
struct CellSpan {
    int first = 0;
    int last = 0;  // one past the last
};
CellSpan spanOf(double low, double high, double start, double side, double period, int count, bool wraps) {
    if (side <= 0) return {};  // a slab without thickness
    if (!wraps) {
        return {std::max(0, static_cast<int>(std::floor((low - start) / side)) - 1),
                std::min(count, static_cast<int>(std::ceil((high - start) / side)) + 1)};
    }
    const auto index = [&](double at) {
        const double n = std::floor((at - start) / period);
        return static_cast<int>(n) * count + std::min(static_cast<int>((at - start - n * period) / side), count - 1);
    };
    return {index(low) - 1, index(high) + 2};
}

// Position of the start of cell k (unwrapped). The last cell of a period may be shorter.
double placeOf(double cell, double start, double side, double period, int count, bool wraps) {
    if (!wraps) return start + cell * side;
    const double n = std::floor(cell / count);
    return start + n * period + std::min((cell - n * count) * side, period);
}

// Hatches the interior of the relief, as in a section drawing; omitted where hatches would be too many.
void addHatches(DistancePicture& picture) {
    constexpr std::size_t kMost = 3000;
    const MapSlice& slice = picture.slice;
    const DistanceFrame& frame = picture.frame;
    const int columns = slice.values->width();
    const int rows = slice.values->height();
    const CellSpan u =
        spanOf(frame.window.x0, frame.window.x1, slice.start.x, slice.cellWidth, slice.periodU, columns, slice.wrapsU);
    const CellSpan v =
        spanOf(frame.window.y0, frame.window.y1, slice.start.y, slice.cellHeight, slice.periodV, rows, slice.wrapsV);
    std::vector<Box> boxes;
    const auto buried = [&](int i, int j) {
        return std::isnan((*slice.values)(static_cast<int>(relief::wrapIndex(i, columns)),
                                          static_cast<int>(relief::wrapIndex(j, rows))));
    };
    const auto place = [&](int i, int j) {
        return frame.at(Point{placeOf(i, slice.start.x, slice.cellWidth, slice.periodU, columns, slice.wrapsU),
                              placeOf(j, slice.start.y, slice.cellHeight, slice.periodV, rows, slice.wrapsV)});
    };
    for (int j = v.first; j < v.last; ++j) {
        if (!slice.wrapsV && (j < 0 || j >= rows)) continue;
        for (int i = u.first; i < u.last; ++i) {
            const int from = i;
            while (i < u.last && (slice.wrapsU || (i >= 0 && i < columns)) && buried(i, j)) ++i;
            if (i == from) continue;
            const Point low = place(from, j);
            const Point high = place(i, j + 1);
            const Box box = Box{low.x, low.y, high.x, high.y}.cut(frame.plot);
            if (!box.empty()) boxes.push_back(box);
        }
    }
    if (boxes.size() > kMost) return;
    for (const Box& box : boxes) picture.drawing.add({}, Role::Background, Hatch{box}, Emphasis::Faint);
}

// Values of the iso-lines: multiples of `step`, or on a logarithmic scale 1, 2 and 5 times the powers of ten.
struct IsoValues {
    std::vector<double> values;
    double step = 0;
    int perDecade = 0;
};
constexpr int kIsoTries = 3;
constexpr double kMostIsoLength = 0.07;  // in points of line length per square point
constexpr double kLeastIsoLength = 14;   // in points; shorter closed lines are not legible
IsoValues isoValues(const ColorScale& scale, int coarser) {
    IsoValues iso;
    if (scale.logarithmic) {
        const std::vector<double> factors = coarser == 0 ? std::vector{1.0, 2.0, 5.0} : std::vector{1.0};
        if (coarser > 1) return iso;
        iso.perDecade = static_cast<int>(factors.size());
        const int first = static_cast<int>(std::floor(std::log10(scale.low)));
        const int last = static_cast<int>(std::ceil(std::log10(scale.high)));
        for (int n = first; n <= last; ++n) {
            for (const double factor : factors) iso.values.push_back(factor * std::pow(10.0, n));
        }
        std::erase_if(iso.values, [&](double value) { return value <= scale.low || value > scale.high; });
        if (!scale.twoSided) return iso;
        for (std::size_t n = iso.values.size(); n-- > 0;) iso.values.push_back(-iso.values[n]);
        std::sort(iso.values.begin(), iso.values.end());
        return iso;
    }
    const double low = scale.twoSided ? -scale.high : scale.low;
    iso.step = chart::niceStep(scale.twoSided ? scale.high : scale.high - low, kIsoLines / (1 << coarser));
    iso.values = chart::multiples(low, scale.high, iso.step);
    std::erase_if(iso.values, [&](double value) { return std::abs(value) < 1e-6 * iso.step; });
    return iso;
}

}  // namespace

LevelTint isoTint(const RangedValues& values, double value) {
    const Rgba ground = Style{}.cell(values.map, value, values.scale);
    return {Style::textOn(ground).r > 128 ? kLightLine : kDarkLine, 2};
}

namespace {

double lengthOf(const std::vector<Point>& line) {
    double length = 0;
    for (std::size_t n = 1; n < line.size(); ++n) {
        length += std::hypot(line[n].x - line[n - 1].x, line[n].y - line[n - 1].y);
    }
    return length;
}

// line: in points of the drawing.
void addIsoLine(DistancePicture& picture, const IsoLine& line) {
    constexpr double kLabelled = 46;  // in points
    // Where the cells are large enough for printed values, lines need no labels.
    constexpr double kPrinted = 24;
    const MapSlice& slice = picture.slice;
    const DistanceFrame& frame = picture.frame;
    const bool printed = slice.cellWidth * frame.scale > kPrinted && slice.cellHeight * frame.scale > kPrinted / 2;
    addLine(picture.drawing, line.points, frame.plot, {ItemKind::IsoLine, 0, 0, 0}, Role::IsoLine, Emphasis::Normal,
            isoTint(picture.values, line.value));
    const Point middle = line.points[line.points.size() / 2];
    if (printed || lengthOf(line.points) < kLabelled || !frame.plot.grown(-8).contains(middle)) return;
    const std::string value =
        picture.isoStep > 0 ? chart::tickText(line.value, picture.isoStep) : relief::numberText(line.value, 3);
    picture.drawing.add({}, Role::IsoLine,
                        Label{.at = middle,
                              .text = plainText(value),
                              .anchor = Anchor::Center,
                              .size = 0.75,
                              .plate = true,
                              .yields = true});
}

void addIsoLines(DistancePicture& picture) {
    const MapSlice& slice = picture.slice;
    const DistanceFrame& frame = picture.frame;
    if (slice.high <= 0) return;
    const int columns = slice.values->width();
    const int rows = slice.values->height();
    const CellSpan u =
        spanOf(frame.window.x0, frame.window.x1, slice.start.x, slice.cellWidth, slice.periodU, columns, slice.wrapsU);
    const CellSpan v =
        spanOf(frame.window.y0, frame.window.y1, slice.start.y, slice.cellHeight, slice.periodV, rows, slice.wrapsV);
    if (u.last - u.first < 2 || v.last - v.first < 2) return;
    relief::FloatImage samples(u.last - u.first, v.last - v.first);
    for (int j = 0; j < samples.height(); ++j) {
        for (int i = 0; i < samples.width(); ++i) {
            const auto x = static_cast<int>(relief::wrapIndex(u.first + i, columns));
            const auto y = static_cast<int>(relief::wrapIndex(v.first + j, rows));
            const float value = (*slice.values)(x, y);
            samples(i, j) = std::isnan(value) ? 0 : (slice.low < 0 ? value : std::max(value, 0.0F));
        }
    }
    const auto placed = [&](const IsoLine& line) {
        std::vector<Point> points;
        for (const Point& p : line.points) {
            points.push_back(frame.at(
                Point{placeOf(u.first + p.x, slice.start.x, slice.cellWidth, slice.periodU, columns, slice.wrapsU),
                      placeOf(v.first + p.y, slice.start.y, slice.cellHeight, slice.periodV, rows, slice.wrapsV)}));
        }
        return points;
    };
    // Reduces the number of lines until they are not too dense; no lines if even the coarsest set is.
    for (int coarser = 0; coarser < kIsoTries; ++coarser) {
        const IsoValues iso = isoValues(picture.values.scale, coarser);
        std::vector<IsoLine> lines = isoLines(samples, iso.values);
        for (IsoLine& line : lines) line.points = placed(line);
        std::erase_if(lines, [](const IsoLine& line) { return lengthOf(line.points) < kLeastIsoLength; });
        double length = 0;
        for (const IsoLine& line : lines) {
            for (const std::vector<Point>& run : clippedTo(line.points, frame.plot)) length += lengthOf(run);
        }
        if (length > kMostIsoLength * frame.plot.width() * frame.plot.height()) continue;
        if (!(length > 0) || lines.empty()) return;
        picture.isoStep = iso.step;
        picture.isoPerDecade = iso.perDecade;
        const auto shorter = [](const IsoLine& a, const IsoLine& b) { return lengthOf(a.points) < lengthOf(b.points); };
        picture.isoValue = std::max_element(lines.begin(), lines.end(), shorter)->value;
        for (const IsoLine& line : lines) addIsoLine(picture, line);
        return;
    }
}

// The surface's outline in a vertical slice.
std::vector<Point> heightsAlong(const DistanceSource& source, const DistanceFrame& frame) {
    constexpr double kEach = 8;  // samples per texel
    constexpr double kMost = 6000;
    const relief::HeightField& field = *source.field;
    const auto height = [&](double u) {
        const Place3 place = fromSlice(frame.axis, frame.slab, frame.plane, {u, 0});
        return field.at(place[0], place[1]) * frame.slab;
    };
    std::vector<Point> line;
    const double low = frame.window.x0;
    const double high = frame.window.x1;
    if (field.surface() == relief::Surface::Columns && high - low < kMost) {
        for (double u = std::floor(low); u < high; u += 1) {
            const double h = height(u + 0.5);
            line.push_back({std::max(u, low), frame.slab - h});
            line.push_back({std::min(u + 1, high), frame.slab - h});
        }
        return line;
    }
    const int samples = static_cast<int>(std::clamp((high - low) * kEach, 2.0, kMost));
    for (int k = 0; k <= samples; ++k) {
        const double u = low + (high - low) * k / samples;
        line.push_back({u, frame.slab - height(u)});
    }
    return line;
}

// The surface's outlines at the height of a horizontal slice.
std::vector<std::vector<Point>> outlinesAt(const DistanceSource& source, const DistanceFrame& frame) {
    constexpr double kMostSide = 2048;
    const relief::HeightField& field = *source.field;
    std::vector<std::vector<Point>> lines;
    if (frame.window.width() > kMostSide || frame.window.height() > kMostSide || frame.slab <= 0) return lines;
    const double height = frame.plane / frame.slab;
    const auto i0 = static_cast<std::int64_t>(std::floor(frame.window.x0)) - 1;
    const auto j0 = static_cast<std::int64_t>(std::floor(frame.window.y0)) - 1;
    relief::FloatImage samples(static_cast<int>(std::ceil(frame.window.width())) + 3,
                               static_cast<int>(std::ceil(frame.window.height())) + 3);
    for (int j = 0; j < samples.height(); ++j) {
        for (int i = 0; i < samples.width(); ++i) samples(i, j) = field.texel(i0 + i, j0 + j);
    }
    const Point shift{static_cast<double>(i0), static_cast<double>(j0)};
    if (field.surface() == relief::Surface::Bilinear) {
        for (const IsoLine& line : isoLines(samples, {height})) {
            lines.emplace_back();
            for (const Point& p : line.points) lines.back().push_back({p.x + shift.x, p.y + shift.y});
        }
        return lines;
    }
    const auto above = [&](int i, int j) { return static_cast<double>(samples(i, j)) >= height; };
    for (int j = 1; j < samples.height(); ++j) {
        for (int i = 1; i < samples.width(); ++i) {
            const Point p{i + shift.x, j + shift.y};
            if (above(i, j) != above(i - 1, j)) lines.push_back({p, {p.x, p.y + 1}});
            if (above(i, j) != above(i, j - 1)) lines.push_back({p, {p.x + 1, p.y}});
        }
    }
    return lines;
}

void addSurface(Drawing& drawing, const DistanceSource& source, const DistanceFrame& frame) {
    std::vector<std::vector<Point>> lines;
    if (frame.axis == SliceAxis::Z) {
        if (!frame.slopes) lines = outlinesAt(source, frame);
    } else {
        lines.push_back(heightsAlong(source, frame));
    }
    for (std::vector<Point>& line : lines) {
        for (Point& p : line) p = frame.at(p);
        addLine(drawing, line, frame.plot, {ItemKind::Surface, 0, 0, 0}, Role::Surface);
    }
}

}  // namespace

DistancePicture distancePicture(const DistanceSource& source, const DistanceOptions& options, int step, double width,
                                double height, relief::Language language) {
    if (source.second != nullptr && source.second->slopes() != source.first->slopes()) {
        throw relief::InputError({}, Message(MessageId::DrawOtherKind,
                                             {{"first", source.first->kind()}, {"second", source.second->kind()}}));
    }
    DistancePicture picture;
    picture.kind = source.first->kind();
    if (source.second != nullptr) picture.minus = source.second->kind();
    picture.frame = distanceFrame(source, options, step, width, height);
    SliceOrder order;
    order.axis = picture.frame.axis;
    order.plane = picture.frame.cut;
    order.sector = picture.frame.sector;
    if (source.second != nullptr) order.secondSector = sectorOf(*source.second, source, options);
    picture.slice = mapSlice(*source.first, source.second, order);
    picture.values = sliceValues(picture, options.ranges, language);
    picture.drawing.bounds = picture.frame.whole;
    addCells(picture, source);
    addHatches(picture);
    if (options.isoLines) addIsoLines(picture);
    addSurface(picture.drawing, source, picture.frame);
    addDistanceAxes(picture, language);
    return picture;
}

DistanceReading distanceReading(const DistanceSource& source, const DistanceFrame& frame, int secondSector, Point at) {
    DistanceReading reading;
    reading.inside = frame.plot.contains(at);
    if (!reading.inside) return reading;
    reading.place = fromSlice(frame.axis, frame.slab, frame.cut, frame.uvAt(at));
    const Box domain = cellDomain(*source.field);
    const bool wraps = source.field->address() == relief::Address::Repeat;
    reading.onMap = wraps || domain.contains({reading.place[0], reading.place[1]});
    reading.bx = source.first->x().index(reading.place[0]);
    reading.by = source.first->y().index(reading.place[1]);
    reading.layer = source.first->layerOf(reading.place[2]);
    reading.first = source.first->at(reading.place, frame.sector);
    if (source.second != nullptr) reading.second = source.second->at(reading.place, secondSector);
    return reading;
}

}  // namespace reliefui
