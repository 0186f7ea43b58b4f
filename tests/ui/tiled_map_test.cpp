// A height map that is read by tiles: pictures and panes are those of the map in memory, and panes that need all
// heights say so.
#include <QDockWidget>
#include <QTemporaryDir>

#include "images/recipe_rows.h"
#include "images/tiled_writer.h"
#include "panes/distance/distance_view.h"
#include "panes/drawing_canvas.h"
#include "panes/profile/profile_view.h"
#include "panes/pyramid/pyramid_view.h"
#include "window_fixture.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

class TiledMapTest : public WindowTest {
  protected:
    // A scenario over a tiled map of bricks. memory: megabytes; 0: as a whole.
    relief::Scenario bricks(int memory) const {
        const std::string path = folder_.filePath(QStringLiteral("map.tif")).toStdString();
        if (!QFileInfo::exists(QString::fromStdString(path))) {
            const auto rows = relief::reliefHeightRows("bricks", 300, 200, 1);
            relief::Work work;
            relief::TiledWriter(*rows, path, {}).write(work);
        }
        relief::Scenario scenario = smallScenario();
        scenario.pictures = {};
        scenario.pictures.height = path;
        scenario.pictures.memory = memory;
        scenario.method = {"max-pyramid", {}};
        scenario.filter.name = "bilinear";
        scenario.shadows = true;
        return scenario;
    }
    // Brings the pane to the front and returns the view in it.
    template <class View>
    View* shown(const QString& pane) {
        auto* const dock = window_->findChild<QDockWidget*>(pane);
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();
        return window_->findChild<View*>();
    }
    // Whether the pane shows this text and nothing else.
    bool says(FigureView* view, relief::MessageId text) const {
        const auto* const canvas = view->findChild<DrawingCanvas*>();
        DrawingCanvas expected(view);
        expected.resize(canvas->size());
        expected.setStyle(workspace_->style());
        expected.showText(text);
        return canvas->isVisible() && grab(const_cast<DrawingCanvas*>(canvas)) == expected.grab().toImage();
    }

    QTemporaryDir folder_;
};

TEST_F(TiledMapTest, PicturesAndRaysAreThoseOfTheMapInMemory) {
    relief::Work work;
    const auto whole = SnapshotMaker().make({bricks(0)}, work);
    const auto tiled = SnapshotMaker().make({bricks(1)}, work);
    ASSERT_TRUE(tiled->assets.tiles);
    ASSERT_FALSE(whole->assets.tiles);
    EXPECT_EQ(tiled->picture, whole->picture);
    ASSERT_TRUE(whole->trace.onRelief);
    EXPECT_EQ(tiled->trace.hit.lambda, whole->trace.hit.lambda);
    EXPECT_EQ(tiled->trace.exact.lambda, whole->trace.exact.lambda);
    EXPECT_FALSE(tiled->has(relief::PyramidKind::Min) || tiled->has(relief::PyramidKind::Mean));
}

// Another program shortens the file: the next picture is refused in a line, and the shown one stays.
TEST_F(TiledMapTest, AFileThatIsCutIsSaidInALine) {
    openWindow(bricks(1));
    const auto before = snapshot();
    ASSERT_TRUE(before->assets.tiles);
    const QString path = folder_.filePath(QStringLiteral("map.tif"));
    ASSERT_TRUE(QFile::resize(path, 8192));
    QString problem;
    QObject::connect(workspace_.get(), &Workspace::problem, window_.get(),
                     [&](const QString& text) { problem = text; });
    relief::Scenario other = scenario();
    other.camera.azimuth += 40;
    workspace_->change(other, {});
    EXPECT_TRUE(QTest::qWaitFor([&] { return !problem.isEmpty(); }, 10000));
    EXPECT_TRUE(problem.startsWith(path)) << problem.toStdString();
    EXPECT_EQ(snapshot()->picture, before->picture);
}

TEST_F(TiledMapTest, PanesThatNeedAllHeightsSaySo) {
    openWindow(bricks(1));
    ASSERT_TRUE(snapshot()->assets.tiles);
    for (QDockWidget* const dock : window_->findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        grab(dock);
    }
    waitForFull();
    EXPECT_TRUE(says(shown<PyramidView>(QStringLiteral("pyramid-pane")), relief::MessageId::DrawTiled));
    EXPECT_TRUE(window_->findChild<PyramidView*>()->image(100).isNull());
    EXPECT_TRUE(says(shown<DistanceView>(QStringLiteral("distance-pane")), relief::MessageId::DrawTiled));
    auto* const profile = shown<ProfileView>(QStringLiteral("profile-pane"));
    EXPECT_FALSE(says(profile, relief::MessageId::DrawTiled));
    EXPECT_GT(colorsIn(profile->image(300)), 4);
    // A method that needs a map of all heights is refused, and the picture stays.
    const auto before = snapshot();
    relief::Scenario cones = scenario();
    cones.method = {"cone", {}};
    QString problem;
    QObject::connect(workspace_.get(), &Workspace::problem, window_.get(),
                     [&](const QString& text) { problem = text; });
    workspace_->change(cones, {});
    EXPECT_TRUE(QTest::qWaitFor([&] { return !problem.isEmpty(); }, 10000));
    EXPECT_TRUE(problem.contains(QStringLiteral("max-pyramid"))) << problem.toStdString();
    EXPECT_EQ(snapshot()->picture, before->picture);
    // Other heights are opened within the same bound, and shown by all panes again if they are read whole.
    workspace_->change(bricks(0), {});
    waitForFull();
    EXPECT_FALSE(snapshot()->assets.tiles);
    EXPECT_FALSE(says(shown<PyramidView>(QStringLiteral("pyramid-pane")), relief::MessageId::DrawTiled));
}

}  // namespace

}  // namespace reliefui
