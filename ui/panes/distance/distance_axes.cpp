#include <cmath>
#include <limits>

#include <QCoreApplication>

#include "painting/chart.h"
#include "painting/legend_rows.h"
#include "panes/distance/distance_drawing.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

class DistanceText {
    Q_DECLARE_TR_FUNCTIONS(reliefui::DistanceText)
};

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
    const chart::Axes axes(drawing, plot, frame.whole);
    axes.corner(level ? Message(MessageId::DrawAxisY)
                      : Message(MessageId::DrawHeightAxis, {{"texels", relief::numberText(frame.slab, 3)}}));
    axes.below({frame.window.x0, frame.window.x1, plot.x0, plot.x1},
               Message(frame.axis == SliceAxis::X ? MessageId::DrawAxisY : MessageId::DrawAxisX));
    chart::Scale upwards{frame.window.y0, frame.window.y1, plot.y0, plot.y1};
    if (!level) {
        // The visible range of heights.
        const double slab = std::max(frame.slab, 1e-9);
        upwards.low = std::max(0.0, 1 - frame.window.y1 / slab);
        upwards.high = std::min(1.0, 1 - frame.window.y0 / slab);
        upwards.from = frame.at(Point{0, (1 - upwards.low) * frame.slab}).y;
        upwards.to = frame.at(Point{0, (1 - upwards.high) * frame.slab}).y;
    }
    axes.left(upwards);
    const Message title = titleOf(picture, language);
    const double wide = textWidth(relief::sentence(title, language), chart::kTextSize, true);
    drawing.add({}, Role::Title,
                Label{.at = {plot.x1, plot.y0},
                      .text = title,
                      .anchor = Anchor::Right,
                      .size = chart::fittingSize(wide, plot.x1 - frame.whole.x0),
                      .offset = {0, -9}},
                Emphasis::Strong);
}

namespace {

Message barName(const DistancePicture& picture) {
    if (picture.minus.empty()) {
        return Message(picture.frame.slopes ? MessageId::DrawSlopeBar : MessageId::DrawDistanceBar);
    }
    return Message(picture.frame.slopes ? MessageId::DrawSlopeDifferenceBar : MessageId::DrawDifferenceBar,
                   {{"first", picture.kind}, {"second", picture.minus}});
}

// Adds a patch in the colour of a mark of the map.
void addPatch(LegendRows& rows, float mark, MessageId name) {
    const Box box{-5, -5, 7, 5};
    Cells patch = colorBar(box, ColorMap::Distance);
    patch.values = std::make_shared<const relief::FloatImage>(1, 1, mark);
    patch.cellWidth = box.width();
    const Point at = rows.sign(Role::HeightFill, patch, Message(name), {}, Emphasis::Normal, LegendRows::kSign + 2);
    if (std::isnan(mark)) rows.add(Role::Background, Hatch{box.moved(at)});
}

// Adds an iso-line on a patch of the map, as it is drawn there.
void addIsoSign(LegendRows& rows, const DistancePicture& picture, const Message& name) {
    const Box box{-5, -5, 7, 5};
    Cells patch = colorBar(box, picture.values.map);
    patch.values = std::make_shared<const relief::FloatImage>(1, 1, static_cast<float>(picture.isoValue));
    patch.cellWidth = box.width();
    patch.scale = picture.values.scale;
    const Point at = rows.sign(Role::HeightFill, patch, name, {}, Emphasis::Normal, LegendRows::kSign + 2);
    rows.add(Role::IsoLine, Polyline{{{at.x + box.x0, at.y}, {at.x + box.x1, at.y}}},
             isoTint(picture.values, picture.isoValue));
}

}  // namespace

RangedValues sliceValues(const DistancePicture& picture, const ColorRanges& ranges, relief::Language language) {
    const bool slopes = picture.frame.slopes;
    const bool difference = !picture.minus.empty();
    RangedValues values;
    values.of = difference ? (slopes ? RangeOf::SlopeDifference : RangeOf::Difference)
                           : (slopes ? RangeOf::Slope : RangeOf::Distance);
    values.name = relief::sentence(barName(picture), language);
    values.unit = (slopes ? DistanceText::tr("height per texel") : DistanceText::tr("texels")).toStdString();
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
    if (surface) addPatch(rows, relief::StoredValues::kSurface, MessageId::DrawSurfaceVoxel);
    if (buried) addPatch(rows, std::numeric_limits<float>::quiet_NaN(), MessageId::DrawBuried);
    if (picture.isoStep > 0) {
        addIsoSign(rows, picture, Message(MessageId::DrawIsoLines, {{"step", relief::numberText(picture.isoStep, 3)}}));
    }
    if (picture.isoPerDecade > 0) {
        const QString where = picture.isoPerDecade > 1 ? DistanceText::tr("lines at 1, 2 and 5 of each power of ten")
                                                       : DistanceText::tr("lines at powers of ten");
        addIsoSign(rows, picture, plainText(where.toStdString()));
    }
    if (!picture.frame.slopes) rows.line(Role::Surface, Message(MessageId::DrawSurface));
    if (source.point != nullptr) addPointLegend(rows, *source.point);
    if (!source.hasRay) return rows.take();
    rows.line(Role::Ray, Message(MessageId::DrawRay));
    if (source.steps == nullptr) return rows.take();
    // The row for violated guarantees is added only if the slice shows one.
    rows.bodies(*source.steps, source.ray, source.exact, [&](const StepBody& body) {
        const Place3 centre = placeOnRay(source, body.lambda);
        return body.kind == StepBody::Kind::Cone ||
               std::abs(offPlane(picture.frame.axis, picture.frame.plane, centre)) < body.radius;
    });
    return rows.take();
}

}  // namespace reliefui
