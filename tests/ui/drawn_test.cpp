// Reliefs drawn by hand: their drawing, and the update of all panes by mouse actions.
#include <cmath>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMouseEvent>
#include <QProcess>
#include <QTemporaryDir>

#include "panes/drawing_canvas.h"
#include "panes/drawn/drawn_drawing.h"
#include "panes/drawn/drawn_view.h"
#include "panes/profile/profile_view.h"
#include "panes/pyramid/pyramid_view.h"
#include "relief/reliefs.h"
#include "scenario/scenario.h"
#include "window_fixture.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

DrawnSource sourceOf(relief::DrawnRelief drawn) {
    DrawnSource source;
    source.relief = std::move(drawn);
    source.hasRay = true;
    source.ray = {0.5, 0.25, 1.5, 0.5};
    source.hit = relief::Hit::at(source.ray, 0.75);
    return source;
}

Point endOfRay(const DrawnPicture& picture) {
    for (const Item& item : picture.drawing.items) {
        const auto* ring = std::get_if<Ring>(&item.primitive);
        if (item.role == Role::Hit && ring != nullptr) return ring->center;
    }
    return {-1, -1};
}

TEST(Drawn, TheGridIsWhatTheTracerGetsAndTheRayLiesOnIt) {
    const DrawnSource source = sourceOf({3, 2, {0, 0.25, 0.5, 0.75, 1, 0.125}});
    const DrawnPicture picture = drawnPicture(source, 0.5);
    const Cells* cells = nullptr;
    for (const Item& item : picture.drawing.items) {
        if (cells == nullptr) cells = std::get_if<Cells>(&item.primitive);
    }
    ASSERT_NE(cells, nullptr);
    EXPECT_EQ((*cells->values)(2, 1), 0.125F);
    EXPECT_EQ(endOfRay(picture), (Point{0.5 + 0.75 * 1.5, 0.25 + 0.75 * 0.5}));
    EXPECT_EQ(drawnTexelAt(picture, source.relief, {2.4, 1.9}), (std::pair{2, 1}));
    EXPECT_FALSE(drawnTexelAt(picture, source.relief, {3.1, 0.5}));
}

// Levels that an edit does not change are shared, not built again.
TEST(Drawn, AnEditSharesTheLevelsThatStay) {
    constexpr int kSide = 16;
    relief::Scenario scenario;
    scenario.width = 40;
    scenario.height = 30;
    scenario.pictures.drawn = {kSide, kSide, std::vector<double>(kSide * kSide, 0.5)};
    scenario.pictures.drawn.heights[0] = 0.75;
    SnapshotMaker maker;
    relief::Work work;
    const auto before = maker.make({scenario}, work);
    // Lower than its neighbours: no maximum changes, but minima and means do.
    scenario.pictures.drawn.heights[5 * kSide + 5] = 0.25;
    const auto after = maker.make({scenario}, work);
    const relief::Pyramid &oldMaxima = before->maxima->pyramid, &maxima = after->maxima->pyramid;
    ASSERT_EQ(maxima.levels(), oldMaxima.levels());
    for (int l = 1; l < maxima.levels(); ++l) EXPECT_EQ(&maxima.level(l), &oldMaxima.level(l)) << "level " << l;
    for (int l = 1; l < after->minima->levels(); ++l) {
        EXPECT_NE(&after->minima->level(l), &before->minima->level(l)) << "level " << l;
    }
    EXPECT_EQ(after->minima->level(after->minima->levels() - 1)(0, 0), 0.25F);
    EXPECT_EQ(after->means->level(1)(2, 2), 0.4375F);
}

TEST(Drawn, TheProfileShowsTheRayFromTheSide) {
    const DrawnSource source = sourceOf({4, 4, {0, 0.25, 0.5, 1}});
    const DrawnPicture picture = drawnPicture(source, 0.5);
    ASSERT_TRUE(picture.profile);
    // The ray is 0.75 of the slab's height below its top there.
    const Point end = endOfRay(picture);
    EXPECT_NEAR(end.x, 0.5 + 0.75 * 1.5, 1e-12);
    EXPECT_NEAR(drawnHeightAt(picture, end), 0.25, 1e-12);
    EXPECT_EQ(drawnTexelAt(picture, source.relief, {3.5, picture.body.y0 + 0.1}), (std::pair{3, 0}));
    for (const double aspect : {0.2, 0.5, 2.0}) {
        const DrawnPicture shaped = drawnPicture(source, aspect);
        const Box bounds = shaped.drawing.bounds;
        EXPECT_GE(bounds.height(), bounds.width() * std::min(aspect, 0.3) * 0.7);
        // However many texels the relief has, most of the width is theirs; the rest has room for the numbers.
        const double beside = (bounds.width() - shaped.body.width()) / 2 / bounds.width();
        EXPECT_GT(beside, 0.02) << aspect;
        EXPECT_LT(beside, 0.1) << aspect;
    }
    EXPECT_TRUE(drawnPicture({}, 1).drawing.items.empty());
}

class DrawnPane : public WindowTest {
  protected:
    void openPane() {
        relief::Scenario scenario = smallScenario();
        scenario.camera.elevation = 30;
        openWindow(scenario);
        QTest::keyClick(window_.get(), Qt::Key_2, Qt::AltModifier);
        QTest::qWait(100);
    }
    DrawnView* view() { return window_->pane<DrawnView>(); }
    DrawnGrid* grid() { return view()->grid(); }
    const relief::DrawnRelief drawn() { return scenario().pictures.drawn; }
    void drag(QPointF from, QPointF to, int moves = 4) {
        QTest::mousePress(grid(), Qt::LeftButton, {}, from.toPoint());
        for (int n = 1; n <= moves; ++n) {
            const QPointF at = from + (to - from) * n / moves;
            QMouseEvent move(QEvent::MouseMove, at, Qt::LeftButton, Qt::LeftButton, {});
            QApplication::sendEvent(grid(), &move);
            QTest::qWait(20);
        }
        QTest::mouseRelease(grid(), Qt::LeftButton, {}, to.toPoint());
        waitForFull();
    }
    // Checks that the tracers use the drawn heights.
    void expectFollowed() {
        const relief::FloatImage expected = relief::drawnHeights(drawn());
        EXPECT_TRUE(std::ranges::equal(snapshot()->request->field.heights().pixels(), expected.pixels()));
        float highest = 0;
        for (const float h : expected.pixels()) highest = std::max(highest, h);
        const relief::Pyramid& maxima = snapshot()->maxima->pyramid;
        EXPECT_EQ(maxima.level(maxima.levels() - 1)(0, 0), highest);
        EXPECT_EQ(snapshot()->scenario.pictures.drawn, drawn());
    }
};

TEST_F(DrawnPane, ItStartsFromWhatThereIsAndGoesBack) {
    openPane();
    EXPECT_GT(colorsIn(grab(grid())), 1) << "says how to begin";
    const relief::Scenario before = scenario();
    const QImage picture = snapshot()->picture;
    const relief::Hit hit = snapshot()->trace.hit;
    const float there =
        snapshot()->request->field.texel(static_cast<int>(std::floor(hit.s)), static_cast<int>(std::floor(hit.t)));
    view()->startFromPicture();
    waitForFull();
    EXPECT_EQ(drawn().width, 16);
    EXPECT_NEAR(drawn().at(8, 8), there, 0.0005) << "the hit lies in the middle";
    expectFollowed();
    view()->startFromRecipe(QStringLiteral("hills"));
    waitForFull();
    EXPECT_NEAR(drawn().at(3, 5), relief::makeRelief("hills", 16, 16, 1)(3, 5), 0.0005);
    expectFollowed();
    EXPECT_GT(colorsIn(grab(grid())), 20);
    workspace_->undo();
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(scenario(), before);
    EXPECT_EQ(snapshot()->picture, picture);
}

TEST_F(DrawnPane, ADraggedTexelIsFollowedAndOneStepOfUndo) {
    openPane();
    view()->setSide(8);
    view()->startFromRecipe(QStringLiteral("hills"));
    waitForFull();
    const relief::Scenario before = scenario();
    const QImage picture = snapshot()->picture;
    const double old = drawn().at(2, 3);
    const QPointF at = grid()->placeOf(2, 3);
    const double points = 40;
    drag(at, at + QPointF(0, (old > 0.5 ? 1 : -1) * points * workspace_->style().pixelsPerPoint()));
    EXPECT_NEAR(std::abs(drawn().at(2, 3) - old), points / 150, 0.01);
    EXPECT_EQ(grid()->chosen(), (std::pair{2, 3}));
    expectFollowed();
    EXPECT_NE(snapshot()->picture, picture);
    for (int n = 0; n < 64; ++n) {
        if (n != 3 * 8 + 2) {
            EXPECT_EQ(drawn().heights[static_cast<std::size_t>(n)], before.pictures.drawn.heights[std::size_t(n)]);
        }
    }
    const relief::Scenario after = scenario();
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(scenario(), before) << "one step of undo for the whole drag";
    EXPECT_EQ(snapshot()->picture, picture);
    workspace_->redo();
    waitForFull();
    EXPECT_EQ(scenario().pictures, after.pictures);
}

TEST_F(DrawnPane, ADragFromBesideTheGridMovesNothing) {
    openPane();
    view()->startFlat();
    waitForFull();
    const relief::Scenario before = scenario();
    const QPointF corner = grid()->placeOf(0, 0), next = grid()->placeOf(1, 1);
    drag(corner - 2 * (next - corner), next);
    EXPECT_EQ(scenario(), before);
}

TEST_F(DrawnPane, AnotherSizeKeepsTheReliefInPlace) {
    openPane();
    view()->startFromRecipe(QStringLiteral("hills"));
    waitForFull();
    const relief::DrawnRelief large = drawn();
    ASSERT_EQ(large.width, 16);
    view()->setProfile(false);
    EXPECT_EQ(drawn(), large) << "it is a grid already";
    view()->setSide(8);
    waitForFull();
    const relief::DrawnRelief small = drawn();
    ASSERT_EQ(small.heights.size(), 64U);
    view()->setSide(16);
    waitForFull();
    ASSERT_EQ(drawn().heights.size(), 256U);
    for (int j = 0; j < 16; ++j) {
        for (int i = 0; i < 16; ++i) {
            if (i % 2 == 0 && j % 2 == 0) {
                EXPECT_EQ(small.at(i / 2, j / 2), large.at(i, j));
            }
            EXPECT_EQ(drawn().at(i, j), small.at(i / 2, j / 2));
        }
    }
    expectFollowed();
}

TEST_F(DrawnPane, AHeightIsTypedAndKeysWork) {
    openPane();
    view()->startFlat(0.25);
    waitForFull();
    QTest::mouseClick(grid(), Qt::LeftButton, {}, grid()->placeOf(4, 5).toPoint());
    auto* const spin = view()->findChild<QDoubleSpinBox*>(QStringLiteral("drawn-height"));
    EXPECT_EQ(spin->value(), 0.25);
    QMouseEvent rest(QEvent::MouseMove, grid()->placeOf(4, 5), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(grid(), &rest);
    EXPECT_TRUE(view()->readout().endsWith(QStringLiteral("0.250"))) << view()->readout().toStdString();
    QTest::keyClick(grid(), Qt::Key_Return);
    EXPECT_TRUE(spin->hasFocus());
    QTest::keyClicks(spin, QStringLiteral("0.875"));
    QTest::keyClick(spin, Qt::Key_Return);
    waitForFull();
    EXPECT_EQ(drawn().at(4, 5), 0.875);
    EXPECT_TRUE(view()->readout().endsWith(QStringLiteral("0.875"))) << "the pointer rests on the texel";
    expectFollowed();
    grid()->setFocus();
    QTest::keyClick(grid(), Qt::Key_Right);
    EXPECT_EQ(grid()->chosen(), (std::pair{5, 5}));
    QTest::keyClick(grid(), Qt::Key_PageUp, Qt::ShiftModifier);
    waitForFull();
    EXPECT_EQ(drawn().at(5, 5), 0.35);
    QTest::keyClick(grid(), Qt::Key_Right);
    QTest::keyClick(grid(), Qt::Key_PageUp);
    EXPECT_EQ(drawn().at(6, 5), 0.26);
    workspace_->undo();
    EXPECT_EQ(drawn().at(6, 5), 0.25);
    EXPECT_EQ(drawn().at(5, 5), 0.35) << "each texel's changes are a step of undo of their own";
    grid()->choose(std::nullopt);  // hides its outline
    // Cells show their numbers, and their brightness is their height: probed in a corner, next to the number.
    const QPointF corner = grid()->placeOf(1, 0) - grid()->placeOf(0, 0);
    const auto brightness = [&](int i, int j) {
        return qGray(grab(grid()).pixel((grid()->placeOf(i, j) + 0.35 * QPointF(corner.x(), corner.x())).toPoint()));
    };
    EXPECT_GT(brightness(4, 5), brightness(5, 5));
    EXPECT_GT(brightness(5, 5), brightness(8, 8));
}

TEST_F(DrawnPane, AProfileIsDrawnWithThePointer) {
    openPane();
    view()->startFlat();
    waitForFull();
    view()->setProfile(true);
    waitForFull();
    ASSERT_TRUE(drawn().profile());
    // Six columns in three mouse events: no column is left out.
    drag(grid()->placeOf(2, 0, 0.01), grid()->placeOf(7, 0, 0.6), 3);
    for (int i = 3; i <= 7; ++i) EXPECT_GT(drawn().at(i, 0), 0.1) << i;
    EXPECT_NEAR(drawn().at(7, 0), 0.6, 0.02);
    EXPECT_EQ(drawn().at(8, 0), 0);
    expectFollowed();
    EXPECT_EQ(snapshot()->request->field.height(), 16) << "the row is repeated";
    view()->setProfile(false);
    waitForFull();
    EXPECT_FALSE(drawn().profile());
    expectFollowed();
    EXPECT_EQ(drawn().at(7, 3), drawn().at(7, 12));
}

TEST_F(DrawnPane, ItIsSavedReopenedAndExported) {
    openPane();
    view()->setSide(8);
    view()->startFromRecipe(QStringLiteral("city"));
    waitForFull();
    const relief::Scenario before = scenario();
    const QImage picture = snapshot()->picture;
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("drawn.json"));
    workspace_->save(file);
    view()->startFlat();
    waitForFull();
    workspace_->open(file);
    waitForFull();
    EXPECT_EQ(scenario(), before);
    EXPECT_EQ(snapshot()->picture, picture);
    const QString png = folder.filePath(QStringLiteral("drawn.png"));
    saveFigure(view(), png, 800);
    EXPECT_EQ(QImage(png).width(), 800);
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
    process.setProcessEnvironment(environment);
    const QString svg = folder.filePath(QStringLiteral("drawn.svg"));
    process.start(QStringLiteral(RELIEFSCOPE),
                  {file, QStringLiteral("--export"), QStringLiteral("drawn"), QStringLiteral("-o"), svg});
    process.waitForFinished(60000);
    EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    QFile text(svg);
    ASSERT_TRUE(text.open(QIODevice::ReadOnly));
    EXPECT_GT(text.readAll().count("<text"), 64);
}

}  // namespace

}  // namespace reliefui
