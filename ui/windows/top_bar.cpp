#include "windows/top_bar.h"

#include <QComboBox>
#include <QLabel>

#include "panes/core_texts.h"
#include "panes/name_box.h"
#include "panes/number_control.h"
#include "windows/method_list.h"
#include "windows/scene_panel.h"
#include "workspace/change_name.h"
#include "workspace/pause_log.h"

namespace reliefui {

TopBar::TopBar(Workspace* workspace, QAction* open, const QList<QAction*>& others, QWidget* parent)
    : QToolBar(tr("Main bar"), parent),
      workspace_(workspace),
      method_(new NameBox(this)),
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

void TopBar::makeMethod() {
    method_->setObjectName(QStringLiteral("method"));
    method_->setAccessibleName(tr("Method"));
    method_->setToolTip(tr("How the ray searches for the relief"));
    fillMethods(method_);
    addLabeled(tr("Method"), method_);
    connect(method_, qOverload<int>(&QComboBox::activated), this, [this](int) {
        relief::Scenario scenario = workspace_->scenario();
        const std::string name = method_->currentData().toString().toStdString();
        if (name == scenario.method.name) return;  // chosen again, it keeps its options
        scenario.method = {name, {}};
        workspace_->change(scenario, changeName([] { return tr("Method"); }));
    });
}

void TopBar::makeFilter() {
    filter_->setObjectName(QStringLiteral("filter"));
    filter_->setAccessibleName(tr("Filter"));
    filter_->setToolTip(tr("How the colour is sampled at the hit"));
    filter_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    fillFilters(filter_);
    addLabeled(tr("Filter"), filter_);
    connect(filter_, qOverload<int>(&QComboBox::activated), this, [this](int) {
        relief::Scenario scenario = workspace_->scenario();
        const std::string name = filter_->currentData().toString().toStdString();
        if (name == scenario.filter.name) return;  // chosen again, it keeps its options
        scenario.filter.name = name;
        scenario.filter.options.clear();  // options of the previous filter do not apply to another
        workspace_->change(scenario, changeName([] { return tr("Filter"); }));
    });
}

// The slider is hidden first if there is not enough room: the number can still be changed in its box.
void TopBar::resizeEvent(QResizeEvent* event) {
    constexpr int kWide = 150;  // in average character widths
    const bool wide = width() > kWide * fontMetrics().averageCharWidth();
    depth_->slider()->setVisible(wide);
    depth_->setSizePolicy(wide ? QSizePolicy::Preferred : QSizePolicy::Maximum, QSizePolicy::Preferred);
    QToolBar::resizeEvent(event);
}

void TopBar::refresh() {
    const PauseLog::Part part("top bar");
    const relief::Scenario& scenario = workspace_->scenario();
    method_->setCurrentIndex(method_->findData(QString::fromStdString(scenario.method.name)));
    filter_->setCurrentIndex(filter_->findData(QString::fromStdString(scenario.filter.name)));
}

}  // namespace reliefui
