#include "panes/pyramid/pyramid_parts.h"

#include "painting/view_map.h"
#include "scenario/step_sentence.h"
#include "workspace/pane_store.h"
#include "workspace/range_json.h"

namespace reliefui {

namespace {

using relief::PyramidKind;

constexpr double kBetween = 16;  // in points

// Values of the visible cells of all levels.
ValueSpread seenHeights(const Drawing& levels) {
    constexpr std::size_t kMostSorted = std::size_t{1} << 16;
    ValueSpread spread(kMostSorted);
    for (const Item& item : levels.items) {
        const auto* const cells = std::get_if<Cells>(&item.primitive);
        if (cells == nullptr) continue;
        const CellRange seen = visibleCells(*cells, cells->clip);
        for (int j = seen.j0; j < seen.j1; ++j) {
            for (int i = seen.i0; i < seen.i1; ++i) spread.add((*cells->values)(i, j));
        }
    }
    spread.finish();
    return spread;
}

// Colours the heights with a common range for all levels and pyramids, which spans the visible values.
void colorHeights(PyramidParts& parts, const ColorRange& range, relief::Language language) {
    const relief::HeightField& field = *parts.parts.front().source.field;
    RangedValues& heights = parts.heights;
    heights.name = relief::sentence(
        relief::Message(relief::MessageId::DrawHeightLegend, {{"texels", relief::numberText(field.slabTexels(), 3)}}),
        language);
    heights.counted = Counted::Texels;
    heights.range = range;
    heights.spread = std::make_shared<const ValueSpread>(seenHeights(parts.levels));
    const ValueSpread& spread = *heights.spread;
    const bool flat = !(spread.largest() > spread.least());
    heights.scale = colorScale(range, spread, flat ? ScaleEnds{0, 1} : ScaleEnds{spread.least(), spread.largest()});
    const auto apply = [&](Drawing& levels) {
        for (Item& item : levels.items) {
            if (auto* const cells = std::get_if<Cells>(&item.primitive)) cells->scale = heights.scale;
        }
    };
    apply(parts.levels);
    for (PyramidPart& part : parts.parts) apply(part.picture.levels);
}

// Measure of the size at which the levels are drawn.
double scaleOf(const PyramidPicture& picture) {
    return picture.blocks.front().unitX() * picture.blocks.back().unitX();
}

}  // namespace

PyramidOptions pyramidOptions(const relief::Scenario& scenario) {
    const auto pane = stateOf<PyramidPane>(scenario);
    PyramidOptions options;
    if (pane.levels == "mean") options.kind = PyramidKind::Mean;
    if (pane.levels == "min") options.kind = PyramidKind::Min;
    options.all = pane.levels == "all";
    options.nearRay = pane.nearRay;
    options.slender = pane.stacked;
    options.heights = rangesOf(scenario).of(RangeOf::Height);
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
    source.slender = options.slender;
    return source;
}

const PyramidPart* PyramidParts::at(Point point) const {
    for (const PyramidPart& part : parts) {
        if (part.picture.levels.bounds.contains(point)) return &part;
    }
    return nullptr;
}

PyramidParts pyramidParts(const Snapshot& snapshot, const PyramidOptions& options, double width, double height,
                          relief::Language language) {
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
    // Arranges the pyramids vertically or horizontally, whichever draws them larger.
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
        all.levels.append(part.picture.levels);
        all.parts.push_back(std::move(part));
    }
    colorHeights(all, options.heights, language);
    return all;
}

Drawing partsMarks(const PyramidParts& parts, int step) {
    Drawing marks;
    for (const PyramidPart& part : parts.parts) marks.append(pyramidMarks(part.source, part.picture, step));
    return marks;
}

}  // namespace reliefui
