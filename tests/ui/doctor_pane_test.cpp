// The doctor's pane: it names the fault of the tracer whose files are open, and leads to its rays.
#include <QListWidget>
#include <QToolButton>

#include "foreign_tracer.h"
#include "panes/doctor/doctor_drawing.h"
#include "panes/doctor/doctor_view.h"
#include "panes/drawing_canvas.h"
#include "relief/files.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 60000;

class DoctorPane : public WindowTest {
  protected:
    static relief::Scenario uneven() {
        relief::Scenario scenario = smallScenario();
        scenario.pictures.recipe = "fractal";
        return scenario;
    }
    void openPane(const relief::Scenario& scenario) {
        openWindow(scenario);
        QTest::keyClick(window_.get(), Qt::Key_9, Qt::AltModifier);
        settle();
    }
    void settle() {
        QTest::qWait(50);
        ASSERT_TRUE(QTest::qWaitFor([&] { return pane()->isUpToDate() && !workspace_->busy(); }, kPatienceMs));
    }
    DoctorView* pane() { return window_->pane<DoctorView>(); }
    QTemporaryDir folder_;
};

TEST_F(DoctorPane, NamesAFaultAndLeadsToItsWorstRay) {
    openPane(withForeignTracer(uneven(), folder_, true));
    ASSERT_TRUE(pane()->report());
    ASSERT_GE(pane()->list()->count(), 1);
    EXPECT_TRUE(pane()->list()->item(0)->text().startsWith(QStringLiteral("y-flipped")))
        << pane()->list()->item(0)->text().toStdString();
    EXPECT_GT(colorsIn(grab(pane()->canvas())), 20);
    const std::size_t worst = *pane()->report()->worst[0];
    EXPECT_TRUE(pane()->list()->item(0)->text().contains(QStringLiteral("ray %1 ").arg(worst)));
    pane()->list()->setFocus();
    pane()->list()->setCurrentRow(0);
    QTest::keyClick(pane()->list(), Qt::Key_Return);
    waitForFull();
    EXPECT_EQ(scenario().other.ray, static_cast<int>(worst));
    EXPECT_EQ(scenario().pixel, pane()->report()->view->pixels[worst]);
    EXPECT_TRUE(snapshot()->trace.fromFile) << "the panes show the file's ray";
    // Its answer is the one step that a file of hits tells of.
    const std::string file = scenario().other.steps;
    const relief::HitBlock hits = relief::parseHits(relief::readTextFile(file), file);
    ASSERT_EQ(snapshot()->trace.steps.size(), 1U);
    EXPECT_EQ(snapshot()->trace.hit.lambda, hits.lambda[worst]);
    EXPECT_NE(hits.lambda[worst], snapshot()->trace.exact.lambda);
    settle();
    EXPECT_TRUE(pane()->report()) << "another ray needs no other diagnosis";
    // A click on the picture chooses the ray there.
    const relief::PixelChoice place = pane()->report()->places[worst / 2];
    const QPointF at = pane()->canvas()->toWidget({place.x + 0.5, place.y + 0.5});
    QTest::mouseClick(pane()->canvas(), Qt::LeftButton, Qt::NoModifier, at.toPoint());
    waitForFull();
    const relief::PixelChoice chosen = *scenario().pixel;
    EXPECT_NEAR(chosen.x, place.x, 2);
    EXPECT_NEAR(chosen.y, place.y, 2);
    EXPECT_EQ(chosen, pane()->report()->view->pixels[static_cast<std::size_t>(scenario().other.ray)]);
}

TEST_F(DoctorPane, SaysThatThereIsNoFaultOrNoTracer) {
    openPane(withForeignTracer(uneven(), folder_, false));
    ASSERT_TRUE(pane()->report());
    ASSERT_EQ(pane()->list()->count(), 1);
    EXPECT_TRUE(pane()->list()->item(0)->text().startsWith(QStringLiteral("no fault")));
    relief::Scenario alone = scenario();
    alone.other = {};
    workspace_->change(alone, QStringLiteral("test"));
    waitForFull();
    settle();
    EXPECT_FALSE(pane()->report());
    EXPECT_FALSE(pane()->list()->isVisible());
    EXPECT_FALSE(pane()->findChild<QToolButton*>(QStringLiteral("doctor-run"))->isEnabled());
    EXPECT_GT(colorsIn(grab(pane()->canvas())), 2);
    // Cancelled, and done again.
    workspace_->undo();
    waitForFull();
    pane()->diagnose();
    EXPECT_TRUE(pane()->cancel());
    ASSERT_TRUE(QTest::qWaitFor([&] { return pane()->isUpToDate(); }, kPatienceMs));
    EXPECT_FALSE(pane()->report());
    QTest::mouseClick(pane()->findChild<QToolButton*>(QStringLiteral("doctor-run")), Qt::LeftButton);
    settle();
    EXPECT_TRUE(pane()->report());
    // The tracer has written its files again, now with a fault: the other panes show the new hits as well.
    withForeignTracer(uneven(), folder_, true);
    QTest::mouseClick(pane()->findChild<QToolButton*>(QStringLiteral("doctor-run")), Qt::LeftButton);
    settle();
    ASSERT_TRUE(pane()->report());
    EXPECT_TRUE(pane()->list()->item(0)->text().startsWith(QStringLiteral("y-flipped")));
    const std::string file = scenario().other.steps;
    const relief::HitBlock hits = relief::parseHits(relief::readTextFile(file), file);
    const std::size_t worst = *pane()->report()->worst[0];
    EXPECT_EQ(snapshot()->otherFiles->hits->lambda[worst], hits.lambda[worst]);
    // A faulty file: no report of what it contained before.
    std::ofstream(file, std::ios::binary) << "oops\n";
    QTest::mouseClick(pane()->findChild<QToolButton*>(QStringLiteral("doctor-run")), Qt::LeftButton);
    EXPECT_FALSE(pane()->report());
    settle();
    EXPECT_TRUE(snapshot()->otherProblem);
    EXPECT_FALSE(pane()->report());
    EXPECT_TRUE(scenario().other);
}

}  // namespace

}  // namespace reliefui
