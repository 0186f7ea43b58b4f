#include "workspace/range_json.h"

#include <algorithm>

#include "relief/describe.h"
#include "workspace/pane_store.h"

namespace reliefui {

namespace {

using relief::InputError;
using relief::Json;
using relief::JsonReader;
using relief::Message;
using relief::MessageId;

constexpr double kMostValue = 1e9;
constexpr double kLeastPercent = 0.001;  // smallest difference of two percentiles

const std::vector<std::string> kScales{"linear", "log"};
const std::vector<std::string> kEnds{"all", "percentile", "own"};

std::size_t indexIn(const std::vector<std::string>& names, const char* what, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    throw InputError("panes", Message(MessageId::UnknownName,
                                      {{"what", what}, {"name", name}, {"known", relief::commaList(names)}}));
}

RangeOf pictureAt(std::size_t n) {
    return static_cast<RangeOf>(n);
}

ColorRange readRange(JsonReader reader, ColorRange range) {
    reader.named("scale", [&](const std::string& name) { range.logarithmic = indexIn(kScales, "scale", name) == 1; });
    reader.named("ends",
                 [&](const std::string& name) { range.ends = static_cast<RangeEnds>(indexIn(kEnds, "ends", name)); });
    reader.read("low", range.low);
    reader.read("high", range.high);
    if (reader.has("threshold")) reader.read("threshold", range.threshold.emplace());
    reader.finish();
    return range;
}

}  // namespace

void RangesState::read(JsonReader reader) {
    for (std::size_t n = 0; n < kRangesOf; ++n) {
        const RangeOf of = pictureAt(n);
        const char* const name = rangeName(of).c_str();
        if (reader.has(name)) ranges.set(of, readRange(reader.child(name), standardRange(of)));
    }
    reader.finish();
}

Json RangesState::json() const {
    Json json = Json::object();
    for (std::size_t n = 0; n < kRangesOf; ++n) {
        const RangeOf of = pictureAt(n);
        if (!ranges.changed(of)) continue;
        const ColorRange range = ranges.of(of);
        Json& one = json[rangeName(of)];
        one = {{"scale", kScales[range.logarithmic ? 1 : 0]}, {"ends", kEnds[static_cast<std::size_t>(range.ends)]}};
        if (range.ends != RangeEnds::All) {
            one["low"] = range.low;
            one["high"] = range.high;
        }
        if (range.threshold) one["threshold"] = *range.threshold;
    }
    return json;
}

void RangesState::check(const std::string& subject) const {
    constexpr double kPercent = 100;
    for (std::size_t n = 0; n < kRangesOf; ++n) {
        const ColorRange range = ranges.of(pictureAt(n));
        const std::string name = rangeName(pictureAt(n));
        if (range.ends == RangeEnds::Percentile) {
            checkWithin(subject, name + ": low", range.low, 0, kPercent - kLeastPercent);
            checkWithin(subject, name + ": high", range.high, range.low + kLeastPercent, kPercent);
        }
        if (range.ends == RangeEnds::Own) {
            checkWithin(subject, name + ": low", range.low, -kMostValue, kMostValue);
            checkWithin(subject, name + ": high", range.high, -kMostValue, kMostValue);
            if (!(range.high > range.low)) {
                throw InputError(
                    subject, Message(MessageId::OutOfRange, {{"what", name + ": high"},
                                                             {"value", range.high},
                                                             {"range", "more than " + relief::numberText(range.low)}}));
            }
        }
        if (range.threshold) checkWithin(subject, name + ": threshold", *range.threshold, -kMostValue, kMostValue);
    }
}

ColorRanges rangesOf(const relief::Scenario& scenario) {
    return stateOf<RangesState>(scenario).ranges;
}

}  // namespace reliefui
