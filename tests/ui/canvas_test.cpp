// Interaction that all two-dimensional panes share: picking, zooming, panning, Cyrillic text.
#include <cmath>

#include "panes/drawing_canvas.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/ray_geometry.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

TEST_F(WindowTest, AClickOnAVisitedTexelChoosesItsStep) {
    openWindow(deepRay());
    PyramidView* const view = window_->pane<PyramidView>();
    grab(view->canvas());
    const auto steps = snapshot()->trace.steps;
    int clicked = 0;
    for (const relief::Step& step : steps) {
        const LevelBlock& block = view->blocks()[static_cast<std::size_t>(step.level)];
        const auto boxes =
            wrapped(stepBox(snapshot()->request->field, step).cut(Box{-1e9, -1e9, 1e9, 1e9}), block.domain, false);
        if (boxes.empty()) continue;
        const Box box = block.toDrawing(boxes.front());
        // Away from the centre, where the ray may be.
        const Point at{box.x0 + 0.25 * box.width(), box.y0 + 0.75 * box.height()};
        if (view->canvas()->itemAt(view->canvas()->toWidget(at)).kind != ItemKind::Step) continue;
        QTest::mouseClick(view->canvas(), Qt::LeftButton, Qt::NoModifier, view->canvas()->toWidget(at).toPoint());
        const relief::Step& chosen = steps[static_cast<std::size_t>(scenario().step)];
        EXPECT_EQ(chosen.level, step.level);
        ++clicked;
    }
    EXPECT_GE(clicked, 3);
}

TEST_F(WindowTest, TheCanvasZoomsAtThePointerAndComesBack) {
    openWindow(smallScenario());
    DrawingCanvas* const canvas = window_->pane<PyramidView>()->canvas();
    const Box box = window_->pane<PyramidView>()->blocks().front().box;
    const Point corner{box.x0 + box.width() / 4, box.y0 + box.height() / 4};
    const QImage before = grab(canvas);
    const QPointF at = canvas->toWidget(corner);
    const double width = canvas->toWidget({box.x1, 0}).x() - canvas->toWidget({box.x0, 0}).x();
    QWheelEvent wheel(at, canvas->mapToGlobal(at.toPoint()), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(canvas, &wheel);
    EXPECT_NEAR(canvas->toWidget(corner).x(), at.x(), 1e-6);
    EXPECT_NEAR(canvas->toWidget(corner).y(), at.y(), 1e-6);
    EXPECT_NEAR(canvas->toWidget({box.x1, 0}).x() - canvas->toWidget({box.x0, 0}).x(), width * 1.5625, 1e-6);
    EXPECT_NE(grab(canvas), before);
    const QPoint from(canvas->width() / 2, canvas->height() / 2);
    QTest::mousePress(canvas, Qt::LeftButton, Qt::NoModifier, from);
    QTest::mouseMove(canvas, from + QPoint(10, 4));
    QMouseEvent move(QEvent::MouseMove, from + QPoint(30, 12), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
    QTest::mouseRelease(canvas, Qt::LeftButton, Qt::NoModifier, from + QPoint(30, 12));
    EXPECT_NEAR(canvas->toWidget(corner).x(), at.x() + 30, 1.5);
    QTest::keyClick(canvas, Qt::Key_R);
    EXPECT_EQ(grab(canvas), before);
}

TEST_F(WindowTest, HoverReadsValuesOut) {
    openWindow(smallScenario());
    PyramidView* const view = window_->pane<PyramidView>();
    const LevelBlock top = view->blocks().back();
    const QPointF at = view->canvas()->toWidget({top.box.x0 + 3, top.box.y1 - 3});
    QMouseEvent move(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(view->canvas(), &move);
    EXPECT_TRUE(view->readout().contains(QString::number(top.level))) << view->readout().toStdString();
    EXPECT_TRUE(view->readout().contains(QStringLiteral("(0, 0)"))) << view->readout().toStdString();
}

// The picture below a resting pointer changes: what is read out is what lies there, until the pointer leaves.
TEST_F(WindowTest, ARestingPointerReadsOutWhatComesUnderIt) {
    openWindow(smallScenario());
    QString ofResult;
    QObject::connect(window_->result(), &ResultView::hovered, [&](const QString& text) { ofResult = text; });
    PyramidView* const view = window_->pane<PyramidView>();
    const QPoint pixel = onScreen(50, 40);
    const LevelBlock top = view->blocks().back();
    const QPointF texel = view->canvas()->toWidget({top.box.x0 + 3, top.box.y1 - 3});
    for (const auto& [widget, at] : {std::pair<QWidget*, QPointF>{window_->result(), pixel}, {view->canvas(), texel}}) {
        QMouseEvent move(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(widget, &move);
    }
    const auto turn = [&](const char* recipe) {
        relief::Scenario next = scenario();
        next.pictures.recipe = recipe;
        next.camera.azimuth += 20;
        workspace_->change(next, QStringLiteral("test"));
        waitForFull();
        QTest::qWait(30);
    };
    const QString pixelBefore = ofResult, texelBefore = view->readout();
    turn("fractal");
    EXPECT_NE(ofResult, pixelBefore);
    EXPECT_NE(view->readout(), texelBefore);
    EXPECT_TRUE(view->readout().contains(QStringLiteral("(0, 0)"))) << view->readout().toStdString();
    for (QWidget* const widget : {static_cast<QWidget*>(window_->result()), static_cast<QWidget*>(view->canvas())}) {
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(widget, &leave);
    }
    turn("bricks");
    EXPECT_TRUE(ofResult.isEmpty());
    EXPECT_TRUE(view->readout().isEmpty());
}

TEST_F(WindowTest, CyrillicLettersAreDrawnByVtk) {
    DrawingCanvas canvas;
    canvas.resize(300, 100);
    canvas.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
    const auto ink = [&](const char* text) {
        auto drawing = std::make_shared<Drawing>();
        drawing->bounds = {0, 0, 100, 30};
        Label label;
        label.at = {50, 15};
        label.anchor = Anchor::Center;
        label.size = 2;
        label.text = plainText(text);
        drawing->add({}, Role::Label, label);
        canvas.setLayers({drawing}, nullptr);
        const QImage shown = grab(&canvas);
        int count = 0;
        for (int y = 0; y < shown.height(); ++y) {
            for (int x = 0; x < shown.width(); ++x) count += shown.pixelColor(x, y).lightness() > 128 ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(ink(" "), 0);
    EXPECT_GT(ink("H"), 20);
    EXPECT_NEAR(ink("Н"), ink("H"), 12) << "the Cyrillic letter looks like the Latin one";
    EXPECT_GT(ink("рівень"), 3 * ink("H"));
}

}  // namespace

}  // namespace reliefui
