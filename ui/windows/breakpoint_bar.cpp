#include "windows/breakpoint_bar.h"

#include "panes/narrow_bar.h"
#include "relief/errors.h"
#include "workspace/change_name.h"
#include "workspace/pause_log.h"

#include <algorithm>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>

namespace reliefui {

namespace {

constexpr int kFarthestTexel = 1 << 30;
constexpr double kHeightStep = 0.05;
constexpr int kConditionLetters = 26;
constexpr int kLongestChip = 44;  // letters

}  // namespace

QString breakpointText(const relief::Breakpoint& breakpoint, relief::Language language) {
    return QString::fromStdString(relief::sentence(relief::breakpointTitle(breakpoint), language));
}

BreakpointBar::BreakpointBar(Workspace* workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), kind_(new QComboBox(this)) {
    auto* const all = new QHBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    auto* const bar = new NarrowBar(this);
    all->addWidget(bar);
    row_ = bar->row();
    row_->setContentsMargins(6, 0, 6, 2);
    row_->addWidget(new QLabel(tr("stop when"), this));
    kind_->setObjectName(QStringLiteral("breakpoint-kind"));
    kind_->setAccessibleName(tr("Where stepping stops"));
    kind_->setToolTip(tr("Playing and running stop at the first step that meets this condition"));
    kind_->addItems({tr("level below"), tr("texel"), tr("ray below"), tr("overshoot"), tr("disagreement with exact"),
                     tr("condition")});
    row_->addWidget(kind_);
    level_ =
        addNumber("breakpoint-level", tr("level "), tr("Level of the pyramid, 0 the finest"), 0, relief::kMostLevels);
    i_ = addNumber("breakpoint-i", QStringLiteral("i "), tr("Column of the texel"), -kFarthestTexel, kFarthestTexel);
    j_ = addNumber("breakpoint-j", QStringLiteral("j "), tr("Row of the texel"), -kFarthestTexel, kFarthestTexel);
    height_ = new QDoubleSpinBox(this);
    height_->setObjectName(QStringLiteral("breakpoint-height"));
    height_->setAccessibleName(tr("Height of the ray, 1 the top of the slab"));
    height_->setToolTip(height_->accessibleName());
    height_->setRange(0, 1);
    height_->setSingleStep(kHeightStep);
    row_->addWidget(height_);
    makeCondition();
    auto* const plus = new QToolButton(this);
    plus->setObjectName(QStringLiteral("breakpoint-add"));
    plus->setText(QStringLiteral("+"));
    plus->setAutoRaise(true);
    plus->setAccessibleName(tr("Add the breakpoint"));
    plus->setToolTip(tr("Add the breakpoint; F9 sets one at the texel of the chosen step"));
    row_->addWidget(plus);
    chips_ = new QWidget(this);
    row_->addWidget(chips_, 1);
    const relief::Breakpoint standard;
    level_->setValue(standard.level);
    height_->setValue(standard.height);
    connect(plus, &QToolButton::clicked, this, qOverload<>(&BreakpointBar::add));
    connect(condition_, &QLineEdit::returnPressed, this, qOverload<>(&BreakpointBar::add));
    connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), this, &BreakpointBar::showFields);
    connect(workspace_, &Workspace::scenarioChanged, this, &BreakpointBar::refresh);
    connect(workspace_, &Workspace::notesChanged, this, &BreakpointBar::refresh);
    connect(workspace_, &Workspace::snapshotChanged, this, &BreakpointBar::refresh);
    connect(workspace_, &Workspace::styleChanged, this, [this] {
        shown_.clear();
        refresh();
    });
    showFields();
    refresh();
}

void BreakpointBar::makeCondition() {
    condition_ = new QLineEdit(this);
    condition_->setObjectName(QStringLiteral("breakpoint-condition"));
    condition_->setAccessibleName(tr("Condition over the columns of the steps"));
    condition_->setToolTip(
        tr("Condition over the columns of the steps and the pixel, such as "
           "level == 3 && delta_lambda < 0.01 or pixel == 480,300; Enter adds it"));
    condition_->setPlaceholderText(QStringLiteral("level == 3 && delta_lambda < 0.01"));
    condition_->setMinimumWidth(fontMetrics().horizontalAdvance(QLatin1Char('x')) * kConditionLetters);
    row_->addWidget(condition_);
    ignore_ = addNumber("breakpoint-ignore", tr("ignore "), tr("How many times the ray meets it before it stops"), 0,
                        relief::kMostIgnored);
}

QSpinBox* BreakpointBar::addNumber(const char* name, const QString& prefix, const QString& help, int low, int high) {
    auto* const box = new QSpinBox(this);
    box->setObjectName(QLatin1String(name));
    box->setRange(low, high);
    box->setPrefix(prefix);
    box->setAccessibleName(help);
    box->setToolTip(help);
    row_->addWidget(box);
    return box;
}

void BreakpointBar::showFields() {
    const auto kind = static_cast<relief::StopKind>(kind_->currentIndex());
    const bool texel = kind == relief::StopKind::Texel;
    level_->setVisible(texel || kind == relief::StopKind::LevelBelow);
    i_->setVisible(texel);
    j_->setVisible(texel);
    height_->setVisible(kind == relief::StopKind::RayBelow);
    condition_->setVisible(kind == relief::StopKind::Condition);
    const auto snapshot = workspace_->snapshot();
    if (!texel || !snapshot || snapshot->trace.steps.empty()) return;
    // Default: the texel where the ray currently is, which is what users want most of the time.
    const auto& steps = snapshot->trace.steps;
    const int last = static_cast<int>(steps.size()) - 1;
    const relief::Step& step = steps[static_cast<std::size_t>(std::clamp(workspace_->scenario().step, 0, last))];
    level_->setValue(step.level);
    i_->setValue(static_cast<int>(step.i));
    j_->setValue(static_cast<int>(step.j));
}

relief::Breakpoint BreakpointBar::edited() const {
    relief::Breakpoint breakpoint;
    breakpoint.kind = static_cast<relief::StopKind>(kind_->currentIndex());
    using relief::StopKind;
    if (breakpoint.kind == StopKind::LevelBelow || breakpoint.kind == StopKind::Texel) {
        breakpoint.level = level_->value();
    }
    if (breakpoint.kind == StopKind::Texel) {
        breakpoint.i = i_->value();
        breakpoint.j = j_->value();
    }
    if (breakpoint.kind == StopKind::RayBelow) breakpoint.height = height_->value();
    if (breakpoint.kind == StopKind::Condition) breakpoint.condition = condition_->text().trimmed().toStdString();
    breakpoint.ignore = ignore_->value();
    return breakpoint;
}

void BreakpointBar::add() {
    add(edited());
}

void BreakpointBar::add(const relief::Breakpoint& added) {
    try {
        relief::checkBreakpoint(added, {});
    } catch (const relief::InputError& error) {
        Q_EMIT workspace_->problem(QString::fromStdString(error.text(workspace_->style().language)));
        return;
    }
    std::vector<relief::Breakpoint> all = workspace_->scenario().breakpoints;
    if (std::find(all.begin(), all.end(), added) != all.end()) return;
    all.push_back(added);
    workspace_->setBreakpoints(std::move(all), changeName([] { return tr("Add breakpoint"); }));
}

void BreakpointBar::toggleHere() {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot || snapshot->trace.steps.empty()) return;
    kind_->setCurrentIndex(static_cast<int>(relief::StopKind::Texel));
    showFields();
    relief::Breakpoint here = edited();
    here.ignore = 0;
    const std::vector<relief::Breakpoint>& all = workspace_->scenario().breakpoints;
    // One that is off, or ignores some stops, is at the texel as well.
    const auto found = std::find_if(all.begin(), all.end(), [&](const relief::Breakpoint& other) {
        return other.kind == here.kind && other.level == here.level && other.i == here.i && other.j == here.j;
    });
    if (found == all.end()) return add(here);
    remove(static_cast<std::size_t>(found - all.begin()));
}

void BreakpointBar::remove(std::size_t number) {
    std::vector<relief::Breakpoint> all = workspace_->scenario().breakpoints;
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(number));
    workspace_->setBreakpoints(std::move(all), changeName([] { return tr("Remove breakpoint"); }));
}

void BreakpointBar::setOn(std::size_t number, bool on) {
    std::vector<relief::Breakpoint> all = workspace_->scenario().breakpoints;
    all[number].on = on;
    workspace_->setBreakpoints(std::move(all), changeName([] { return tr("Turn breakpoint on or off"); }));
}

BreakpointBar::Chip BreakpointBar::chipOf(const relief::Breakpoint& breakpoint) const {
    const relief::Language language = workspace_->style().language;
    // The filled or empty dot shows the state, so that colour is not the only cue.
    Chip chip{breakpoint.on ? QStringLiteral("● ") : QStringLiteral("○ "), {}, breakpoint.on};
    const QString title = breakpointText(breakpoint, language);
    chip.text += title.size() > kLongestChip ? title.left(kLongestChip) + QStringLiteral("…") : title;
    chip.help = title + QLatin1Char('\n');
    const auto snapshot = workspace_->snapshot();
    if (snapshot && !snapshot->trace.steps.empty()) {
        const relief::BreakpointHits hits = relief::breakpointHits(breakpoint, snapshot->trace.stopped());
        if (hits.fault) {
            chip.text += QStringLiteral("  ⚠");
            chip.help += QString::fromStdString(relief::sentence(*hits.fault, language)) + QLatin1Char('\n');
        } else {
            chip.text += QStringLiteral("  ×%1").arg(hits.steps.size() - hits.ignored);
            chip.help += tr("On this ray: %n stop(s)", nullptr, static_cast<int>(hits.steps.size() - hits.ignored));
            if (breakpoint.ignore > 0) chip.help += tr(", the first %1 ignored").arg(breakpoint.ignore);
            chip.help += QLatin1Char('\n');
        }
    }
    chip.help += breakpoint.on ? tr("Stops here; press to turn it off") : tr("Is off; press to turn it on");
    return chip;
}

void BreakpointBar::refresh() {
    const PauseLog::Part part("breakpoints");
    const std::vector<relief::Breakpoint>& all = workspace_->scenario().breakpoints;
    std::vector<Chip> now;
    for (const relief::Breakpoint& breakpoint : all) now.push_back(chipOf(breakpoint));
    if (now == shown_ && chips_->layout() != nullptr) return;
    shown_ = now;
    // The call may come from a click on one of the old chips, so these are deleted later, after that event.
    QWidget* const old = chips_;
    chips_ = new QWidget(this);
    delete row_->replaceWidget(old, chips_);  // replaceWidget() returns the layout item, which the caller owns
    old->hide();
    old->deleteLater();
    auto* const row = new QHBoxLayout(chips_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    for (std::size_t n = 0; n < now.size(); ++n) {
        addChip(n, now[n], breakpointText(all[n], workspace_->style().language));
    }
    row->addStretch(1);
    chips_->show();
}

void BreakpointBar::addChip(std::size_t number, const Chip& shown, const QString& name) {
    auto* const chip = new QToolButton(chips_);
    chip->setObjectName(QStringLiteral("breakpoint-%1").arg(number));
    chip->setCheckable(true);
    chip->setChecked(shown.on);
    // Otherwise "&" underlines the letter behind it.
    chip->setText(QString(shown.text).replace(QLatin1Char('&'), QStringLiteral("&&")));
    chip->setAccessibleName(name);
    chip->setToolTip(shown.help);
    connect(chip, &QToolButton::toggled, this, [this, number](bool on) { setOn(number, on); });
    chips_->layout()->addWidget(chip);
    auto* const cross = new QToolButton(chips_);
    cross->setObjectName(QStringLiteral("breakpoint-remove-%1").arg(number));
    cross->setText(QStringLiteral("×"));
    cross->setAutoRaise(true);
    cross->setAccessibleName(tr("Remove the breakpoint: %1").arg(name));
    cross->setToolTip(cross->accessibleName());
    connect(cross, &QToolButton::clicked, this, [this, number] { remove(number); });
    chips_->layout()->addWidget(cross);
}

}  // namespace reliefui
