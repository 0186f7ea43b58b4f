#include "scenario/sequence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scenario/variation.h"

namespace relief {

namespace {

constexpr double kFullTurn = 360;  // degrees
constexpr double kSwing = 60;      // degrees; more obliquely, a wall looks too narrow
constexpr int kDigits = 6;         // of values between two given ones, so that a caption shows all of them

struct Swept {
    OptionDescription description;
    std::optional<CompareSubject> subject;  // std::nullopt: a number of the scenario
    std::string value;                      // the present one
};

constexpr std::array kSubjects{CompareSubject::Methods, CompareSubject::Filters, CompareSubject::Mappings};

// All that can be swept; of two with the same name, the first.
std::vector<Swept> allSwept(const Scenario& scenario) {
    std::vector<Swept> all;
    const bool orbit = scenario.camera.kind == Camera::Kind::Orbit;
    for (const ScenarioNumber& number : scenarioNumbers()) {
        const std::string& name = number.description.name;
        // Frames have one size; a camera that is given by its eye has no angles.
        if (name == "width" || name == "height") continue;
        if (!orbit && (name == "elevation" || name == "azimuth" || name == "distance")) continue;
        all.push_back({number.description, {}, numberText(number.get(scenario))});
    }
    for (const CompareSubject subject : kSubjects) {
        const MethodChoice own = ownVariation(scenario, subject);
        const MethodDescription described = describedVariation(subject, own);
        for (const OptionDescription& option : described.options) {
            const bool known = std::any_of(all.begin(), all.end(),
                                           [&](const Swept& one) { return one.description.name == option.name; });
            if (known) continue;
            const auto given = own.options.find(option.name);
            all.push_back(
                {option, subject, given != own.options.end() ? given->second : described.defaults.at(option.name)});
        }
    }
    return all;
}

Swept sweptOption(const Scenario& scenario, const std::string& name, const std::string& subject) {
    std::vector<Swept> all = allSwept(scenario);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Swept& one) { return one.description.name == name; });
    if (found != all.end()) return std::move(*found);
    std::vector<std::string> names;
    for (const Swept& one : all) names.push_back(one.description.name);
    throw InputError(subject, unknownName({"what", MessageId::WordSetting}, name, commaList(names)));
}

Scenario withValue(Scenario scenario, const Swept& swept, const std::string& value, const std::string& subject) {
    if (!swept.subject) {
        setScenarioNumber(scenario, swept.description.name, parseNumber(value, subject), subject);
        return scenario;
    }
    MethodChoice choice = ownVariation(scenario, *swept.subject);
    choice.options[swept.description.name] = value;
    checkVariation(*swept.subject, choice, subject);
    return varied(std::move(scenario), *swept.subject, choice);
}

std::vector<std::string> valuesBetween(const Sequence& sequence, const OptionDescription& option) {
    const int frames = sequence.frames.value_or(kSequenceFrames);
    const bool whole = option.kind == OptionKind::Integer;
    std::vector<std::string> values;
    for (int n = 0; n < frames; ++n) {
        const double share = frames > 1 ? n / (frames - 1.0) : 0;
        const double value = sequence.from + (sequence.to - sequence.from) * share;
        std::string text = whole ? numberText(std::round(value)) : numberText(value, kDigits);
        if (text == "-0") text = "0";
        if (values.empty() || values.back() != text) values.push_back(std::move(text));
    }
    return values;
}

// Of names, all; of angles, 30 degrees to both sides; of other numbers, from half the present value to twice.
std::string proposedValues(const Swept& swept) {
    const OptionDescription& option = swept.description;
    if (option.kind == OptionKind::Choice || option.kind == OptionKind::Method) {
        std::string names;
        for (const std::string& name : option.choices) names += (names.empty() ? "" : ",") + name;
        return names;
    }
    constexpr double kAside = 30;  // degrees
    double value = option.low;
    // An integer option may have a word instead.
    if (std::find(option.choices.begin(), option.choices.end(), swept.value) == option.choices.end())
        value = parseNumber(swept.value, option.name);
    const bool angle = option.unit == "degrees" && option.low < 0;
    double from = angle ? value - kAside : value / 2, to = angle ? value + kAside : value * 2;
    if (option.kind == OptionKind::Integer) from = std::round(from);
    if (from == to) to = from + option.step * 10;
    const auto text = [&](double end) { return numberText(std::clamp(end, option.low, option.high), kDigits); };
    return text(from) + ".." + text(to);
}

SequenceFrame frameOf(const Scenario& scenario, const Swept& swept, const std::string& value,
                      const std::string& subject) {
    const OptionDescription& option = swept.description;
    return {withValue(scenario, swept, value, subject), option.name, value + (option.unit == "degrees" ? "°" : "")};
}

std::vector<SequenceFrame> orbitFrames(const Sequence& sequence, const Scenario& scenario, const std::string& subject) {
    const Swept azimuth = sweptOption(scenario, "azimuth", subject);
    const int frames = sequence.frames.value_or(kSequenceFrames);
    std::vector<SequenceFrame> all;
    for (int n = 0; n < frames; ++n) {
        const double share = n / static_cast<double>(frames);
        const double angle = scenario.scene == SceneKind::Wall
                                 ? kSwing * std::sin(2 * std::numbers::pi * share)
                                 : std::fmod(scenario.camera.azimuth + kFullTurn * share, kFullTurn);
        std::string value = numberText(angle, kDigits);
        if (std::abs(angle) < 1e-9) value = "0";
        all.push_back(frameOf(scenario, azimuth, value, subject));
    }
    return all;
}

InputError noSequence(const std::string& subject, const std::string& text) {
    return {subject, Message(MessageId::SequenceUnknown, {{"text", text}})};
}

}  // namespace

Sequence parseSweep(const std::string& text, std::optional<int> frames, const std::string& subject) {
    Sequence sequence;
    sequence.kind = Sequence::Kind::Sweep;
    sequence.frames = frames;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) throw noSequence(subject, text);
    sequence.option = text.substr(0, equals);
    const std::string values = text.substr(equals + 1);
    if (const std::size_t dots = values.find(".."); dots != std::string::npos) {
        sequence.from = parseNumber(std::string_view(values).substr(0, dots), subject);
        sequence.to = parseNumber(std::string_view(values).substr(dots + 2), subject);
        return sequence;
    }
    for (std::size_t begin = 0; begin <= values.size();) {
        const std::size_t end = std::min(values.find(',', begin), values.size());
        sequence.values.push_back(values.substr(begin, end - begin));
        begin = end + 1;
    }
    if (frames) throw InputError("--frames", Message(MessageId::ArgumentsExclude, {{"other", "A,B,..."}}));
    return sequence;
}

Sequence parseSequence(const std::string& text, std::optional<int> frames, const std::string& subject) {
    constexpr std::string_view kSweep = "sweep:";
    if (text.starts_with(kSweep)) return parseSweep(text.substr(kSweep.size()), frames, subject);
    if (text != "steps" && text != "orbit") throw noSequence(subject, text);
    Sequence sequence;
    sequence.kind = text == "steps" ? Sequence::Kind::Steps : Sequence::Kind::Orbit;
    sequence.frames = frames;
    if (frames && sequence.kind == Sequence::Kind::Steps)
        throw InputError("--frames", Message(MessageId::ArgumentsExclude, {{"other", subject + " steps"}}));
    return sequence;
}

std::vector<SequenceFrame> framesOf(const Sequence& sequence, const Scenario& scenario, const std::string& subject) {
    if (sequence.kind == Sequence::Kind::Orbit) return orbitFrames(sequence, scenario, subject);
    const Swept swept = sweptOption(scenario, sequence.option, subject);
    const auto values = sequence.values.empty() ? valuesBetween(sequence, swept.description) : sequence.values;
    std::vector<SequenceFrame> all;
    for (const std::string& value : values) {
        all.push_back(frameOf(scenario, swept, value, subject));
        checkScenario(all.back().scenario, subject);
    }
    return all;
}

std::vector<SweptOption> sweptOptions(const Scenario& scenario) {
    std::vector<SweptOption> options;
    for (const Swept& swept : allSwept(scenario))
        options.push_back({swept.description.name, swept.description.help, proposedValues(swept)});
    return options;
}

InputError stepsNotShown(const std::string& view, const std::string& subject) {
    return {subject, Message(MessageId::SequenceNoSteps, {{"view", view}})};
}

InputError longerSequence(const std::string& file) {
    return {file, Message(MessageId::SequenceLonger)};
}

std::string frameName(const std::string& stem, std::size_t number) {
    constexpr std::size_t kFrameDigits = 5;
    std::string digits = std::to_string(number);
    digits.insert(0, kFrameDigits - std::min(kFrameDigits, digits.size()), '0');
    return stem + "_" + digits;
}

}  // namespace relief
