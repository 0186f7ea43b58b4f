// The advice as text and as JSON.
#include <algorithm>
#include <cmath>

#include "measuring/advise/advice_json.h"
#include "measuring/advise/recommend.h"
#include "measuring/bench/machine.h"
#include "measuring/text_table.h"
#include "relief/tracers/map_choice.h"

namespace relief {

namespace {

constexpr int kDigits = 3;
constexpr std::size_t kLines = 12;  // maximum number of table rows

std::string number(double value) {
    return std::isnan(value) ? "-" : readable(value, kDigits);
}

// Returns the names of the maps that the method and the one inside it trace with.
std::string mapNames(const MethodChoice& method) {
    std::vector<std::string> names = findTracer(method.name).maps;
    const auto inner = innerMethod(method);
    const auto used = usedMap(method);
    if (used && !inner) names = {used->kind};
    if (inner && !findTracer(inner->name).maps.empty()) names.push_back(mapNames(*inner));
    return commaList(names);
}

double percentMore(const AdvisedForm& form, const AdvisedForm& than) {
    return (form.cost / than.cost - 1) * 100;
}

class AdviceSentences {
  public:
    AdviceSentences(const AdviceOptions& options, const Advice& advice, Language language)
        : options_(options), advice_(advice), language_(language) {}

    std::string text() {
        const HeightField& field = options_.field;
        say(MessageId::AdviceAsked, {{"relief", options_.name},
                                     {"width", field.width()},
                                     {"height", field.height()},
                                     {"surface", std::string(surfaceName(field.surface()))},
                                     {"address", std::string(addressName(field.address()))},
                                     {"depth", field.reliefDepth()},
                                     {"views", viewsText(options_.views)},
                                     {"error", options_.error},
                                     {"outliers", number(options_.outliers * 100)},
                                     {"memory", bytesText(options_.memory, kDigits)}});
        if (options_.maxSteps > 0) say(MessageId::AdviceMaxSteps, {{"steps", options_.maxSteps}});
        text_ += '\n';
        if (advice_.relief.flat) {
            say(MessageId::AdviceFlat, {{"height", static_cast<double>(field.texel(0, 0))}});
        }
        if (!advice_.keepsBounds) say(MessageId::AdviceNothingKept, {});
        method();
        reasons();
        if (advice_.filter) filter();
        table();
        return text_;
    }

  private:
    void say(MessageId id, std::vector<MessageValue> values) {
        text_ += sentence(Message(id, std::move(values)), language_) + "\n";
    }

    void method() {
        const AdvisedForm& best = advice_.best();
        const AdvisedForm& exact = advice_.forms[advice_.exact];
        say(MessageId::AdviceMethod, {{"method", methodText(best.method)}});
        if (best.bytes == 0) {
            say(MessageId::AdviceNoMap, {});
        } else {
            say(MessageId::AdviceMap, {{"map", mapNames(best.method)},
                                       {"bytes", bytesText(best.bytes, kDigits)},
                                       {"seconds", number(best.buildSeconds)}});
        }
        if (options_.form == Form::Simd) {
            say(MessageId::AdviceRate, {{"rate", number(1e-6 / best.secondsPerRay)},
                                        {"exact", number(1e-6 / exact.secondsPerRay)},
                                        {"times", number(exact.secondsPerRay / best.secondsPerRay)}});
        } else {
            say(MessageId::AdviceCost, {{"cost", number(best.cost)},
                                        {"factor", options_.stepCost},
                                        {"exact", number(exact.cost)},
                                        {"times", number(exact.cost / best.cost)}});
        }
    }

    // Says how much more expensive a form is than the chosen one: as a factor from twice on, in percent below.
    void moreExpensive(MessageId percent, MessageId times, const AdvisedForm& form) {
        constexpr double kTwice = 100;
        const double more = percentMore(form, advice_.best());
        if (more < kTwice) {
            say(percent, {{"method", methodText(form.method)}, {"percent", number(more)}});
        } else {
            say(times, {{"method", methodText(form.method)}, {"times", number(1 + more / 100)}});
        }
    }

    void reasons() {
        const AdvisedForm& best = advice_.best();
        const AdvisedForm& exact = advice_.forms[advice_.exact];
        say(MessageId::AdviceCounts, {{"steps", number(best.steps)},
                                      {"reads", number(best.reads)},
                                      {"exactSteps", number(exact.steps)},
                                      {"exactReads", number(exact.reads)}});
        say(MessageId::AdviceErrors, {{"beyond", number(best.beyond * 100)},
                                      {"largest", number(best.largest)},
                                      {"guarantee", std::string(guaranteeName(best.guarantee))}});
        say(MessageId::AdviceRelief, {{"roughness", number(advice_.relief.roughness)},
                                      {"flat", number(advice_.relief.flatTiles * 100)},
                                      {"side", ReliefFigures::kTile},
                                      {"steep", number(advice_.relief.steep * 100)}});
        if (advice_.cheapest != advice_.chosen) {
            const AdvisedForm& cheapest = advice_.forms[advice_.cheapest];
            say(MessageId::AdviceLean, {{"method", methodText(cheapest.method)},
                                        {"percent", number((1 - cheapest.cost / best.cost) * 100)},
                                        {"bytes", bytesText(cheapest.bytes, kDigits)},
                                        {"seconds", number(cheapest.buildSeconds)}});
        } else if (advice_.next != advice_.chosen) {
            const AdvisedForm& next = advice_.forms[advice_.next];
            moreExpensive(MessageId::AdviceNext, MessageId::AdviceNextTimes, next);
        }
        if (advice_.withoutMap && best.bytes > 0) {
            const AdvisedForm& plain = advice_.forms[*advice_.withoutMap];
            moreExpensive(MessageId::AdviceWithoutMap, MessageId::AdviceWithoutMapTimes, plain);
        }
        const auto count = [&](Verdict verdict) {
            return std::count_if(advice_.forms.begin(), advice_.forms.end(),
                                 [&](const AdvisedForm& form) { return form.verdict == verdict; });
        };
        // Methods whose map is not built are in none of the tables.
        const auto countAndNames = [&](Verdict verdict) {
            std::vector<std::string> names;
            for (const AdvisedForm& form : advice_.forms) {
                if (form.verdict == verdict) names.push_back(methodText(form.method));
            }
            return std::to_string(names.size()) + (names.empty() ? "" : " (" + commaList(names) + ")");
        };
        say(MessageId::AdviceDropped, {{"total", advice_.forms.size()},
                                       {"error", count(Verdict::Error)},
                                       {"steps", count(Verdict::Steps)},
                                       {"memory", count(Verdict::Memory)},
                                       {"time", countAndNames(Verdict::BuildTime)},
                                       {"other", count(Verdict::Refused)},
                                       {"slow", count(Verdict::Slow)}});
    }

    void filter() {
        const FilterAdvice& filter = *advice_.filter;
        const FilterFigures& live = filter.filters[filter.live];
        const FilterFigures& still = filter.filters[filter.still];
        constexpr std::size_t kTrilinear = 2;
        const FilterFigures& plain = filter.filters[kTrilinear];
        text_ += '\n';
        say(MessageId::AdviceFilter, {{"filter", filterText(live.filter)},
                                      {"error", number(live.rmse * 1000)},
                                      {"texels", number(live.texels)},
                                      {"plain", filterText(plain.filter)},
                                      {"plainError", number(plain.rmse * 1000)},
                                      {"elevation", number(filter.elevation)},
                                      {"anisotropy", number(filter.anisotropy)}});
        if (filter.still == filter.live) return;
        say(MessageId::AdviceStillFilter, {{"filter", filterText(still.filter)},
                                           {"error", number(still.rmse * 1000)},
                                           {"times", number(live.rate / still.rate)}});
    }

    void table() {
        const bool simd = options_.form == Form::Simd;
        const char* cost = simd ? "ns/ray" : "cost";
        const TableRow heading{"",      cost,   "steps",   "most",    "reads",    "beyond %",
                               "error", "maps", "build s", "verdict", "guarantee"};
        constexpr std::size_t kVerdict = 9;
        const auto line = [&](const AdvisedForm& form) {
            return TableRow{methodText(form.method),
                            number(simd ? form.cost * 1e9 : form.cost),
                            number(form.steps),
                            form.mostSteps > 0 ? std::to_string(form.mostSteps) : "-",
                            number(form.reads),
                            number(form.beyond * 100),
                            number(form.largest),
                            sentence(bytesText(form.bytes, kDigits)),
                            number(form.buildSeconds),
                            std::string(verdictName(form.verdict)),
                            std::string(guaranteeName(form.guarantee))};
        };
        std::vector<TableRow> safe{heading};
        std::vector<const AdvisedForm*> others;
        for (const AdvisedForm& form : advice_.forms) {
            const bool keeps = form.verdict == Verdict::Kept || form.verdict == Verdict::Slow;
            if (keeps && safe.size() <= kLines) safe.push_back(line(form));
            if (form.verdict == Verdict::Error || form.verdict == Verdict::Steps) others.push_back(&form);
        }
        text_ += "\n" + textTable(safe, 1, kVerdict);
        if (!others.empty()) {
            std::stable_sort(others.begin(), others.end(),
                             [](const AdvisedForm* a, const AdvisedForm* b) { return a->cost < b->cost; });
            std::vector<TableRow> past{heading};
            for (const AdvisedForm* form : others) {
                if (past.size() <= kLines) past.push_back(line(*form));
            }
            text_ += '\n';
            say(MessageId::AdvicePastBounds, {});
            text_ += textTable(past, 1, kVerdict);
        }
        text_ += (simd ? "ns/ray: processor time on one thread. " : "") + cpuText() + ", " + compilerText() + ", " +
                 commitText() + "\n";
    }

    const AdviceOptions& options_;
    const Advice& advice_;
    Language language_;
    std::string text_;
};

using Json = nlohmann::ordered_json;

Json formJson(const AdvisedForm& form) {
    return {{"method", form.method.name},
            {"options", optionsText(form.method, true)},
            {"text", methodText(form.method)},
            {"verdict", std::string(verdictName(form.verdict))},
            {"guarantee", std::string(guaranteeName(form.guarantee))},
            {"cost", form.cost},
            {"seconds_a_ray", form.secondsPerRay},
            {"steps", form.steps},
            {"reads", form.reads},
            {"steps_max", form.mostSteps},
            {"beyond", form.beyond},
            {"error_max", form.largest},
            {"memory_bytes", form.bytes},
            {"build_seconds", form.buildSeconds},
            {"rounds", form.rounds}};
}

Json filterJson(const FilterAdvice& advice) {
    Json all = Json::array();
    for (const FilterFigures& figures : advice.filters) {
        all.push_back({{"filter", filterText(figures.filter)},
                       {"rmse", figures.rmse},
                       {"texels_read", figures.texels},
                       {"rate", figures.rate}});
    }
    return {{"live", filterText(advice.filters[advice.live].filter)},
            {"still", filterText(advice.filters[advice.still].filter)},
            {"elevation", advice.elevation},
            {"anisotropy", advice.anisotropy},
            {"filters", all}};
}

}  // namespace

std::string adviceText(const AdviceOptions& options, const Advice& advice, Language language) {
    return AdviceSentences(options, advice, language).text();
}

std::string adviceJson(const AdviceOptions& options, const Advice& advice) {
    Json json = adviceSubject(options.name, options.field, options.views);
    json.update({{"error", options.error},
                 {"outliers", options.outliers},
                 {"memory_limit_bytes", options.memory},
                 {"max_steps", options.maxSteps},
                 {"seconds", options.seconds},
                 {"form", std::string(formName(options.form))},
                 {"step_cost", options.stepCost},
                 {"seed", options.seed},
                 {"chosen", formJson(advice.best())}});
    json["map"] = mapNames(advice.best().method);
    json["relief"] = {{"roughness", advice.relief.roughness},
                      {"flat_tiles", advice.relief.flatTiles},
                      {"tile", ReliefFigures::kTile},
                      {"steep", advice.relief.steep},
                      {"flat", advice.relief.flat}};
    json["keeps_bounds"] = advice.keepsBounds;
    if (advice.filter) json["filter"] = filterJson(*advice.filter);
    if (advice.rebuilt) json["where_heights_change"] = methodText(advice.forms[*advice.rebuilt].method);
    json["forms"] = Json::array();
    for (const AdvisedForm& form : advice.forms) json["forms"].push_back(formJson(form));
    json["cpu"] = cpuText();
    json["compiler"] = compilerText();
    json["commit"] = commitText();
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<Message> adviceNotes(const AdviceOptions& options, const Advice& advice) {
    std::vector<Message> notes;
    if (advice.stillClose > 0) {
        notes.emplace_back(MessageId::AdviceTimeUp,
                           std::vector<MessageValue>{{"count", advice.stillClose}, {"percent", kClosePercent}});
    }
    if (options.filters && !advice.filter) notes.emplace_back(MessageId::AdviceNoFilter);
    if (advice.rebuilt && std::isinf(advice.paysAfterRays)) {
        notes.emplace_back(MessageId::AdviceBuildNeverPays,
                           std::vector<MessageValue>{{"seconds", numberText(advice.best().buildSeconds, kDigits)},
                                                     {"method", methodText(advice.forms[*advice.rebuilt].method)}});
    } else if (advice.rebuilt) {
        notes.emplace_back(MessageId::AdviceBuildDominates,
                           std::vector<MessageValue>{{"rays", numberText(advice.paysAfterRays / 1e6, kDigits)},
                                                     {"method", methodText(advice.forms[*advice.rebuilt].method)}});
    }
    return notes;
}

}  // namespace relief
