// Every listed method, in every pane: its options, its steps in sentences, its marks in 3-D.
#include <random>

#include <vtkActorCollection.h>
#include <vtkRenderer.h>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableView>

#include "panes/number_control.h"
#include "panes/options_form.h"
#include "panes/ray_geometry.h"
#include "panes/steps/step_table.h"
#include "panes/trace/trace3d_samples.h"
#include "panes/trace/trace3d_view.h"
#include "relief/reliefs.h"
#include "relief/tracers.h"
#include "window_fixture.h"
#include "windows/step_bar.h"
#include "windows/time_pane.h"
#include "windows/top_bar.h"

namespace reliefui {

namespace {

using relief::Decision;

// Traces a ray on a small relief; returns its steps as the panes receive them.
std::vector<relief::Step> stepsOf(const relief::MethodChoice& method, const relief::HeightField& field,
                                  const relief::ViewRay& ray) {
    relief::Work work;
    relief::MapCache cache;
    relief::RayBlock rays;
    rays.push(ray);
    relief::HitBlock hits;
    relief::StepLog log;
    relief::makeTracer(method, field, cache, work)->trace(rays, hits, log, work);
    return log.steps;
}

relief::HeightField field(int width, int height, relief::Surface surface = relief::Surface::Bilinear,
                          relief::Address address = relief::Address::Repeat) {
    return relief::HeightField(
        std::make_shared<const relief::FloatImage>(relief::makeRelief("fractal", width, height, 3)), surface, address);
}

// A choice is announced later; by then the form may show another method, such as that of a lesson just opened.
TEST(OptionsForm, AChoiceOfControlsThatAreGoneIsDropped) {
    const auto describe = [](const char* name) {
        const auto& all = relief::tracerList();
        return *std::find_if(all.begin(), all.end(), [&](const auto& method) { return method.name == name; });
    };
    OptionsForm form;
    form.show(describe("hybrid"), {"hybrid", {}});
    QStringList announced;
    QObject::connect(&form, &OptionsForm::changed, [&](const QString& name) { announced << name; });
    const auto choose = [&](bool other) {
        auto* const box = form.findChild<QComboBox*>();
        ASSERT_NE(box, nullptr);
        if (other) box->setCurrentIndex(box->currentIndex() == 0 ? 1 : 0);
        Q_EMIT box->activated(box->currentIndex());
    };
    choose(true);
    form.show(describe("layers"), {"layers", {}});
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCoreApplication::processEvents();
    EXPECT_TRUE(announced.isEmpty());
    form.show(describe("hybrid"), {"hybrid", {}});
    choose(false);
    QCoreApplication::processEvents();
    EXPECT_TRUE(announced.isEmpty()) << "it is chosen already";
    choose(true);
    QCoreApplication::processEvents();
    EXPECT_EQ(announced.size(), 1);
}

TEST_F(WindowTest, EveryMethodIsOfferedAndShown) {
    relief::Scenario scenario = smallScenario();
    openWindow(scenario);
    QComboBox* const chooser = window_->topBar()->method();
    auto* const form = window_->findChild<QWidget*>(QStringLiteral("scene-panel"))->findChild<OptionsForm*>();
    for (const relief::MethodDescription& method : relief::tracerList()) {
        const int item = chooser->findData(QString::fromStdString(method.name));
        ASSERT_GE(item, 0) << method.name;
        chooser->setCurrentIndex(item);
        Q_EMIT chooser->activated(item);
        waitForFull();
        ASSERT_EQ(this->scenario().method.name, method.name);
        for (const relief::OptionDescription& option : method.options) {
            auto* const control = form->findChild<QWidget*>(QString::fromStdString(option.name));
            ASSERT_NE(control, nullptr) << method.name << " " << option.name;
            EXPECT_FALSE(control->toolTip().isEmpty());
        }
        const QString promise = window_->findChild<QLabel*>(QStringLiteral("guarantee"))->text();
        EXPECT_FALSE(promise.isEmpty());
        const auto& steps = snapshot()->trace.steps;
        EXPECT_FALSE(steps.empty()) << method.name;
        for (std::size_t k = 0; k < steps.size(); ++k) {
            workspace_->chooseStep(static_cast<int>(k));
            EXPECT_GT(window_->time()->table()->sentence().size(), 10) << method.name;
            EXPECT_FALSE(window_->time()->table()->sentence().contains(QLatin1Char('{'))) << method.name;
        }
        EXPECT_GT(colorsIn(grab(window_->pane<Trace3dView>())), 50) << method.name;
    }
}

TEST_F(WindowTest, TheOptionsOfAMethodAreChangedAndDrawn) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {}};
    openWindow(scenario);
    auto* const layers = window_->findChild<QWidget*>(QStringLiteral("scene-panel"))
                             ->findChild<OptionsForm*>()
                             ->findChild<NumberControl*>(QStringLiteral("layers"));
    ASSERT_NE(layers, nullptr);
    EXPECT_EQ(layers->value(), 64);
    // A wide range is logarithmic: the middle of the slider is the geometric mean.
    layers->slider()->setValue(SliderScale::kPositions / 2);
    EXPECT_EQ(layers->value(), 256);
    waitForFull();
    EXPECT_EQ(this->scenario().method.options.at("layers"), "256");
    EXPECT_EQ(snapshot()->scenario.method, this->scenario().method);
    // The steps are those of the changed number of layers.
    EXPECT_EQ(snapshot()->trace.steps.at(2).lambdaOut, 1.0 / 256);
    workspace_->finishInteraction();
    layers->box()->setValue(8);
    waitForFull();
    EXPECT_EQ(snapshot()->trace.steps.at(2).lambdaOut, 1.0 / 8);
    workspace_->undo();
    EXPECT_EQ(layers->value(), 256);
}

TEST_F(WindowTest, AMethodInsideAMethodBringsItsOwnOptions) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"hybrid", {{"inner", "layers-bisection"}, {"inner.bisections", "5"}}};
    openWindow(scenario);
    auto* const form = window_->findChild<QWidget*>(QStringLiteral("scene-panel"))->findChild<OptionsForm*>();
    auto* const inner = form->findChild<QComboBox*>(QStringLiteral("inner"));
    ASSERT_NE(inner, nullptr);
    EXPECT_EQ(inner->currentText(), QStringLiteral("layers-bisection"));
    auto* const bisections = form->findChild<NumberControl*>(QStringLiteral("inner.bisections"));
    ASSERT_NE(bisections, nullptr);
    EXPECT_EQ(bisections->value(), 5);
    bisections->box()->setValue(7);
    waitForFull();
    EXPECT_EQ(this->scenario().method.options.at("inner.bisections"), "7");
    // What is chosen again keeps its options.
    QComboBox* const method = window_->topBar()->method();
    for (QComboBox* const list : {inner, method}) Q_EMIT list->activated(list->currentIndex());
    QTest::qWait(1);
    EXPECT_EQ(this->scenario().method.options.count("inner.bisections"), 1U);
    const int layers = inner->findText(QStringLiteral("layers"));
    ASSERT_GE(layers, 0);
    inner->setCurrentIndex(layers);
    Q_EMIT inner->activated(layers);
    QTest::qWait(1);
    waitForFull();
    EXPECT_EQ(this->scenario().method.options.at("inner"), "layers");
    EXPECT_EQ(this->scenario().method.options.count("inner.bisections"), 0U);
    EXPECT_EQ(form->findChild<NumberControl*>(QStringLiteral("inner.bisections")), nullptr);
    EXPECT_NE(form->findChild<NumberControl*>(QStringLiteral("inner.layers")), nullptr);
}

TEST(Samples, sheetsAreFewAndTheChosenOneIsDrawnByItself) {
    const relief::HeightField relief = field(64, 64);
    const relief::ViewRay ray{3, 5, 40, 22};
    const auto few = stepsOf({"layers", {{"layers", "8"}}}, relief, ray);
    ASSERT_GE(few.size(), 3U);
    // Every layer except the start and the chosen one.
    EXPECT_EQ(sheetLambdas(few, 0).size(), few.size() - 1);
    EXPECT_EQ(sheetLambdas(few, 1).size(), few.size() - 2);
    const auto many = stepsOf({"layers", {{"layers", "4096"}}}, relief, ray);
    ASSERT_GT(many.size(), 4 * kMostSheets);
    EXPECT_LE(sheetLambdas(many, 0).size(), kMostSheets);
    EXPECT_GT(sheetLambdas(many, 0).size(), kMostSheets / 2);
    // An offset has no layers, nor has a pyramid.
    EXPECT_TRUE(sheetLambdas(stepsOf({"offset", {}}, relief, ray), 0).empty());
    EXPECT_TRUE(sheetLambdas(stepsOf({"max-pyramid", {}}, relief, ray), 0).empty());
}

// The value of a step is the surface's height at the position where it was sampled.
TEST(Samples, heightsAreShownWhereTheyWereSampled) {
    constexpr double kRounding = 1e-6;  // heights are float
    const relief::HeightField relief = field(64, 48);
    for (const char* const method : {"offset", "offset-limited", "layers", "layers-secant", "layers-bisection"}) {
        const relief::ViewRay ray{3, 5, 40, 22};
        const auto steps = stepsOf({method, {}}, relief, ray);
        int read = 0;
        for (std::size_t k = 0; k < steps.size(); ++k) {
            const Decision d = steps[k].decision;
            if (d != Decision::Advance && d != Decision::Refine && d != Decision::Hit) continue;
            const double lambda = readAt(steps, k);
            EXPECT_NEAR(steps[k].value, relief.at(ray.s0 + lambda * ray.a, ray.t0 + lambda * ray.b), kRounding)
                << method << " step " << k;
            ++read;
        }
        EXPECT_GT(read, 0) << method;
    }
}

// Also over a base level, whose texels do not coincide with whole texels of a map of odd size.
TEST(Samples, theRayIsInsideTheBoxOverAnyBaseLevel) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const relief::Surface surface : {relief::Surface::Bilinear, relief::Surface::Columns}) {
        for (const relief::Address address : {relief::Address::Repeat, relief::Address::Border}) {
            const relief::HeightField relief = field(37, 21, surface, address);
            for (int base = 0; base < 5; ++base) {
                const relief::MethodChoice method{"max-pyramid", {{"base", std::to_string(base)}}};
                int seen = 0;
                for (int n = 0; n < 200; ++n) {
                    const relief::ViewRay ray{unit(random) * 37, unit(random) * 21, unit(random) * 90 - 45,
                                              unit(random) * 90 - 45};
                    const RayPath path(relief, ray);
                    for (const relief::Step& step : stepsOf(method, relief, ray)) {
                        if (step.decision == Decision::Advance || step.lambdaOut <= step.lambdaIn) continue;
                        EXPECT_GE(step.level, base);
                        const Point middle = path.at((step.lambdaIn + step.lambdaOut) / 2);
                        EXPECT_TRUE(stepBox(relief, step, base).grown(1e-6).contains(middle))
                            << "base " << base << " level " << step.level << " n " << n;
                        ++seen;
                    }
                }
                EXPECT_GT(seen, 20);
            }
        }
    }
}

TEST_F(WindowTest, ShadowsAreSwitchedOnAndUndone) {
    relief::Scenario low = smallScenario();
    low.light.elevation = 12;
    openWindow(low);
    const QImage lit = snapshot()->picture;
    auto* const box = window_->findChild<QCheckBox*>(QStringLiteral("shadows"));
    ASSERT_NE(box, nullptr);
    EXPECT_FALSE(box->isChecked());
    box->click();
    waitForFull();
    EXPECT_TRUE(scenario().shadows);
    EXPECT_NE(snapshot()->picture, lit);
    workspace_->undo();
    waitForFull();
    EXPECT_FALSE(box->isChecked());
    EXPECT_EQ(snapshot()->picture, lit);
}

TEST_F(WindowTest, ALongLogIsAModelNotWidgets) {
    relief::Scenario scenario = smallScenario();
    // One step per layer at a pixel: a log with tens of thousands of rows.
    scenario.method = {"layers", {{"layers", "65536"}}};
    scenario.width = scenario.height = 24;
    scenario.pixel = relief::PixelChoice{12, 12};
    openWindow(scenario);
    ASSERT_GT(snapshot()->trace.steps.size(), 10000U);
    const QTableView* const table = window_->time()->table()->table();
    EXPECT_EQ(table->model()->rowCount(), static_cast<int>(snapshot()->trace.steps.size()));
    EXPECT_LT(table->findChildren<QWidget*>().size(), 40);
    for (const int step : {0, 5000, 9999}) {
        workspace_->chooseStep(step);
        EXPECT_EQ(table->currentIndex().row(), step);
    }
}

TEST_F(WindowTest, StepsPlayAtTheChosenSpeed) {
    openWindow(smallScenario());
    auto* const bar = window_->findChild<StepBar*>();
    auto* const speed = bar->findChild<QDoubleSpinBox*>(QStringLiteral("play-speed"));
    ASSERT_NE(speed, nullptr);
    speed->setValue(2);
    // Keys step through round values; any other value can be typed.
    QTest::keyClick(window_.get(), Qt::Key_BracketRight);
    EXPECT_EQ(speed->value(), 5);
    QTest::keyClick(window_.get(), Qt::Key_BracketLeft);
    QTest::keyClick(window_.get(), Qt::Key_BracketLeft);
    EXPECT_EQ(speed->value(), 1);
    speed->setValue(37.5);
    // The setting is kept for the next window.
    EXPECT_EQ(StepBar(workspace_.get()).findChild<QDoubleSpinBox*>(QStringLiteral("play-speed"))->value(), 37.5);
    workspace_->chooseStep(0);
    bar->togglePlay();
    EXPECT_TRUE(QTest::qWaitFor([&] { return scenario().step + 1 == static_cast<int>(snapshot()->trace.steps.size()); },
                                10000));
}

}  // namespace

}  // namespace reliefui
