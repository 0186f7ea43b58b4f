// The duel: methods on one ray in lock step, the first divergence and its kind, linked with the other panes.
#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QDockWidget>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>

#include "painting/text_width.h"
#include "painting/view_map.h"
#include "panes/drawing_canvas.h"
#include "panes/duel/duel_view.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

class DuelTest : public WindowTest {
  protected:
    // Without compared methods at first.
    void openDuel(relief::Scenario scenario) {
        scenario.comparison.others.clear();
        openWindow(scenario);
        window_->pane<DuelView>()->window()->activateWindow();
        for (QDockWidget* const dock : window_->findChildren<QDockWidget*>()) {
            if (dock->widget() == window_->pane<DuelView>()) dock->raise();
        }
        waitForDuel();
    }
    void waitForDuel() {
        waitForFull();
        const auto ready = [&] {
            return window_->pane<DuelView>()->isUpToDate() && window_->pane<DuelView>()->duel() != nullptr &&
                   window_->pane<DuelView>()->duel()->snapshot == snapshot();
        };
        ASSERT_TRUE(QTest::qWaitFor(ready, 20000));
    }
    void choose(int place, const QString& method) {
        auto* const box = window_->pane<DuelView>()->findChild<QComboBox*>(QStringLiteral("duel-method-%1").arg(place));
        const int row = box->findData(method);
        ASSERT_GE(row, 0);
        box->setCurrentIndex(row);
        Q_EMIT box->activated(row);
        waitForDuel();
    }
};

TEST_F(DuelTest, MethodsAreComparedOnTheRay) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "4"}}};
    openDuel(scenario);
    // If no method is compared, the exact one is set against an approximate one.
    ASSERT_EQ(window_->pane<DuelView>()->duel()->runs.size(), 2U);
    EXPECT_EQ(window_->pane<DuelView>()->duel()->runs[1].name, "exact");
    EXPECT_TRUE(window_->pane<DuelView>()->verdict().contains(QStringLiteral("against exact")));
    choose(0, QStringLiteral("max-pyramid"));
    choose(1, QStringLiteral("offset"));
    const Duel* duel = window_->pane<DuelView>()->duel();
    ASSERT_EQ(duel->runs.size(), 3U);
    EXPECT_EQ(duel->runs[0].steps, snapshot()->trace.steps);
    EXPECT_EQ(duel->runs[1].hit.lambda, duel->exact.lambda) << "max-pyramid is exact";
    EXPECT_EQ(duel->judgements[1].kind, relief::Departure::None);
    // Methods are shown by name, with the options that were given.
    EXPECT_EQ(duel->runs[0].name, "layers:layers=4");
    EXPECT_EQ(duel->runs[1].name, "max-pyramid");
    // Every method is mentioned.
    for (const relief::DuelRun& run : duel->runs) {
        EXPECT_TRUE(window_->pane<DuelView>()->verdict().contains(QString::fromStdString(run.name))) << run.name;
    }
    EXPECT_GT(colorsIn(grab(window_->pane<DuelView>()->canvas())), 20);
    // One method is removed.
    choose(0, QString());
    EXPECT_EQ(window_->pane<DuelView>()->duel()->runs.size(), 2U);
    choose(0, QStringLiteral("layers"));
    ASSERT_EQ(window_->pane<DuelView>()->duel()->runs.size(), 2U);
    EXPECT_EQ(window_->pane<DuelView>()->duel()->runs[0].name, "layers:layers=4");
}

// In each method's column of the table every step stands once, in order; where a method waits, nothing stands.
TEST_F(DuelTest, EachStepStandsOnce) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "8"}}};
    openDuel(scenario);
    const auto* const table = window_->pane<DuelView>()->findChild<QTableView*>();
    ASSERT_NE(table, nullptr);
    const QAbstractItemModel& model = *table->model();
    const Duel& duel = *window_->pane<DuelView>()->duel();
    ASSERT_EQ(model.columnCount(), static_cast<int>(duel.runs.size()));
    for (int column = 0; column < model.columnCount(); ++column) {
        std::size_t steps = 0;
        for (int row = 0; row < model.rowCount(); ++row) {
            const QString cell = model.index(row, column).data().toString();
            if (cell.isEmpty()) continue;
            EXPECT_EQ(cell.section(QLatin1Char(' '), 0, 0).toULong(), ++steps) << column;
        }
        EXPECT_EQ(steps, duel.runs[static_cast<std::size_t>(column)].steps.size()) << column;
    }
}

TEST_F(DuelTest, TheFirstDivergenceIsShownAndNamed) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "4"}}};
    openDuel(scenario);
    choose(0, QStringLiteral("max-pyramid"));
    DuelView* const view = window_->pane<DuelView>();
    const Duel* duel = view->duel();
    ASSERT_TRUE(duel->firstMoment()) << "four layers give the exact hit: nothing is tested";
    view->first();
    EXPECT_EQ(this->scenario().step, 0);
    QTest::keyClick(window_.get(), Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(view->moment(), *duel->firstMoment());
    const std::size_t wrong = duel->judgements[*duel->first].step;
    EXPECT_EQ(duel->steps.moments[view->moment()][*duel->first], wrong);
    ASSERT_EQ(*duel->first, 0U) << "the other is exact";
    EXPECT_EQ(this->scenario().step, static_cast<int>(wrong)) << "all panes stand at the step";
    const QString kind = QString::fromStdString(
        relief::sentence(relief::departureTitle(duel->judgements[0]), workspace_->style().language));
    EXPECT_TRUE(view->verdict().contains(kind)) << view->verdict().toStdString();
    // The close-up is shown until the user steps on; projector mode keeps it.
    const double near = duel->closeUp();
    EXPECT_EQ(view->shownUpTo(), near);
    const std::size_t moment = view->moment();
    for (const bool on : {true, false}) {
        window_->setProjector(on);
        waitForDuel();
        EXPECT_EQ(view->moment(), moment);
        EXPECT_EQ(view->shownUpTo(), near);
    }
    duel = view->duel();
    // The window's step determines the moment as well.
    workspace_->chooseStep(1);
    EXPECT_EQ(duel->steps.moments[view->moment()][0], 1U);
    auto* const table = view->findChild<QTableView*>();
    EXPECT_EQ(table->currentIndex().row(), static_cast<int>(view->moment()));
    // A click on the last row: all methods are at their results.
    const QModelIndex last = table->model()->index(table->model()->rowCount() - 1, 0);
    table->setCurrentIndex(last);
    EXPECT_EQ(this->scenario().step, static_cast<int>(duel->runs[0].steps.size()) - 1);
    EXPECT_EQ(view->shownUpTo(), duel->within(near, view->moment()) ? near : 0);
    // A jump that could not be made, because there was no duel, is not made later.
    workspace_->chooseStep(0);
    workspace_->setGuessing(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view->isUpToDate() && view->duel() == nullptr; }, 20000));
    view->toDivergence();
    workspace_->setGuessing(false);
    waitForDuel();
    EXPECT_EQ(this->scenario().step, 0);
    EXPECT_EQ(view->shownUpTo(), 0);
    // Another pixel starts another duel.
    const Duel* const before = view->duel();
    workspace_->choosePixel(30, 100);
    waitForDuel();
    EXPECT_NE(view->duel(), before);
    EXPECT_EQ(view->duel()->runs[0].steps, snapshot()->trace.steps);
}

// The chosen method is the one to be explained, even where a rival goes wrong before it.
TEST_F(DuelTest, TheChosenMethodsOwnDivergenceComesFirst) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "8"}}};
    openDuel(scenario);
    choose(0, QStringLiteral("exact"));
    choose(1, QStringLiteral("offset"));
    DuelView* const view = window_->pane<DuelView>();
    const auto stepOf = [&](std::size_t run) { return view->duel()->judgements[run].step; };
    const auto wrong = [&](std::size_t run) { return view->duel()->judgements[run].kind != relief::Departure::None; };
    const auto later = [&] {
        const auto& steps = view->duel()->steps;
        return wrong(0) && wrong(2) && steps.momentOf(0, stepOf(0)) > steps.momentOf(2, stepOf(2));
    };
    for (int x = 20; x < 190 && !later(); x += 12) {
        workspace_->choosePixel(x, 40 + x / 2);
        waitForDuel();
    }
    ASSERT_TRUE(later()) << "offset goes wrong before layers nowhere: nothing is tested";
    EXPECT_EQ(view->duel()->first, 0U);
    QTest::keyClick(window_.get(), Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(this->scenario().step, static_cast<int>(stepOf(0)));
    // Where the chosen method is right, the rival's error is shown.
    relief::Scenario right = this->scenario();
    right.method = {"max-pyramid", {}};
    workspace_->change(right, QStringLiteral("method"));
    waitForDuel();
    EXPECT_EQ(view->duel()->first, 2U);
}

// On a projector, too, the longest name is not truncated, and half of the pane is left for the relief.
TEST_F(DuelTest, NamesOfMethodsAreWhole) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"distance-conservative", {}};
    scenario.comparison.others = {{"distance-refined-sampled", {}}, {"max-pyramid-paper", {}}, {"cone", {}}};
    openWindow(scenario);
    window_->findChild<QDockWidget*>(QStringLiteral("duel-pane"))->raise();
    waitForDuel();
    const Duel& duel = *window_->pane<DuelView>()->duel();
    for (const QSizeF& room : {QSizeF(340, 190), QSizeF(400, 230), QSizeF(800, 400)}) {
        const DuelSource source = duel.source();
        const ProfileFrame frame = duelFrame(source, {}, room.width(), room.height());
        EXPECT_GT(frame.plot.height(), room.height() / 4) << room.height();
        EXPECT_GT(frame.plot.width(), room.width() / 2) << room.width();
        const Drawing marks = duelMarks(source, frame, duel.steps.moments.front());
        double last = 0;  // the upper side
        for (const relief::DuelRun& run : duel.runs) {
            bool found = false;
            for (const Item& item : marks.items) {
                const auto* const label = std::get_if<Label>(&item.primitive);
                if (label == nullptr || labelText(*label, relief::Language::English) != run.name) continue;
                found = true;
                EXPECT_GE(label->at.x + label->offset.x - textWidth(run.name, label->size), 0) << run.name;
                EXPECT_GT(label->at.y, last) << "in the order of the methods";
                last = label->at.y;
            }
            EXPECT_TRUE(found) << run.name;
        }
        EXPECT_LT(last, frame.plot.y0);
    }
}

// The title of a fault stands below its track, and above the title of the axis.
TEST_F(DuelTest, TitlesOfFaultsKeepClearOfTheAxisTitle) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"max-pyramid", {}};
    scenario.comparison.others = {{"layers", {{"layers", "4"}}}, {"layers", {{"layers", "5"}}}};
    openWindow(scenario);
    window_->findChild<QDockWidget*>(QStringLiteral("duel-pane"))->raise();
    waitForDuel();
    const Duel& duel = *window_->pane<DuelView>()->duel();
    const DuelSource source = duel.source();
    ASSERT_NE(duel.judgements.back().kind, relief::Departure::None);
    int titles = 0;
    for (const double height : {230.0, 300.0, 400.0, 600.0}) {
        const ProfileFrame frame = duelFrame(source, {}, 500, height);
        double axisTop = frame.plot.y0;
        for (const Item& item : profileAxes(source.profile, frame).items) {
            const auto* const label = std::get_if<Label>(&item.primitive);
            if (label == nullptr || label->anchor != Anchor::BottomLeft) continue;
            axisTop = std::min(axisTop, labelBox(*label, {}, 100, 10 * label->size, 1).y0);
        }
        ASSERT_LT(axisTop, frame.plot.y0);
        for (const Item& item : duelMarks(source, frame, duel.steps.moments.front()).items) {
            const auto* const label = std::get_if<Label>(&item.primitive);
            const bool title =
                label != nullptr &&
                std::any_of(duel.judgements.begin(), duel.judgements.end(), [&](const relief::Judgement& one) {
                    return relief::departureTitle(one).id == label->text.id;
                });
            if (!title) continue;
            ++titles;
            EXPECT_LE(labelBox(*label, {}, 100, 10 * label->size, 1).y1, axisTop) << height;
        }
    }
    EXPECT_GT(titles, 2);
}

TEST_F(DuelTest, TheTableBelowTheDrawingHasAQuarterOfAHighPane) {
    openDuel(smallScenario());
    DuelView high(workspace_.get());
    high.first();  // before there is a duel, there is no moment to go to
    high.forward();
    EXPECT_EQ(high.moment(), 0U);
    high.resize(300, 950);
    high.show();
    auto* const table = high.findChild<QTableView*>();
    const auto* const split = qobject_cast<QSplitter*>(table->parentWidget());
    ASSERT_NE(split, nullptr);
    ASSERT_TRUE(QTest::qWaitFor([&] { return table->isVisible() && split->orientation() == Qt::Vertical; }, 5000));
    QTest::qWait(50);
    EXPECT_GE(5 * table->height(), split->height());
}

TEST_F(DuelTest, WhatIsSeenFromNearHoldsTheDivergenceAndNothingBeyond) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "64"}}};
    openDuel(scenario);
    choose(0, QStringLiteral("max-pyramid"));
    choose(1, QStringLiteral("offset"));
    // Finds a ray that hits deep enough for a close-up.
    constexpr double kDeep = 0.35;
    for (int x = 20; x < 190 && !(window_->pane<DuelView>()->duel()->exact.lambda > kDeep); x += 12) {
        workspace_->choosePixel(x, 40 + x / 2);
        waitForDuel();
    }
    const Duel& duel = *window_->pane<DuelView>()->duel();
    ASSERT_GT(duel.exact.lambda, kDeep);
    ASSERT_TRUE(duel.firstMoment());
    DuelSource source = duel.source();
    const ProfileFrame whole = duelFrame(source, {}, 500, 300);
    // A step without a mark of its own lies next to one.
    constexpr double kNext = 4;  // in points
    const std::vector<std::size_t> first(duel.runs.size(), 0);
    const Drawing marks = duelMarks(source, whole, first);
    for (std::size_t r = 0; r < duel.runs.size(); ++r) {
        for (const relief::Step& step : duel.runs[r].steps) {
            const double x = whole.xAt(duelPlace(step));
            const bool marked =
                duelPlace(step) > whole.lambdaEnd || std::ranges::any_of(marks.items, [&](const Item& item) {
                    const auto* const mark = std::get_if<Marker>(&item.primitive);
                    return mark != nullptr && item.id.kind == ItemKind::Step && item.id.level == static_cast<int>(r) &&
                           std::abs(mark->at.x - x) <= kNext;
                });
            EXPECT_TRUE(marked) << duel.runs[r].name << " at " << duelPlace(step);
        }
    }
    source.upTo = duel.closeUp();
    EXPECT_TRUE(duel.within(source.upTo, *duel.firstMoment()));
    EXPECT_GE(source.upTo, duel.exact.lambda);
    EXPECT_LE(source.upTo, 1);
    const ProfileFrame near = duelFrame(source, {}, 500, 300);
    EXPECT_LE(near.lambdaEnd, whole.lambdaEnd);
    EXPECT_GE(near.lambdaEnd, std::min(source.upTo, whole.lambdaEnd));
    // However short the visible part is, no step is drawn outside it.
    source.upTo = duel.exact.lambda / 1000;
    const ProfileFrame little = duelFrame(source, {}, 500, 300);
    ASSERT_LT(little.lambdaEnd, duel.exact.lambda);
    int steps = 0;
    for (const Item& item : duelMarks(source, little, first).items) {
        if (item.id.kind != ItemKind::Step) continue;
        ++steps;
        const auto& run = duel.runs[static_cast<std::size_t>(item.id.level)];
        EXPECT_LE(duelPlace(run.steps[static_cast<std::size_t>(item.id.i)]), little.lambdaEnd);
    }
    EXPECT_GT(steps, 2);
}

}  // namespace

}  // namespace reliefui
