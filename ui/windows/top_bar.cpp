#include "windows/top_bar.h"

#include <QComboBox>
#include <QLabel>
#include <QStandardItemModel>

#include "panes/core_texts.h"
#include "panes/number_control.h"
#include "windows/scene_panel.h"
#include "workspace/pause_log.h"

namespace reliefui {

TopBar::TopBar(Workspace* workspace, QAction* open, const QList<QAction*>& others, QWidget* parent)
    : QToolBar(tr("Main bar"), parent),
      workspace_(workspace),
      method_(new QComboBox(this)),
      filter_(new QComboBox(this)),
      depth_(makeNumberControl(workspace, "relief-depth", this)) {
    setObjectName(QStringLiteral("top-bar"));
    setMovable(false);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    addAction(open);
    addSeparator();
    makeMethod();
    makeFilter();
    depth_->setObjectName(QStringLiteral("top-relief-depth"));
    depth_->setMaximumWidth(260);
    addLabeled(controlTitle("relief-depth"), depth_);
    addSeparator();
    for (QAction* const action : others) addAction(action);
    connect(workspace_, &Workspace::scenarioChanged, this, &TopBar::refresh);
    refresh();
}

void TopBar::addLabeled(const QString& label, QWidget* control) {
    auto* const text = new QLabel(QStringLiteral("  ") + label + QStringLiteral(" "), this);
    text->setBuddy(control);
    text->setToolTip(control->toolTip());
    addWidget(text);
    addWidget(control);
}

void TopBar::addMethods(bool tracers, const QString& group) {
    bool first = true;
    for (const relief::MethodDescription& method : relief::tracerList()) {
        if ((method.kind == relief::MethodKind::Tracer) != tracers || method.kind == relief::MethodKind::AnyHit)
            continue;
        if (first && !group.isEmpty()) {
            method_->insertSeparator(method_->count());
            method_->addItem(group);
            // A heading: not to be chosen.
            if (auto* const items = qobject_cast<QStandardItemModel*>(method_->model())) {
                items->item(method_->count() - 1)->setFlags(Qt::NoItemFlags);
            }
        }
        first = false;
        const QString name = QString::fromStdString(method.name);
        method_->addItem(name, name);
        method_->setItemData(method_->count() - 1, coreText(method.help), Qt::ToolTipRole);
    }
}

void TopBar::makeMethod() {
    method_->setObjectName(QStringLiteral("method"));
    method_->setAccessibleName(tr("Method"));
    method_->setToolTip(tr("How the ray searches for the relief"));
    method_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    addMethods(true, {});
    addMethods(false, tr("no search"));
    addLabeled(tr("Method"), method_);
    connect(method_, qOverload<int>(&QComboBox::activated), this, [this](int) {
        relief::Scenario scenario = workspace_->scenario();
        scenario.method = {};
        scenario.method.name = method_->currentData().toString().toStdString();
        workspace_->change(scenario, tr("Method"));
    });
}

void TopBar::makeFilter() {
    filter_->setObjectName(QStringLiteral("filter"));
    filter_->setAccessibleName(tr("Filter"));
    filter_->setToolTip(tr("How the colour is read at the hit"));
    filter_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (const relief::FilterDescription& filter : relief::filterList()) {
        const QString name = QString::fromStdString(filter.name);
        filter_->addItem(name, name);
        filter_->setItemData(filter_->count() - 1, coreText(filter.help), Qt::ToolTipRole);
    }
    addLabeled(tr("Filter"), filter_);
    connect(filter_, qOverload<int>(&QComboBox::activated), this, [this](int) {
        relief::Scenario scenario = workspace_->scenario();
        scenario.filter.name = filter_->currentData().toString().toStdString();
        scenario.filter.options.clear();  // another filter takes none of them
        workspace_->change(scenario, tr("Filter"));
    });
}

void TopBar::refresh() {
    const PauseLog::Part part("top bar");
    const relief::Scenario& scenario = workspace_->scenario();
    method_->setCurrentIndex(method_->findData(QString::fromStdString(scenario.method.name)));
    filter_->setCurrentIndex(filter_->findData(QString::fromStdString(scenario.filter.name)));
}

}  // namespace reliefui
