#include "windows/time_pane.h"

#include <QTableView>
#include <QVBoxLayout>

#include "panes/steps/step_sentence.h"
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
    kind.figures = {{"steps", true, [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         return stepsFigure(std::move(s), now.step);
                     }}};
    return kind;
}

TimePane::TimePane(Workspace* workspace, QWidget* parent)
    : QWidget(parent),
      bar_(new StepBar(workspace, this)),
      breakpoints_(new BreakpointBar(workspace, this)),
      other_(new OtherBar(workspace, this)),
      table_(new StepTable(workspace, this)),
      sentence_(new StepSentence(workspace, this)) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar_);
    column->addWidget(breakpoints_);
    column->addWidget(other_);
    column->addWidget(table_, 1);
    column->addWidget(sentence_);
    sentence_->hide();
}

int TimePane::showParts(Parts parts) {
    const bool all = parts == Parts::All;
    breakpoints_->setVisible(all);
    table_->setVisible(all);
    sentence_->setVisible(parts == Parts::BarAndSentence);
    const int strip = sentence_->sizeHint().height() * 3 / 2;
    sentence_->setFixedHeight(strip);
    const int height = bar_->sizeHint().height() + (sentence_->isHidden() ? 0 : strip);
    setMaximumHeight(all ? QWIDGETSIZE_MAX : height);
    return height;
}

}  // namespace reliefui
