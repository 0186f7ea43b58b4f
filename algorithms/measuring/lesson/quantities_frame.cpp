// Quantities of the whole picture: errors, steps, counters; of the method's map; and of the methods for rows.
#include <algorithm>
#include <span>

#include "filtering/pixel_model.h"
#include "measuring/lesson/quantity_query.h"
#include "measuring/quantiles.h"

namespace relief {

namespace {

constexpr std::uint64_t kCertifiedRays = 20000;
constexpr int kTruth = 8;  // samples along a side of a pixel
constexpr int kMostTruth = 64;

// The errors of the rays with the right outcome.
std::vector<double> finiteErrors(const Query& query) {
    const ErrorLayer& errors = query.scene().errors(query.work);
    std::vector<double> out;
    for (std::size_t i = 0; i < errors.texels.size(); ++i) {
        if (errors.kinds[i] != ErrorKind::None && errors.kinds[i] != ErrorKind::Wrong)
            out.push_back(static_cast<double>(errors.texels[i]));
    }
    return out;
}
double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? 0 : sum / asNumber(values.size());
}
double p95Of(std::vector<double> values) {
    constexpr double kShare = 0.95;
    return values.empty() ? 0 : quantile(std::move(values), kShare);
}
double largestOf(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}
template <ErrorKind Kind>
double errorsOf(const Query& query) {
    return asNumber(query.scene().errors(query.work).counts[static_cast<std::size_t>(Kind)]);
}
template <class T>
std::vector<double> perRay(const Query& query, const std::vector<T>& values) {
    const auto& polygon = query.frame().rays->polygon;
    std::vector<double> out;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (polygon[i] != kNoPolygon) out.push_back(asNumber(values[i]));
    }
    return out;
}
std::vector<double> stepsOf(const Query& query) {
    return perRay(query, query.frame().hits->hits.steps);
}
template <Outcome Wanted>
double outcomesOf(const Query& query) {
    const auto& outcome = query.frame().hits->hits.outcome;
    return asNumber(std::count(outcome.begin(), outcome.end(), Wanted));
}
std::size_t pixelOf(const Query& query) {
    const Frame& frame = query.frame();
    return frame.index(query.whole(0, 0, frame.width - 1), query.whole(1, 0, frame.height - 1));
}

// FNV-1a, 64 bits.
class Checksum {
  public:
    template <class T>
    void add(std::span<const T> values) {
        for (const std::byte byte : std::as_bytes(values))
            sum_ = (sum_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
    }
    std::string text() const {
        constexpr std::string_view kDigits = "0123456789abcdef";
        std::string out;
        for (int shift = 60; shift >= 0; shift -= 4) out += kDigits[(sum_ >> static_cast<unsigned>(shift)) & 15U];
        return out;
    }

  private:
    std::uint64_t sum_ = 0xcbf29ce484222325;
};
std::string hitsChecksum(const Query& query) {
    const HitBlock& hits = query.frame().hits->hits;
    Checksum sum;
    sum.add(std::span<const Outcome>(hits.outcome));
    for (std::size_t i = 0; i < hits.size(); ++i) {
        // NaN, where there is no hit, has many representations.
        if (hits.outcome[i] == Outcome::Hit) sum.add(std::span<const double>(&hits.lambda[i], 1));
    }
    return sum.text();
}
std::string pictureChecksum(const Query& query) {
    Checksum sum;
    sum.add(query.frame().light->color.pixels());
    return sum.text();
}

PictureError pictureErrorOf(const Query& query) {
    const int samples = query.has(0) ? query.whole(0, 2, kMostTruth) : kTruth;
    const PixelModel model = query.has(1) ? parsePixelModel(query.text(1)) : query.scenario.filter.pixelModel;
    const ColorImage& truth = query.scenes.truth(query.scenario, samples, model, query.work);
    return query.scene().pictureError(truth, query.work);
}

double counterOf(const Query& query) {
    const std::string wanted = query.text(0);
    std::vector<std::string> known;
    for (const auto& [what, value] : query.frame().counters) {
        const std::string_view name = messageTemplate(what, Language::English);
        if (name == wanted) return value;
        known.emplace_back(name);
    }
    query.fail(0, unknownName({"what", MessageId::WordName}, wanted, commaList(known)));
}
const SkipRow& skippedRow(const Query& query) {
    const std::string wanted = query.text(0);
    const auto& rows = query.scene().skipped(query.work);
    for (const SkipRow& row : rows) {
        if (row.name == wanted) return row;
    }
    query.fail(0, unknownName({"what", MessageId::WordName}, wanted, namesOf(rows)));
}

double skippedShare(const Query& query) {
    const SkipRow& row = skippedRow(query);
    return row.of > 0 ? row.count / row.of : 0;
}

const Certificate& certificateOf(const Query& query) {
    constexpr double kMostRays = 1e7;
    const auto rays = query.has(0) ? static_cast<std::uint64_t>(query.whole(0, 1, kMostRays)) : kCertifiedRays;
    return query.scene().certificate(rays, query.work);
}

const RowBenchRow& rowOf(const Query& query) {
    constexpr double kUsualWidth = 4096, kUsualElevation = 25;
    const auto width = static_cast<std::int64_t>(query.has(1) ? query.whole(1, 1, asNumber(kWidestRow)) : kUsualWidth);
    const double elevation = query.has(2) ? query.number(2, 1, 90) : kUsualElevation;
    const std::string precision = query.has(3) ? query.text(3) : "double";
    if (precision != "double" && precision != "float") {
        query.fail(3, unknownName({"what", MessageId::WordName}, precision, "float, double"));
    }
    return query.scenes.rows(query.text(0), width, elevation,
                             precision == "float" ? RowPrecision::Float : RowPrecision::Double, query.work);
}

}  // namespace

std::vector<Quantity> frameQuantities() {
    return {
        RELIEF_QUANTITY("frame.rays", 0, 0, asNumber(stepsOf(q).size())),
        RELIEF_QUANTITY("frame.hits", 0, 0, outcomesOf<Outcome::Hit>(q)),
        RELIEF_QUANTITY("frame.misses", 0, 0, outcomesOf<Outcome::Miss>(q)),
        RELIEF_QUANTITY("frame.limits", 0, 0, outcomesOf<Outcome::Limit>(q)),
        RELIEF_QUANTITY("frame.error.mean", 0, 0, meanOf(finiteErrors(q))),
        RELIEF_QUANTITY("frame.error.p95", 0, 0, p95Of(finiteErrors(q))),
        RELIEF_QUANTITY("frame.error.max", 0, 0, largestOf(finiteErrors(q))),
        RELIEF_QUANTITY("frame.error.at", 2, 2, static_cast<double>(q.scene().errors(q.work).texels[pixelOf(q)])),
        RELIEF_QUANTITY("frame.wrong", 0, 0, errorsOf<ErrorKind::Wrong>(q)),
        RELIEF_QUANTITY("frame.past", 0, 0, errorsOf<ErrorKind::Past>(q)),
        RELIEF_QUANTITY("frame.short", 0, 0, errorsOf<ErrorKind::Short>(q)),
        RELIEF_QUANTITY("frame.steps.mean", 0, 0, meanOf(stepsOf(q))),
        RELIEF_QUANTITY("frame.steps.p95", 0, 0, p95Of(stepsOf(q))),
        RELIEF_QUANTITY("frame.steps.max", 0, 0, largestOf(stepsOf(q))),
        RELIEF_QUANTITY("frame.steps.at", 2, 2, asNumber(q.frame().hits->hits.steps[pixelOf(q)])),
        RELIEF_QUANTITY("frame.reads.mean", 0, 0, meanOf(perRay(q, q.frame().hits->hits.reads))),
        RELIEF_QUANTITY("frame.checksum", 0, 0, hitsChecksum(q)),
        RELIEF_QUANTITY("frame.shadowed", 0, 0,
                        q.frame().shadows ? asNumber(std::count(q.frame().shadows->shadowed.begin(),
                                                                q.frame().shadows->shadowed.end(), std::uint8_t{1}))
                                          : 0.0),
        RELIEF_QUANTITY("frame.mapping_error", 0, 0, q.frame().mappingOff),
        RELIEF_QUANTITY("picture.checksum", 0, 0, pictureChecksum(q)),
        RELIEF_QUANTITY("picture.rmse", 0, 2, pictureErrorOf(q).rmse),
        RELIEF_QUANTITY("picture.psnr", 0, 2, pictureErrorOf(q).psnr),
        RELIEF_QUANTITY("picture.flip", 0, 2, pictureErrorOf(q).flip),
        RELIEF_QUANTITY("counter", 1, 1, counterOf(q)),
        RELIEF_QUANTITY("skipped", 1, 1, skippedShare(q)),
        RELIEF_QUANTITY("skipped.count", 1, 1, skippedRow(q).count),
        RELIEF_QUANTITY("children.mean", 0, 0, q.scene().children(q.work).mean()),
        RELIEF_QUANTITY("children.share", 1, 1,
                        q.scene().children(q.work).share(static_cast<std::size_t>(q.whole(0, 1, ChildCounts::kMost)))),
        RELIEF_QUANTITY("map.overshoots", 0, 1, asNumber(certificateOf(q).overshoots)),
        RELIEF_QUANTITY("map.worst", 0, 1, certificateOf(q).worst),
        RELIEF_QUANTITY("map.values", 0, 1, certificateOf(q).bounds ? asNumber(certificateOf(q).bounds->values) : 0.0),
        RELIEF_QUANTITY("map.broken", 0, 1, certificateOf(q).bounds ? asNumber(certificateOf(q).bounds->broken) : 0.0),
        RELIEF_QUANTITY("map.proven", 0, 1, certificateOf(q).proven()),
        RELIEF_QUANTITY("map.safe", 0, 1, certificateOf(q).safe()),
        RELIEF_QUANTITY("rows.mul", 1, 4, rowOf(q).counts.mul),
        RELIEF_QUANTITY("rows.add", 1, 4, rowOf(q).counts.add),
        RELIEF_QUANTITY("rows.div", 1, 4, rowOf(q).counts.div),
        RELIEF_QUANTITY("rows.error", 1, 4, rowOf(q).errorMax),
    };
}

}  // namespace relief
