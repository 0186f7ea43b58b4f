#include "windows/filter_box.h"

#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>

#include "panes/core_texts.h"
#include "panes/options_form.h"
#include "scenario/variation.h"
#include "workspace/change_name.h"

namespace reliefui {

FilterBox::FilterBox(Workspace* workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), help_(new QLabel(this)), options_(new OptionsForm(this)) {
    setObjectName(QStringLiteral("filter-box"));
    help_->setWordWrap(true);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(help_);
    column->addWidget(options_);
    connect(workspace_, &Workspace::scenarioChanged, this, &FilterBox::refresh);
    connect(options_, &OptionsForm::editFinished, workspace_, &Workspace::finishInteraction);
    connect(options_, &OptionsForm::changed, this, &FilterBox::change);
    refresh();
}

void FilterBox::change(const QString& name, const QString& text, bool live) {
    const relief::Scenario& scenario = workspace_->scenario();
    relief::MethodChoice choice = relief::ownVariation(scenario, relief::CompareSubject::Filters);
    choice.options[name.toStdString()] = text.toStdString();
    workspace_->change(relief::varied(scenario, relief::CompareSubject::Filters, choice),
                       changeName([name] { return optionTitle(name.toStdString()); }), QStringLiteral("filter-") + name,
                       live);
}

void FilterBox::refresh() {
    const relief::MethodChoice choice = relief::ownVariation(workspace_->scenario(), relief::CompareSubject::Filters);
    const relief::MethodDescription described = relief::describedVariation(relief::CompareSubject::Filters, choice);
    QString help = coreText(described.help);
    if (!help.isEmpty()) help[0] = help[0].toUpper();  // it is a sentence here
    help_->setText(tr("<b>%1</b>. %2").arg(titleText(described.title), help));
    help_->setToolTip(QStringList{QString::fromStdString(described.name), QString::fromStdString(described.source)}
                          .join('\n')
                          .trimmed());
    options_->setVisible(!described.options.empty());
    options_->show(described, choice);
}

}  // namespace reliefui
