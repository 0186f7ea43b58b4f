// Default arrangement of the panes and shares of the window's area, as a table: for the desktop, a small desktop, a
// projector and teaching.
#pragma once

#include <QSize>

namespace reliefui {

struct LayoutPlan {
    // show the panes at the left; if false, those of them that display something join the stack at the right
    bool controls = true;
    bool oneStack = false;  // the panes at the right form one stack of tabs instead of two
    bool table = true;      // show the table of steps at the bottom; if false, only the bar for stepping
    // Shares of the window's width (left, right) and height (steps); upper: share of the right column's height.
    double left = 0.2;
    double right = 0.36;
    double steps = 0.23;
    double upper = 5.0 / 9;
};

// window: size in points.
LayoutPlan layoutPlan(bool teaching, bool projector, const QSize& window);

}  // namespace reliefui
