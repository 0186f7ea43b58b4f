// A button that opens the dialog for a colour range: linear or logarithmic, all values, percentiles or own ends, a
// threshold, and above them the legend with the histogram. The choice is stored in the scenario, as for all panes.
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
    // Returns the values currently shown in colours; std::nullopt if nothing shown has a range.
    using Shown = std::function<std::optional<RangedValues>()>;
    RangeButton(Workspace* workspace, Shown shown, QWidget* parent);

    // Opens the dialog at the button, even if a click on the legend triggered it.
    void open();
    // Enables the button if there is a range to choose; call it when something else is shown.
    void refresh();

  private:
    Workspace* workspace_;
    Shown shown_;
    QPointer<RangeBox> box_;
};

}  // namespace reliefui
