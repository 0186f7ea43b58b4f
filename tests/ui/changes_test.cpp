// A change computes only what depends on it, with the bits of a new picture.
#include "changes.h"

#include <gtest/gtest.h>
#include <QSignalSpy>

#include "window_fixture.h"

namespace reliefui {

namespace {

using relief::MessageId;

relief::Scenario scene() {
    relief::Scenario scenario;
    scenario.pictures.height = std::string(RELIEF_DATASETS) + "/stone_wall_bricks102/height.jpg";
    scenario.pictures.color = std::string(RELIEF_DATASETS) + "/stone_wall_bricks102/color.jpg";
    scenario.filter.name = "elliptical";
    scenario.width = 160;
    scenario.height = 120;
    scenario.pixel = relief::PixelChoice{70, 60};
    scenario.shadows = true;
    return scenario;
}

double counted(const std::map<MessageId, double>& counters, MessageId what) {
    const auto found = counters.find(what);
    return found == counters.end() ? 0 : found->second;
}

void expectOnlyWhatDepends(const relief::Scenario& first, const std::vector<Change>& changes) {
    SnapshotMaker kept;
    relief::Work start;
    SnapshotOrder order{first};
    auto before = kept.make(order, start);
    for (const Change& change : changes) {
        SCOPED_TRACE(change.name);
        change.apply(order);
        relief::Work work;
        const auto now = kept.make(order, work);
        const std::uint32_t made = stagesMade(*before, *now);
        // The counts of steps belong to the stage of hits, and are added to it.
        if (order.layer != Layer::Steps) {
            EXPECT_EQ(made, change.stages);
        }
        const auto& counters = now->frame->counters;
        const auto noneWithout = [&](relief::Stage stage, double count) {
            if (change.stages != kNoStage && !relief::has(change.stages, stage)) {
                EXPECT_EQ(count, 0);
            }
        };
        noneWithout(relief::Stage::Hits, counted(counters, MessageId::CountRaysTraced));
        noneWithout(relief::Stage::Color, counted(counters, MessageId::CountTexelsRead));
        noneWithout(relief::Stage::Shadows, counted(counters, MessageId::CountHitsLit));
        // Only hits may need maps.
        if (!relief::has(change.stages, relief::Stage::Hits)) {
            EXPECT_EQ(counted(work.counters().values(), MessageId::CountMapBuilds), 0);
        }
        const std::vector<relief::SkipRow> ledger = relief::skipLedger(*now->frame, *now->request);
        const auto tiles = std::find_if(ledger.begin(), ledger.end(), [](const relief::SkipRow& row) {
            return std::string_view(row.name) == "tiles-kept";
        });
        ASSERT_EQ(tiles != ledger.end(), change.edit);
        if (change.edit) {
            EXPECT_GT(tiles->count, tiles->of / 2);
            EXPECT_LT(tiles->count, tiles->of);
        }
        SnapshotMaker fresh;
        relief::Work again;
        const auto anew = fresh.make(order, again);
        EXPECT_EQ(now->picture, anew->picture);
        EXPECT_EQ(now->layer.image, anew->layer.image);
        EXPECT_EQ(now->frame->light->color, anew->frame->light->color);
        before = now;
    }
}

TEST(Changes, ComputeOnlyWhatDependsOnThem) {
    expectOnlyWhatDepends(scene(), sceneChanges());
}

TEST(Changes, EditsByHandComputeOnlyTheTilesAroundThem) {
    relief::Scenario scenario = drawnScenario(32);
    scenario.width = 640;
    scenario.height = 480;
    scenario.camera.elevation = 50;
    expectOnlyWhatDepends(scenario, editChanges());
}

// A layer is made again only if a stage that it depends on has changed.
TEST(Changes, ALayerStaysWhileItsStagesDo) {
    SnapshotMaker maker;
    relief::Work work;
    SnapshotOrder order{scene()};
    order.layer = Layer::Error;
    order.scenario.method.name = "layers";
    const auto error = [&] { return maker.make(order, work)->layer.error; };
    const auto first = error();
    order.scenario.light.azimuth += 20;
    EXPECT_EQ(error(), first);
    order.scenario.filter.name = "bilinear";
    EXPECT_EQ(error(), first);
    order.layer = Layer::Depth;
    maker.make(order, work);
    order.layer = Layer::Error;
    EXPECT_EQ(error(), first);
    order.scenario.method.options["layers"] = "7";
    const auto other = error();
    EXPECT_NE(other, first);
    order.scenario.camera.azimuth += 20;
    EXPECT_NE(error(), other);
}

using ChangesInTheWindow = WindowTest;

// Neither the worker nor a snapshot is involved.
TEST_F(ChangesInTheWindow, OfLooksAndStepsRequestNoPicture) {
    openWindow(deepRay());
    const auto shown = snapshot();
    QSignalSpy busy(workspace_.get(), &Workspace::busyChanged);
    QSignalSpy snapshots(workspace_.get(), &Workspace::snapshotChanged);
    workspace_->change(scenario(), QStringLiteral("nothing"));
    workspace_->chooseStep(scenario().step + 1);
    workspace_->setBookmarks({{"here", *scenario().pixel, scenario().camera, 0}}, QStringLiteral("bookmark"));
    Style style = workspace_->style();
    style.theme = style.theme == Theme::Dark ? Theme::Light : Theme::Dark;
    workspace_->setStyle(style);
    style.language = relief::Language::Ukrainian;
    workspace_->setStyle(style);
    window_->resize(window_->size() + QSize(40, 30));
    workspace_->pointAtTexel(0);
    QTest::qWait(200);
    EXPECT_EQ(busy.count(), 0);
    EXPECT_EQ(snapshots.count(), 0);
    EXPECT_EQ(snapshot(), shown);
    // The spies notice what does request one.
    workspace_->choosePixel(scenario().pixel->x + 3, scenario().pixel->y);
    waitForFull();
    EXPECT_GT(busy.count(), 0);
    EXPECT_GT(snapshots.count(), 0);
    EXPECT_EQ(snapshot()->frame, shown->frame);
}

}  // namespace

}  // namespace reliefui
