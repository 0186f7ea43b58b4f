// Lessons as files: their words, what is refused, the scenarios of their pages, the check of their claims.
#include "measuring/lesson/lesson.h"

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "measuring/lesson/course.h"
#include "measuring/lesson/lesson_check.h"
#include "relief/files.h"

namespace relief::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kText = R"(# A title

About it.

### remember
Remember this.

## first: One page

Text with {trace.steps} steps, $V_{i+1}$ and *weight*.

### question
Which?
- this one
- that one

### answer
Because {1 + 1:.1}.

## second: Another

### knob
Turn it.
)";

constexpr const char* kJson = R"({
  "lesson": 1,
  "minutes": 5,
  "scenario": {"reliefscope": 1, "pictures": {"recipe": {"name": "bricks", "width": 32, "height": 32}},
    "method": {"name": "layers", "options": {"layers": "8"}}, "size": [64, 48], "pixel": [32, 30]},
  "variants": {"more": {"method": {"options": {"layers": "32"}}}},
  "pages": [
    {"name": "first", "pane": "profile", "step": "last",
     "question": {"choose": ["trace.steps < 0", "trace.steps > 0"]},
     "claims": ["frame.error.mean@more < frame.error.mean", "frame.rays@second == frame.rays"]},
    {"name": "second", "change": {"method": {"options": {"layers": "16"}}},
     "knob": {"set": "/method/options/layers", "values": ["8", "16"],
              "watch": [{"value": "frame.error.mean", "trend": "falls"}]},
     "claims": ["option('layers') == 16"]}
  ]
})";

class LessonFiles : public testing::Test {
  protected:
    LessonFiles() {
        std::string pattern = (fs::temp_directory_path() / "relief_lesson_XXXXXX").string();
        folder_ = mkdtemp(pattern.data());
        fs::create_directory(lessonFolder());
        write(kJson, kText);
    }
    ~LessonFiles() override { fs::remove_all(folder_); }
    std::string lessonFolder() const { return (fs::path(folder_) / "101").string(); }
    void write(const std::string& json, const std::string& text) const {
        writeTextFile(lessonFolder() + "/lesson.json", json);
        writeTextFile(lessonFolder() + "/text.en.md", text);
    }
    static std::string replaced(std::string text, const std::string& from, const std::string& to) {
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    }
    Lesson read() const { return readLesson(lessonFolder(), RELIEF_DATASETS); }
    LessonReport check() const {
        SceneCache scenes;
        Work work;
        return checkLesson(read(), scenes, work);
    }

    std::string folder_;
};

TEST_F(LessonFiles, AreRead) {
    const Lesson lesson = read();
    EXPECT_EQ(lesson.name, "101");
    EXPECT_EQ(lesson.minutes, 5);
    EXPECT_EQ(lesson.english.title, "A title");
    EXPECT_EQ(lesson.english.about, "About it.");
    EXPECT_EQ(lesson.english.remember, "Remember this.");
    ASSERT_EQ(lesson.pages.size(), 2U);
    EXPECT_EQ(lesson.ukrainian.title, "A title") << "the language that is there";
    const PageText& page = lesson.english.pages[0];
    EXPECT_EQ(page.title, "One page");
    EXPECT_EQ(page.choices, (std::vector<std::string>{"this one", "that one"}));
    EXPECT_EQ(page.question, "Which?");
    EXPECT_EQ(lessonHtml(page.text, [](const ValueSlot& slot) { return "<" + slot.expression; }),
              "<p>Text with <b>&lt;trace.steps</b> steps, <i>V<sub>i+1</sub></i> and <i>weight</i>.</p>\n");
    EXPECT_EQ(valueSlots(page.answer).at(0).format, ".1");
    EXPECT_EQ(wordCount(page.text), 7);
    EXPECT_EQ(lesson.scenarioOf(0).method.options.at("layers"), "8");
    EXPECT_EQ(lesson.scenarioOf(1).method.options.at("layers"), "16") << "changes add up";
    EXPECT_EQ(lesson.scenarioOf(1, 0).method.options.at("layers"), "8") << "the knob's first value";
    EXPECT_EQ(lesson.scenarioAt("more", lesson.scenarioOf(1))->method.options.at("layers"), "32");
    EXPECT_FALSE(lesson.scenarioAt("other", lesson.scenarioOf(1)));
    EXPECT_EQ(parseLessonText(lessonTextFile(lesson.english), "again").pages[0].choices, page.choices);
}

TEST_F(LessonFiles, ThatHoldPassTheCheckAndFaultsAreFound) {
    const LessonReport good = check();
    EXPECT_TRUE(good.holds()) << reportText(read(), good, Language::English);
    EXPECT_EQ(good.claims, 5) << "three claims, an answer, a trend";
    EXPECT_TRUE(reportText(read(), good, Language::English).starts_with("101 holds: 2 pages, 5 claims,"));
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"option('layers') == 16", "option('layers') == 17"},
        {"\"falls\"", "\"rises\""},
        {"trace.steps < 0", "trace.steps > 1"},
        {"trace.steps > 0\"", "trace.steps < 0\""},
        {"frame.error.mean@more <", "frame.error.mean@fewer <"},
        {"option('layers')", "option('layer')"},
        {"frame.rays@second ==", "frame.beams@second =="},
        {"\"pixel\": [32, 30]", "\"pixel\": [0, 0]"},
        {"\"step\": \"last\"", "\"step\": \"ascend\""},
        {"option('layers') == 16", "option('layers')"}};
    for (const auto& [from, to] : wrong) {
        write(replaced(kJson, from, to), kText);
        const LessonReport report = check();
        EXPECT_FALSE(report.holds()) << to;
        EXPECT_TRUE(reportText(read(), report, Language::English).starts_with("101 FAILS")) << to;
    }
    write(kJson, replaced(kText, "{trace.steps}", "{trace.stops}"));
    EXPECT_FALSE(check().holds()) << "a value of the text that there is not";
}

TEST_F(LessonFiles, ThatAreWrongAreRefusedWithTheirPlace) {
    const std::vector<std::pair<std::string, std::string>> wrong{{"\"lesson\": 1", "\"lesson\": 2"},
                                                                 {"\"minutes\": 5", "\"minuets\": 5"},
                                                                 {"\"minutes\": 5", "\"minutes\": -5"},
                                                                 {"\"last\"", "\"lasts\""},
                                                                 {"\"profile\"", "\"profil\""},
                                                                 {"\"name\": \"second\"", "\"name\": \"first\""},
                                                                 {"\"name\": \"second\"", "\"name\": \"more\""},
                                                                 {"\"second\", \"change\"", "\"a b\", \"change\""},
                                                                 {"\"falls\"", "\"fals\""},
                                                                 {"trace.steps < 0", "trace.steps <"},
                                                                 {"\"layers\": \"16\"", "\"layers\": \"x\""},
                                                                 {"\"choose\": [", "\"chose\": ["},
                                                                 {"\"/method", "\"method"},
                                                                 {"[\"8\", \"16\"]", "[\"8\"]"},
                                                                 {"\"reliefscope\": 1", "\"reliefscope\": 3"},
                                                                 {"\"watch\": [{", "\"watch\": [{\"more\": 1, "},
                                                                 {"\"bricks\"", "\"brics\""},
                                                                 {"\"pages\": [", "\"pages\": [1, "}};
    for (const auto& [from, to] : wrong) {
        write(replaced(kJson, from, to), kText);
        try {
            read();
            ADD_FAILURE() << to;
        } catch (const InputError& error) {
            EXPECT_TRUE(error.text(Language::English).find("lesson.json: ") != std::string::npos ||
                        error.text(Language::English).find("text.en.md: ") != std::string::npos)
                << error.text(Language::English);
        }
    }
    const std::string many = std::string("Text") + [] {
        std::string words;
        for (int n = 0; n < kMostPageWords; ++n) words += " word";
        return words;
    }();
    const std::vector<std::pair<std::string, std::string>> words{{"# A title", "A title"},
                                                                 {"## first: One", "## One"},
                                                                 {"## first", "## furst"},
                                                                 {"### question", "### questoin"},
                                                                 {"- that one\n", ""},
                                                                 {"### knob\nTurn it.", ""},
                                                                 {"{trace.steps}", "{trace.steps"},
                                                                 {"Text", many},
                                                                 {"## second: Another", "# Again"}};
    for (const auto& [from, to] : words) {
        write(kJson, replaced(kText, from, to));
        // A brace that is left open is found when the text is filled in.
        if (to == "{trace.steps") {
            EXPECT_FALSE(check().holds());
        } else {
            EXPECT_THROW(read(), InputError) << to;
        }
    }
}

TEST_F(LessonFiles, HaveKnobsThatSetOnlyWhatTheScenarioCanHold) {
    Json scenario = Json::parse(R"({"size": [64, 48], "method": {"name": "cone"}, "step": 1})");
    EXPECT_TRUE(putValue(scenario, "/method/options/base", "2"));
    EXPECT_TRUE(putValue(scenario, "/size/1", 50));
    EXPECT_EQ(scenario,
              Json::parse(R"({"size": [64, 50], "method": {"name": "cone", "options": {"base": "2"}}, "step": 1})"));
    for (const char* const pointer :
         {"/size/2", "/size/400000000", "/size/9000000000000000000", "/size/99999999999999999999", "/size/", "/size/-",
          "/size/x", "/step/1", "/a~2", "size"}) {
        EXPECT_FALSE(putValue(scenario, pointer, 1)) << pointer;
    }
    for (const std::string pointer : {"/size/400000000", "/size/99999999999999999999", "/size/"}) {
        write(replaced(kJson, "/method/options/layers\", \"values\": [\"8\", \"16\"]",
                       pointer + "\", \"values\": [8, 16]"),
              kText);
        EXPECT_THROW(read(), InputError) << pointer;
    }
}

TEST_F(LessonFiles, MayBeNamedByARelativePath) {
    fs::copy_file(std::string(RELIEF_DATASETS) + "/gray_rocks/height.png", lessonFolder() + "/own.png");
    write(replaced(kJson, R"("recipe": {"name": "bricks", "width": 32, "height": 32})", R"("height": "own.png")"),
          kText);
    const Lesson lesson = readLesson(fs::relative(lessonFolder()).string(), RELIEF_DATASETS);
    const Scenario twice = lesson.scenarioAt("more", lesson.scenarioOf(0)).value();
    EXPECT_TRUE(fs::exists(twice.pictures.height)) << twice.pictures.height;
}

TEST_F(LessonFiles, OfAFolderMakeACourse) {
    for (const char* const name : {"102", "own"})
        fs::copy(lessonFolder(), fs::path(folder_) / name, fs::copy_options::recursive);
    EXPECT_EQ(readCourse(folder_).lessons(), (std::vector<std::string>{"101", "102", "own"}));
    EXPECT_EQ(readCourse(folder_).chapters.size(), 1U);
    writeTextFile(
        folder_ + "/course.json",
        R"({"course": 1, "chapters": [{"begins": "1", "title": {"en": "One", "uk": "Перший"}}, {"begins": "2"}]})");
    const Course course = readCourse(folder_);
    ASSERT_EQ(course.chapters.size(), 2U) << "the empty chapter is left out";
    EXPECT_EQ(course.chapters[0].title(Language::Ukrainian), "Перший");
    EXPECT_EQ(course.chapters[1].lessons, std::vector<std::string>{"own"});
    writeTextFile(folder_ + "/course.json", R"({"course": 1, "chapter": []})");
    EXPECT_THROW(readCourse(folder_), InputError);
    EXPECT_THROW(readCourse(lessonFolder()), InputError) << "no lessons in it";
    EXPECT_TRUE(isLessonFolder(folder_));
    EXPECT_TRUE(isLessonFolder(lessonFolder()));
    EXPECT_FALSE(isLessonFolder(RELIEF_DATASETS));
}

TEST_F(LessonFiles, AreMadeOfAScenario) {
    NewLesson lesson;
    lesson.scenario = read().scenarioOf(0);
    lesson.scenario.pictures.recipe.clear();
    lesson.scenario.pictures.height = std::string(RELIEF_DATASETS) + "/gray_rocks/height.png";
    lesson.scenario.step = 3;
    lesson.pane = "duel";
    lesson.datasets = RELIEF_DATASETS;
    lesson.english.title = lesson.ukrainian.title = "Mine";
    PageText start;
    start.name = "start";
    start.title = "Start";
    start.text = "{trace.steps} steps";
    lesson.english.pages = {start};
    lesson.ukrainian.pages = {start};
    const std::string made = folder_ + "/made";
    writeLesson(made, lesson);
    EXPECT_NE(readTextFile(made + "/lesson.json").find("\"datasets/gray_rocks/height.png\""), std::string::npos);
    const Lesson read = readLesson(made, RELIEF_DATASETS);
    EXPECT_EQ(read.pages[0].pane, "duel");
    EXPECT_EQ(read.scenarioOf(0).pictures.height, lesson.scenario.pictures.height);
    SceneCache scenes;
    Work work;
    EXPECT_EQ(shownScenario(read, 0, scenes, work).step, 3);
    EXPECT_TRUE(checkLesson(read, scenes, work).holds());
    EXPECT_THROW(writeLesson(made, lesson), InputError) << "nothing is overwritten";
    lesson.datasets.clear();
    writeLesson(folder_ + "/alone", lesson);
    EXPECT_EQ(readTextFile(folder_ + "/alone/lesson.json").find("\"datasets/"), std::string::npos);
    EXPECT_EQ(readLesson(folder_ + "/alone", "").scenarioOf(0).pictures.height, lesson.scenario.pictures.height);
}

}  // namespace
}  // namespace relief::test
