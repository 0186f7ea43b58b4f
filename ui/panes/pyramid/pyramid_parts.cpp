#include "panes/pyramid/pyramid_parts.h"

namespace reliefui {

namespace {

using relief::PyramidKind;

constexpr double kBetween = 16;  // points

void append(Drawing& to, Drawing from) {
    to.bounds = to.bounds.joined(from.bounds);
    for (Item& item : from.items) to.items.push_back(std::move(item));
}

// How large its levels are drawn.
double scaleOf(const PyramidPicture& picture) {
    return picture.blocks.front().unitX() * picture.blocks.back().unitX();
}

}  // namespace

PyramidOptions pyramidOptions(const PyramidPane& pane) {
    PyramidOptions options;
    if (pane.levels == "mean") options.kind = PyramidKind::Mean;
    if (pane.levels == "min") options.kind = PyramidKind::Min;
    options.all = pane.levels == "all";
    options.nearRay = pane.nearRay;
    return options;
}

PyramidSource pyramidSource(const Snapshot& s, const PyramidOptions& options) {
    PyramidSource source;
    source.field = &s.request->field;
    source.overCells = options.kind == PyramidKind::Max;
    source.pyramid = source.overCells ? std::shared_ptr<const relief::Pyramid>(s.maxima, &s.maxima->pyramid)
                                      : (options.kind == PyramidKind::Mean ? s.means : s.minima);
    source.hasRay = s.trace.onRelief;
    source.ray = s.trace.ray;
    source.hit = s.trace.hit;
    source.steps = &s.trace.steps;
    source.baseLevel = s.trace.baseLevel;
    source.nearRay = options.nearRay;
    return source;
}

const PyramidPart* PyramidParts::at(Point point) const {
    for (const PyramidPart& part : parts) {
        if (part.picture.levels.bounds.contains(point)) return &part;
    }
    return nullptr;
}

PyramidParts pyramidParts(const Snapshot& snapshot, const PyramidOptions& options, double width, double height) {
    std::vector<PyramidKind> kinds{options.kind};
    if (options.all) kinds = {PyramidKind::Max, PyramidKind::Mean, PyramidKind::Min};
    std::erase_if(kinds, [&](PyramidKind kind) { return !snapshot.has(kind); });
    PyramidParts all;
    if (kinds.empty()) return all;
    const auto count = static_cast<double>(kinds.size());
    const auto sourceOf = [&](PyramidKind kind) {
        PyramidOptions one = options;
        one.kind = kind;
        return pyramidSource(snapshot, one);
    };
    // One above the other or side by side, whichever draws them larger.
    const double high = (height - (count - 1) * kBetween) / count;
    const double wide = (width - (count - 1) * kBetween) / count;
    const PyramidSource first = sourceOf(kinds.front());
    const bool rows =
        scaleOf(pyramidPicture(first, width, high)) >= scaleOf(pyramidPicture(first, wide, height)) || count == 1;
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        PyramidPart part;
        part.source = sourceOf(kinds[n]);
        const auto number = static_cast<double>(n);
        part.picture = rows ? pyramidPicture(part.source, width, high, {0, number * (high + kBetween)})
                            : pyramidPicture(part.source, wide, height, {number * (wide + kBetween), 0});
        append(all.levels, part.picture.levels);
        all.parts.push_back(std::move(part));
    }
    return all;
}

Drawing partsMarks(const PyramidParts& parts, int step) {
    Drawing marks;
    for (const PyramidPart& part : parts.parts) append(marks, pyramidMarks(part.source, part.picture, step));
    return marks;
}

}  // namespace reliefui
