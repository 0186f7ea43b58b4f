#include "measuring/lesson/quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <span>

#include "filtering/pixel_model.h"
#include "measuring/quantiles.h"
#include "relief/describe.h"
#include "relief/step_log.h"
#include "scenario/ray_files.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, 7> kDepartures{
    "none", "missed-spike", "stopped-early", "unsafe-map", "interpolation-leak", "not-refined", "taken-as-flat"};
constexpr std::uint64_t kCertifiedRays = 20000;
constexpr int kTruth = 8;  // samples along a side of a pixel
constexpr int kMostTruth = 64;

// What a quantity is measured with.
struct Query {
    const QuantityName& name;
    const Scenario& scenario;
    SceneCache& scenes;
    Work& work;

    MeasuredScene& scene() const { return scenes.scene(scenario); }
    const LoggedRay& ray() const { return scene().ray(work); }
    const Frame& frame() const { return scene().frame(work); }

    [[noreturn]] void fail(std::size_t index, const Message& why) const {
        throw InputError(name.name, Message(MessageId::LessonArgument, {{"number", index + 1}, {"why", why}}));
    }
    bool has(std::size_t index) const { return index < name.arguments.size(); }
    double number(std::size_t index) const {
        if (const double* const value = std::get_if<double>(&name.arguments[index])) return *value;
        fail(index, Message(MessageId::WantANumber));
    }
    std::string text(std::size_t index) const {
        if (const std::string* const value = std::get_if<std::string>(&name.arguments[index])) return *value;
        fail(index, Message(MessageId::WantAText));
    }
    // A whole number in [low, high].
    int whole(std::size_t index, double low, double high) const {
        const double value = number(index);
        if (value != std::floor(value) || !(value >= low && value <= high)) {
            fail(index, Message(MessageId::NumberOutOfRange, {{"value", value}, {"range", rangeOf(low, high)}}));
        }
        return static_cast<int>(value);
    }
};

using Measure = Quantity::Measure;

// Makes a Measure of a function of a Query.
template <auto Function>
constexpr Measure measured = [](const QuantityName& name, const Scenario& scenario, SceneCache& scenes, Work& work) {
    return LessonValue(Function(Query{name, scenario, scenes, work}));
};

template <std::integral T>
double asNumber(T value) {
    return static_cast<double>(value);
}

// The method's own options and defaults.
LessonValue optionValue(const Query& query) {
    const std::string name = query.text(0);
    std::string known;
    for (const ChoiceOption& option : choiceOptions(query.scenario.method)) {
        known += (known.empty() ? "" : ", ") + option.description.name;
        if (option.description.name != name) continue;
        const auto given = query.scenario.method.options.find(name);
        const std::string text = given == query.scenario.method.options.end() ? option.defaultValue : given->second;
        const bool number =
            option.description.kind == OptionKind::Integer || option.description.kind == OptionKind::Real;
        const auto& words = option.description.choices;
        if (!number || std::find(words.begin(), words.end(), text) != words.end()) return text;
        return parseNumber(text, name);
    }
    query.fail(0, unknownName({"what", Message(MessageId::WordOptionOf, {{"method", query.scenario.method.name}})},
                              name, known));
}

const Step& chosenStep(const Query& query) {
    const auto& steps = query.ray().steps;
    if (steps.empty()) throw InputError(query.name.name, Message(MessageId::LessonNoStep));
    if (query.has(0)) return steps[static_cast<std::size_t>(query.whole(0, 1, asNumber(steps.size())) - 1)];
    return steps[std::min(static_cast<std::size_t>(std::max(query.scenario.step, 0)), steps.size() - 1)];
}

double countedSteps(const Query& query) {
    const std::string wanted = query.text(0);
    std::vector<std::string> known;
    for (const auto& name : kDecisionNames) known.emplace_back(name);
    for (const auto& name : kPhaseNames) known.emplace_back(name);
    for (const auto& name : kSubjectNames) known.emplace_back(name);
    if (std::find(known.begin(), known.end(), wanted) == known.end()) {
        query.fail(0, unknownName({"what", MessageId::WordName}, wanted, commaList(known)));
    }
    // "start" and "refine" are a decision and a phase; "hit" and the like one thing only.
    return asNumber(std::count_if(query.ray().steps.begin(), query.ray().steps.end(), [&](const Step& step) {
        return decisionName(step.decision) == wanted || phaseName(step.phase) == wanted ||
               subjectName(step.subject) == wanted;
    }));
}

double heightAt(const Query& query) {
    const FloatImage& heights = query.scene().field(query.work).heights();
    return static_cast<double>(
        heights(query.whole(0, 0, heights.width() - 1), query.whole(1, 0, heights.height() - 1)));
}

template <PyramidKind Kind>
double topOf(const Query& query) {
    const Pyramid& pyramid = query.scene().pyramid(Kind, query.work);
    return static_cast<double>(pyramid.level(pyramid.levels() - 1)(0, 0));
}
template <PyramidKind Kind>
double texelOf(const Query& query) {
    const Pyramid& pyramid = query.scene().pyramid(Kind, query.work);
    const FloatImage& level = pyramid.level(query.whole(0, 0, pyramid.levels() - 1));
    return static_cast<double>(level(query.whole(1, 0, level.width() - 1), query.whole(2, 0, level.height() - 1)));
}

PointDistances pointOf(const Query& query) {
    const HeightField& field = query.scene().field(query.work);
    const double s = query.number(0), t = query.number(1), z = query.number(2);
    if (!(s >= 0 && s <= field.width())) query.whole(0, 0, field.width());
    if (!(t >= 0 && t <= field.height())) query.whole(1, 0, field.height());
    if (!(z >= 0 && z <= 1)) query.whole(2, 0, 1);
    return query.scene().point(s, t, z, query.work);
}

double elevationOf(const Query& query) {
    const ViewRay& ray = query.ray().ray;
    return std::atan2(query.scene().field(query.work).slabTexels(), std::hypot(ray.a, ray.b)) * 180 / std::numbers::pi;
}

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
    const double elevation = query.has(2) ? query.number(2) : kUsualElevation;
    if (!(elevation >= 1 && elevation <= 90)) query.whole(2, 1, 90);
    const std::string precision = query.has(3) ? query.text(3) : "double";
    if (precision != "double" && precision != "float") {
        query.fail(3, unknownName({"what", MessageId::WordName}, precision, "float, double"));
    }
    return query.scenes.rows(query.text(0), width, elevation,
                             precision == "float" ? RowPrecision::Float : RowPrecision::Double, query.work);
}

LessonValue pixelNumber(const Query& query) {
    const std::string name = query.name.name.substr(std::string_view("pixel.").size());
    std::string known;
    for (const NamedNumber& number : namedNumbers(query.scene().coefficients(query.work))) {
        if (number.name == name) return number.value;
        known += (known.empty() ? "" : ", ") + std::string(number.name);
    }
    throw InputError("", unknownName({"what", MessageId::WordQuantity}, name, known));
}

double visibleWeight(const Query& query) {
    double sum = 0;
    for (const FootprintTexel& texel : query.scene().footprint(query.work).log.texels) {
        if (!texel.hidden) sum += static_cast<double>(texel.weight.r + texel.weight.g + texel.weight.b) / 3;
    }
    return sum;
}

#define RELIEF_QUANTITY(name, least, most, ...)                                 \
    Quantity {                                                                  \
        name, least, most, measured<[](const Query& q) { return __VA_ARGS__; }> \
    }

std::vector<Quantity> sceneQuantities() {
    return {
        RELIEF_QUANTITY("scene", 1, 1, scenarioNumber(q.text(0)).get(q.scenario)),
        RELIEF_QUANTITY("option", 1, 1, optionValue(q)),
        RELIEF_QUANTITY("method.name", 0, 0, q.scenario.method.name),
        RELIEF_QUANTITY("method.guarantee", 0, 0, std::string(guaranteeName(q.scene().tracer(q.work).guarantee()))),
        RELIEF_QUANTITY("method.bytes", 0, 0, asNumber(q.scene().tracer(q.work).bytes())),
        RELIEF_QUANTITY("heights.width", 0, 0, asNumber(q.scene().field(q.work).width())),
        RELIEF_QUANTITY("heights.height", 0, 0, asNumber(q.scene().field(q.work).height())),
        RELIEF_QUANTITY(
            "heights.levels", 0, 0,
            asNumber(Pyramid::levelCount(q.scene().field(q.work).width(), q.scene().field(q.work).height()))),
        RELIEF_QUANTITY("heights.at", 2, 2, heightAt(q)),
        RELIEF_QUANTITY("heights.max", 0, 0, topOf<PyramidKind::Max>(q)),
        RELIEF_QUANTITY("heights.mean", 0, 0, topOf<PyramidKind::Mean>(q)),
        RELIEF_QUANTITY("heights.min", 0, 0, topOf<PyramidKind::Min>(q)),
        RELIEF_QUANTITY("pyramid.max", 3, 3, texelOf<PyramidKind::Max>(q)),
        RELIEF_QUANTITY("pyramid.mean", 3, 3, texelOf<PyramidKind::Mean>(q)),
        RELIEF_QUANTITY("pyramid.min", 3, 3, texelOf<PyramidKind::Min>(q)),
        RELIEF_QUANTITY("point.euclidean", 3, 3, pointOf(q).euclidean),
        RELIEF_QUANTITY("point.refined", 3, 3, pointOf(q).refined),
        RELIEF_QUANTITY("point.blocked", 3, 3, asNumber(pointOf(q).blocked)),
    };
}

std::vector<Quantity> rayQuantities() {
    return {
        RELIEF_QUANTITY("ray.s0", 0, 0, q.ray().ray.s0),
        RELIEF_QUANTITY("ray.t0", 0, 0, q.ray().ray.t0),
        RELIEF_QUANTITY("ray.a", 0, 0, q.ray().ray.a),
        RELIEF_QUANTITY("ray.b", 0, 0, q.ray().ray.b),
        RELIEF_QUANTITY("ray.run", 0, 0, std::hypot(q.ray().ray.a, q.ray().ray.b)),
        RELIEF_QUANTITY("ray.elevation", 0, 0, elevationOf(q)),
        RELIEF_QUANTITY("exact.outcome", 0, 0, std::string(outcomeName(q.ray().exact.outcome))),
        RELIEF_QUANTITY("exact.lambda", 0, 0, q.ray().exact.lambda),
        RELIEF_QUANTITY("exact.height", 0, 0, 1 - q.ray().exact.lambda),
        RELIEF_QUANTITY("exact.s", 0, 0, q.ray().exact.s),
        RELIEF_QUANTITY("exact.t", 0, 0, q.ray().exact.t),
        RELIEF_QUANTITY("trace.outcome", 0, 0, std::string(outcomeName(q.ray().hit.outcome))),
        RELIEF_QUANTITY("trace.lambda", 0, 0, q.ray().hit.lambda),
        RELIEF_QUANTITY("trace.height", 0, 0, 1 - q.ray().hit.lambda),
        RELIEF_QUANTITY("trace.s", 0, 0, q.ray().hit.s),
        RELIEF_QUANTITY("trace.t", 0, 0, q.ray().hit.t),
        RELIEF_QUANTITY("trace.error", 0, 0, q.ray().judgement.texels),
        RELIEF_QUANTITY("trace.steps", 0, 0, asNumber(q.ray().steps.size())),
        RELIEF_QUANTITY("trace.reads", 0, 0, asNumber(q.ray().reads)),
        RELIEF_QUANTITY("trace.count", 1, 1, countedSteps(q)),
        RELIEF_QUANTITY("trace.departure", 0, 0,
                        std::string(kDepartures[static_cast<std::size_t>(q.ray().judgement.kind)])),
        RELIEF_QUANTITY("trace.departure_step", 0, 0,
                        q.ray().judgement.kind == Departure::None ? 0.0 : asNumber(q.ray().judgement.step + 1)),
        RELIEF_QUANTITY("trace.overshoot_step", 0, 0,
                        q.ray().judgement.overshoot ? asNumber(*q.ray().judgement.overshoot + 1) : 0.0),
        RELIEF_QUANTITY("step.decision", 0, 1, std::string(decisionName(chosenStep(q).decision))),
        RELIEF_QUANTITY("step.kind", 0, 1, std::string(subjectName(chosenStep(q).subject))),
        RELIEF_QUANTITY("step.level", 0, 1, asNumber(chosenStep(q).level)),
        RELIEF_QUANTITY("step.i", 0, 1, asNumber(chosenStep(q).i)),
        RELIEF_QUANTITY("step.j", 0, 1, asNumber(chosenStep(q).j)),
        RELIEF_QUANTITY("step.k", 0, 1, asNumber(chosenStep(q).k)),
        RELIEF_QUANTITY("step.value", 0, 1, chosenStep(q).value),
        RELIEF_QUANTITY("step.lambda_in", 0, 1, chosenStep(q).lambdaIn),
        RELIEF_QUANTITY("step.lambda_out", 0, 1, chosenStep(q).lambdaOut),
        RELIEF_QUANTITY("step.lambda_after", 0, 1, chosenStep(q).lambdaAfter),
        RELIEF_QUANTITY("step.z_in", 0, 1, chosenStep(q).zIn()),
        RELIEF_QUANTITY("step.z_out", 0, 1, chosenStep(q).zOut()),
        RELIEF_QUANTITY("pixel.", 0, 0, pixelNumber(q)),
        RELIEF_QUANTITY("footprint.texels", 0, 0, asNumber(q.scene().footprint(q.work).counts.texels)),
        RELIEF_QUANTITY("footprint.tested", 0, 0, asNumber(q.scene().footprint(q.work).counts.tested)),
        RELIEF_QUANTITY("footprint.hidden", 0, 0, asNumber(q.scene().footprint(q.work).counts.hidden)),
        RELIEF_QUANTITY("footprint.skipped", 0, 0, asNumber(q.scene().footprint(q.work).counts.skipped)),
        RELIEF_QUANTITY("footprint.level", 0, 0, asNumber(q.scene().footprint(q.work).log.footprint.level)),
        RELIEF_QUANTITY("footprint.major", 0, 0, q.scene().footprint(q.work).major),
        RELIEF_QUANTITY("footprint.minor", 0, 0, q.scene().footprint(q.work).minor),
        RELIEF_QUANTITY("footprint.weight", 0, 0, visibleWeight(q)),
    };
}

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

#undef RELIEF_QUANTITY

}  // namespace

const std::vector<Quantity>& quantityList() {
    static const std::vector<Quantity> list = [] {
        std::vector<Quantity> all;
        for (auto&& part : {sceneQuantities(), rayQuantities(), frameQuantities()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return list;
}

const Quantity& findQuantity(const QuantityName& name) {
    const auto& list = quantityList();
    const auto found = std::find_if(list.begin(), list.end(), [&](const Quantity& one) {
        return one.name.ends_with('.') ? name.name.starts_with(one.name) : one.name == name.name;
    });
    if (found == list.end()) {
        std::vector<std::string> known;
        for (const Quantity& one : list) known.emplace_back(one.name);
        throw InputError("", unknownName({"what", MessageId::WordQuantity}, name.name, commaList(known)));
    }
    if (name.arguments.size() < found->least || name.arguments.size() > found->most) {
        throw InputError(name.name,
                         Message(MessageId::LessonArguments,
                                 {{"count", name.arguments.size()}, {"range", rangeOf(found->least, found->most)}}));
    }
    return *found;
}

QuantitySource lessonSource(const Lesson& lesson, const Scenario& scenario, SceneCache& scenes, Work& work) {
    return [&lesson, scenario, &scenes, &work](const QuantityName& name) {
        const Quantity& quantity = findQuantity(name);
        if (name.place.empty()) return quantity.measure(name, scenario, scenes, work);
        const auto placed = lesson.scenarioAt(name.place, scenario);
        if (!placed) {
            std::vector<std::string> known;
            for (const auto& variant : lesson.variants) known.push_back(variant.first);
            for (const LessonPage& page : lesson.pages) known.push_back(page.name);
            throw InputError("", unknownName({"what", MessageId::WordPlace}, name.place, commaList(known)));
        }
        return quantity.measure(name, *placed, scenes, work);
    };
}

}  // namespace relief
