// Text of the pane about the compared pictures, next to them and under the pointer.
#include <algorithm>

#include <QCoreApplication>

#include "panes/compare/compare_data.h"
#include "panes/core_texts.h"
#include "panes/result/result_painting.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::CompareSubject;

class CompareText {
    Q_DECLARE_TR_FUNCTIONS(reliefui::CompareText)
};

}  // namespace

CompareSource compareSource(const ComparedView& view, const relief::Scenario& scenario, std::size_t shown,
                            const ComparePending& pending) {
    CompareSource source;
    const relief::MethodChoice reference = comparedReference(scenario);
    const relief::Comparison& how = scenario.comparison;
    const std::vector<relief::MethodChoice> all = relief::comparedOf(scenario);
    source.subject = how.subject;
    source.mode = how.mode;
    source.measure = how.measure;
    source.dividers = relief::dividersOf(how);
    source.shown = shown % all.size();
    source.aspect = static_cast<double>(scenario.height) / scenario.width;
    if (const ErrorScale& scale = view.scaleOf(how.measure); scale.spread && view.measured(scenario, 0)) {
        RangedValues values;
        values.of = rangeOf(how.measure);
        values.map = ColorMap::Count;
        values.range = scale.range;
        values.scale = scale.scale;
        values.spread = scale.spread;
        source.errors = std::move(values);
    }
    source.reference = comparedReferenceName(scenario);
    source.rays = view.measured(scenario, 0) ? view.rays : 0;
    source.rounds = view.rounds;
    const auto first = [&](std::size_t n) {
        return std::find_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n),
                            [&](const auto& one) { return relief::sameVariation(how.subject, one, all[n]); });
    };
    for (std::size_t n = 0; n < all.size(); ++n) {
        CompareTile tile;
        tile.name = comparedName(n, how.subject, all[n]);
        tile.title = titleText(relief::describedVariation(how.subject, all[n]).title).toStdString();
        tile.reference = relief::sameVariation(how.subject, all[n], reference);
        const auto same = static_cast<std::size_t>(first(n) - all.begin());
        if (same < n) tile.same = std::string(1, static_cast<char>('A' + same));
        tile.veiled = !view.current(scenario, n) && pending.veil;
        if (!view.current(scenario, n) || view.coarse) {
            tile.pending = pending.text;
        } else {
            const ComparedPicture& picture = view.pictures[n];
            tile.missing = picture.problem;
            tile.traces = picture.traces || how.subject != CompareSubject::Methods;
            tile.measuring = !view.measured(scenario, n);
            if (tile.measuring && pending.stopped) tile.pending = pending.text;
            if (pending.text.id != relief::MessageId::DrawComparePending) tile.progress = pending.text;
            tile.rating = picture.traces && !view.rated;
            if (!tile.measuring && picture.error) {
                tile.equal = picture.equal;
                tile.rmse = picture.error->rmse;
                tile.psnr = picture.error->psnr;
                tile.flip = picture.error->flip;
            }
            tile.rate = picture.rate;
            tile.spread = picture.spread;
            tile.steps = picture.steps;
            if (how.subject == CompareSubject::Mappings && picture.frame) tile.off = picture.frame->mappingOff;
            if (how.subject == CompareSubject::Filters && all[n].name == relief::kSupersample) {
                const int samples = relief::varied(scenario, how.subject, all[n]).filter.samples;
                tile.samples = samples * samples;
            }
        }
        source.tiles.push_back(std::move(tile));
    }
    return source;
}

QString compareReadout(const ComparedView& view, const relief::Scenario& scenario, std::size_t number,
                       relief::PixelChoice pixel) {
    if (!view.current(scenario, number)) return {};
    const ComparedPicture& picture = view.pictures[number];
    QString text = QString::fromStdString(picture.name);
    if (!picture.frame) return text;
    const relief::Frame& frame = *picture.frame;
    const int x = std::clamp(pixel.x * frame.width / scenario.width, 0, frame.width - 1);
    const int y = std::clamp(pixel.y * frame.height / scenario.height, 0, frame.height - 1);
    const std::size_t i = frame.index(x, y);
    const auto fixed = [](double value, int decimals) {
        return QString::fromStdString(relief::fixedText(value, decimals));
    };
    if (frame.rays->polygon[i] == relief::kNoPolygon) return text + QStringLiteral(": ") + outcomeTitle({});
    const relief::Hit hit = frame.hits->hits[i];
    text += QStringLiteral(": ");
    text += hit.outcome == relief::Outcome::Hit
                ? CompareText::tr("(%1, %2) λ %3").arg(fixed(hit.s, 2), fixed(hit.t, 2), fixed(hit.lambda, 3))
                : outcomeTitle(hit.outcome);
    if (scenario.comparison.subject == CompareSubject::Methods && picture.traces && picture.tracer) {
        relief::RayBlock ray;
        ray.push(frame.rays->rays[i]);
        relief::HitBlock again;
        relief::BlockCounts counts;
        relief::Work work(1);
        picture.tracer->trace(ray, again, counts, work);
        text += CompareText::tr(", steps: %1").arg(again.steps[0]);
    }
    if (scenario.comparison.subject == CompareSubject::Filters) {
        const QRgb color = picture.picture.pixel(x, y);
        text += QStringLiteral(", RGB %1 %2 %3").arg(qRed(color)).arg(qGreen(color)).arg(qBlue(color));
    }
    if (picture.flip && view.measured(scenario, number)) {
        text += QStringLiteral(", FLIP %1").arg(fixed(static_cast<double>((*picture.flip)(x, y)), 3));
    }
    return text;
}

}  // namespace reliefui
