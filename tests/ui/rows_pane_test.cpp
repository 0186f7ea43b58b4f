// The rows pane, operated as by a person, and figures exported by the program.
#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QProcess>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolButton>

#include "panes/drawing_canvas.h"
#include "panes/rows/rows_drawing.h"
#include "panes/rows/rows_view.h"
#include "scenario/scenario.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 120000;

class RowsPane : public WindowTest {
  protected:
    void openPane() {
        relief::Scenario scenario = smallScenario();
        scenario.camera.elevation = 35;
        scenario.camera.azimuth = 50;
        openWindow(scenario);
        window_->findChild<QDockWidget*>(QStringLiteral("rows-pane"))->raise();
        settle();
        ASSERT_NE(view()->shown(), nullptr);
    }
    void settle() {
        QTest::qWait(100);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view()->isUpToDate(); }, kPatienceMs));
    }
    RowsView* view() { return window_->pane<RowsView>(); }
    DrawingCanvas* canvas() { return view()->canvas(); }
};

TEST_F(RowsPane, ItShowsTheRowOfTheChosenPixel) {
    openPane();
    EXPECT_GT(colorsIn(grab(canvas())), 50);
    const auto shown = [&] { return *view()->shown(); };
    EXPECT_EQ(shown().place.line, scenario().pixel->y);
    EXPECT_EQ(shown().place.chosen, scenario().pixel->x);
    // The ray of a pixel enters at the coordinates of the row.
    const auto i = static_cast<std::size_t>(shown().place.chosen - shown().row.span.begin);
    constexpr double kRounding = 1e-6;
    EXPECT_NEAR(shown().row.u[i], snapshot()->trace.ray.s0, kRounding);
    EXPECT_NEAR(shown().row.v[i], snapshot()->trace.ray.t0, kRounding);

    const int other = scenario().pixel->y - 20;
    workspace_->choosePixel(scenario().pixel->x, other);
    waitForFull();
    settle();
    EXPECT_EQ(shown().place.line, other);
}

TEST_F(RowsPane, AClickChoosesAPixelOfTheRowAndTheWheelZoomsAlongIt) {
    openPane();
    const RowsFrame home = view()->frame();
    const double pixel = home.from + 0.7 * (home.to - home.from);
    const QPoint at = canvas()->toWidget({home.xAt(pixel), home.lower.center().y}).toPoint();
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, at);
    waitForFull();
    settle();
    EXPECT_NEAR(scenario().pixel->x, pixel, 1 + (home.to - home.from) / home.upper.width());
    EXPECT_EQ(view()->shown()->place.chosen, scenario().pixel->x);
    QWheelEvent wheel(at, canvas()->mapToGlobal(at), {}, QPoint(0, 960), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(canvas(), &wheel);
    const RowsFrame near = view()->frame();
    EXPECT_LT(near.to - near.from, 0.3 * (home.to - home.from));
    EXPECT_NEAR(near.xAt(pixel), home.xAt(pixel), 3);
    QTest::mousePress(canvas(), Qt::LeftButton, Qt::NoModifier, at);
    QMouseEvent move(QEvent::MouseMove, at + QPoint(40, 0), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(canvas(), &move);
    QTest::mouseRelease(canvas(), Qt::LeftButton, Qt::NoModifier, at + QPoint(40, 0));
    EXPECT_LT(view()->frame().from, near.from) << "dragged to the right";
    const int before = scenario().pixel->x;
    EXPECT_EQ(scenario().pixel->x, before) << "a drag chooses nothing";
    QTest::keyClick(canvas(), Qt::Key_R);
    EXPECT_EQ(view()->frame().from, home.from);
    EXPECT_EQ(view()->frame().to, home.to);
    // Each click is one step of undo.
    const double other = home.from + 0.3 * (home.to - home.from);
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier,
                      canvas()->toWidget({home.xAt(other), home.lower.center().y}).toPoint());
    EXPECT_LT(scenario().pixel->x, before);
    workspace_->undo();
    EXPECT_EQ(scenario().pixel->x, before);
}

TEST_F(RowsPane, HoverReadsOut) {
    openPane();
    // In the whole window there is room for the strips.
    QWidget* const title = window_->findChild<QDockWidget*>(QStringLiteral("rows-pane"))->titleBarWidget();
    QTest::mouseDClick(title, Qt::LeftButton, Qt::NoModifier, QPoint(60, title->height() / 2));
    // Qt distributes the space of docks in several passes.
    QTest::qWait(300);
    settle();
    const RowsFrame& frame = view()->frame();
    const RowsData& data = *view()->shown();
    // On the curve of the first variant, in the middle of the row.
    const std::size_t curve = 3;
    const auto pixel = static_cast<std::int64_t>((frame.from + frame.to) / 2);
    const auto i = static_cast<std::size_t>(pixel - data.row.span.begin);
    const Point at{frame.xAt(static_cast<double>(pixel) + 0.5), frame.yAt(data.row.curves[0].u[i])};
    QTest::mouseMove(canvas(), canvas()->toWidget(at).toPoint());
    QTest::qWait(50);
    const QString text = view()->readout();
    EXPECT_TRUE(text.contains(QStringLiteral("affine"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("error"))) << text.toStdString();
    // In the strip of streams each pixel shows its stream.
    ASSERT_EQ(frame.strips.size(), 1u);
    const double part = (0.5 + static_cast<double>(frame.lens.size() / 2)) / static_cast<double>(frame.lens.size());
    const Point box{frame.strips[0].x0 + part * frame.strips[0].width(), frame.strips[0].center().y};
    QTest::mouseMove(canvas(), canvas()->toWidget(box).toPoint());
    QTest::qWait(50);
    const std::int64_t below = frame.lens.begin + frame.lens.size() / 2;
    const std::int32_t stream = data.row.curves[curve].stream[static_cast<std::size_t>(below - data.row.span.begin)];
    EXPECT_TRUE(view()->readout().contains(QStringLiteral("pixel %1 ").arg(below))) << view()->readout().toStdString();
    EXPECT_TRUE(view()->readout().contains(QStringLiteral("stream %1 of 4").arg(stream)))
        << view()->readout().toStdString();
}

TEST_F(RowsPane, TheControlsChooseVariantsAndWidth) {
    openPane();
    const QImage before = grab(canvas());
    const auto find = [&](const char* name) { return view()->findChild<QWidget*>(QString::fromLatin1(name)); };
    auto* const open = qobject_cast<QToolButton*>(find("rows-variants"));
    open->click();
    auto* const variant = qobject_cast<QComboBox*>(find("rows-3-variant"));
    ASSERT_TRUE(variant != nullptr && variant->isVisible());
    variant->setCurrentIndex(variant->findText(QStringLiteral("subspan")));
    Q_EMIT variant->activated(variant->currentIndex());
    settle();
    EXPECT_EQ(view()->options().methods[2], "subspan");
    auto* const span = qobject_cast<QSpinBox*>(find("rows-3-span"));
    ASSERT_TRUE(span->isVisible());
    span->setValue(32);
    qobject_cast<QSpinBox*>(find("rows-4-streams"))->setValue(8);
    settle();
    EXPECT_EQ(view()->options().methods[2], "subspan:span=32");
    EXPECT_EQ(view()->options().methods[3], "streams:streams=8");
    EXPECT_EQ(view()->shown()->row.curves[2].options.span, 32);
    auto* const pixels = qobject_cast<QComboBox*>(find("rows-pixels"));
    pixels->setCurrentIndex(pixels->findData(65536));
    Q_EMIT pixels->activated(pixels->currentIndex());
    settle();
    EXPECT_EQ(view()->shown()->place.width, 65536);
    EXPECT_NE(grab(canvas()), before);
    RowsOptions none;
    none.methods.clear();
    view()->setOptions(none);
    settle();
    EXPECT_EQ(view()->shown(), nullptr);
    EXPECT_TRUE(QTest::qWaitFor([&] { return colorsIn(grab(canvas())) > 1; }, kPatienceMs)) << "it says so";
}

TEST_F(RowsPane, TheSkyHasNoRow) {
    openPane();
    relief::Scenario scenario = this->scenario();
    scenario.scene = relief::SceneKind::Cube;
    scenario.camera.distance = 4;
    scenario.pixel = relief::PixelChoice{0, 0};
    workspace_->change(scenario, QStringLiteral("cube"));
    waitForFull();
    settle();
    EXPECT_EQ(view()->shown(), nullptr);
    EXPECT_TRUE(QTest::qWaitFor([&] { return colorsIn(grab(canvas())) > 1; }, kPatienceMs)) << "it says so";
}

TEST_F(RowsPane, ItIsExportedAsItIsShown) {
    openPane();
    const QTemporaryDir folder;
    for (const char* const ending : {"svg", "pdf", "png"}) {
        const QString file = folder.filePath(QStringLiteral("rows.") + QString::fromLatin1(ending));
        saveFigure(view(), file);
        EXPECT_GT(QFileInfo(file).size(), 3000) << ending;
    }
    EXPECT_GT(colorsIn(view()->image(800)), 50);
}

// The program exports the rows without a display.
TEST(Rows, TheProgramExportsThem) {
    const QTemporaryDir folder;
    const QString scenario = folder.filePath(QStringLiteral("scenario.json"));
    relief::saveScenario(scenario.toStdString(), smallScenario());
    const auto run = [&](const QStringList& more) {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove(QStringLiteral("DISPLAY"));
        environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(RELIEFSCOPE), QStringList{scenario} + more);
        process.waitForFinished(60000);
        return process.exitCode();
    };
    const QStringList exportTo{QStringLiteral("--export"), QStringLiteral("rows"), QStringLiteral("-o")};
    for (const char* const ending : {"svg", "pdf", "png"}) {
        const QString file = folder.filePath(QStringLiteral("rows.") + QString::fromLatin1(ending));
        EXPECT_EQ(run(exportTo + QStringList{file}), 0);
        EXPECT_GT(QFileInfo(file).size(), 3000) << ending;
    }
    const QImage own(folder.filePath(QStringLiteral("rows.png")));
    EXPECT_GT(colorsIn(own), 50);
    const QString other = folder.filePath(QStringLiteral("other.png"));
    const QString variants = QStringLiteral("--variants");
    EXPECT_EQ(run(exportTo + QStringList{other, variants, QStringLiteral("subspan:error=0.5,opposed"),
                                         QStringLiteral("--row-width"), QStringLiteral("16384")}),
              0);
    EXPECT_NE(QImage(other), own);
    EXPECT_EQ(run(exportTo + QStringList{other, variants, QStringLiteral("fill")}), 2);
    EXPECT_EQ(run(exportTo + QStringList{other, QStringLiteral("--row-width"), QStringLiteral("1000000")}), 0);
    EXPECT_EQ(run(exportTo + QStringList{other, QStringLiteral("--row-width"), QStringLiteral("0")}), 2);
    // A slice that the map does not have is refused, instead of the last one being drawn.
    const QStringList slice{QStringLiteral("--export"), QStringLiteral("distance"), QStringLiteral("-o"),     other,
                            QStringLiteral("--axis"),   QStringLiteral("x"),        QStringLiteral("--slice")};
    EXPECT_EQ(run(slice + QStringList{QStringLiteral("63")}), 0);
    EXPECT_EQ(run(slice + QStringList{QStringLiteral("999")}), 2);
    EXPECT_EQ(run({variants, QStringLiteral("affine")}), 2);
}

}  // namespace

}  // namespace reliefui
