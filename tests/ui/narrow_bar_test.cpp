// A row of controls that is wider than its room.
#include "panes/narrow_bar.h"

#include <QLabel>
#include <QScrollBar>
#include <QWheelEvent>

#include "window_fixture.h"

namespace reliefui {
namespace {

class NarrowBarTest : public WindowTest {};

// As in every list: the wheel turned towards the user, or a swipe to the left, shows what comes later.
TEST_F(NarrowBarTest, TheWheelGoesOnAndBack) {
    QWidget face;
    NarrowBar bar(&face);
    bar.row()->addWidget(new QLabel(QString(200, QLatin1Char('x'))));
    face.resize(200, 60);
    bar.resize(200, 40);
    face.show();
    QTest::qWait(50);
    // A pane is drawn only where something of it is seen, be it behind its controls.
    EXPECT_TRUE(face.visibleRegion().contains(bar.geometry().center()));
    const auto turn = [&](QPoint by) {
        const int before = bar.horizontalScrollBar()->value();
        QWheelEvent wheel({10, 10}, bar.viewport()->mapToGlobal(QPoint(10, 10)), {}, by, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(bar.viewport(), &wheel);
        return bar.horizontalScrollBar()->value() - before;
    };
    EXPECT_GT(turn({0, -120}), 0);
    EXPECT_LT(turn({0, 120}), 0);
    EXPECT_GT(turn({-120, 0}), 0);
    EXPECT_LT(turn({120, 0}), 0);
}

}  // namespace
}  // namespace reliefui
