#include "windows/time_pane.h"

#include <QTableView>
#include <QVBoxLayout>

#include "panes/steps/step_table.h"
#include "panes/steps/steps_figure.h"
#include "windows/breakpoint_bar.h"
#include "windows/other_bar.h"
#include "windows/step_bar.h"

namespace reliefui {

PaneKind timePane() {
    PaneKind kind;
    kind.name = QStringLiteral("steps");
    kind.title = StepTable::tr("Steps");
    kind.help = StepTable::tr("The steps of the ray, one by one, and what each of them means");
    kind.place = DockPlace::Bottom;
    kind.make = makePane<TimePane>;
    kind.focus = [](QWidget* pane) -> QWidget* { return qobject_cast<TimePane*>(pane)->table()->table(); };
    kind.figures = {{"steps", true, plainFigure<stepsFigure>}};
    return kind;
}

TimePane::TimePane(Workspace* workspace, QWidget* parent)
    : QWidget(parent),
      bar_(new StepBar(workspace, this)),
      breakpoints_(new BreakpointBar(workspace, this)),
      other_(new OtherBar(workspace, this)),
      table_(new StepTable(workspace, this)) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar_);
    column->addWidget(breakpoints_);
    column->addWidget(other_);
    column->addWidget(table_, 1);
}

int TimePane::showBarOnly(bool only) {
    for (QWidget* const part : {static_cast<QWidget*>(breakpoints_), static_cast<QWidget*>(table_)}) {
        part->setVisible(!only);
    }
    const int height = bar_->sizeHint().height();
    setMaximumHeight(only ? height : QWIDGETSIZE_MAX);
    return height;
}

}  // namespace reliefui
