#include "windows/other_bar.h"
#include "workspace/change_name.h"

#include <algorithm>

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

namespace reliefui {

OtherBar::OtherBar(Workspace* workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      file_(new QLabel(this)),
      ray_(new QSpinBox(this)),
      count_(new QLabel(this)),
      stepsOf_(new QComboBox(this)) {
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(6, 0, 6, 2);
    row->addWidget(file_);
    ray_->setObjectName(QStringLiteral("other-ray"));
    ray_->setPrefix(tr("ray "));
    ray_->setAccessibleName(tr("Ray of the file"));
    ray_->setToolTip(tr("Ray of the file to show, numbered from 0"));
    row->addWidget(ray_);
    row->addWidget(count_);
    stepsOf_->setObjectName(QStringLiteral("other-shown"));
    stepsOf_->setAccessibleName(tr("Tracer whose steps are shown"));
    stepsOf_->setToolTip(tr("Tracer whose steps all panes show; the duel shows both"));
    row->addWidget(stepsOf_);
    auto* const closer = new QToolButton(this);
    closer->setObjectName(QStringLiteral("other-close"));
    closer->setText(QStringLiteral("×"));
    closer->setAutoRaise(true);
    closer->setAccessibleName(tr("Close the other tracer's files"));
    closer->setToolTip(closer->accessibleName());
    row->addWidget(closer);
    row->addStretch(1);
    connect(closer, &QToolButton::clicked, this, &OtherBar::close);
    connect(ray_, qOverload<int>(&QSpinBox::valueChanged), this, [this](int ray) {
        relief::OtherTracer other = workspace_->scenario().other;
        other.ray = ray;
        change(other, changeName([] { return tr("Choose ray"); }));
    });
    connect(stepsOf_, qOverload<int>(&QComboBox::activated), this, [this](int item) {
        relief::OtherTracer other = workspace_->scenario().other;
        other.shown = item == 0;
        change(other, changeName([] { return tr("Tracer whose steps are shown"); }));
    });
    connect(workspace_, &Workspace::scenarioChanged, this, &OtherBar::refresh);
    connect(workspace_, &Workspace::snapshotChanged, this, &OtherBar::refresh);
    refresh();
}

void OtherBar::change(const relief::OtherTracer& other, const QString& what) {
    relief::Scenario changed = workspace_->scenario();
    changed.other = other;
    workspace_->change(changed, what);
}

void OtherBar::open(const QString& rays, const QString& steps) {
    change(
        {QFileInfo(rays).absoluteFilePath().toStdString(), QFileInfo(steps).absoluteFilePath().toStdString(), 0, true},
        changeName([] { return tr("Open another tracer's steps"); }));
}

void OtherBar::close() {
    change({}, changeName([] { return tr("Close another tracer's steps"); }));
}

void OtherBar::refresh() {
    const relief::Scenario& scenario = workspace_->scenario();
    const auto snapshot = workspace_->snapshot();
    setVisible(static_cast<bool>(scenario.other));
    if (!scenario.other) return;
    const QSignalBlocker quietRay(ray_);
    const QSignalBlocker quietWhose(stepsOf_);
    const int rays = snapshot ? static_cast<int>(snapshot->otherRays) : 0;
    ray_->setRange(0, std::max(scenario.other.ray, rays - 1));
    ray_->setValue(scenario.other.ray);
    count_->setText(tr("of %1").arg(rays));
    const QString name = QFileInfo(QString::fromStdString(scenario.other.steps)).fileName();
    file_->setText(QFileInfo(QString::fromStdString(scenario.other.rays)).fileName());
    file_->setToolTip(QString::fromStdString(scenario.other.rays + "\n" + scenario.other.steps));
    stepsOf_->clear();
    stepsOf_->addItem(tr("steps of %1").arg(name));
    stepsOf_->addItem(tr("steps of %1").arg(QString::fromStdString(scenario.method.name)));
    stepsOf_->setCurrentIndex(scenario.other.shown ? 0 : 1);
}

}  // namespace reliefui
