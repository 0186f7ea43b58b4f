// Moving pictures: one frame per step or value, each as it would be exported alone; all of one size; never mixed with
// an earlier, longer one.
#include <fstream>
#include <regex>
#include <sstream>

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QLineEdit>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTimer>

#include <nlohmann/json.hpp>

#include "relief/errors.h"
#include "relief/files.h"
#include "window_fixture.h"
#include "windows/moving_picture.h"
#include "windows/pane_list.h"

namespace reliefui {

namespace {

FigurePage smallPage() {
    FigurePage page;
    page.widthMm = 100;
    page.dpi = 80;
    page.style.theme = Theme::Light;
    return page;
}

MovingPicture movingOf(const char* view, const std::string& sequence, std::optional<int> frames,
                       const relief::Scenario& scenario) {
    MovingPicture moving{figureKind(view), relief::parseSequence(sequence, frames, "--sequence"), {}};
    moving.order.scenario = scenario;
    return moving;
}

class Moving : public ::testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path().toStdString() + "/" + name; }
    QStringList written(const QString& folder) const {
        return QDir(folder_.filePath(folder)).entryList(QDir::Files, QDir::Name);
    }
    void write(const MovingPicture& moving, const std::string& file, FigurePage page = smallPage()) {
        writeFrames(
            moving, maker_, page, path(file), [](std::size_t, std::size_t) {}, work_);
    }
    std::string page(const MovingPicture& moving) {
        return movingPage(
            moving, maker_, [](relief::Language) {}, [](std::size_t, std::size_t) {}, work_);
    }
    std::shared_ptr<const Snapshot> snapshot(const relief::Scenario& scenario) {
        SnapshotOrder order;
        order.scenario = scenario;
        return maker_.make(order, work_);
    }
    // Returns the data of a page's slider.
    static nlohmann::json slider(const std::string& html) {
        const std::string begin = "class=\"frames\">";
        const std::size_t at = html.find(begin);
        if (at == std::string::npos) return {};
        return nlohmann::json::parse(html.substr(at + begin.size(), html.find("</script>", at) - at - begin.size()));
    }

    QTemporaryDir folder_;
    SnapshotMaker maker_;
    relief::Work work_;
};

TEST_F(Moving, AStepIsAFrameAsItIsExportedAlone) {
    relief::Scenario scenario = deepRay();
    const MovingPicture moving = movingOf("profile", "steps", {}, scenario);
    write(moving, "steps/profile.png");
    const auto steps = static_cast<int>(snapshot(scenario)->trace.steps.size());
    const QStringList files = written(QStringLiteral("steps"));
    ASSERT_EQ(files.size(), steps);
    EXPECT_GT(steps, 8);
    EXPECT_EQ(files.front().toStdString(), "profile_00000.png");
    for (const int step : {0, 5, steps - 1}) {
        scenario.step = step;
        const auto alone = snapshot(scenario);
        writeFigure(*moving.kind.make(alone, alone->scenario), smallPage(), path("alone.png"), work_);
        EXPECT_EQ(relief::readTextFile(path("steps/" + files[step].toStdString())),
                  relief::readTextFile(path("alone.png")))
            << step;
    }
    EXPECT_NE(relief::readTextFile(path("steps/" + files[0].toStdString())),
              relief::readTextFile(path("steps/" + files[1].toStdString())));
}

TEST_F(Moving, ASweepShowsItsValuesInPicturesOfOneSize) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {}};
    // So narrow that the caption of some frames takes another line.
    FigurePage page = smallPage();
    std::set<int> heights;
    for (const double width : {60.0, 63.0, 66.0, 69.0}) {
        page.widthMm = width;
        write(movingOf("profile", "sweep:layers=4,1000", {}, scenario), "sweep/p.png", page);
        std::set<int> here;
        for (const QString& file : written(QStringLiteral("sweep"))) {
            here.insert(QImage(folder_.filePath(QStringLiteral("sweep/") + file)).height());
        }
        EXPECT_EQ(here.size(), 1U) << width;
    }
    write(movingOf("profile", "sweep:layers=4,1000", {}, scenario), "vectors/p.svg");
    EXPECT_EQ(written(QStringLiteral("vectors")).size(), 2);
    EXPECT_NE(relief::readTextFile(path("vectors/p_00001.svg")).find("layers = 1000 · "), std::string::npos);
    // The frame is that of the scenario with the value.
    scenario.method.options["layers"] = "1000";
    const auto alone = snapshot(scenario);
    page.caption = false;
    page.widthMm = 100;
    write(movingOf("profile", "sweep:layers=4,1000", {}, scenario), "plain/p.png", page);
    writeFigure(*figureKind("profile").make(alone, alone->scenario), page, path("alone.png"), work_);
    EXPECT_EQ(relief::readTextFile(path("plain/p_00001.png")), relief::readTextFile(path("alone.png")));
}

TEST_F(Moving, APageHasAllFramesOnce) {
    const std::string html = page(movingOf("result", "orbit", 5, smallScenario()));
    const nlohmann::json data = slider(html);
    ASSERT_EQ(data["en"].size(), 5U);
    EXPECT_EQ(data["uk"], data["en"]) << "a picture has no words";
    EXPECT_EQ(data["steps"].size(), 5U);
    std::set<nlohmann::json> different;
    for (const auto& parts : data["en"]) different.insert(parts);
    EXPECT_EQ(different.size(), 5U);
    EXPECT_EQ(data["say-uk"][1].get<std::string>().find("azimuth = " + data["steps"][1].get<std::string>()), 0U);
    EXPECT_NE(html.find("class=\"play\""), std::string::npos);
    const std::string list = "id=\"parts\">";
    const std::size_t at = html.find(list) + list.size();
    const nlohmann::json parts = nlohmann::json::parse(html.substr(at, html.find("</script>", at) - at));
    std::size_t most = 0;
    for (const auto& frame : data["en"]) most = std::max(most, frame[0].get<std::size_t>());
    EXPECT_EQ(parts.size(), most + 1) << "no part belongs to no frame";
    // Drawings stay drawings.
    const std::string drawn = page(movingOf("profile", "sweep:relief-depth=0.05..0.2", 3, smallScenario()));
    EXPECT_EQ(drawn.find("data:image/jpeg"), std::string::npos);
    EXPECT_EQ(slider(drawn)["steps"], (nlohmann::json{"0.05", "0.125", "0.2"}));
}

// Steps count from 1, also where they are pictures, and a ray of the sky has a page, too.
TEST_F(Moving, APageCountsTheSteps) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "1"}}};
    scenario.pictures.recipeWidth = scenario.pictures.recipeHeight = 8;
    MovingPicture pictures = movingOf("profile", "steps", {}, scenario);
    pictures.kind.vectors = false;
    const nlohmann::json steps = slider(page(pictures))["steps"];
    ASSERT_GE(steps.size(), 2U);
    for (std::size_t n = 0; n < steps.size(); ++n) EXPECT_EQ(steps[n], std::to_string(n + 1));
    const nlohmann::json trace = slider(page(movingOf("trace", "steps", {}, scenario)));
    EXPECT_EQ(trace["steps"], steps) << "the 3-D trace moves as well";
    EXPECT_NE(trace["en"][0], trace["en"][1]);
    scenario.pixel.reset();
    EXPECT_NE(page(movingOf("pyramid", "steps", {}, scenario)).find("<svg"), std::string::npos);
}

TEST_F(Moving, ALongerSequenceIsNotMixedWithAShorterOne) {
    const relief::Scenario scenario = smallScenario();
    write(movingOf("profile", "sweep:fov=20,30,40", {}, scenario), "f/p.png");
    write(movingOf("profile", "sweep:fov=25,35,45", {}, scenario), "f/p.png");  // one as long is replaced
    try {
        write(movingOf("profile", "sweep:fov=20,30", {}, scenario), "f/p.png");
        ADD_FAILURE();
    } catch (const relief::InputError& error) {
        EXPECT_NE(error.text(relief::Language::English).find("p_00002.png"), std::string::npos);
    }
    write(movingOf("profile", "sweep:fov=20,30", {}, scenario), "f/other.png");
    EXPECT_EQ(written(QStringLiteral("f")).size(), 5);
    EXPECT_THROW(write(movingOf("skipped", "steps", {}, scenario), "f/s.png"), relief::InputError);
    relief::Scenario none = scenario;
    none.pixel.reset();
    EXPECT_THROW(write(movingOf("profile", "steps", {}, none), "f/n.png"), relief::InputError);
    EXPECT_THROW(write(movingOf("profile", "sweep:fov=0..9", {}, scenario), "f/n.png"), relief::InputError);
}

TEST_F(WindowTest, TheDialogProposesWhatThePaneCanShow) {
    openWindow(smallScenario());
    QAction* moving = nullptr;
    for (QAction* const action : window_->findChildren<QAction*>()) {
        if (action->text().remove('&').startsWith(QStringLiteral("Moving picture"))) moving = action;
    }
    ASSERT_NE(moving, nullptr);
    bool seen = false;
    const std::vector<PaneKind>& all = paneList();
    const auto result =
        std::find_if(all.begin(), all.end(), [](const PaneKind& one) { return one.name == QLatin1String("result"); });
    ASSERT_NE(result, all.end());
    window_->result()->setFocus();
    QTimer::singleShot(0, window_.get(), [&] {
        auto* const dialog = window_->findChild<QDialog*>(QStringLiteral("moving-picture"));
        ASSERT_NE(dialog, nullptr);
        seen = true;
        auto* const panes = dialog->findChild<QComboBox*>(QStringLiteral("moving-pane"));
        auto* const moves = dialog->findChild<QComboBox*>(QStringLiteral("moving-what"));
        auto* const values = dialog->findChild<QLineEdit*>(QStringLiteral("moving-values"));
        auto* const frames = dialog->findChild<QSpinBox*>(QStringLiteral("moving-frames"));
        EXPECT_EQ(panes->currentText(), result->title) << "the pane with the focus";
        panes->setCurrentIndex(panes->findText(QStringLiteral("Profile")));
        EXPECT_EQ(moves->itemData(0).toStringList(), QStringList(QStringLiteral("steps")));
        EXPECT_FALSE(values->isEnabled() || frames->isEnabled()) << "the ray has as many steps as it has";
        moves->setCurrentIndex(moves->findText(QStringLiteral("relief-depth")));
        EXPECT_TRUE(values->isEnabled() && frames->isEnabled());
        EXPECT_TRUE(values->text().contains(QStringLiteral(".."))) << values->text().toStdString();
        values->setText(QStringLiteral("0.1,0.2"));
        EXPECT_FALSE(frames->isEnabled());
        panes->setCurrentIndex(0);
        EXPECT_EQ(moves->itemData(0).toStringList(), QStringList(QStringLiteral("orbit")));
        dialog->reject();
    });
    moving->trigger();
    EXPECT_TRUE(seen);
}

}  // namespace

}  // namespace reliefui
