#include "measuring/lesson/lesson.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "measuring/lesson/course.h"
#include "relief/files.h"
#include "relief/step_log.h"

namespace relief {

namespace fs = std::filesystem;

namespace {

constexpr const char* kEnglishText = "text.en.md";
constexpr const char* kUkrainianText = "text.uk.md";
constexpr std::array<std::string_view, 3> kTrends{"falls", "rises", "same"};
constexpr std::array<std::string_view, 3> kStepWords{"last", "departure", "overshoot"};
constexpr std::array<std::string_view, 15> kPanes{"result",   "profile",   "duel",    "compare", "pyramid",
                                                  "distance", "footprint", "rows",    "steps",   "trace",
                                                  "formula",  "charts",    "skipped", "watch",   "why"};
constexpr int kMostChoices = 9;
constexpr std::size_t kMostTurns = 12;

std::string joined(const std::string& folder, const char* name) {
    return (fs::path(folder) / name).string();
}

template <class Names>
std::string listOf(const Names& names) {
    std::vector<std::string> list;
    for (const auto& name : names) list.emplace_back(name);
    return commaList(list);
}

bool isWord(const std::string& text) {
    return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
           std::all_of(text.begin(), text.end(),
                       [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

void requireWord(const std::string& name) {
    if (!isWord(name)) throw InputError("", Message(MessageId::LessonNoWord, {{"text", name}}));
}

template <class Names>
void requireOneOf(const Names& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw InputError("", unknownName({"what", MessageId::WordName}, name, listOf(names)));
    }
}

std::vector<Expression> expressionsOf(JsonReader& reader, const char* key) {
    std::vector<Expression> list;
    reader.readTexts(key, [&](const std::string& text) { list.emplace_back(text); });
    return list;
}

LessonQuestion questionOf(JsonReader reader) {
    LessonQuestion question;
    if (reader.has("choose")) {
        question.choices = expressionsOf(reader, "choose");
        const auto count = static_cast<int>(question.choices.size());
        if (count < 2 || count > kMostChoices)
            reader.fail("choose", Message(MessageId::RangeOf, {{"low", 2}, {"high", kMostChoices}}));
    } else if (reader.has("number")) {
        question.kind = LessonQuestion::Kind::Number;
        reader.named("number", [&](const std::string& text) { question.number.emplace(text); });
        reader.read("within", question.within);
    } else if (reader.has("hit")) {
        question.kind = LessonQuestion::Kind::Hit;
        bool hit = true;
        reader.read("hit", hit);
        question.within = kHitWithin;
        reader.read("within", question.within);
        if (!(question.within > 0)) reader.fail("within", MessageId::WantALarger);
    } else {
        reader.fail({}, MessageId::WantAQuestion);
    }
    if (question.within < 0) reader.fail("within", MessageId::WantALarger);
    reader.finish();
    return question;
}

// scenario: the page's.
LessonKnob knobOf(JsonReader reader, Json scenario) {
    LessonKnob knob;
    reader.read("set", knob.set);
    if (knob.set.size() < 2 || knob.set.front() != '/') reader.fail("set", MessageId::WantAPointer);
    if (!reader.has("values")) reader.fail("values", MessageId::WantValues);
    const Json& values = reader.object()["values"];
    if (!values.is_array() || values.size() < 2 || values.size() > kMostTurns)
        reader.fail("values", MessageId::WantValues);
    for (const Json& value : values) {
        if (!value.is_primitive() || value.is_null()) reader.fail("values", MessageId::WantValues);
        knob.values.push_back(value);
    }
    if (!putValue(scenario, knob.set, knob.values.front())) reader.fail("set", MessageId::WantAPointer);
    reader.readObjects("watch", [&](JsonReader item) {
        std::optional<Expression> value;
        Trend trend = Trend::None;
        item.named("value", [&](const std::string& text) { value.emplace(text); });
        if (!value) item.fail("value", MessageId::WantAText);
        item.named("trend", [&](const std::string& name) {
            requireOneOf(kTrends, name);
            trend = static_cast<Trend>(std::find(kTrends.begin(), kTrends.end(), name) - kTrends.begin() + 1);
        });
        item.finish();
        knob.watch.push_back({*value, trend});
    });
    if (knob.watch.empty()) reader.fail("watch", MessageId::WantObjects);
    reader.finish();
    return knob;
}

StepRule stepRuleOf(JsonReader& reader) {
    const Json& value = reader.object()["step"];
    if (value.is_number()) {
        int number = 0;
        reader.readWhole("step", number);
        if (number < 1) reader.fail("step", MessageId::WantALarger);
        return number;
    }
    std::string name;
    reader.named("step", [&](const std::string& text) {
        std::vector<std::string_view> known(kStepWords.begin(), kStepWords.end());
        known.insert(known.end(), kDecisionNames.begin(), kDecisionNames.end());
        requireOneOf(known, text);
        name = text;
    });
    return name;
}

LessonPage pageOf(JsonReader reader, Json& scenario) {
    LessonPage page;
    reader.named("name", [&](const std::string& name) {
        requireWord(name);
        page.name = name;
    });
    if (page.name.empty()) reader.fail("name", MessageId::WantAText);
    if (reader.has("change")) {
        const Json& change = reader.object()["change"];
        if (!change.is_object()) reader.fail("change", MessageId::WantAObject);
        scenario.merge_patch(change);
    }
    reader.named("pane", [&](const std::string& name) {
        requireOneOf(kPanes, name);
        page.pane = name;
    });
    reader.named("layer", [&](const std::string& name) {
        requireOneOf(layerNames(), name);
        page.layer = name;
    });
    if (reader.has("step")) page.step = stepRuleOf(reader);
    if (reader.has("question")) page.question = questionOf(reader.child("question"));
    if (reader.has("knob")) page.knob = knobOf(reader.child("knob"), scenario);
    page.claims = expressionsOf(reader, "claims");
    page.scenario = scenario;
    reader.finish();
    return page;
}

// Throws InputError if the words do not fit the pages.
void checkWords(const Lesson& lesson, const LessonText& text, const std::string& file) {
    const auto fail = [&](const Message& why) { throw InputError(file, why); };
    if (text.pages.size() != lesson.pages.size()) {
        fail(Message(MessageId::LessonPagesDiffer, {{"count", text.pages.size()}, {"wanted", lesson.pages.size()}}));
    }
    for (std::size_t n = 0; n < text.pages.size(); ++n) {
        const PageText& words = text.pages[n];
        const LessonPage& page = lesson.pages[n];
        if (words.name != page.name)
            fail(Message(MessageId::LessonPageDiffers, {{"page", words.name}, {"wanted", page.name}}));
        const auto choices = page.question ? page.question->choices.size() : 0;
        if (words.choices.size() != choices) {
            fail(Message(MessageId::LessonChoicesDiffer,
                         {{"page", page.name}, {"count", words.choices.size()}, {"wanted", choices}}));
        }
        if (page.question.has_value() == words.question.empty()) {
            fail(Message(MessageId::LessonQuestionDiffers, {{"page", page.name}}));
        }
        if (page.knob.has_value() == words.knob.empty())
            fail(Message(MessageId::LessonKnobDiffers, {{"page", page.name}}));
        if (const int count = wordCount(words.text); count > kMostPageWords) {
            fail(Message(MessageId::LessonTooLong, {{"page", page.name}, {"count", count}, {"limit", kMostPageWords}}));
        }
    }
}

void readWords(Lesson& lesson) {
    std::error_code none;
    const std::string english = joined(lesson.folder, kEnglishText), ukrainian = joined(lesson.folder, kUkrainianText);
    const bool hasEnglish = fs::exists(english, none), hasUkrainian = fs::exists(ukrainian, none);
    if (!hasEnglish && !hasUkrainian) {
        throw InputError(lesson.folder,
                         Message(MessageId::LessonNoWords, {{"file", kEnglishText}, {"other", kUkrainianText}}));
    }
    const auto read = [&](const std::string& file) {
        LessonText text = parseLessonText(readTextFile(file), file);
        checkWords(lesson, text, file);
        return text;
    };
    if (hasEnglish) lesson.english = read(english);
    if (hasUkrainian) lesson.ukrainian = read(ukrainian);
    if (!hasEnglish) lesson.english = lesson.ukrainian;
    if (!hasUkrainian) lesson.ukrainian = lesson.english;
}

// Throws InputError with file and line; `line`: of the page, since the scenario is put together from several places.
Scenario parsedScenario(const Json& json, const std::string& file, std::size_t line) {
    try {
        return parseScenario(json.dump(), file);
    } catch (const InputError& error) {
        Message why = error.message();
        for (MessageValue& value : why.values) {
            if (value.name == "line") value.text = std::to_string(line);
        }
        throw InputError(error.subject(), std::move(why));
    }
}

}  // namespace

void resolveShipped(Json& scenario, const std::string& folder, const std::string& datasets) {
    constexpr std::string_view kPrefix = "datasets/";
    const auto resolve = [&](const char* object, const char* key) {
        if (!scenario.contains(object) || !scenario[object].is_object() || !scenario[object].contains(key)) return;
        Json& value = scenario[object][key];
        if (!value.is_string()) return;
        const std::string path = value.get<std::string>();
        std::error_code none;
        if (!path.starts_with(kPrefix) || fs::exists(fs::path(folder) / path, none)) return;
        value = (fs::path(datasets) / path.substr(kPrefix.size())).string();
    };
    for (const char* key : {"height", "color", "normal"}) resolve("pictures", key);
    for (const char* key : {"rays", "steps"}) resolve("other-tracer", key);
}

std::string knobValueText(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

bool putValue(Json& scenario, const std::string& pointer, const Json& value) {
    // The library throws for what is no pointer, and for names in an array that are no number or too large a one.
    try {
        std::vector<std::string> names;
        for (Json::json_pointer rest(pointer); !rest.empty(); rest.pop_back()) names.push_back(rest.back());
        // By hand, because the library's operator fills an array with as many elements as the pointer's number says.
        Json* at = &scenario;
        for (auto name = names.rbegin(); name != names.rend(); ++name) {
            if (at->is_null()) *at = Json::object();
            const Json::json_pointer step = Json::json_pointer() / *name;
            if (!at->is_object() && !at->contains(step)) return false;
            at = at->is_object() ? &(*at)[*name] : &(*at)[step];
        }
        *at = value;
        return true;
    } catch (const Json::exception&) {
        return false;
    }
}

std::string Lesson::file() const {
    return joined(folder, kLessonFile);
}

std::optional<std::size_t> Lesson::pageOf(const std::string& page) const {
    const auto found =
        std::find_if(pages.begin(), pages.end(), [&](const LessonPage& one) { return one.name == page; });
    if (found == pages.end()) return std::nullopt;
    return static_cast<std::size_t>(found - pages.begin());
}

Scenario Lesson::scenarioOf(std::size_t page, std::optional<std::size_t> turned) const {
    const LessonPage& chosen = pages[page];
    if (!turned) return parsedScenario(chosen.scenario, file(), chosen.line);
    Json scenario = chosen.scenario;
    if (!putValue(scenario, chosen.knob->set, chosen.knob->values[*turned])) {
        throw InputError(file(), Message(MessageId::ScenarioLine,
                                         {{"line", chosen.line}, {"why", Message(MessageId::WantAPointer)}}));
    }
    return parsedScenario(scenario, file(), chosen.line);
}

std::optional<Scenario> Lesson::scenarioAt(const std::string& place, const Scenario& from) const {
    if (const auto page = pageOf(place)) return scenarioOf(*page);
    for (const auto& [name, patch] : variants) {
        if (name != place) continue;
        Json scenario = Json::parse(scenarioText(from, folder));
        scenario.merge_patch(patch);
        return parsedScenario(scenario, file(), 1);
    }
    return std::nullopt;
}

Lesson readLesson(const std::string& folder, const std::string& datasets) {
    Lesson lesson;
    lesson.folder = fs::path(folder).has_filename() ? folder : fs::path(folder).parent_path().string();
    lesson.name = fs::path(fs::absolute(lesson.folder)).filename().string();
    const std::string file = lesson.file();
    const std::string text = readTextFile(file);
    const Json json = parseJson(text, file);
    JsonReader reader({text, file}, json, {});
    int version = 0;
    reader.readWhole("lesson", version);
    if (version != kLessonVersion)
        reader.fail("lesson", Message(MessageId::LessonVersion, {{"known", kLessonVersion}}));
    reader.read("minutes", lesson.minutes);
    if (reader.has("minutes") && !(lesson.minutes > 0 && lesson.minutes <= 600))
        reader.fail("minutes", MessageId::WantALarger);
    if (!reader.has("scenario") || !json["scenario"].is_object()) reader.fail("scenario", MessageId::WantAObject);
    Json scenario = json["scenario"];
    if (reader.has("variants")) {
        JsonReader variants = reader.child("variants");
        variants.acceptAll();
        for (const auto& [name, patch] : variants.object().items()) {
            reader.guarded({"variants", name}, [&, key = name] { requireWord(key); });
            if (!patch.is_object()) variants.fail(name, MessageId::WantAObject);
            Json resolved = patch;
            resolveShipped(resolved, lesson.folder, datasets);
            lesson.variants.emplace_back(name, std::move(resolved));
        }
    }
    resolveShipped(scenario, lesson.folder, datasets);
    reader.readObjects("pages", [&](JsonReader item) {
        LessonPage page = pageOf(std::move(item), scenario);
        resolveShipped(page.scenario, lesson.folder, datasets);
        page.line = lineOf(text, {"pages", lesson.pages.size()});
        const bool isVariant = std::any_of(lesson.variants.begin(), lesson.variants.end(),
                                           [&](const auto& variant) { return variant.first == page.name; });
        if (isVariant || lesson.pageOf(page.name)) {
            throw InputError(file, Message(MessageId::ScenarioLine,
                                           {{"line", page.line},
                                            {"why", Message(MessageId::LessonPageTwice, {{"page", page.name}})}}));
        }
        lesson.pages.push_back(std::move(page));
    });
    if (lesson.pages.empty()) reader.fail("pages", MessageId::WantObjects);
    reader.finish();
    readWords(lesson);
    for (std::size_t page = 0; page < lesson.pages.size(); ++page) lesson.scenarioOf(page);
    return lesson;
}

void writeLesson(const std::string& folder, const NewLesson& lesson) {
    std::error_code fault;
    if (fs::exists(folder, fault)) throw InputError(folder, Message(MessageId::LessonFolderExists));
    fs::create_directories(folder, fault);
    if (fault) throw WorkError(folder, Message(MessageId::LessonFolderFails, {{"why", fault.message()}}));
    Json scenario = Json::parse(scenarioText(lesson.scenario, fs::absolute(folder).string()));
    scenario.erase("step");
    const std::string shipped = (fs::path(lesson.datasets) / "").string();
    for (auto& picture : scenario["pictures"]) {
        if (!picture.is_string() || lesson.datasets.empty()) continue;
        const std::string path = picture.get<std::string>();
        if (path.starts_with(shipped)) picture = "datasets/" + path.substr(shipped.size());
    }
    Json page{{"name", lesson.english.pages.front().name}};
    if (std::find(kPanes.begin(), kPanes.end(), lesson.pane) != kPanes.end()) page["pane"] = lesson.pane;
    if (lesson.scenario.pixel) page["step"] = lesson.scenario.step + 1;
    page["claims"] = Json::array();
    const Json json{{"lesson", kLessonVersion}, {"scenario", scenario}, {"pages", Json::array({page})}};
    writeTextFile(joined(folder, kLessonFile), json.dump(2) + "\n");
    writeTextFile(joined(folder, kEnglishText), lessonTextFile(lesson.english));
    writeTextFile(joined(folder, kUkrainianText), lessonTextFile(lesson.ukrainian));
}

std::optional<int> stepOf(const StepRule& rule, const std::vector<Step>& steps, std::optional<std::size_t> departure,
                          std::optional<std::size_t> overshoot) {
    const auto within = [&](std::size_t index) {
        return index < steps.size() ? std::optional(static_cast<int>(index)) : std::nullopt;
    };
    if (const int* const number = std::get_if<int>(&rule)) return within(static_cast<std::size_t>(*number - 1));
    const std::string& name = std::get<std::string>(rule);
    if (name == "last") return steps.empty() ? std::nullopt : within(steps.size() - 1);
    if (name == "departure") return departure ? within(*departure) : std::nullopt;
    if (name == "overshoot") return overshoot ? within(*overshoot) : std::nullopt;
    const auto found =
        std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return decisionName(step.decision) == name; });
    return within(static_cast<std::size_t>(found - steps.begin()));
}

}  // namespace relief
