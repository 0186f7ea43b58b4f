#include "panes/shader/shader_drawing.h"

#include <algorithm>
#include <cmath>

#include "painting/chart.h"
#include "painting/legend_rows.h"
#include "relief/ray.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

constexpr double kGap = 6;     // between pictures, points
constexpr double kTitle = 15;  // height of a picture's title, points
constexpr int kDigits = 3;

// Smallest difference of hits, texels, that a logarithmic scale tells from none: float's rounding.
constexpr double kLeastHit = 1e-4;

std::string number(double value) {
    return relief::numberText(value, kDigits);
}

Message valueText(const ShaderPreview& preview, ShaderMeasure measure, relief::PixelChoice pixel) {
    const auto value = static_cast<double>((*preview.differences(measure))(pixel.x, pixel.y));
    if (std::isinf(value)) return Message(MessageId::ShaderOnlyOne);
    if (measure == ShaderMeasure::Colors || std::isnan(value))
        return plainText(std::isnan(value) ? "-" : number(value));
    return Message(MessageId::ShaderTexels, {{"texels", number(value)}});
}

std::vector<relief::MessageValue> timeValues(const ShaderPreview& preview) {
    constexpr double kMilli = 1000, kPercent = 100;
    return {{"milliseconds", number(kMilli * preview.seconds)},
            {"percent", relief::numberText(kPercent * preview.spread, 2)},
            {"width", preview.shader->width()},
            {"height", preview.shader->height()},
            {"renderer", preview.renderer}};
}

// The columns with the largest pictures.
int columnsFor(double width, double height, double aspect) {
    int best = 1;
    double largest = 0;
    for (const int columns : {1, 2, 3}) {
        const int rows = (2 + columns) / columns;
        const double room =
            std::min((width - kGap * (columns - 1)) / columns, ((height - kGap * (rows - 1)) / rows - kTitle) / aspect);
        if (room > largest) {
            largest = room;
            best = columns;
        }
    }
    return best;
}

}  // namespace

RangeOf shaderRangeOf(ShaderMeasure measure) {
    return measure == ShaderMeasure::Colors ? RangeOf::CompareL1 : RangeOf::Error;
}

RangedValues shaderValues(const ShaderSource& source, relief::Language language) {
    const bool hits = source.measure == ShaderMeasure::Hits;
    RangedValues values;
    values.of = shaderRangeOf(source.measure);
    values.name = relief::sentence(Message(hits ? MessageId::ShaderHitName : MessageId::ShaderColorName), language);
    values.map = hits ? ColorMap::Difference : ColorMap::Count;
    values.range = source.range;
    values.spread = source.preview->spreads[static_cast<std::size_t>(source.measure)];
    const ScaleEnds ends =
        hits ? ScaleEnds{0, std::max(values.spread->largestMagnitude(), 10 * kLeastHit), true, kLeastHit}
             : ScaleEnds{0, values.spread->largest()};
    values.scale = colorScale(source.range, *values.spread, ends);
    return values;
}

std::optional<relief::PixelChoice> ShaderPicture::pixelAt(Point at) const {
    for (const Box& room : rooms) {
        if (!room.contains(at)) continue;
        return relief::PixelChoice{static_cast<int>(std::min(at.x - room.x0, room.width() * (1 - 1e-9)) / pixelSide),
                                   static_cast<int>(std::min(at.y - room.y0, room.height() * (1 - 1e-9)) / pixelSide)};
    }
    return std::nullopt;
}

ShaderPicture shaderPicture(const ShaderSource& source, double width, double height, relief::Language language) {
    const ShaderPreview& preview = *source.preview;
    const relief::FloatImage& shader = *preview.shader;
    const double aspect = static_cast<double>(shader.height()) / shader.width();
    const int columns = columnsFor(width, height, aspect), rows = (2 + columns) / columns;
    constexpr double kLeastSide = 40;  // a smaller pane scales the drawing
    const double side = std::max(kLeastSide, std::min((width - kGap * (columns - 1)) / columns,
                                                      ((height - kGap * (rows - 1)) / rows - kTitle) / aspect));
    ShaderPicture out;
    out.pixelSide = side / shader.width();
    const std::array titles{MessageId::ShaderTitle, MessageId::ShaderTitleCpu, MessageId::ShaderTitleDifference};
    const std::array pictures{preview.shader, preview.cpu, preview.differences(source.measure)};
    const RangedValues values = shaderValues(source, language);
    for (std::size_t n = 0; n < titles.size(); ++n) {
        const double x = static_cast<double>(static_cast<int>(n) % columns) * (side + kGap);
        const double y = static_cast<double>(static_cast<int>(n) / columns) * (side * aspect + kTitle + kGap);
        Box& room = out.rooms[n];
        room = {x, y + kTitle, x + side, y + kTitle + side * aspect};
        const Message title(titles[n]);
        Label label;
        label.at = {x, y + kTitle / 2};
        label.text = source.before ? Message(MessageId::ShaderTitleBefore, {{"title", title}}) : title;
        label.size = chart::fittingSize(chart::widthOf(label.text), side);
        out.drawing.add({}, Role::Title, std::move(label));
        Cells cells;
        cells.values = pictures[n];
        cells.x = room.x0;
        cells.y = room.y0;
        cells.cellWidth = cells.cellHeight = out.pixelSide;
        cells.clip = room;
        cells.map = n < 2 ? ColorMap::Picture : values.map;
        if (n == 2) cells.scale = values.scale;
        out.drawing.add({ItemKind::Layer, 0, static_cast<std::int64_t>(n), 0}, Role::Frame, std::move(cells));
        if (!source.pixel) continue;
        const Point at{room.x0 + (source.pixel->x + 0.5) * out.pixelSide,
                       room.y0 + (source.pixel->y + 0.5) * out.pixelSide};
        out.drawing.add({}, Role::Hit, Ring{at});
    }
    const double used = static_cast<double>(columns) * (side + kGap) - kGap;
    out.drawing.bounds = {0, 0, used, static_cast<double>(rows) * (side * aspect + kTitle + kGap) - kGap};
    return out;
}

std::vector<Message> shaderLines(const ShaderSource& source) {
    const ShaderPreview& preview = *source.preview;
    std::vector<Message> lines;
    if (source.timed) {
        lines.emplace_back(preview.frames > 1 ? MessageId::ShaderSpeed : MessageId::ShaderSpeedOnce,
                           timeValues(preview));
    }
    const relief::ShaderDifferences& found = preview.found;
    lines.push_back(Message(MessageId::ShaderHits, {{"far", found.far},
                                                    {"count", found.compared},
                                                    {"texels", number(relief::kSameAnswer)},
                                                    {"largest", number(found.largestHit)},
                                                    {"other", found.otherOutcome}}));
    lines.push_back(
        Message(MessageId::ShaderColors, {{"mean", number(found.meanColor)}, {"largest", number(found.largestColor)}}));
    if (const auto worst = preview.worst(source.measure)) {
        lines.push_back(
            Message(MessageId::ShaderWorst,
                    {{"x", worst->x}, {"y", worst->y}, {"value", valueText(preview, source.measure, *worst)}}));
    } else {
        lines.push_back(Message(MessageId::ShaderEqual));
    }
    if (preview.notes.empty()) return lines;
    Message notes = preview.notes.front();
    for (std::size_t n = 1; n < preview.notes.size(); ++n) {
        notes = Message(MessageId::ShaderNoteTwo, {{"first", notes}, {"second", preview.notes[n]}});
    }
    lines.push_back(Message(MessageId::ShaderNotes, {{"notes", notes}}));
    return lines;
}

Message shaderSummary(const ShaderPreview& preview) {
    const relief::ShaderDifferences& found = preview.found;
    Message line(preview.frames > 1 ? MessageId::ShaderSummary : MessageId::ShaderSummaryOnce, timeValues(preview));
    line.values.emplace_back("far", found.far + found.otherOutcome);
    return line;
}

Drawing shaderLegend(const ShaderSource& source, double width, relief::Language language) {
    LegendRows rows(width, language);
    rows.block(rangeLegend(shaderValues(source, language), width, true));
    for (const Message& line : shaderLines(source)) {
        rows.words(line);
        rows.newRow();
    }
    return rows.take();
}

Message shaderReadout(const ShaderPreview& preview, relief::PixelChoice pixel) {
    return Message(MessageId::ShaderReadout, {{"x", pixel.x},
                                              {"y", pixel.y},
                                              {"hit", valueText(preview, ShaderMeasure::Hits, pixel)},
                                              {"color", valueText(preview, ShaderMeasure::Colors, pixel)}});
}

}  // namespace reliefui
