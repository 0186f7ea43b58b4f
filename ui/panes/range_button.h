// A button that opens the choice of a colour range: linear or logarithmic, all values, percentiles or own ends, a
// threshold, above them the legend with the histogram. What is chosen goes into the scenario, as all choices of panes.
#pragma once

#include <functional>
#include <optional>

#include <QPointer>
#include <QToolButton>

#include "painting/range_legend.h"

namespace reliefui {

class Workspace;
class RangeBox;

class RangeButton : public QToolButton {
    Q_OBJECT
  public:
    // What is shown in colours now; none: nothing that has a range.
    using Shown = std::function<std::optional<RangedValues>()>;
    RangeButton(Workspace* workspace, Shown shown, QWidget* parent);

    // At the button, wherever the click came from.
    void open();
    // Enabled where there is a range to be chosen; to be called when something else is shown.
    void refresh();

  private:
    Workspace* workspace_;
    Shown shown_;
    QPointer<RangeBox> box_;
};

}  // namespace reliefui
