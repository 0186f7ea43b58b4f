#include "panes/skipped/skipped_pane.h"

#include "panes/skipped/skipped_figure.h"
#include "panes/skipped/skipped_panel.h"

namespace reliefui {

PaneKind skippedPane() {
    PaneKind kind;
    kind.name = QStringLiteral("skipped");
    kind.title = SkippedPanel::tr("Skipped");
    kind.help = SkippedPanel::tr("Work that was skipped for the picture, and why");
    kind.place = DockPlace::Bottom;
    kind.make = makePane<SkippedPanel>;
    kind.figures = {{"skipped", true, plainFigure<skippedFigure>}};
    kind.open = false;  // opened from the menu, by its key or from the status bar
    return kind;
}

}  // namespace reliefui
