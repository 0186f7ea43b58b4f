// Coordinates by other rows than direct, chosen in the window.
#include <QComboBox>
#include <QLabel>

#include "window_fixture.h"

namespace reliefui {
namespace {

TEST_F(WindowTest, CoordinatesAreChosenSaidAndUndone) {
    relief::Scenario start = smallScenario();
    start.scene = relief::SceneKind::Wall;
    start.camera.azimuth = 55;
    openWindow(start);
    waitForFull();
    auto* const box = window_->findChild<QComboBox*>(QStringLiteral("mapping"));
    auto* const line = window_->findChild<QLabel*>(QStringLiteral("status-frame"));
    ASSERT_TRUE(box != nullptr && line != nullptr);
    EXPECT_EQ(box->currentData().toString(), QStringLiteral("direct"));
    EXPECT_FALSE(line->text().contains(QStringLiteral("coordinates")));
    const auto straight = snapshot()->frame->ray(100, 60);
    const int item = box->findData(QStringLiteral("affine"));
    box->setCurrentIndex(item);
    Q_EMIT box->activated(item);
    waitForFull();
    EXPECT_EQ(scenario().mapping, "affine");
    EXPECT_TRUE(line->text().contains(QStringLiteral("coordinates ±"))) << line->text().toStdString();
    EXPECT_NE(snapshot()->frame->ray(100, 60), straight);
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(scenario().mapping, "direct");
    EXPECT_EQ(box->currentData().toString(), QStringLiteral("direct"));
    EXPECT_EQ(snapshot()->frame->ray(100, 60), straight);
}

}  // namespace
}  // namespace reliefui
