// The 3-D trace: its content and its camera control.
#include <cmath>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCoordinate.h>
#include <vtkRenderer.h>

#include "painting/painter.h"
#include "panes/trace/trace3d_view.h"
#include "panes/turntable.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

// Counts pixels with the colour's hue; lighting changes only the brightness.
int pixelsLike(const QImage& image, QColor color) {
    constexpr int kHue = 8;
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor seen = image.pixelColor(x, y);
            const bool same = std::abs(seen.hsvHue() - color.hsvHue()) <= kHue;
            count += same && seen.hsvSaturation() > 150 && seen.value() > 60 ? 1 : 0;
        }
    }
    return count;
}

QVTKOpenGLNativeWidget* canvasOf(MainWindow& window) {
    return window.pane<Trace3dView>()->findChild<QVTKOpenGLNativeWidget*>();
}

TEST_F(WindowTest, TheTraceIsColouredByDecision) {
    openWindow(smallScenario());
    auto* const canvas = canvasOf(*window_);
    const auto& steps = snapshot()->trace.steps;
    const Style& style = workspace_->style();
    // The heights are grey, so every colour in the pane is that of a role.
    ASSERT_EQ(snapshot()->assets.color, nullptr);
    EXPECT_GT(pixelsLike(grab(canvas), toColor(style.color(Role::Ray))), 40);
    for (const auto decision : {relief::Decision::Descend, relief::Decision::Skip}) {
        for (std::size_t k = 0; k < steps.size(); ++k) {
            // A step longer than a point.
            if (steps[k].decision != decision || steps[k].lambdaOut - steps[k].lambdaIn < 0.02) continue;
            workspace_->chooseStep(static_cast<int>(k));
            EXPECT_GT(pixelsLike(grab(canvas), toColor(style.color(roleOf(decision)))), 60)
                << relief::decisionName(decision);
            break;
        }
    }
}

// Returns true if `seen` is the colour, possibly darkened by lighting.
bool isLit(QColor seen, Rgba color) {
    constexpr double kOff = 26;
    const double along = seen.red() * color.r + seen.green() * color.g + seen.blue() * color.b;
    const double light = along / (color.r * color.r + color.g * color.g + color.b * color.b);
    return light > 0.6 && light < 1.1 && std::abs(seen.red() - light * color.r) < kOff &&
           std::abs(seen.green() - light * color.g) < kOff && std::abs(seen.blue() - light * color.b) < kOff;
}

int pixelsOf(const QImage& image, Rgba color) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == toColor(color) ? 1 : 0;
    }
    return count;
}

// Counts lit pixels above the legend.
int litPixels(const QImage& image, Rgba color) {
    int count = 0;
    for (int y = 0; y < image.height() * 8 / 10; ++y) {
        for (int x = 0; x < image.width(); ++x) count += isLit(image.pixelColor(x, y), color) ? 1 : 0;
    }
    return count;
}

// Returns a pixel on the ray's interval of the chosen step, next to its label.
QPoint onStretch(MainWindow& window, const Snapshot& snapshot, const relief::Step& step) {
    const TraceScene scene(snapshot, 1);
    vtkRenderer* const renderer = window.pane<Trace3dView>()->renderer();
    const Place at = scene.onRay(step.lambdaIn + 0.25 * (step.lambdaOut - step.lambdaIn));
    auto place = vtkSmartPointer<vtkCoordinate>::New();
    place->SetCoordinateSystemToWorld();
    place->SetValue(at[0], at[1], at[2]);
    const int* const pixel = place->GetComputedDisplayValue(renderer);
    return {pixel[0], canvasOf(window)->height() - 1 - pixel[1]};
}

TEST_F(WindowTest, TheTraceIsColouredByLevelAndByPhaseWithALegend) {
    relief::Scenario scenario = smallScenario();
    for (const relief::MethodChoice& method :
         {relief::MethodChoice{"max-pyramid-paper", {}}, relief::MethodChoice{"layers-bisection", {{"layers", "8"}}}}) {
        scenario.method = method;
        openWindow(scenario);
        const auto& steps = snapshot()->trace.steps;
        const Style& style = workspace_->style();
        constexpr Role kOfPhase[] = {Role::Start, Role::Searched, Role::Refined};
        for (const char* const by : {"level", "phase"}) {
            window_->pane<Trace3dView>()->setColors(QString::fromLatin1(by));
            const int levels = snapshot()->maxima->pyramid.levels();
            int right = 0;
            int probes = 0;
            for (std::size_t k = 0; k < steps.size(); ++k) {
                if (steps[k].lambdaOut - steps[k].lambdaIn < 0.02) continue;
                workspace_->chooseStep(static_cast<int>(k));
                const QImage shown = grab(canvasOf(*window_));
                // The sheets of layers cover the ray, so there any pixel outside the legend counts.
                const Rgba color = std::string(by) == "level" ? style.levelLine({steps[k].level, levels})
                                                              : style.color(kOfPhase[static_cast<int>(steps[k].phase)]);
                const QPoint at = onStretch(*window_, *snapshot(), steps[k]);
                const bool sheets = method.name != "max-pyramid-paper";
                right += isLit(shown.pixelColor(at), color) || (sheets && litPixels(shown, color) > 60) ? 1 : 0;
                ++probes;
                const int patch = pixelsOf(shown, color);
                EXPECT_GT(patch, 40) << method.name << " " << by << ": step " << k << " is not in the legend";
            }
            ASSERT_GT(probes, 2);
            // The relief hides some.
            EXPECT_GE(right, probes * 2 / 3) << method.name << " " << by << ": " << right << " of " << probes;
        }
        window_.reset();
        workspace_.reset();
    }
}

TEST_F(WindowTest, TheTraceIsExportedInTheColoursOfThePane) {
    openWindow(smallScenario());
    const auto& steps = snapshot()->trace.steps;
    const QImage byDecision = window_->pane<Trace3dView>()->image(900);
    window_->pane<Trace3dView>()->setColors(QStringLiteral("level"));
    const QImage byLevel = window_->pane<Trace3dView>()->image(900);
    const Rgba color = workspace_->style().levelLine({steps.front().level, snapshot()->maxima->pyramid.levels()});
    EXPECT_EQ(pixelsOf(byDecision, color), 0);
    EXPECT_GT(pixelsOf(byLevel, color), 40);
}

TEST_F(WindowTest, TheTraceTurnsZoomsAndFitsAgain) {
    openWindow(smallScenario());
    auto* const canvas = canvasOf(*window_);
    QTest::keyClick(canvas, Qt::Key_R);
    const QImage fitted = grab(canvas);
    const QPoint middle(canvas->width() / 2, canvas->height() / 2);
    QTest::mousePress(canvas, Qt::LeftButton, Qt::NoModifier, middle);
    QMouseEvent move(QEvent::MouseMove, middle + QPoint(60, 20), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
    QTest::mouseRelease(canvas, Qt::LeftButton, Qt::NoModifier, middle + QPoint(60, 20));
    const QImage turned = grab(canvas);
    EXPECT_NE(turned, fitted);
    QWheelEvent wheel(middle, canvas->mapToGlobal(middle), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(canvas, &wheel);
    const QImage zoomed = grab(canvas);
    EXPECT_NE(zoomed, turned);
    // What is under the pointer stays there, but for some perspective.
    const relief::Step& first = snapshot()->trace.steps.front();
    const QPoint at = onStretch(*window_, *snapshot(), first);
    QWheelEvent nearer(at, canvas->mapToGlobal(at), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                       false);
    QApplication::sendEvent(canvas, &nearer);
    const QImage twice = grab(canvas);
    EXPECT_NE(twice, zoomed);
    EXPECT_LT((onStretch(*window_, *snapshot(), first) - at).manhattanLength(), canvas->width() / 20);
    // Another layer of the result is no reason to move the camera.
    workspace_->setLayer(Layer::Steps);
    waitForFull();
    EXPECT_EQ(grab(canvas), twice);
    QTest::keyClick(canvas, Qt::Key_R);
    EXPECT_EQ(grab(canvas), fitted);
    window_->pane<Trace3dView>()->setExaggeration(2);
    EXPECT_NE(grab(canvas), fitted);
}

TEST_F(WindowTest, TheTraceOfTheSkySaysSo) {
    relief::Scenario scenario = smallScenario();
    scenario.camera.distance = 4;  // with sky on all sides
    openWindow(scenario);
    auto* const canvas = canvasOf(*window_);
    workspace_->choosePixel(0, 0);
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    ASSERT_EQ(snapshot()->trace.pixel, (relief::PixelChoice{0, 0}));
    ASSERT_FALSE(snapshot()->trace.onRelief);
    const QImage shown = grab(canvas);
    EXPECT_EQ(pixelsLike(shown, toColor(workspace_->style().color(Role::Ray))), 0);
    EXPECT_GT(colorsIn(shown), 2) << "a text says what to do";
}

TEST_F(WindowTest, EveryModelAndAddressingIsShown) {
    for (const auto surface : {relief::Surface::Bilinear, relief::Surface::Columns}) {
        for (const auto address : {relief::Address::Repeat, relief::Address::Clamp, relief::Address::Border}) {
            relief::Scenario scenario = smallScenario();
            scenario.surface = surface;
            scenario.address = address;
            openWindow(scenario);
            EXPECT_GT(colorsIn(grab(canvasOf(*window_))), 30);
            window_.reset();
            workspace_.reset();
        }
    }
}

TEST(Turntable, whatIsFittedIsInTheView) {
    Turntable camera;
    camera.lookAlong(1, 0.3);
    camera.fit({{0, 0, 0}, {50, -10, 3}, {20, 30, 12}}, 0.7);
    const auto right = camera.right();
    EXPECT_NEAR(std::hypot(right[0], right[1], right[2]), 1, 1e-12);
    EXPECT_EQ(right[2], 0) << "up stays up";
    // The direction of view is perpendicular to `right`.
    EXPECT_NEAR(right[0] * 1 + right[1] * 0.3, 0, 1e-12);
    // A drag over the whole height of a view moves the camera by the height that is seen.
    Turntable moved = camera;
    moved.move(0, 600, 600);
    const auto from = camera.eye();
    const auto to = moved.eye();
    EXPECT_NEAR(std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]), camera.viewHeight(), 1e-9);
}

}  // namespace

}  // namespace reliefui
