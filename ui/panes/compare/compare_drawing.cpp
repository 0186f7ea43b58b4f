#include "panes/compare/compare_drawing.h"

#include <algorithm>
#include <cmath>

#include "painting/chart.h"
#include "painting/legend_rows.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::CompareMode;
using relief::Message;
using relief::MessageId;

constexpr double kGap = 6;     // between tiles, in points
constexpr double kTitle = 15;  // line height of a tile's name
constexpr double kLine = 12;
constexpr double kAbove = 3;             // gap between pictures that share a place and the numbers below
constexpr const char* kBetween = "   ";  // numbers in a line

std::string figures(double value) {
    if (std::isinf(value)) return "∞";
    return relief::numberText(value, 3);
}

// Distributes the numbers over as many lines as needed.
std::vector<std::string> lines(const std::vector<std::string>& numbers, double width) {
    std::vector<std::string> out;
    const auto textOf = [](const std::string& line) { return textWidth(line); };
    for (const std::string& number : numbers) {
        if (out.empty() || textWidth(out.back() + kBetween + number) > width) {
            for (std::string& line : wrappedText(number, width, textOf)) out.push_back(std::move(line));
        } else {
            out.back() += kBetween + number;
        }
    }
    return out;
}

bool beside(const CompareSource& source) {
    return source.mode == CompareMode::Tiles || source.mode == CompareMode::Difference;
}

struct Grid {
    int columns = 1;
    int rows = 1;
    double scale = 0;  // width of a picture, in points
};

// What stands below a tile: the identifier with its options, if the heading does not say it, and the numbers.
std::vector<std::string> textsBelow(const CompareTile& tile, relief::Language language) {
    std::vector<std::string> all;
    if (!tile.title.empty()) all.push_back(tile.name.substr(2));
    for (std::string& number : compareNumbers(tile, language)) all.push_back(std::move(number));
    return all;
}

std::size_t mostLines(const CompareSource& source, double width, relief::Language language) {
    std::size_t most = std::max<std::size_t>(source.lines, 1);
    for (const CompareTile& tile : source.tiles) {
        most = std::max(most, lines(textsBelow(tile, language), width).size());
    }
    return most;
}

double tileText(const CompareSource& source, double width, relief::Language language) {
    return kTitle + kLine * static_cast<double>(mostLines(source, width, language));
}

// The grid with the largest pictures.
Grid gridOf(const CompareSource& source, double width, double height, relief::Language language) {
    Grid best;
    const int count = static_cast<int>(source.tiles.size());
    const int most = source.columns > 0 ? source.columns : count;
    for (int columns = std::max(source.columns, 1); columns <= most; ++columns) {
        const int rows = (count + columns - 1) / columns;
        const double w = (width - kGap * (columns - 1)) / columns;
        const double h = (height - kGap * (rows - 1)) / rows - tileText(source, w, language);
        const double scale = std::min(w, h / source.aspect);
        if (scale > best.scale) best = {columns, rows, scale};
    }
    return best;
}

void add(Drawing& drawing, Point at, std::string text, double size, Anchor anchor, Role role,
         Emphasis emphasis = Emphasis::Normal) {
    drawing.add({}, role, Label{.at = at, .text = plainText(std::move(text)), .anchor = anchor, .size = size},
                emphasis);
}

std::string headingOf(const CompareTile& tile) {
    return tile.title.empty() ? tile.name : tile.name.substr(0, 2) + tile.title;
}

void addTitle(Drawing& drawing, const CompareTile& tile, const Box& box, relief::Language language) {
    constexpr double kSmallest = 0.6;
    const double room = box.width() - 4;
    std::string name = headingOf(tile);
    if (tile.reference) {
        const std::string whole = name + " · " + relief::sentence(Message(MessageId::DrawCompareReference), language);
        if (textWidth(whole, kSmallest, true) <= room) name = whole;
    }
    add(drawing, {box.x0 + 2, box.y0 + kTitle / 2}, name, std::clamp(room / textWidth(name, 1, true), kSmallest, 1.0),
        Anchor::Left, Role::Title, Emphasis::Strong);
}

void addNumbers(Drawing& drawing, const CompareTile& tile, const Box& box, relief::Language language) {
    double y = box.y0 + kLine / 2;
    for (const std::string& line : lines(textsBelow(tile, language), box.width())) {
        add(drawing, {box.x0 + 2, y}, line, chart::kTextSize, Anchor::Left, Role::Legend);
        y += kLine;
    }
}

// Adds a message in the middle of the picture: why there is none, or that it is going to be replaced.
void addMissing(Drawing& drawing, const CompareTile& tile, const Box& room) {
    const std::optional<Message>& text = tile.veiled ? tile.pending : tile.missing;
    if (!text) return;
    drawing.add({}, tile.veiled ? Role::Background : Role::Label,
                Label{.at = room.center(),
                      .text = *text,
                      .anchor = Anchor::Center,
                      .size = chart::fittingSize(chart::widthOf(*text), room.width() - 4),
                      .plate = tile.veiled});
}

// Lines for one of the pictures that share a place: its name and numbers.
std::vector<std::string> numberLines(const CompareTile& tile, double width, relief::Language language) {
    std::vector<std::string> all{tile.name};
    for (std::string& number : compareNumbers(tile, language)) all.push_back(std::move(number));
    return lines(all, width);
}

std::size_t linesBelow(const CompareSource& source, double width, relief::Language language) {
    std::size_t below = 0;
    for (const CompareTile& tile : source.tiles) below += numberLines(tile, width, language).size();
    return std::max(below, source.lines);
}

CompareLayout tiled(const CompareSource& source, double width, double height, relief::Language language) {
    CompareLayout layout;
    const Grid grid = gridOf(source, width, height, language);
    const double w = (width - kGap * (grid.columns - 1)) / grid.columns;
    const double h = (height - kGap * (grid.rows - 1)) / grid.rows;
    layout.lines = mostLines(source, w, language);
    const double text = kLine * static_cast<double>(layout.lines);
    for (std::size_t n = 0; n < source.tiles.size(); ++n) {
        const auto column = static_cast<double>(static_cast<int>(n) % grid.columns);
        const auto row = static_cast<double>(static_cast<int>(n) / grid.columns);
        const Box cell{column * (w + kGap), row * (h + kGap), column * (w + kGap) + w, row * (h + kGap) + h};
        Box room{cell.x0, cell.y0 + kTitle, cell.x1, cell.y1 - text};
        // No higher than the picture, so that the numbers follow directly below it.
        room.y1 = std::max(room.y0 + 1, std::min(room.y1, room.y0 + room.width() * source.aspect));
        addTitle(layout.drawing, source.tiles[n], cell, language);
        addNumbers(layout.drawing, source.tiles[n], {cell.x0, room.y1 + 1, cell.x1, cell.y1}, language);
        addMissing(layout.drawing, source.tiles[n], room);
        layout.drawing.add({ItemKind::Layer, 0, static_cast<std::int64_t>(n), 0}, Role::Frame,
                           Rectangle{room, false, 0, 0});
        layout.rooms.push_back(room);
        layout.clips.push_back(room);
    }
    return layout;
}

// All pictures in one place, with the numbers of each in lines below.
CompareLayout stacked(const CompareSource& source, double width, double height, relief::Language language) {
    CompareLayout layout;
    const std::size_t count = source.tiles.size();
    layout.lines = linesBelow(source, width, language);
    // The box equals the picture, because dividers are positioned relative to it.
    const double most = std::max(1.0, height - kLine * static_cast<double>(layout.lines) - kAbove);
    const double side = std::min(width, most / source.aspect);
    const Box room{(width - side) / 2, 0, (width + side) / 2, side * source.aspect};
    layout.dividers = source.dividers;
    for (std::size_t n = 0; n < count; ++n) {
        Box clip = room;
        if (source.mode == CompareMode::Swipe) {
            clip.x0 = n == 0 ? room.x0 : room.x0 + source.dividers[n - 1] * room.width();
            clip.x1 = n + 1 == count ? room.x1 : room.x0 + source.dividers[n] * room.width();
        } else if (n != source.shown) {
            clip = {};
        }
        layout.rooms.push_back(room);
        layout.clips.push_back(clip);
        if (!clip.empty()) addMissing(layout.drawing, source.tiles[n], clip);
    }
    layout.drawing.add({}, Role::Frame, Rectangle{room, false, 0, 0});
    for (std::size_t n = 0; n < count; ++n) {
        const Box& clip = layout.clips[n];
        if (clip.empty()) continue;
        const std::string& name = source.tiles[n].name;
        layout.drawing.add({}, Role::Background,
                           Label{.at = {clip.x0, room.y0},
                                 .text = plainText(clip.width() > textWidth(name, 1) + 14 ? name : name.substr(0, 1)),
                                 .anchor = Anchor::TopLeft,
                                 .offset = {5, 5},
                                 .plate = true},
                           Emphasis::Strong);
        if (n == 0 || source.mode != CompareMode::Swipe) continue;
        const ItemId id{ItemKind::Layer, 0, static_cast<std::int64_t>(n), 0};
        layout.drawing.add(id, Role::Highlight, Polyline{{{clip.x0, room.y0}, {clip.x0, room.y1}}, false});
        layout.drawing.add(id, Role::Highlight, Marker{{clip.x0, room.center().y}, Shape::Diamond, 11},
                           Emphasis::Strong);
    }
    double y = room.y1 + kAbove + kLine / 2;
    for (const CompareTile& tile : source.tiles) {
        const bool strong = source.mode == CompareMode::Flicker && &tile == &source.tiles[source.shown];
        for (const std::string& line : numberLines(tile, width, language)) {
            add(layout.drawing, {2, y}, line, chart::kTextSize, Anchor::Left, Role::Legend,
                strong ? Emphasis::Strong : Emphasis::Normal);
            y += kLine;
        }
    }
    return layout;
}

// std::nullopt if no differences are shown.
std::optional<RangedValues> scaleOf(const CompareSource& source, relief::Language language) {
    if (source.mode != CompareMode::Difference || !source.errors) return std::nullopt;
    RangedValues values = *source.errors;
    values.name = relief::sentence(compareErrorName(source.measure), language);
    return values;
}

}  // namespace

std::vector<std::string> compareNumbers(const CompareTile& tile, relief::Language language) {
    std::vector<std::string> numbers;
    const auto say = [&](const Message& message) {
        for (std::string& part : textParts(relief::sentence(message, language))) numbers.push_back(std::move(part));
    };
    if (tile.pending) {
        say(*tile.pending);
        return numbers;
    }
    if (tile.missing) return numbers;
    if (!tile.same.empty()) {
        say(Message(MessageId::DrawCompareSame, {{"name", tile.same}}));
        return numbers;
    }
    if (tile.measuring) {
        say(Message(MessageId::DrawCompareMeasuringError));
        if (tile.progress) say(*tile.progress);
    } else if (tile.equal) {
        say(Message(MessageId::DrawCompareEqual));
    } else if (tile.rmse && tile.psnr && tile.flip) {
        say(Message(MessageId::DrawCompareError,
                    {{"rmse", figures(*tile.rmse)}, {"psnr", figures(*tile.psnr)}, {"flip", figures(*tile.flip)}}));
    }
    // Half the interquartile range, in per cent.
    const std::string spread = relief::fixedText(50 * tile.spread, 1);
    if (tile.rate && tile.steps) {
        say(Message(MessageId::DrawCompareRate,
                    {{"rate", figures(*tile.rate)}, {"spread", spread}, {"steps", figures(*tile.steps)}}));
    } else if (tile.rate) {
        say(Message(MessageId::DrawCompareFilterRate, {{"rate", figures(*tile.rate)}, {"spread", spread}}));
    } else if (tile.samples) {
        say(Message(MessageId::DrawCompareSamples, {{"rays", *tile.samples}}));
    } else if (tile.off) {
        if (*tile.off > 0) say(Message(MessageId::DrawCompareOff, {{"texels", figures(*tile.off)}}));
    } else if (tile.rating) {
        say(Message(MessageId::DrawCompareMeasuring));
    } else if (!tile.traces) {
        say(Message(MessageId::DrawCompareNoRays));
    }
    return numbers;
}

double compareLeastHeight(const CompareSource& source, double width, relief::Language language) {
    constexpr double kLeastPicture = 80;  // smallest width of a picture, in points
    const double picture = kLeastPicture * source.aspect;
    if (!beside(source)) return picture + kLine * static_cast<double>(linesBelow(source, width, language)) + 3;
    double least = HUGE_VAL;
    const int count = static_cast<int>(source.tiles.size());
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        const double w = (width - kGap * (columns - 1)) / columns;
        if (columns > 1 && w < kLeastPicture) break;
        least = std::min(least, rows * (picture + tileText(source, w, language)) + kGap * (rows - 1));
    }
    return least;
}

CompareLayout compareLayout(const CompareSource& source, double width, double height, relief::Language language) {
    CompareLayout layout =
        beside(source) ? tiled(source, width, height, language) : stacked(source, width, height, language);
    for (const CompareTile& tile : source.tiles) layout.veiled.push_back(tile.veiled);
    layout.bounds = {0, 0, width, height};
    layout.drawing.bounds = layout.bounds;
    return layout;
}

Message compareErrorName(relief::CompareMeasure measure) {
    return Message(measure == relief::CompareMeasure::Flip ? MessageId::DrawCompareFlip : MessageId::DrawCompareL1);
}

double compareHeight(const CompareSource& source, double width, relief::Language language) {
    if (!beside(source)) {
        return width * source.aspect + kAbove + kLine * static_cast<double>(linesBelow(source, width, language));
    }
    const int rows = (static_cast<int>(source.tiles.size()) + source.columns - 1) / source.columns;
    const double w = (width - kGap * (source.columns - 1)) / source.columns;
    const double one = kTitle + w * source.aspect + kLine * static_cast<double>(mostLines(source, w, language));
    return one * rows + kGap * (rows - 1);
}

Drawing compareScale(const CompareSource& source, double width, relief::Language language) {
    const auto values = scaleOf(source, language);
    return values ? rangeLegend(*values, width, true) : Drawing();
}

Drawing compareLegend(const CompareSource& source, double width, relief::Language language) {
    LegendRows rows(width, language);
    if (source.mode == CompareMode::Difference) {
        RangedValues none;
        none.spread = std::make_shared<const ValueSpread>();
        Drawing scale = rangeLegend(scaleOf(source, language).value_or(none), width);
        // Not measured yet: only the room is reserved, so that the pictures do not move later.
        if (!source.errors) scale.items.clear();
        rows.block(std::move(scale));
    }
    const bool filters = source.subject == relief::CompareSubject::Filters;
    const Message note =
        source.rays > 0 ? Message(filters ? MessageId::DrawCompareFiltersAgainst : MessageId::DrawCompareAgainst,
                                  {{"reference", source.reference}, {"rays", source.rays}, {"rounds", source.rounds}})
                        : Message(MessageId::DrawCompareColors, {{"reference", source.reference}});
    rows.words(note, 0);
    return rows.take();
}

}  // namespace reliefui
