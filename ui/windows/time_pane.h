// Time: the bar that steps and plays, breakpoints, somebody else's tracer, the table of steps.
#pragma once

#include <cstdint>

#include <QWidget>

#include "panes/pane.h"

namespace reliefui {

class BreakpointBar;
class OtherBar;
class StepBar;
class StepSentence;
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

    // All: what a student works with. Bar: below something that is looked at. BarAndSentence: where nothing else says
    // the sentence.
    enum class Parts : std::uint8_t { All, Bar, BarAndSentence };
    // The height that they need; All takes what there is.
    int showParts(Parts parts);

  private:
    StepBar* bar_;
    BreakpointBar* breakpoints_;
    OtherBar* other_;
    StepTable* table_;
    StepSentence* sentence_;
};

}  // namespace reliefui
