// Errors of the compared pictures against their reference, as numbers and as colours; and rendering the same pictures
// again for a page.
#include <algorithm>
#include <cmath>

#include "painting/style.h"
#include "panes/compare/compare_data.h"
#include "workspace/discard.h"
#include "workspace/range_json.h"
#include "workspace/resized_snapshot.h"

namespace reliefui {

namespace {

using relief::CompareMeasure;
using relief::CompareSubject;

constexpr CompareMeasure kMeasures[] = {CompareMeasure::L1, CompareMeasure::Flip};
// Sample size of the spread of values; with more, counts are estimates.
constexpr std::size_t kMostSpread = std::size_t{1} << 20;

std::shared_ptr<const relief::FloatImage> l1Errors(const relief::ColorImage& a, const relief::ColorImage& b) {
    const auto encoded = [](float v) { return relief::srgbFromLinear(std::clamp(v, 0.0F, 1.0F)); };
    auto errors = std::make_shared<relief::FloatImage>(a.width(), a.height());
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        float sum = 0;
        for (int c = 0; c < 3; ++c) sum += std::abs(encoded(a.pixels()[i][c]) - encoded(b.pixels()[i][c]));
        errors->pixels()[i] = sum / 3;
    }
    return errors;
}

const std::shared_ptr<const relief::FloatImage>& errorsOf(const ComparedPicture& picture, CompareMeasure measure) {
    return measure == CompareMeasure::L1 ? picture.l1 : picture.flip;
}

QImage colored(const relief::FloatImage& errors, const ColorScale& scale) {
    const Style style;  // the theme does not matter: the map of counts is the same in both
    QImage image(errors.width(), errors.height(), QImage::Format_RGB32);
    for (int y = 0; y < errors.height(); ++y) {
        auto* const line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < errors.width(); ++x) {
            const Rgba c = style.cell(ColorMap::Count, static_cast<double>(errors(x, y)), scale);
            line[x] = qRgb(c.r, c.g, c.b);
        }
    }
    return image;
}

void spread(ComparedView& view) {
    for (const CompareMeasure measure : kMeasures) {
        auto values = std::make_shared<ValueSpread>(kMostSpread);
        for (const ComparedPicture& picture : view.pictures) {
            const auto& errors = errorsOf(picture, measure);
            if (!errors || view.isReference(picture)) continue;
            for (const float error : errors->pixels()) values->add(error);
        }
        values->finish();
        view.scales[static_cast<std::size_t>(measure)].spread = std::move(values);
    }
}

void color(ComparedView& view, const ColorRanges& ranges) {
    for (const CompareMeasure measure : kMeasures) {
        ErrorScale& scale = view.scales[static_cast<std::size_t>(measure)];
        scale.range = ranges.of(rangeOf(measure));
        scale.scale = colorScale(scale.range, *scale.spread, {0, scale.spread->largest()});
    }
    for (ComparedPicture& picture : view.pictures) {
        if (!picture.error) continue;
        picture.l1Picture = colored(*picture.l1, view.scaleOf(CompareMeasure::L1).scale);
        picture.flipPicture = colored(*picture.flip, view.scaleOf(CompareMeasure::Flip).scale);
    }
}

// The snapshot at another size, with this choice of the comparison's subject.
std::shared_ptr<const Snapshot> resizedAs(const Snapshot& snapshot, const relief::MethodChoice& choice, int width,
                                          relief::Work& work) {
    const CompareSubject subject = snapshot.scenario.comparison.subject;
    auto own = std::make_shared<Snapshot>(snapshot);
    own->scenario = relief::varied(snapshot.scenario, subject, choice);
    if (subject == CompareSubject::Heights) own->assets.heights = relief::variedHeights(own->assets.heights, choice);
    own->layer = {};
    return resized(own, width, work);
}

}  // namespace

RangeOf rangeOf(CompareMeasure measure) {
    return measure == CompareMeasure::L1 ? RangeOf::CompareL1 : RangeOf::CompareFlip;
}

bool ComparedView::inRanges(const ColorRanges& ranges) const {
    return std::ranges::all_of(kMeasures, [&](CompareMeasure measure) {
        return scaleOf(measure).range == ranges.of(reliefui::rangeOf(measure));
    });
}

void Comparer::measure(ComparedView& view, const relief::Frame& reference, relief::Work& work) const {
    const relief::ColorImage& right = reference.light->color;
    for (ComparedPicture& picture : view.pictures) {
        if (!picture.frame) continue;
        work.throwIfStopped();
        const relief::ColorImage& test = picture.frame->light->color;
        relief::FloatImage map;
        picture.error = relief::pictureError(right, test, relief::kPixelsPerDegree, map, work);
        picture.equal = picture.frame.get() == &reference || std::ranges::equal(right.pixels(), test.pixels());
        picture.flip = std::make_shared<const relief::FloatImage>(std::move(map));
        picture.l1 = l1Errors(right, test);
    }
    spread(view);
    color(view, rangesOf(view.scenario));
}

std::shared_ptr<const ComparedView> recolored(const ComparedView& view, const ColorRanges& ranges) {
    auto other = makeFreedInBackground<ComparedView>(view);
    color(*other, ranges);
    return other;
}

std::vector<QImage> redrawnPictures(const ComparedView& view, const Snapshot& snapshot, int width, relief::Work& work) {
    const relief::Comparison& how = snapshot.scenario.comparison;
    const std::vector<relief::MethodChoice> all = relief::comparedOf(snapshot.scenario);
    std::vector<QImage> pictures(all.size());
    const bool asShown = width == view.scenario.width;
    const bool errors = how.mode == relief::CompareMode::Difference;
    std::shared_ptr<const Snapshot> reference;
    if (errors && !asShown) reference = resizedAs(snapshot, comparedReference(snapshot.scenario), width, work);
    for (std::size_t n = 0; n < all.size(); ++n) {
        const ComparedPicture& picture = view.pictures[n];
        const bool isReference = view.isReference(picture);
        if (picture.problem) continue;
        if (asShown || (reference && isReference)) {
            pictures[n] = asShown ? picture.shown(how, isReference) : reference->picture;
            continue;
        }
        const auto drawn = resizedAs(snapshot, all[n], width, work);
        pictures[n] = drawn->picture;
        if (!errors) continue;
        const relief::ColorImage& right = reference->frame->light->color;
        const relief::ColorImage& test = drawn->frame->light->color;
        const ColorScale& scale = view.scaleOf(how.measure).scale;
        if (how.measure == CompareMeasure::L1) {
            pictures[n] = colored(*l1Errors(right, test), scale);
        } else {
            relief::FloatImage flip;
            relief::pictureError(right, test, relief::kPixelsPerDegree, flip, work);
            pictures[n] = colored(flip, scale);
        }
    }
    return pictures;
}

}  // namespace reliefui
