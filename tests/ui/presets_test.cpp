// Presets of the view, and resetting a method's options to their defaults.
#include <QComboBox>
#include <QToolButton>

#include "window_fixture.h"
#include "windows/scene_panel.h"

namespace reliefui {

namespace {

class PresetsTest : public WindowTest {};

TEST_F(PresetsTest, EveryViewShowsTheReliefOfEveryScene) {
    openWindow(smallScenario());
    auto* const box = window_->findChild<QComboBox*>(QStringLiteral("view-preset"));
    ASSERT_NE(box, nullptr);
    ASSERT_EQ(box->count(), static_cast<int>(viewPresets().size()) + 1);
    for (const relief::SceneKind scene : {relief::SceneKind::Floor, relief::SceneKind::Wall, relief::SceneKind::Cube}) {
        relief::Scenario changed = scenario();
        changed.scene = scene;
        workspace_->change(changed, QStringLiteral("scene"));
        waitForFull();
        for (int item = 1; item < box->count(); ++item) {
            const relief::Scenario before = scenario();
            box->setCurrentIndex(item);
            Q_EMIT box->activated(item);
            waitForFull();
            const ViewPreset& preset = viewPresets()[static_cast<std::size_t>(item - 1)];
            EXPECT_EQ(scenario().camera, presetCamera(preset, scene)) << preset.name;
            EXPECT_EQ(box->currentIndex(), 0);
            // The view shows more than sky.
            const auto frame = snapshot()->frame;
            int covered = 0;
            for (int y = 0; y < frame->height; ++y) {
                for (int x = 0; x < frame->width; ++x) covered += frame->ray(x, y) ? 1 : 0;
            }
            EXPECT_GT(covered, 0.2 * frame->width * frame->height) << preset.name;
            workspace_->undo();
            waitForFull();
            EXPECT_EQ(scenario().camera, before.camera);
        }
    }
}

TEST_F(PresetsTest, AMethodGetsItsOwnOptionsBack) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "7"}}};
    openWindow(scenario);
    auto* const defaults = window_->findChild<QToolButton*>(QStringLiteral("method-defaults"));
    ASSERT_NE(defaults, nullptr);
    EXPECT_TRUE(defaults->isEnabled());
    defaults->click();
    waitForFull();
    EXPECT_TRUE(this->scenario().method.options.empty());
    EXPECT_FALSE(defaults->isEnabled());
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(this->scenario().method, scenario.method);
    EXPECT_TRUE(defaults->isEnabled());
}

}  // namespace

}  // namespace reliefui
