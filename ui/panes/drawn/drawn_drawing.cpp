#include "panes/drawn/drawn_drawing.h"

#include <algorithm>
#include <cmath>

#include "painting/chart.h"
#include "painting/legend_rows.h"
#include "panes/ray_geometry.h"

namespace reliefui {

namespace {

using relief::DrawnRelief;
using relief::Message;
using relief::MessageId;

// Margin for text around the plot of a profile, as a share of the relief's width.
constexpr double kMargin = 0.06;

// Adds the ray from where it enters to where it ends, repeated within the domain.
void addRay(Drawing& drawing, const DrawnSource& source, Point from, Point to, const Box& domain) {
    const std::vector<Segment> pieces = wrapped(Segment{from, to}, domain, source.address == relief::Address::Repeat);
    for (const Segment& piece : pieces) {
        drawing.add({ItemKind::Ray, 0, 0, 0}, Role::Ray, Polyline{{piece.first, piece.second}});
    }
    if (pieces.empty()) return;
    drawing.add({ItemKind::Ray, 0, 0, 0}, Role::Start, Marker{pieces.front().first, Shape::Dot, 7});
    if (source.hit.outcome == relief::Outcome::Hit) {
        drawing.add({ItemKind::Hit, 0, 0, 0}, Role::Hit, Ring{pieces.back().second, 5});
    }
}

DrawnPicture gridPicture(const DrawnSource& source) {
    const DrawnRelief& relief = source.relief;
    DrawnPicture picture;
    picture.body = {0, 0, double(relief.width), double(relief.height)};
    Cells cells;
    cells.values = std::make_shared<const relief::FloatImage>(relief::drawnHeights(relief));
    cells.clip = picture.body;
    cells.print = true;
    picture.drawing.add({ItemKind::Level, 0, 0, 0}, Role::HeightFill, std::move(cells));
    picture.drawing.add({}, Role::Frame, Rectangle{picture.body, false, 0, 0});
    if (source.chosen) {
        const double i = source.chosen->first;
        const double j = source.chosen->second;
        picture.drawing.add({ItemKind::Texel, 0, source.chosen->first, source.chosen->second}, Role::Highlight,
                            Rectangle{{i, j, i + 1, j + 1}, false, 0, 6}, Emphasis::Strong);
    }
    if (source.hasRay) {
        const relief::ViewRay& ray = source.ray;
        const double end = rayEnd(source.hit, nullptr);
        addRay(picture.drawing, source, {ray.s0, ray.t0}, {ray.s0 + end * ray.a, ray.t0 + end * ray.b}, picture.body);
    }
    return picture;
}

// Outline of the surface along the row: the columns' steps, or heights interpolated between texel centres.
std::vector<Point> outline(const DrawnSource& source, const DrawnPicture& picture) {
    const DrawnRelief& relief = source.relief;
    const auto y = [&](int i) {
        const auto n = static_cast<int>(relief::addressIndex(i, relief.width, source.address));
        return picture.body.y1 - relief.at(n, 0) * picture.body.height();
    };
    std::vector<Point> line;
    if (source.surface == relief::Surface::Columns) {
        for (int i = 0; i < relief.width; ++i) {
            line.push_back({double(i), y(i)});
            line.push_back({i + 1.0, y(i)});
        }
        return line;
    }
    line.push_back({0, (y(-1) + y(0)) / 2});
    for (int i = 0; i < relief.width; ++i) line.push_back({i + 0.5, y(i)});
    line.push_back({double(relief.width), (y(relief.width - 1) + y(relief.width)) / 2});
    return line;
}

// All rows are equal, so the ray's path in (s, height) contains all information.
void addRayInProfile(DrawnPicture& picture, const DrawnSource& source) {
    const relief::ViewRay& ray = source.ray;
    const double end = rayEnd(source.hit, nullptr);
    const Box& body = picture.body;
    // Repeated only along the row, not vertically: a ray that leaves the slab at the bottom does not enter again at the
    // top.
    const double low = body.y0 - body.height();
    addRay(picture.drawing, source, {ray.s0, body.y0}, {ray.s0 + end * ray.a, body.y0 + end * body.height()},
           {body.x0, low, body.x1, low + 4 * body.height()});
}

DrawnPicture profilePicture(const DrawnSource& source, double aspect) {
    const DrawnRelief& relief = source.relief;
    DrawnPicture picture;
    picture.profile = true;
    const double width = relief.width;
    const double margin = kMargin * width;
    picture.body = {0, 0, width, std::max(0.1 * width, (width + 2 * margin) * aspect - 2 * margin)};
    const Box& body = picture.body;
    for (int i = 0; i < relief.width; ++i) {
        const double top = body.y1 - relief.at(i, 0) * body.height();
        const ItemId id{ItemKind::Texel, 0, i, 0};
        picture.drawing.add(id, Role::HeightFill, Rectangle{{i + 0.04, top, i + 0.96, body.y1}, true, 0, 0});
        const bool chosen = source.chosen && source.chosen->first == i;
        picture.drawing.add(id, chosen ? Role::Highlight : Role::Layer,
                            Polyline{{{i + 0.04, top}, {i + 0.96, top}}, false},
                            chosen ? Emphasis::Strong : Emphasis::Normal);
        picture.drawing.add({}, Role::Label,
                            Label{.at = {i + 0.5, top},
                                  .text = plainText(relief::numberText(relief.at(i, 0), 2)),
                                  .anchor = Anchor::Bottom,
                                  .size = 0.8,
                                  .offset = {0, -3},
                                  .yields = true},
                            chosen ? Emphasis::Strong : Emphasis::Normal);
    }
    picture.drawing.add({ItemKind::Surface, 0, 0, 0}, Role::Surface, Polyline{outline(source, picture), false});
    picture.drawing.add({}, Role::Frame, Rectangle{body, false, 0, 0});
    for (const double height : {0.0, 0.5, 1.0}) {
        chart::text(picture.drawing, {body.x0, body.y1 - height * body.height()},
                    plainText(relief::numberText(height, 2)), Anchor::Right, {-4, 0});
    }
    if (source.hasRay) addRayInProfile(picture, source);
    picture.drawing.bounds = body.grown(margin);
    return picture;
}

}  // namespace

DrawnPicture drawnPicture(const DrawnSource& source, double aspect) {
    if (source.relief.empty()) return {};
    if (source.relief.profile()) return profilePicture(source, aspect);
    DrawnPicture picture = gridPicture(source);
    picture.drawing.bounds = picture.body;
    return picture;
}

Drawing drawnLegend(const DrawnSource& source, double width, relief::Language language) {
    LegendRows rows(width, language);
    if (source.relief.profile()) {
        rows.line(Role::Surface, Message(MessageId::DrawDrawnHeight));
    } else {
        rows.ramp(ColorMap::Height, Message(MessageId::DrawDrawnHeight));
    }
    if (source.hasRay) {
        rows.line(Role::Ray, source.relief.profile() ? Message(MessageId::DrawRay) : Message(MessageId::DrawDrawnRay));
    }
    rows.words(Message(MessageId::DrawDrawnHelp));
    return rows.take();
}

std::optional<std::pair<int, int>> drawnTexelAt(const DrawnPicture& picture, const DrawnRelief& relief, Point at) {
    if (relief.empty() || !picture.body.contains(at)) return std::nullopt;
    const int i = std::clamp(static_cast<int>(std::floor(at.x)), 0, relief.width - 1);
    if (picture.profile) return std::pair{i, 0};
    return std::pair{i, std::clamp(static_cast<int>(std::floor(at.y)), 0, relief.height - 1)};
}

double drawnHeightAt(const DrawnPicture& picture, Point at) {
    return std::clamp((picture.body.y1 - at.y) / picture.body.height(), 0.0, 1.0);
}

}  // namespace reliefui
