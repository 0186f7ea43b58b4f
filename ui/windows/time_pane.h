// The time pane: the bar for stepping and playing, breakpoints, rays of another program's tracer, the table of steps.
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

    // All: everything, for work at a desk. Bar: only the bar for stepping. BarAndSentence: also the step in words, if
    // no other widget shows it.
    enum class Parts : std::uint8_t { All, Bar, BarAndSentence };
    // Shows these parts; returns the height that they need. All uses whatever height is available.
    int showParts(Parts parts);

  private:
    StepBar* bar_;
    BreakpointBar* breakpoints_;
    OtherBar* other_;
    StepTable* table_;
    StepSentence* sentence_;
};

}  // namespace reliefui
