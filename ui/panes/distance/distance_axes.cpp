#include <cmath>
#include <limits>

#include <QCoreApplication>

#include "painting/axis_ticks.h"
#include "painting/legend_rows.h"
#include "panes/distance/distance_drawing.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

class DistanceText {
    Q_DECLARE_TR_FUNCTIONS(reliefui::DistanceText)
};

constexpr double kTextSize = 0.8;
constexpr double kTick = 3;  // points
constexpr double kNumberRoom = 34;

void addText(Drawing& drawing, Point at, Message text, Anchor anchor, Point offset, bool yields = false) {
    Label label;
    label.at = at;
    label.text = std::move(text);
    label.anchor = anchor;
    label.size = kTextSize;
    label.offset = offset;
    label.yields = yields;
    drawing.add({}, Role::Legend, std::move(label));
}

Message titleOf(const DistancePicture& picture, relief::Language language) {
    const DistanceFrame& frame = picture.frame;
    std::string name = picture.kind;
    if (!picture.minus.empty()) name += " − " + picture.minus;
    if (frame.sectors > 1) {
        const Message named(MessageId::DrawSectorOf,
                            {{"map", name}, {"sector", frame.sector + 1}, {"sectors", frame.sectors}});
        name = relief::sentence(named, language);
    }
    if (frame.slopes) return Message(MessageId::DrawSlopes, {{"map", name}});
    const bool level = frame.axis == SliceAxis::Z;
    const std::string at =
        level ? relief::fixedText(frame.slab > 0 ? frame.plane / frame.slab : 0, 3) : relief::fixedText(frame.plane, 2);
    const MessageId id =
        level ? MessageId::DrawSliceZ : (frame.axis == SliceAxis::X ? MessageId::DrawSliceX : MessageId::DrawSliceY);
    return Message(id, {{"map", name}, {"at", at}});
}

}  // namespace

void addDistanceAxes(DistancePicture& picture, relief::Language language) {
    Drawing& drawing = picture.drawing;
    const DistanceFrame& frame = picture.frame;
    const Box& plot = frame.plot;
    const bool level = frame.axis == SliceAxis::Z;
    drawing.add({}, Role::Frame, Rectangle{plot, false, -0.5, 0});
    const auto tick = [&](Point from, Point to) { drawing.add({}, Role::Frame, Polyline{{from, to}, false}); };
    const Message upwards = level ? Message(MessageId::DrawAxisY)
                                  : Message(MessageId::DrawHeightAxis, {{"texels", relief::numberText(frame.slab, 3)}});
    addText(drawing, {plot.x0, plot.y0}, upwards, Anchor::BottomLeft, {kTick - kNumberRoom + 2, -7}, true);
    const Message across(frame.axis == SliceAxis::X ? MessageId::DrawAxisY : MessageId::DrawAxisX);
    if (lowPane(frame)) {
        addText(drawing, {plot.x1, plot.y1}, across, Anchor::Right, {0, kTick + 6});
    } else {
        addText(drawing, {plot.center().x, plot.y1}, across, Anchor::Top, {0, kTick + 13});
    }
    const double stepU = niceStep(frame.window.width(), plot.width() / 52);
    for (const double u : ticks(frame.window.x0, frame.window.x1, stepU)) {
        const double x = frame.at(Point{u, 0}).x;
        tick({x, plot.y1}, {x, plot.y1 + kTick});
        addText(drawing, {x, plot.y1}, plainText(tickText(u, stepU)), Anchor::Top, {0, kTick + 1}, true);
    }
    // Of heights, what the window shows of them.
    const double slab = std::max(frame.slab, 1e-9);
    const double low = level ? frame.window.y0 : std::max(0.0, 1 - frame.window.y1 / slab);
    const double high = level ? frame.window.y1 : std::min(1.0, 1 - frame.window.y0 / slab);
    const double stepV = niceStep(std::max(high - low, 1e-9), plot.height() / 22);
    for (const double v : ticks(low, high, stepV)) {
        const double y = frame.at(Point{0, level ? v : (1 - v) * frame.slab}).y;
        tick({plot.x0 - kTick, y}, {plot.x0, y});
        addText(drawing, {plot.x0, y}, plainText(tickText(v, stepV)), Anchor::Right, {-kTick - 2, 0}, true);
    }
    Label title;
    title.at = {plot.x1, plot.y0};
    title.text = titleOf(picture, language);
    title.anchor = Anchor::Right;
    title.size = 0.85;
    title.offset = {0, -9};
    drawing.add({}, Role::Title, std::move(title), Emphasis::Strong);
}

namespace {

Message barName(const DistancePicture& picture) {
    if (picture.minus.empty()) {
        return Message(picture.frame.slopes ? MessageId::DrawSlopeBar : MessageId::DrawDistanceBar);
    }
    return Message(picture.frame.slopes ? MessageId::DrawSlopeDifferenceBar : MessageId::DrawDifferenceBar,
                   {{"first", picture.kind}, {"second", picture.minus}});
}

void addPatch(LegendRows& rows, Role role, const Message& name, bool hatched) {
    const Point at = rows.place(LegendRows::kSign + 2 + rows.textRoom(name) + LegendRows::kBetween);
    const Box box{at.x, at.y - 5, at.x + 12, at.y + 5};
    Cells patch;
    auto value = std::make_shared<relief::FloatImage>(1, 1);
    (*value)(0, 0) = role == Role::Tested ? relief::StoredValues::kSurface : std::numeric_limits<float>::quiet_NaN();
    patch.values = std::move(value);
    patch.x = box.x0;
    patch.y = box.y0;
    patch.cellWidth = box.width();
    patch.cellHeight = box.height();
    patch.clip = box;
    patch.map = ColorMap::Distance;
    rows.add(role, patch);
    if (hatched) rows.add(Role::Background, Hatch{box});
    rows.text({at.x + LegendRows::kSign + 2, at.y}, name);
}

}  // namespace

RangedValues sliceValues(const DistancePicture& picture, const ColorRanges& ranges, relief::Language language) {
    const bool slopes = picture.frame.slopes;
    const bool difference = !picture.minus.empty();
    RangedValues values;
    values.of = difference ? (slopes ? RangeOf::SlopeDifference : RangeOf::Difference)
                           : (slopes ? RangeOf::Slope : RangeOf::Distance);
    values.name = relief::sentence(barName(picture), language);
    values.unit = (slopes ? DistanceText::tr("heights a texel") : DistanceText::tr("texels")).toStdString();
    values.counted = slopes ? Counted::Texels : Counted::Voxels;
    values.map = difference ? ColorMap::Difference : ColorMap::Distance;
    values.range = ranges.of(values.of);
    values.spread = picture.slice.spread;
    values.scale = colorScale(values.range, *values.spread,
                              {difference ? 0 : picture.slice.low, picture.slice.high, difference, 0});
    return values;
}

Drawing distanceLegend(const DistanceSource& source, const DistancePicture& picture, double width,
                       relief::Language language, bool brief) {
    LegendRows rows(width, language);
    rows.block(rangeLegend(picture.values, width, brief));
    bool buried = false;
    bool surface = false;
    for (const float value : picture.slice.values->pixels()) {
        buried = buried || std::isnan(value);
        surface = surface || (picture.minus.empty() && value < 0);
    }
    if (surface) addPatch(rows, Role::Tested, Message(MessageId::DrawSurfaceVoxel), false);
    if (buried) addPatch(rows, Role::HeightFill, Message(MessageId::DrawBuried), true);
    if (picture.isoStep > 0) {
        rows.line(Role::IsoLine, Message(MessageId::DrawIsoLines, {{"step", relief::numberText(picture.isoStep, 3)}}));
    }
    if (picture.isoPerDecade > 0) {
        const QString where = picture.isoPerDecade > 1 ? DistanceText::tr("lines at 1, 2 and 5 of each power of ten")
                                                       : DistanceText::tr("lines at powers of ten");
        rows.line(Role::IsoLine, plainText(where.toStdString()));
    }
    if (!picture.frame.slopes) rows.line(Role::Surface, Message(MessageId::DrawSurface));
    if (source.point != nullptr) addPointLegend(rows, *source.point);
    if (!source.hasRay) return rows.take();
    rows.line(Role::Ray, Message(MessageId::DrawRay));
    if (source.steps == nullptr) return rows.take();
    // A broken promise gets its row where the slice shows it.
    rows.bodies(*source.steps, source.ray, source.exact, [&](const StepBody& body) {
        const Place3 centre = placeOnRay(source, body.lambda);
        return body.kind == StepBody::Kind::Cone ||
               std::abs(offPlane(picture.frame.axis, picture.frame.plane, centre)) < body.radius;
    });
    return rows.take();
}

}  // namespace reliefui
