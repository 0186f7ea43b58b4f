// Quantities of the scene: its options, heights, pyramids and distances.
#include <algorithm>

#include "measuring/lesson/quantity_query.h"
#include "relief/describe.h"

namespace relief {

namespace {

// The method's own options and defaults.
ExpressionValue optionValue(const Query& query) {
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
    return query.scene().point(query.number(0, 0, field.width()), query.number(1, 0, field.height()),
                               query.number(2, 0, 1), query.work);
}

}  // namespace

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

}  // namespace relief
