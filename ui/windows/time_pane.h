// Time: the bar that steps and plays, breakpoints, somebody else's tracer, the table of steps.
#pragma once

#include <QWidget>

#include "panes/pane.h"

namespace reliefui {

class BreakpointBar;
class OtherBar;
class StepBar;
class StepTable;
class Workspace;

PaneKind timePane();

class TimePane : public QWidget {
    Q_OBJECT
  public:
    TimePane(Workspace* workspace, QWidget* parent = nullptr);

    StepBar* bar() { return bar_; }
    BreakpointBar* breakpoints() { return breakpoints_; }
    OtherBar* other() { return other_; }
    StepTable* table() { return table_; }

    // Below a pane that fills the window only the bar is shown. Its height then.
    int showBarOnly(bool only);

  private:
    StepBar* bar_;
    BreakpointBar* breakpoints_;
    OtherBar* other_;
    StepTable* table_;
};

}  // namespace reliefui
