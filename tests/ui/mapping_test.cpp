// Texture coordinates from row variants other than direct, chosen in the window.
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>

#include "window_fixture.h"

namespace reliefui {
namespace {

TEST_F(WindowTest, CoordinatesAreChosenShownAndUndone) {
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

// The error of ellipses along rows is displayed; options that they do not support are refused with a message, and the
// state is kept.
TEST_F(WindowTest, EllipsesAlongRowsAreShownAndRefusedForShapedPixels) {
    relief::Scenario start = smallScenario();
    start.filter = {"elliptical", {{"ellipse", "cached"}}};
    openWindow(start);
    waitForFull();
    auto* const line = window_->findChild<QLabel*>(QStringLiteral("status-frame"));
    ASSERT_NE(line, nullptr);
    EXPECT_GT(snapshot()->ellipseOff, 0);
    EXPECT_LT(snapshot()->ellipseOff, 1e-4);
    EXPECT_TRUE(line->text().contains(QStringLiteral("footprint axes ±"))) << line->text().toStdString();
    const QSignalSpy problems(workspace_.get(), &Workspace::problem);
    const std::shared_ptr<const Snapshot> shown = snapshot();
    const relief::Scenario before = scenario();
    relief::Scenario wrong = before;
    wrong.filter.options["weights"] = "box";
    workspace_->change(wrong, QStringLiteral("Weights"));
    ASSERT_EQ(problems.size(), 1);
    const QString said = problems[0][0].toString();
    EXPECT_TRUE(said.contains(QStringLiteral("ellipse is cached"))) << said.toStdString();
    EXPECT_TRUE(said.contains(QStringLiteral("weights=box"))) << said.toStdString();
    EXPECT_FALSE(said.contains(QLatin1Char('\n')));
    EXPECT_EQ(scenario(), before);
    EXPECT_EQ(snapshot(), shown);
    relief::Scenario direct = before;
    direct.filter.options["ellipse"] = "direct";
    workspace_->change(direct, QStringLiteral("Ellipse"));
    waitForFull();
    EXPECT_EQ(snapshot()->ellipseOff, 0);
    EXPECT_FALSE(line->text().contains(QStringLiteral("footprint axes"))) << line->text().toStdString();
}

}  // namespace
}  // namespace reliefui
