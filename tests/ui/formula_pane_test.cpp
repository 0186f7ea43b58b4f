// The formula pane in the window: it follows the step, and hides what the user is to guess.
#include <algorithm>

#include <QDockWidget>

#include "panes/formula/formula_view.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

TEST_F(WindowTest, TheFormulaPaneFollowsTheStepAndHidesWhatIsGuessed) {
    openWindow(deepRay());
    QDockWidget* const dock = window_->findChild<QDockWidget*>(QStringLiteral("formula-pane"));
    ASSERT_NE(dock, nullptr);
    dock->show();
    dock->raise();
    FormulaView* const view = window_->pane<FormulaView>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !view->face()->sheet().places.empty(); }, 5000));
    EXPECT_GT(colorsIn(grab(view)), 4);
    const auto says = [&](const char* words) {
        const auto& places = view->face()->sheet().places;
        return std::any_of(places.begin(), places.end(),
                           [&](const FormulaSheet::Place& p) { return p.words.starts_with(words); });
    };
    int descent = 0;
    while (!snapshot()->trace.steps[static_cast<std::size_t>(descent)].as<relief::subject::Texel>()->ray) ++descent;
    workspace_->chooseStep(descent);
    EXPECT_TRUE(says("V_(i+1) = 2 V_i"));
    workspace_->chooseStep(0);
    EXPECT_FALSE(says("V_(i+1) = 2 V_i"));
    EXPECT_TRUE(says("s = s_0"));
    workspace_->setGuessing(true);
    EXPECT_FALSE(says("s = s_0")) << "where it hits";
    EXPECT_FALSE(says("w / Σw"));
    EXPECT_TRUE(says("u_x = a / q²"));
    workspace_->setGuessing(false);
    // Hovering shows the readout of a row.
    const FormulaSheet::Place& place = view->face()->sheet().places.front();
    const double unit = workspace_->style().pixelsPerPoint();
    const QPointF at(12 * unit, (place.box.center().y + 6) * unit);
    EXPECT_EQ(view->face()->rowAt(at).toStdString(), place.words);
}

}  // namespace

}  // namespace reliefui
