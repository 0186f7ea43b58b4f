// Lessons show what their text says.
#include <algorithm>

#include <QAction>
#include <QDockWidget>

#include "lessons/lessons.h"
#include "panes/distance/distance_state.h"
#include "panes/duel/duel_data.h"
#include "panes/point_finder.h"
#include "window_fixture.h"
#include "windows/message_bar.h"
#include "windows/pane_list.h"
#include "workspace/pane_store.h"

namespace reliefui {

namespace {

constexpr double kRounding = 1e-5;  // of heights in float

std::size_t hiddenTexels(const PixelFootprint& footprint) {
    std::size_t hidden = 0;
    for (const relief::FootprintTexel& texel : footprint.log.texels) hidden += texel.hidden ? 1U : 0U;
    return hidden;
}

std::ptrdiff_t advances(const std::vector<relief::Step>& steps) {
    return std::count_if(steps.begin(), steps.end(),
                         [](const relief::Step& s) { return s.decision == relief::Decision::Advance; });
}

void showsWhatItSays(const Lesson& lesson, const Snapshot& snapshot) {
    ASSERT_TRUE(snapshot.trace.onRelief);
    const auto& steps = snapshot.trace.steps;
    const int chosen = snapshot.scenario.step;
    ASSERT_LT(static_cast<std::size_t>(chosen), steps.size());
    // The number of the step is small enough for a class to follow.
    EXPECT_LT(steps.size(), 60U);
    if (lesson.departure) {
        relief::Work work;
        const auto duel =
            makeDuel(std::make_shared<const Snapshot>(snapshot), snapshot.scenario.comparison.others, work);
        ASSERT_EQ(duel->judgements[0].kind, *lesson.departure);
        EXPECT_EQ(duel->first, std::size_t{0}) << "the lesson is about the method itself";
        EXPECT_GT(duel->judgements[0].texels, 1) << "too small to be visible";
        EXPECT_EQ(static_cast<std::size_t>(chosen), duel->judgements[0].step) << "it opens at the error";
        const bool better = std::any_of(duel->judgements.begin() + 1, duel->judgements.end(),
                                        [](const auto& j) { return j.kind == relief::Departure::None; });
        EXPECT_TRUE(better) << "no compared method does better";
    } else if (lesson.name == QStringLiteral("vain_descent")) {
        EXPECT_EQ(steps[static_cast<std::size_t>(chosen)].decision, relief::Decision::Ascend);
    } else if (lesson.name == QStringLiteral("hidden_texels")) {
        ASSERT_NE(snapshot.footprint, nullptr);
        EXPECT_GT(hiddenTexels(*snapshot.footprint), 3U);
    } else if (lesson.name == QStringLiteral("paper_march")) {
        EXPECT_EQ(advances(steps), 5);
        const relief::Step& last = steps[steps.size() - 2];
        EXPECT_LT(last.zOut(), 0.2) << "the last sphere reaches below the floor";
        EXPECT_NEAR(1 - snapshot.trace.hit.lambda, 0.2, kRounding) << "the floor";
        // The same ray with the refined map.
        const relief::Scenario refined = lessonScenario(QStringLiteral("paper_walls"));
        EXPECT_EQ(refined.pixel, snapshot.scenario.pixel);
        EXPECT_EQ(refined.camera, snapshot.scenario.camera);
    } else if (lesson.name == QStringLiteral("paper_walls")) {
        EXPECT_EQ(advances(steps), 4) << "as the lesson before it says";
        relief::Work work;
        const auto point = pointOf(snapshot, stateOf<PointState>(snapshot.scenario).point, work);
        ASSERT_NE(point, nullptr);
        EXPECT_NEAR(point->distances.euclidean, 3, kRounding);
        EXPECT_NEAR(point->distances.s, 1, kRounding) << "the left wall";
        EXPECT_NEAR(point->distances.refined, 4, kRounding);
        EXPECT_NEAR(1 - point->distances.hit.lambda, 0.2, kRounding) << "the floor";
        EXPECT_GT(point->distances.blocked, 0);
        EXPECT_EQ(stateOf<DistancePane>(snapshot.scenario).axis, "y") << "both walls stand in the slice across them";
        EXPECT_EQ(stateOf<DistancePane>(snapshot.scenario).slice, 4) << "the slice of the point";
    } else {
        FAIL() << "its content is not tested";
    }
}

TEST_F(WindowTest, EveryLessonShowsWhatItSays) {
    openWindow(smallScenario());
    const auto all = lessons();
    ASSERT_GE(all.size(), 8U);
    for (const Lesson& lesson : all) {
        SCOPED_TRACE(lesson.name.toStdString());
        auto* const action = window_->findChild<QAction*>(QStringLiteral("lesson-") + lesson.name);
        ASSERT_NE(action, nullptr);
        action->trigger();
        const relief::Scenario expected = lessonScenario(lesson.name);
        ASSERT_TRUE(QTest::qWaitFor([&] { return scenario() == expected; }, 10000));
        ASSERT_NO_FATAL_FAILURE(waitForFull());
        // The stored step exists on the ray, since the program recognises a lesson by its scenario when the picture is
        // ready.
        EXPECT_EQ(relief::scenarioText(scenario()), relief::scenarioText(expected));
        ASSERT_NO_FATAL_FAILURE(showsWhatItSays(lesson, *snapshot()));
        EXPECT_EQ(window_->messages()->text(), lesson.about);
        auto* const pane = window_->findChild<QDockWidget*>(lesson.pane + QStringLiteral("-pane"));
        ASSERT_NE(pane, nullptr);
        EXPECT_FALSE(pane->visibleRegion().isEmpty()) << "its pane is in front";
    }
    // Each lesson is one step of undo.
    const relief::Scenario before = lessonScenario(all[all.size() - 2].name);
    workspace_->undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return scenario() == before; }, 10000));
}

// A lesson opened as a file, from the command line or the menu, is the same.
TEST_F(WindowTest, ALessonOpenedAsAFileShowsItsPane) {
    openWindow(smallScenario());
    for (const char* const name : {"hidden_texels", "missed_spike"}) {
        SCOPED_TRACE(name);
        const auto all = lessons();
        const auto lesson =
            std::find_if(all.begin(), all.end(), [&](const auto& l) { return l.name == QLatin1String(name); });
        ASSERT_NE(lesson, all.end());
        workspace_->open(QStringLiteral(RELIEF_SOURCE "/ui/lessons/%1.json").arg(QLatin1String(name)));
        auto* const pane = window_->findChild<QDockWidget*>(lesson->pane + QStringLiteral("-pane"));
        EXPECT_TRUE(QTest::qWaitFor([&] { return !pane->visibleRegion().isEmpty(); }, 10000)) << "its pane is in front";
        EXPECT_EQ(window_->messages()->text(), lesson->about);
        ASSERT_NO_FATAL_FAILURE(waitForFull());
    }
}

}  // namespace

}  // namespace reliefui
