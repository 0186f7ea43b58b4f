// The exported shaders in the window: they draw what the CPU's methods draw, and what refuses them is said in a line.
#include <QComboBox>
#include <QDockWidget>
#include <QToolButton>

#include "panes/drawing_canvas.h"
#include "panes/shader/shader_view.h"
#include "relief/tracers.h"
#include "window_fixture.h"
#include "workspace/snapshot_maker.h"

// Included after Qt, because it defines macros.
#include <EGL/egl.h>

namespace reliefui {

namespace {

constexpr int kPatienceMs = 60000;

std::shared_ptr<const ShaderPreview> previewOf(const relief::Scenario& scenario,
                                               const ShaderGlSource& open = openShaderGl) {
    relief::Work work;
    return shaderPreview(SnapshotMaker().make({scenario}, work), open, work);
}

// What a graphics card that is reset does to its contexts: functions of OpenGL do nothing from then on.
void endCurrentContext() {
    eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

std::string problemOf(const relief::Scenario& scenario, const ShaderGlSource& open = openShaderGl) {
    const auto preview = previewOf(scenario, open);
    return preview->problem ? relief::sentence(*preview->problem) : std::string();
}

// Draws the scenario; fails if the shader's hits differ from the CPU's in more than this share of the pixels, or the
// colours by more than this on average.
std::shared_ptr<const ShaderPreview> expectAlike(const relief::Scenario& scenario, double share, double color) {
    const auto preview = previewOf(scenario);
    EXPECT_FALSE(preview->problem) << relief::sentence(*preview->problem);
    if (preview->problem) return preview;
    const relief::ShaderDifferences& found = preview->found;
    EXPECT_GT(found.compared, 1000U);
    EXPECT_LE(static_cast<double>(found.far + found.otherOutcome), share * static_cast<double>(found.compared));
    EXPECT_LE(found.meanColor, color);
    EXPECT_GT(preview->seconds, 0);
    return preview;
}

// The third picture is of the chosen differences, and the chosen pixel, if there is one, is marked in all three.
void expectPictures(const std::shared_ptr<const ShaderPreview>& preview) {
    ShaderSource source;
    source.preview = preview;
    const auto worst = source.preview->found.worstColor;
    ASSERT_TRUE(worst);
    const auto largest = static_cast<float>(source.preview->found.largestColor);
    for (const auto measure : {ShaderMeasure::Colors, ShaderMeasure::Hits}) {
        source.measure = measure;
        for (const auto& pixel : {std::optional<relief::PixelChoice>(), worst}) {
            source.pixel = pixel;
            const ShaderPicture picture = shaderPicture(source, 600, 400, relief::Language::English);
            std::size_t rings = 0;
            for (const Item& item : picture.drawing.items) {
                const auto* const cells = std::get_if<Cells>(&item.primitive);
                if (cells != nullptr && item.id.i == 2 && measure == ShaderMeasure::Colors) {
                    EXPECT_EQ((*cells->values)(worst->x, worst->y), largest);
                }
                const auto* const ring = std::get_if<Ring>(&item.primitive);
                if (ring == nullptr) continue;
                EXPECT_EQ(picture.pixelAt(ring->center), pixel);
                ++rings;
            }
            EXPECT_EQ(rings, pixel ? picture.rooms.size() : 0);
        }
    }
}

TEST(ShaderPreview, EveryShaderDrawsWhatItsMethodDraws) {
    relief::Scenario scenario = smallScenario();
    scenario.camera.elevation = 50;
    for (const std::string& tracer : relief::shaderTracers()) {
        SCOPED_TRACE(tracer);
        scenario.method = {tracer, {}};
        // Of the search by cones, steps end near the surface, where float decides.
        const bool exact = relief::findTracer(tracer).guarantee == relief::Guarantee::Exact;
        expectAlike(scenario, exact ? 0 : 0.01, 1e-4);
    }
}

TEST(ShaderPreview, ItDrawsAShippedMapOnACubeByTheFilterThatItHas) {
    relief::Scenario scenario = smallScenario();
    scenario.pictures = {};
    scenario.pictures.height = RELIEF_DATASETS "/gray_rocks/height.png";
    scenario.pictures.color = RELIEF_DATASETS "/gray_rocks/color.jpg";
    scenario.scene = relief::SceneKind::Cube;
    scenario.filter.name = "elliptical";
    scenario.surface = relief::Surface::Columns;
    const auto preview = expectAlike(scenario, 0.001, 1e-3);
    ASSERT_FALSE(preview->problem);
    std::string notes;
    for (const relief::Message& note : preview->notes) notes += relief::sentence(note) + "\n";
    EXPECT_NE(notes.find("has no elliptical"), std::string::npos) << notes;
    EXPECT_NE(notes.find("has no columns"), std::string::npos) << notes;
    EXPECT_NE(notes.find("shadows"), std::string::npos) << notes;
    expectPictures(preview);
}

TEST(ShaderPreview, WhatRefusesItIsSaidInALine) {
    relief::Scenario scenario = smallScenario();
    for (const EglProblem problem : {EglProblem::NoEgl, EglProblem::NoVersion}) {
        const auto refused = [problem](EglProblem& why) {
            why = problem;
            return std::unique_ptr<ShaderGl>();
        };
        scenario.method = {"max-pyramid", {}};
        EXPECT_NE(problemOf(scenario, refused).find(problem == EglProblem::NoEgl ? "no OpenGL" : "OpenGL 4.5"),
                  std::string::npos);
    }
    scenario.method = {"exact", {}};
    EXPECT_NE(problemOf(scenario).find("exact has no shader"), std::string::npos);
    scenario.method = {"cone", {{"sectors", "4"}}};
    EXPECT_NE(problemOf(scenario).find("sectors"), std::string::npos);
    scenario.method = {"layers", {}};
    scenario.pictures.recipeWidth = 1 << 15;
    scenario.pictures.recipeHeight = 4;
    EXPECT_NE(problemOf(scenario).find("32768"), std::string::npos);
}

// The context ends before each of the stages in turn: nothing is compared, and the reason is said. Another context
// draws.
TEST(ShaderPreview, AContextThatIsLostIsSaidInALine) {
    const relief::Scenario scenario = smallScenario();
    relief::Work making;
    const auto snapshot = SnapshotMaker().make({scenario}, making);
    for (const double lostAt : {0.0, 0.2, 0.4, 0.6}) {
        SCOPED_TRACE(lostAt);
        bool open = false;
        relief::Work work(0, {}, [&](std::string_view, double done) {
            if (open && done >= lostAt) endCurrentContext();
        });
        const auto opening = [&](EglProblem& problem) {
            auto gl = openShaderGl(problem);
            open = gl != nullptr;
            if (open && lostAt == 0) endCurrentContext();
            return gl;
        };
        const auto preview = shaderPreview(snapshot, opening, work);
        ASSERT_TRUE(preview->problem);
        EXPECT_NE(relief::sentence(*preview->problem).find("has lost"), std::string::npos)
            << relief::sentence(*preview->problem);
        EXPECT_FALSE(preview->shader);
        EXPECT_FALSE(previewOf(scenario)->problem);
    }
}

class ShaderPaneTest : public WindowTest {
  protected:
    void openPane() {
        openWindow(smallScenario());
        QTest::keyClick(window_.get(), Qt::Key_8, Qt::AltModifier);
        settle();
    }
    void settle() {
        QTest::qWait(50);
        ASSERT_TRUE(QTest::qWaitFor([&] { return pane()->preview() && pane()->isUpToDate() && !workspace_->busy(); },
                                    kPatienceMs));
    }
    ShaderView* pane() { return window_->pane<ShaderView>(); }
};

TEST_F(ShaderPaneTest, AClickAndTheButtonChooseAPixel) {
    openPane();
    ASSERT_FALSE(pane()->preview()->problem);
    EXPECT_GT(colorsIn(grab(pane())), 50);
    // The CPU's picture.
    const Box room = pane()->picture().rooms[1];
    const Point at{room.x0 + 0.25 * room.width(), room.y0 + 0.5 * room.height()};
    QTest::mouseClick(pane()->canvas(), Qt::LeftButton, Qt::NoModifier, pane()->canvas()->toWidget(at).toPoint());
    EXPECT_NEAR(scenario().pixel->x, 50, 2);
    EXPECT_NEAR(scenario().pixel->y, 75, 2);
    settle();
    for (const int measure : {0, 1}) {
        pane()->setMeasure(static_cast<ShaderMeasure>(measure));
        EXPECT_EQ(pane()->findChild<QComboBox*>(QStringLiteral("shader-measure"))->currentIndex(), measure);
        auto* const worst = pane()->findChild<QToolButton*>(QStringLiteral("shader-worst"));
        const auto place = pane()->preview()->worst(static_cast<ShaderMeasure>(measure));
        ASSERT_TRUE(place);
        worst->setFocus(Qt::ShortcutFocusReason);  // as by Tab: then Space presses the button
        ASSERT_TRUE(worst->isEnabled());
        ASSERT_EQ(QApplication::focusWidget(), worst);
        QTest::keyClick(worst, Qt::Key_Space);
        EXPECT_EQ(scenario().pixel, place);
    }
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("shader.svg"));
    saveFigure(pane(), file);
    EXPECT_TRUE(QFile::exists(file));
}

TEST_F(ShaderPaneTest, ItFollowsTheScenarioAndSaysWhyItCannot) {
    openPane();
    ASSERT_FALSE(pane()->preview()->problem);
    relief::Scenario other = scenario();
    other.method = {"exact", {}};
    workspace_->change(other, QStringLiteral("test"));
    waitForFull();
    settle();
    EXPECT_TRUE(pane()->preview()->problem);
    EXPECT_FALSE(pane()->findChild<QToolButton*>(QStringLiteral("shader-worst"))->isEnabled());
    EXPECT_GT(colorsIn(grab(pane()->canvas())), 2) << "the line is shown";
    EXPECT_TRUE(pane()->image(200).isNull()) << "there is nothing to export";
    workspace_->undo();
    waitForFull();
    settle();
    EXPECT_FALSE(pane()->preview()->problem);
    // Without OpenGL the window goes on.
    pane()->setGlSource([](EglProblem& why) {
        why = EglProblem::NoEgl;
        return std::unique_ptr<ShaderGl>();
    });
    settle();
    ASSERT_TRUE(pane()->preview()->problem);
    EXPECT_GT(colorsIn(grab(pane()->canvas())), 2);
    pane()->setGlSource(openShaderGl);
    EXPECT_FALSE(pane()->isUpToDate());
    EXPECT_TRUE(pane()->cancel());
    ASSERT_TRUE(QTest::qWaitFor([&] { return pane()->isUpToDate(); }, kPatienceMs));
    pane()->draw();
    settle();
    EXPECT_FALSE(pane()->preview()->problem);
}

}  // namespace

}  // namespace reliefui
