// Where the panes stand and how the window's room is shared: what is arranged at first, on a projector and for
// teaching, as a table.
#pragma once

#include <QSize>

namespace reliefui {

struct LayoutPlan {
    bool controls = true;   // the panes at the left; else only those of them that show something stand in the stack
    bool oneStack = false;  // the panes at the right stand behind each other in one stack of tabs, else in two
    bool table = true;      // below: the table of steps; else only the bar that steps
    // Parts of the window: the panes at the left and right, the steps; of the panes at the right, those above.
    double left = 0.2;
    double right = 0.36;
    double steps = 0.23;
    double upper = 5.0 / 9;
};

// window: in points.
LayoutPlan layoutPlan(bool teaching, bool projector, const QSize& window);

}  // namespace reliefui
