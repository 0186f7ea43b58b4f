// The choice of a colour range, and its effects on the picture, the legend, the scenario and undo.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTemporaryDir>

#include "panes/distance/distance_view.h"
#include "panes/drawing_canvas.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/range_box.h"
#include "panes/result/result_painting.h"
#include "window_fixture.h"
#include "windows/pane_list.h"
#include "workspace/pane_store.h"
#include "workspace/range_json.h"

namespace reliefui {
namespace {

class RangeChoice : public WindowTest {
  protected:
    template <class Control>
    Control* control(const QWidget* button, const char* name) const {
        Control* const found = button->findChild<Control*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    static RangeButton* buttonOf(const QWidget* pane) {
        return pane->findChild<RangeButton*>(QStringLiteral("color-range"));
    }
    ColorRange chosen(RangeOf of) const { return rangesOf(scenario()).of(of); }
    // Checks that every pixel of a layer of numbers has the colour of its value.
    void expectColoursOfTheScale() {
        const LayerPicture& layer = snapshot()->layer;
        ASSERT_NE(layer.values, nullptr);
        const Style style;
        for (int y = 0; y < layer.image.height(); y += 7) {
            for (int x = 0; x < layer.image.width(); x += 5) {
                const auto value = static_cast<double>((*layer.values)(x, y));
                if (std::isnan(value) || layer.error) continue;
                const Rgba expected = style.cell(colorMapOf(layer.layer), value, layer.scale);
                const QColor seen = layer.image.pixelColor(x, y);
                EXPECT_LE(std::abs(seen.red() - expected.r) + std::abs(seen.green() - expected.g), 3) << x << "," << y;
            }
        }
    }
};

TEST_F(RangeChoice, TheResultFollowsItAndUndo) {
    openWindow(smallScenario());
    RangeButton* const button = window_->result()->rangeButton();
    EXPECT_FALSE(button->isEnabled()) << "colours have no range";
    workspace_->setLayer(Layer::Steps);
    waitForFull();
    ASSERT_TRUE(button->isEnabled());
    EXPECT_EQ(snapshot()->layer.range, standardRange(RangeOf::Steps));
    expectColoursOfTheScale();
    const QImage before = snapshot()->layer.image;
    const auto frame = snapshot()->frame;
    button->open();
    auto* const scale = control<QComboBox>(button, "range-scale");
    auto* const ends = control<QComboBox>(button, "range-ends");
    ASSERT_NE(scale, nullptr);
    QTest::keyClick(scale, Qt::Key_Down);
    ASSERT_TRUE(QTest::qWaitFor([&] { return snapshot()->layer.range.logarithmic; }, 20000));
    EXPECT_TRUE(chosen(RangeOf::Steps).logarithmic);
    EXPECT_TRUE(snapshot()->layer.scale.logarithmic);
    EXPECT_NE(snapshot()->layer.image, before);
    EXPECT_EQ(snapshot()->frame, frame) << "nothing is rendered for other colours";
    expectColoursOfTheScale();
    QTest::keyClick(scale, Qt::Key_Up);
    ends->setCurrentIndex(2);
    Q_EMIT ends->activated(2);
    auto* const high = control<QDoubleSpinBox>(button, "range-high");
    const double near = control<QDoubleSpinBox>(button, "range-low")->value() + 0.25;
    high->setValue(near);
    ASSERT_TRUE(QTest::qWaitFor([&] { return snapshot()->layer.range == chosen(RangeOf::Steps); }, 20000));
    EXPECT_EQ(high->value(), near);
    EXPECT_GE(high->singleStep() * std::pow(10, high->decimals()), 1) << "a step of the wheel is seen";
    high->setValue(9);
    control<QCheckBox>(button, "range-threshold-on")->click();
    control<QDoubleSpinBox>(button, "range-threshold")->setValue(5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return snapshot()->layer.range == chosen(RangeOf::Steps); }, 20000));
    EXPECT_EQ(snapshot()->layer.scale.high, 9);
    EXPECT_EQ(snapshot()->layer.scale.threshold, 5);
    expectColoursOfTheScale();
    // The legend counts the values that the picture shows.
    const LayerPicture& layer = snapshot()->layer;
    const auto pixels = layer.values->pixels();
    const auto above = std::count_if(pixels.begin(), pixels.end(), [](float v) { return v > 5; });
    EXPECT_EQ(layer.spread->above(5), above);
    EXPECT_NE(rangeTexts(layerValues(layer)).back().find(std::to_string(above)), std::string::npos);
    // Reversed ends are refused with a message.
    QString problem;
    QObject::connect(workspace_.get(), &Workspace::problem, [&](const QString& said) { problem = said; });
    control<QDoubleSpinBox>(button, "range-low")->setValue(100);
    EXPECT_TRUE(problem.contains(QStringLiteral("steps"))) << problem.toStdString();
    EXPECT_NE(control<QDoubleSpinBox>(button, "range-low")->value(), 100);
    while (workspace_->canUndo() && chosen(RangeOf::Steps) != standardRange(RangeOf::Steps)) workspace_->undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return snapshot()->layer.range == standardRange(RangeOf::Steps); }, 20000));
    EXPECT_EQ(snapshot()->layer.image, before);
    EXPECT_EQ(scale->currentIndex(), 0);
}

TEST_F(RangeChoice, ScenariosKeepIt) {
    ColorRange range;
    range.logarithmic = true;
    range.ends = RangeEnds::Own;
    range.low = 0.25;
    range.high = 7;
    range.threshold = 0.5;
    RangesState state;
    for (std::size_t n = 0; n < kRangesOf; ++n) state.ranges.set(static_cast<RangeOf>(n), range);
    relief::Scenario scenario = smallScenario();
    setState(scenario, state);
    EXPECT_EQ(rangesOf(scenario), state.ranges);
    // Ranges with default values are not written.
    setState(scenario, RangesState{});
    EXPECT_TRUE(scenario.ui.empty());
    const auto problemOf = [&](const std::string& ranges) -> std::string {
        scenario.ui = "{\"ranges\": " + ranges + "}";
        try {
            checkStates(scenario, stateReaders(), "file");
        } catch (const relief::InputError& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_EQ(problemOf(R"({"steps": {"scale": "log"}})"), "");
    for (const char* const wrong :
         {R"({"stps": {}})", R"({"steps": {"scale": "cubic"}})", R"({"steps": {"ends": "some"}})",
          R"({"steps": {"ends": "own", "low": 3, "high": 2}})", R"({"error": {"ends": "percentile", "high": 101}})",
          R"({"depth": {"threshold": "much"}})", R"({"depth": {"treshold": 1}})"}) {
        const std::string problem = problemOf(wrong);
        EXPECT_FALSE(problem.empty()) << wrong;
        EXPECT_EQ(std::count(problem.begin(), problem.end(), '\n'), 0) << problem;
    }
}

// With only texels near the ray, the pyramid uses the full range of colours, and equal heights have the same colour on
// all levels.
TEST_F(RangeChoice, ThePyramidIsStretchedToWhatIsSeen) {
    openWindow(smallScenario());
    auto* const view = window_->pane<PyramidView>();
    view->showNearRay(true);
    const PyramidParts parts = pyramidParts(*snapshot(), pyramidOptions({}), 600, 300);
    const ColorScale& scale = parts.heights.scale;
    EXPECT_EQ(scale.low, parts.heights.spread->least());
    EXPECT_EQ(scale.high, parts.heights.spread->largest());
    EXPECT_LT(scale.high - scale.low, 1);
    int grids = 0;
    for (const Item& item : parts.levels.items) {
        const auto* const cells = std::get_if<Cells>(&item.primitive);
        if (cells == nullptr) continue;
        ++grids;
        EXPECT_EQ(cells->scale, scale);
    }
    EXPECT_GT(grids, 3);
}

// A click on the colour bar opens the choice; for the keyboard there is a button.
TEST_F(RangeChoice, TheBarOfColoursOpensIt) {
    openWindow(smallScenario());
    auto* const view = window_->pane<PyramidView>();
    window_->findChild<QWidget*>(QStringLiteral("pyramid-pane"))->raise();
    RangeButton* const button = buttonOf(view);
    ASSERT_NE(button, nullptr);
    ASSERT_TRUE(QTest::qWaitFor([&] { return button->isEnabled(); }, 5000));
    EXPECT_NE(button->focusPolicy() & Qt::TabFocus, 0);
    QPoint bar;
    for (int y = view->canvas()->height(); y > 0 && bar.isNull(); y -= 2) {
        if (view->canvas()->itemAt(QPoint(60, y)).kind == ItemKind::ColorBar) bar = {60, y};
    }
    if (bar.isNull()) GTEST_SKIP() << "no room for a legend";
    QTest::mouseClick(view->canvas(), Qt::LeftButton, Qt::NoModifier, bar);
    RangeBox* const box = button->findChild<RangeBox*>();
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->isVisible());
    box->close();
}

}  // namespace
}  // namespace reliefui
