// The result view and the workspace behind it.
#include <algorithm>

#include <QApplication>
#include <QComboBox>
#include <QPainter>
#include <QWheelEvent>

#include "panes/result/pixel_values.h"
#include "panes/result/result_painting.h"
#include "relief/tracers.h"
#include "window_fixture.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
// Sanitizers make the program ten times slower, so moving pictures are smaller and fewer.
constexpr bool kAsSlowAsItIs = true;
#else
constexpr bool kAsSlowAsItIs = false;
#endif

// Traces the pixel's ray with the library alone.
relief::StepLog coreLog(const relief::Scenario& scenario, const relief::Assets& assets) {
    const relief::FrameRequest request = relief::frameRequest(scenario, assets);
    relief::Work work;
    relief::MapCache maps;
    const auto tracer = relief::makeTracer(scenario.method, request.field, maps, work);
    const auto ray = relief::pixelRay(request, scenario.pixel->x, scenario.pixel->y);
    relief::StepLog log;
    if (!ray) return log;
    relief::RayBlock rays;
    rays.push(*ray);
    relief::HitBlock hits;
    tracer->trace(rays, hits, log, work);
    return log;
}

TEST_F(WindowTest, ClickChoosesThePixelAndItsTraceIsTheCores) {
    openWindow(smallScenario());
    for (const QPoint pixel : {QPoint(70, 60), QPoint(120, 90), QPoint(40, 100)}) {
        QTest::mouseClick(window_->result(), Qt::LeftButton, Qt::NoModifier, onScreen(pixel.x(), pixel.y()));
        waitForFull();
        ASSERT_TRUE(scenario().pixel.has_value());
        EXPECT_EQ(scenario().pixel->x, pixel.x());
        EXPECT_EQ(scenario().pixel->y, pixel.y());
        const PixelTrace& trace = snapshot()->trace;
        const relief::StepLog log = coreLog(scenario(), snapshot()->assets);
        EXPECT_EQ(trace.steps, log.steps);
        ASSERT_TRUE(trace.onRelief);
        EXPECT_EQ(trace.reads, log.reads.front());
        EXPECT_EQ(scenario().step, 0) << "the search before its answer";
        EXPECT_EQ(snapshot()->scenario, scenario());
    }
}

TEST_F(WindowTest, ThePictureIsTheFrames) {
    openWindow(smallScenario());
    ResultView* const view = window_->result();
    QTest::keyClick(view, Qt::Key_R);
    const QImage shown = grab(view);
    const QImage& picture = snapshot()->picture;
    ASSERT_EQ(picture.size(), QSize(200, 150));
    ASSERT_GT(colorsIn(picture), 100);
    int compared = 0;
    for (int y = 5; y < 150; y += 13) {
        for (int x = 5; x < 200; x += 11) {
            const QPoint at = onScreen(x, y);
            // The ring and the magnifier cover parts of the picture.
            if ((at - onScreen(90, 80)).manhattanLength() < 40 || (at.x() > view->width() / 2 && at.y() < 200))
                continue;
            EXPECT_EQ(shown.pixelColor(at), picture.pixelColor(x, y)) << x << "," << y;
            ++compared;
        }
    }
    EXPECT_GT(compared, 80);
    EXPECT_NE(shown.pixelColor(onScreen(90, 80) + QPoint(9, 0)), shown.pixelColor(onScreen(100, 80)));
}

TEST_F(WindowTest, ArrowsMoveThePixel) {
    openWindow(smallScenario());
    ResultView* const view = window_->result();
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Right);
    QTest::keyClick(view, Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(*scenario().pixel, (relief::PixelChoice{91, 90}));
    QTest::keyClick(view, Qt::Key_Left, Qt::ShiftModifier);
    QTest::keyClick(view, Qt::Key_Up);
    EXPECT_EQ(*scenario().pixel, (relief::PixelChoice{81, 89}));
    for (int i = 0; i < 30; ++i) QTest::keyClick(view, Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_EQ(*scenario().pixel, (relief::PixelChoice{0, 89}));
    waitForFull();
    EXPECT_EQ(snapshot()->trace.pixel, (relief::PixelChoice{0, 89}));
    // A sequence of keys is one change.
    workspace_->undo();
    EXPECT_EQ(*scenario().pixel, (relief::PixelChoice{90, 80}));
}

TEST_F(WindowTest, DraggingDrawsCoarseThenFull) {
    relief::Scenario large = smallScenario();
    large.width = 1600;
    large.height = 1200;
    openWindow(large);
    std::vector<bool> coarse;
    double slowest = 0;
    QObject::connect(workspace_.get(), &Workspace::snapshotChanged, window_.get(), [&] {
        coarse.push_back(snapshot()->coarse);
        if (snapshot()->coarse) slowest = std::max(slowest, snapshot()->frame->seconds);
        EXPECT_GT(colorsIn(snapshot()->picture), 30) << "never blank";
        if (snapshot()->coarse) {
            EXPECT_LT(snapshot()->picture.width(), 1600);
        }
    });
    ResultView* const view = window_->result();
    const QPoint from(view->width() / 2, view->height() / 2);
    const double azimuth = scenario().camera.azimuth;
    QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, from);
    for (int i = 1; i <= 30; ++i) {
        QTest::mouseMove(view, from + QPoint(4 * i, 0));
        QTest::qWait(10);
    }
    const std::size_t during = coarse.size();
    QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, from + QPoint(120, 0));
    waitForFull();
    EXPECT_GE(during, kAsSlowAsItIs ? 0U : 3U) << "pictures are shown during the drag";
    ASSERT_GT(coarse.size(), during);
    EXPECT_TRUE(
        std::all_of(coarse.begin(), coarse.begin() + static_cast<std::ptrdiff_t>(during), [](bool c) { return c; }));
    EXPECT_FALSE(coarse.back());
    EXPECT_LT(scenario().camera.azimuth, azimuth);
    // At rest the picture equals one rendered without dragging.
    relief::Work work;
    EXPECT_EQ(snapshot()->picture, SnapshotMaker().make({scenario()}, work)->picture);
    std::printf("%zu coarse frames in 30 moves, the slowest took %.0f ms\n", during, slowest * 1000);
    // The whole drag is one change.
    workspace_->undo();
    EXPECT_EQ(scenario().camera.azimuth, azimuth);
}

// The full picture with this filter takes a minute: while the camera moves, a picture with plain filtering is shown.
TEST_F(WindowTest, DraggingDoesNotWaitForASlowFilter) {
    relief::Scenario slow = smallScenario();
    slow.width = 800;
    slow.height = 600;
    openWindow(slow);
    slow = scenario();
    slow.filter.name = "elliptical-visible";
    slow.filter.options = {{"form", "position-area"}};
    workspace_->change(slow, QStringLiteral("test"));
    EXPECT_TRUE(workspace_->busy());
    bool seen = false;
    for (int n = 0; n < 200 && !seen; ++n) {
        slow.camera.azimuth += 1;
        workspace_->change(slow, QStringLiteral("test"), QStringLiteral("drag"), true);
        QTest::qWait(50);
        const relief::FrameRequest& drawn = *snapshot()->request;
        seen = snapshot()->coarse && drawn.filter.name == "elliptical" && (kAsSlowAsItIs || drawn.width == 800);
    }
    EXPECT_TRUE(seen);
    workspace_->cancel();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !workspace_->busy(); }, 20000));
    // Cancels at various times of a moving picture, also when rendering no longer checks for cancellation.
    for (int n = 0; n < 40; ++n) {
        slow.camera.azimuth -= 1;
        workspace_->change(slow, QStringLiteral("test"), QStringLiteral("drag"), true);
        QTest::qWait(3 * n);
        workspace_->cancel();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace_->busy(); }, 20000)) << "after " << 3 * n << " ms";
        slow = scenario();
    }
}

TEST_F(WindowTest, WheelMovesTheCameraAndSettles) {
    openWindow(smallScenario());
    ResultView* const view = window_->result();
    const double distance = scenario().camera.distance;
    QWheelEvent wheel(QPointF(50, 50), view->mapToGlobal(QPoint(50, 50)), {}, QPoint(0, 120), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(view, &wheel);
    EXPECT_LT(scenario().camera.distance, distance);
    waitForFull();
    // With Ctrl the picture is enlarged around the pointer, and the camera does not move.
    const QPointF at = onScreen(90, 80);
    const double before = scenario().camera.distance;
    const QPointF fixed = view->toPicture(at);
    QWheelEvent zoom(at, view->mapToGlobal(at.toPoint()), {}, QPoint(0, 240), Qt::NoButton, Qt::ControlModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(view, &zoom);
    EXPECT_EQ(scenario().camera.distance, before);
    EXPECT_NEAR(view->toPicture(at).x(), fixed.x(), 1e-6);
    EXPECT_NEAR(view->toPicture(at).y(), fixed.y(), 1e-6);
    EXPECT_GT(view->toWidget({1, 0}).x() - view->toWidget({0, 0}).x(), 1.5);
}

TEST_F(WindowTest, LayersAreDrawn) {
    openWindow(smallScenario());
    auto* const layers = window_->findChild<QComboBox*>(QStringLiteral("layer"));
    ASSERT_NE(layers, nullptr);
    ASSERT_EQ(layers->count(), kLayers);
    for (int i = 1; i < kLayers; ++i) {
        layers->setCurrentIndex(i);
        waitForFull();
        EXPECT_EQ(snapshot()->layer.layer, static_cast<Layer>(i));
        // If the filter does not compute the layer's values, it has one colour, and its legend explains why.
        EXPECT_EQ(colorsIn(snapshot()->layer.image) > 1, snapshot()->layer.applies) << i;
        EXPECT_EQ(snapshot()->picture.size(), snapshot()->layer.image.size());
        EXPECT_GT(colorsIn(grab(window_->result())), 2) << i;
    }
    layers->setCurrentIndex(1);
    waitForFull();
    const auto& steps = snapshot()->frame->hits->hits.steps;
    EXPECT_EQ(snapshot()->layer.ends.high, *std::max_element(steps.begin(), steps.end()));
}

// Zoomed in so far that a pixel has room for text, its values are shown.
TEST_F(WindowTest, LargePixelsHaveTheirValues) {
    openWindow(smallScenario());
    ResultView* const view = window_->result();
    const QPointF at = onScreen(60, 70);
    const auto zoomTo = [&](double side) {
        for (int k = 0; k < 60 && onScreen(61, 70).x() - onScreen(60, 70).x() < side; ++k) {
            QWheelEvent wheel(at, view->mapToGlobal(at.toPoint()), {}, {0, 120}, Qt::NoButton, Qt::ControlModifier,
                              Qt::NoScrollPhase, false);
            QApplication::sendEvent(view, &wheel);
        }
    };
    const auto colorsOfPixel = [&](int x, int y) {
        const QRect pixel(onScreen(x, y) - QPoint(8, 12), QSize(16, 24));
        return colorsIn(grab(view).copy(pixel));
    };
    zoomTo(30);
    EXPECT_EQ(colorsOfPixel(60, 70), 1);
    zoomTo(64);
    EXPECT_GT(colorsOfPixel(60, 70), 4);
    const QColor color = snapshot()->picture.pixelColor(60, 70);
    EXPECT_EQ(pixelValues(*snapshot(), 60, 70).join(' '),
              QStringLiteral("R %1 G %2 B %3").arg(color.red()).arg(color.green()).arg(color.blue()));
    for (int l = 1; l < kLayers; ++l) {
        workspace_->setLayer(static_cast<Layer>(l));
        waitForFull();
        const QStringList values = pixelValues(*snapshot(), 60, 70);
        if (!snapshot()->layer.applies) continue;
        ASSERT_FALSE(values.isEmpty()) << l;
        EXPECT_GT(colorsOfPixel(60, 70), 2) << l << ": " << values.join(' ').toStdString();
    }
}

TEST_F(WindowTest, RShowsTheWholePictureAgain) {
    openWindow(smallScenario());
    ResultView* const view = window_->result();
    view->setFocus();
    const QPointF before = onScreen(60, 70);
    QTest::keyClick(view, Qt::Key_Plus, Qt::ControlModifier);
    const QPointF zoomed = onScreen(60, 70);
    EXPECT_NE(zoomed, before);
    QTest::keyClick(view, Qt::Key_R, Qt::ControlModifier);
    EXPECT_EQ(onScreen(60, 70), zoomed) << "that is another key";
    QTest::keyClick(view, Qt::Key_R);
    EXPECT_EQ(onScreen(60, 70), before);
}

// Each of the pixels around one is a square of its colour; only that one has an outline.
TEST(Magnifier, ShowsThePixelsAroundOne) {
    QImage image(40, 40, QImage::Format_RGB32);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) image.setPixelColor(x, y, QColor(6 * x, 6 * y, 99));
    }
    const Style style;
    const QRect frame(QPoint(4, 3), magnifierSize(style, 1000));
    QImage shown(frame.size() + QSize(10, 10), QImage::Format_RGB32);
    QPainter painter(&shown);
    paintMagnifier(painter, image, {20, 20}, frame, style);
    painter.end();
    const int side = (frame.width() - 2) / kMagnified;
    constexpr int kHalf = kMagnified / 2;
    for (int j = -kHalf; j <= kHalf; ++j) {
        for (int i = -kHalf; i <= kHalf; ++i) {
            if (std::abs(i) <= 1 && std::abs(j) <= 1) continue;  // the outline
            const QPoint at = frame.topLeft() + QPoint(1, 1) + side * QPoint(i + kHalf, j + kHalf);
            const QColor own = image.pixelColor(20 + i, 20 + j);
            EXPECT_EQ(shown.pixelColor(at), own) << i << " " << j;
            EXPECT_EQ(shown.pixelColor(at + QPoint(side - 1, side - 1)), own) << i << " " << j;
        }
    }
}

TEST(PixelReadout, IsBriefOnlyOnRequest) {
    relief::Work work;
    const auto snapshot = SnapshotMaker().make({smallScenario()}, work);
    const QStringList brief = pixelReadout(*snapshot, {60, 70}, true);
    const QStringList whole = pixelReadout(*snapshot, {60, 70});
    EXPECT_FALSE(brief.isEmpty());
    EXPECT_GT(whole.size(), brief.size());
}

TEST_F(WindowTest, TheErrorLayerIsTheCores) {
    relief::Scenario layers = smallScenario();
    layers.method = {"layers", {{"layers", "6"}}};
    openWindow(layers);
    workspace_->setLayer(Layer::Error);
    waitForFull();
    const LayerPicture& layer = snapshot()->layer;
    ASSERT_NE(layer.error, nullptr);
    relief::MapCache maps;
    relief::Work work;
    const auto core = relief::errorAgainstExact(*snapshot()->frame, *snapshot()->request, maps, work);
    EXPECT_EQ(layer.error->kinds, core.kinds);
    EXPECT_GT(core.counts[static_cast<std::size_t>(relief::ErrorKind::Past)], 0);
    EXPECT_FLOAT_EQ(static_cast<float>(layer.ends.high), static_cast<float>(core.largest));
    std::array<int, relief::kErrorKinds> seen{};
    for (int y = 0; y < 150; ++y) {
        for (int x = 0; x < 200; ++x) {
            const std::size_t i = snapshot()->frame->index(x, y);
            const QRgb color = layer.image.pixel(x, y);
            ++seen[static_cast<std::size_t>(core.kinds[i])];
            if (core.kinds[i] == relief::ErrorKind::Right) {
                EXPECT_EQ(color, kNoError);
            }
            // The two kinds of error have the colours of the two sides of the map, whatever their size.
            if (core.kinds[i] == relief::ErrorKind::Short) {
                EXPECT_GT(qBlue(color), qRed(color)) << x << "," << y;
            }
            if (core.kinds[i] != relief::ErrorKind::Past) continue;
            EXPECT_GT(qRed(color), qBlue(color)) << x << "," << y;
            const QString read = pixelReadout(*snapshot(), {x, y}, true).join(' ');
            EXPECT_TRUE(read.contains(QStringLiteral("overshoot"))) << read.toStdString();
        }
    }
    for (const auto kind : {relief::ErrorKind::None, relief::ErrorKind::Past}) {
        EXPECT_EQ(seen[static_cast<std::size_t>(kind)], core.counts[static_cast<std::size_t>(kind)]);
    }
    // Layers that are not displayed are not computed.
    workspace_->setLayer(Layer::Steps);
    waitForFull();
    EXPECT_EQ(snapshot()->layer.error, nullptr);
}

TEST_F(WindowTest, APictureTakesItsLegendAlongOnRequest) {
    openWindow(smallScenario());
    for (int i = 1; i < kLayers; ++i) {
        workspace_->setLayer(static_cast<Layer>(i));
        waitForFull();
        const LayerPicture& layer = snapshot()->layer;
        const QImage whole = withLegend(layer.image, layer, workspace_->style());
        const QSize legend = paintLegend(nullptr, layer, {}, workspace_->style(), layer.image.width());
        EXPECT_EQ(whole.height(), layer.image.height() + legend.height());
        EXPECT_GE(whole.width(), legend.width());
        EXPECT_EQ(whole.copy(layer.image.rect()), layer.image);
        EXPECT_GT(colorsIn(whole.copy(0, layer.image.height(), whole.width(), legend.height())), 3) << i;
    }
}

}  // namespace

}  // namespace reliefui
