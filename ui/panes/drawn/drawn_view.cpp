#include "panes/drawn/drawn_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/core_texts.h"
#include "panes/drawn/drawn_figure.h"
#include "relief/addressing.h"
#include "relief/reliefs.h"
#include "workspace/change_name.h"
#include "workspace/language.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr std::array<int, 5> kSides{8, 12, 16, 24, 32};
constexpr int kFirstSide = 16;
constexpr double kThousand = 1000;  // heights are multiples of 1 / kThousand
// First entries of the list, before the recipes.
enum StartItem { kNothing, kPicture, kFlat, kRecipes };

// height(x, y): of a texel of the relief, whose size is given.
template <class Height>
relief::DrawnRelief drawnOf(const Height& height, int wide, int high, int left, int top, int side) {
    relief::DrawnRelief drawn{side, side, {}};
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const auto x = static_cast<int>(relief::addressIndex(left + i, wide, relief::Address::Repeat));
            const auto y = static_cast<int>(relief::addressIndex(top + j, high, relief::Address::Repeat));
            drawn.heights.push_back(std::round(static_cast<double>(height(x, y)) * kThousand) / kThousand);
        }
    }
    return drawn;
}

}  // namespace

DrawnView::DrawnView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("By hand"), QStringLiteral("drawn"), tr("Export the relief by hand"), parent),
      grid_(new DrawnGrid(workspace, this)) {
    setFace(grid_);
    auto* const starts = new QHBoxLayout;
    auto* const bar = new QHBoxLayout;
    makeBar(starts, bar);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(starts);
    column->addLayout(bar);
    column->addWidget(grid_, 1);
    connect(grid_, &DrawnGrid::hovered, this, &DrawnView::setReadout);
    connect(grid_, &DrawnGrid::chosenChanged, this, &DrawnView::showControls);
    connect(grid_, &DrawnGrid::typingRequested, this, [this](const QKeyEvent* first) {
        height_->setFocus(Qt::ShortcutFocusReason);
        height_->selectAll();
        if (first == nullptr) return;
        QKeyEvent typed(QEvent::KeyPress, first->key(), first->modifiers(), first->text());
        QApplication::sendEvent(height_, &typed);
    });
    connect(workspace, &Workspace::scenarioChanged, this, &DrawnView::refresh);
    connect(workspace, &Workspace::styleChanged, this, &DrawnView::refresh);
    refresh();
}

void DrawnView::makeBar(QHBoxLayout* starts, QHBoxLayout* bar) {
    for (QHBoxLayout* const row : {starts, bar}) row->setContentsMargins(4, 2, 6, 2);
    start_ = new QComboBox(this);
    start_->setObjectName(QStringLiteral("drawn-start"));
    start_->setToolTip(tr("Relief to start from; the colours of the picture are not used"));
    start_->addItem(tr("start from…"));
    start_->addItem(tr("the picture, around the hit"));
    start_->addItem(tr("a plain"));
    for (const relief::ReliefRecipe& recipe : relief::reliefRecipes()) {
        if (!recipe.anySize) continue;
        const QString name = QString::fromUtf8(recipe.name.data(), static_cast<int>(recipe.name.size()));
        start_->addItem(titleText(std::string(recipe.title)), name);
        start_->setItemData(start_->count() - 1, name + QStringLiteral(": ") + coreText(std::string(recipe.help)),
                            Qt::ToolTipRole);
    }
    side_ = new QComboBox(this);
    side_->setObjectName(QStringLiteral("drawn-side"));
    side_->setToolTip(tr("Texels per side"));
    for (const int side : kSides) side_->addItem(QStringLiteral("%1 × %1").arg(side), side);
    side_->setCurrentIndex(side_->findData(kFirstSide));
    profile_ = new QToolButton(this);
    profile_->setObjectName(QStringLiteral("drawn-profile"));
    profile_->setText(tr("profile"));
    profile_->setToolTip(tr("A single row, which all others repeat, drawn from the side"));
    profile_->setCheckable(true);
    profile_->setAutoRaise(true);
    height_ = new QDoubleSpinBox(this);
    height_->setObjectName(QStringLiteral("drawn-height"));
    height_->setLocale(QLocale::c());
    height_->setRange(0, 1);
    height_->setDecimals(3);
    height_->setSingleStep(0.05);
    height_->setPrefix(tr("height "));
    height_->setKeyboardTracking(false);
    height_->setToolTip(tr("Height of the chosen texel, 0 to 1; type digits, press Enter or double-click the texel"));
    for (QWidget* const control : std::initializer_list<QWidget*>{start_, side_, profile_, height_}) {
        control->setAccessibleName(control->toolTip());
        (control == start_ || control == side_ ? starts : bar)->addWidget(control);
    }
    // The pane may be as narrow as the scene panel.
    start_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    start_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    bar->addStretch(1);
    connect(start_, qOverload<int>(&QComboBox::activated), this, [this](int item) {
        if (item == kPicture) startFromPicture();
        if (item == kFlat) startFlat();
        if (item >= kRecipes) startFromRecipe(start_->itemData(item).toString());
        start_->setCurrentIndex(kNothing);
    });
    connect(side_, qOverload<int>(&QComboBox::activated), this, [this] { setSide(side()); });
    connect(profile_, &QToolButton::clicked, this, &DrawnView::setProfile);
    connect(height_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &DrawnView::setHeight);
}

int DrawnView::side() const {
    return side_->currentData().toInt();
}

void DrawnView::showSnapshot() {
    const PauseLog::Part part("by hand");
    grid_->refresh();
    showControls();
}

// Sets the controls to the scenario's values.
void DrawnView::showControls() {
    const bool there = !drawn().empty();
    profile_->setEnabled(there);
    profile_->setChecked(there && drawn().profile());
    const int known = side_->findData(drawn().width);
    if (there && known >= 0) side_->setCurrentIndex(known);
    const auto chosen = grid_->chosen();
    const QSignalBlocker quiet(height_);
    height_->setEnabled(there && chosen.has_value());
    if (there && chosen) height_->setValue(drawn().at(chosen->first, chosen->second));
}

void DrawnView::set(relief::DrawnRelief drawn, const QString& what) {
    relief::Scenario scenario = workspace_->scenario();
    // Colours and normals of the previous relief would not match this one.
    if (scenario.pictures.drawn.empty()) scenario.pictures = {};
    scenario.pictures.drawn = std::move(drawn);
    workspace_->finishInteraction();
    workspace_->change(scenario, what);
}

void DrawnView::startFromPicture() {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot || !snapshot->request) return;
    const relief::HeightField& field = snapshot->request->field;
    const bool hit = snapshot->trace.onRelief && snapshot->trace.hit.outcome == relief::Outcome::Hit;
    const double s = hit ? snapshot->trace.hit.s : field.width() / 2.0;
    const double t = hit ? snapshot->trace.hit.t : field.height() / 2.0;
    const auto corner = [&](double at) { return static_cast<int>(std::floor(at)) - side() / 2; };
    const auto height = [&](int x, int y) { return field.texel(x, y); };
    try {
        set(drawnOf(height, field.width(), field.height(), corner(s), corner(t), side()),
            changeName([] { return tr("Start from the picture"); }));
    } catch (const relief::InputError& error) {  // a damaged tile of a map that is read by tiles
        Q_EMIT workspace_->problem(QString::fromStdString(error.text(uiLanguage())));
    }
}

void DrawnView::startFlat(double height) {
    const auto count = static_cast<std::size_t>(side()) * static_cast<std::size_t>(side());
    set({side(), side(), std::vector<double>(count, height)}, changeName([] { return tr("Start from a plain"); }));
}

void DrawnView::startFromRecipe(const QString& recipe) {
    const relief::FloatImage image = relief::makeRelief(recipe.toStdString(), side(), side(), 1);
    set(drawnOf(image, side(), side(), 0, 0, side()), changeName([recipe] { return tr("Start from %1").arg(recipe); }));
}

void DrawnView::setSide(int side) {
    side_->setCurrentIndex(side_->findData(side));
    const relief::DrawnRelief& old = drawn();
    if (old.empty() || (old.width == side && old.height == side)) return;
    relief::DrawnRelief next{side, side, {}};
    const int rows = old.profile() ? 1 : side;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < side; ++i) next.heights.push_back(old.at(i * old.width / side, j * old.height / side));
    }
    set(std::move(next), changeName([] { return tr("Texels per side"); }));
}

void DrawnView::setProfile(bool on) {
    relief::DrawnRelief next = drawn();
    if (next.empty() || next.profile() == on) return;
    const auto width = static_cast<std::ptrdiff_t>(next.width);
    const int row = grid_->chosen() ? grid_->chosen()->second : next.height / 2;
    const auto begin = next.heights.begin() + (on ? row * width : 0);
    const std::vector<double> line(begin, begin + width);
    next.heights.clear();
    for (int j = 0; j < (on ? 1 : next.height); ++j) next.heights.insert(next.heights.end(), line.begin(), line.end());
    set(std::move(next), changeName([on] { return on ? tr("Profile") : tr("Grid"); }));
}

void DrawnView::setHeight(double height) {
    const auto chosen = grid_->chosen();
    if (!chosen || drawn().empty()) return;
    relief::DrawnRelief next = drawn();
    const int row = next.profile() ? 0 : chosen->second;
    const auto place = static_cast<std::size_t>(row * next.width + chosen->first);
    if (place >= next.heights.size()) return;
    next.heights[place] = std::round(height * kThousand) / kThousand;
    set(std::move(next), changeName([] { return tr("Height of a texel"); }));
}

std::shared_ptr<const Figure> DrawnView::figure() const {
    const auto snapshot = workspace_->snapshot();
    return snapshot && !snapshot->scenario.pictures.drawn.empty() ? drawnFigure(snapshot) : nullptr;
}

}  // namespace reliefui
