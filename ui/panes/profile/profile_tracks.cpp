// The columns of another program's steps as tracks below the profile.
#include <algorithm>

#include "painting/chart.h"
#include "panes/profile/profile_drawing.h"
#include "panes/value_graph.h"

namespace reliefui {

namespace {

// Sizes in points.
constexpr double kTrack = 30;
constexpr double kLeastTrack = 16;
constexpr double kBetween = 3;
constexpr double kNameSize = 0.75;
constexpr double kMostTracks = 0.4;  // as a share of the height

// The columns that are shown: those that have numbers.
std::vector<const relief::FurtherColumn*> tracksOf(const ProfileSource& source) {
    std::vector<const relief::FurtherColumn*> tracks;
    // A duel shows the profile of several methods, without steps.
    const bool steps = source.steps != nullptr && !source.steps->empty();
    if (!source.hasRay || source.further == nullptr || !steps) return tracks;
    for (const relief::FurtherColumn& column : *source.further) {
        const auto numbers = relief::columnNumbers(column);
        if (numbers && !graphRange(*numbers).empty()) tracks.push_back(&column);
    }
    return tracks;
}

std::size_t tracksThatFit(double room) {
    return static_cast<std::size_t>(std::max(0.0, room / kLeastTrack));
}

}  // namespace

double tracksHeight(const ProfileSource& source, double height) {
    const std::size_t count = std::min(tracksOf(source).size(), tracksThatFit(kMostTracks * height));
    return std::min(static_cast<double>(count) * kTrack, kMostTracks * height);
}

void addTracks(Drawing& drawing, const ProfileSource& source, const ProfileFrame& frame, int step) {
    if (frame.tracks <= 0) return;
    std::vector<const relief::FurtherColumn*> columns = tracksOf(source);
    columns.resize(std::min(columns.size(), tracksThatFit(frame.tracks)));
    const double unit = 1 / frame.zoom;
    const Box seen = frame.seen();
    const double left = std::max(seen.x0, frame.visible.x0 + chart::kLeft * unit);
    const double high = frame.tracks * unit / static_cast<double>(columns.size());
    const auto& steps = *source.steps;
    const auto chosen = static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(steps.size()) - 1));
    const auto xAt = [&](double lambda) { return std::clamp(frame.xAt(lambda), left, std::max(left, seen.x1)); };
    std::vector<GraphPart> parts;
    for (const relief::Step& one : steps) parts.push_back({xAt(one.lambdaIn), xAt(one.lambdaOut)});
    for (std::size_t n = 0; n < columns.size(); ++n) {
        const double top = frame.visible.y1 - frame.tracks * unit + static_cast<double>(n) * high;
        const Box box{left, top + kBetween * unit, std::max(left, seen.x1), top + high};
        drawing.add({}, Role::Background, Rectangle{box, true, 0, 0}, Emphasis::Strong);
        drawing.add({}, Role::Grid, Rectangle{box, false, 0, 0});
        addValueGraph(drawing, box, parts, *relief::columnNumbers(*columns[n]), chosen, unit);
        const std::string& cell = columns[n]->cells[chosen];
        const std::string name = columns[n]->name + (cell.empty() ? "" : " " + cell);
        const double margin = 2 * unit;
        const double width = textWidth(name, kNameSize) * unit;
        // Above the curve, which may pass there.
        drawing.add(
            {}, Role::Background,
            Rectangle{{box.x0 + unit, box.y0 + unit, box.x0 + width + 3 * margin, box.y0 + 11 * unit}, true, 0, 0},
            Emphasis::Strong);
        drawing.add({}, Role::Legend,
                    Label{.at = {box.x0, box.y0},
                          .text = plainText(name),
                          .anchor = Anchor::TopLeft,
                          .size = kNameSize,
                          .offset = {3, 1}});
    }
}

}  // namespace reliefui
