// Controls of the rows pane: the variants and their options, the number of pixels, the precision.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/core_texts.h"
#include "panes/drawing_canvas.h"
#include "panes/pane_controls.h"
#include "panes/rows/rows_view.h"

namespace reliefui {

namespace {

constexpr int kWidths[] = {640, 3840, 16384, 65536};

const relief::RowMethodDescription* description(const QString& name) {
    for (const relief::RowMethodDescription& method : relief::rowMethodList()) {
        if (method.name == name.toStdString()) return &method;
    }
    return nullptr;
}

bool takes(const relief::RowMethodDescription* method, const char* option) {
    return method != nullptr && method->defaults.count(option) > 0;
}

}  // namespace

RowsView::RowsView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Rows"), QStringLiteral("rows"), tr("Export the rows"), parent),
      canvas_(new DrawingCanvas(this)) {
    setFace(canvas_);
    makeBar();
    makeVariants();
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar_);
    column->addWidget(variants_);
    column->addWidget(canvas_, 1);
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) {
        if (!problem.isEmpty()) Q_EMIT workspace_->problem(problem);
    };
    listener.progress = [](const QString&, double) {};
    job_ = std::make_unique<LatestJob>(this, std::move(listener));
    canvas_->installEventFilter(this);
    connect(canvas_, &DrawingCanvas::pointed, this, &RowsView::readOut);
    connect(canvas_, &DrawingCanvas::left, this, [this] { setReadout({}); });
    connect(canvas_, &DrawingCanvas::resized, this, &RowsView::draw);
    connect(workspace_, &Workspace::panesChanged, this, &RowsView::adopt);
    connect(workspace_, &Workspace::styleChanged, this, &RowsView::draw);
    adopt();
    showControls();
    refresh();
}

RowsView::~RowsView() = default;

void RowsView::makeBar() {
    bar_ = new QWidget(this);
    auto* const bar = new QHBoxLayout(bar_);
    bar->setContentsMargins(4, 2, 6, 2);
    open_ = addToolButton(bar, tr("variants"), tr("Variants to compare, and their options"), true);
    open_->setObjectName(QStringLiteral("rows-variants"));
    connect(open_, &QToolButton::toggled, this, [this](bool on) { variants_->setVisible(on); });
    pixels_ =
        addChooser(bar, "rows-pixels", tr("Width of the picture in pixels; on long rows rounding errors accumulate"));
    pixels_->addItem(tr("the picture's width"), 0);
    for (const int width : kWidths) pixels_->addItem(tr("%n pixels", nullptr, width), width);
    precision_ = addChooser(bar, "rows-precision", tr("Type of the numbers with which the variants compute"));
    precision_->addItem(QStringLiteral("float"), false);
    precision_->addItem(QStringLiteral("double"), true);
    logarithmic_ = addToolButton(bar, tr("log"), tr("Errors on a logarithmic scale"), true);
    logarithmic_->setObjectName(QStringLiteral("rows-log"));
    auto* const fit =
        addToolButton(bar, tr("fit"), tr("Show all of the row (R); wheel zooms, drag moves, click chooses a pixel"));
    bar->addStretch(1);
    connect(fit, &QToolButton::clicked, this, &RowsView::resetZoom);
    connect(pixels_, qOverload<int>(&QComboBox::activated), this, [this] {
        RowsOptions next = options_;
        next.pixels = pixels_->currentData().toInt();
        change(next);
    });
    connect(precision_, qOverload<int>(&QComboBox::activated), this, [this] {
        RowsOptions next = options_;
        next.inDouble = precision_->currentData().toBool();
        change(next);
    });
    connect(logarithmic_, &QToolButton::clicked, this, [this](bool on) {
        RowsOptions next = options_;
        next.logarithmic = on;
        change(next);
    });
}

void RowsView::makeVariants() {
    variants_ = new QWidget(this);
    auto* const grid = new QGridLayout(variants_);
    grid->setContentsMargins(4, 0, 6, 2);
    grid->setVerticalSpacing(1);
    grid->setColumnStretch(6, 1);
    for (std::size_t s = 0; s < kMostRowCurves; ++s) addSlot(grid, static_cast<int>(s));
    variants_->hide();
}

void RowsView::addSlot(QGridLayout* grid, int row) {
    const QString name = QStringLiteral("rows-%1-").arg(row + 1);
    Slot slot;
    grid->addWidget(new QLabel(QString::number(row + 1), variants_), row, 0);
    slot.variant = new QComboBox(variants_);
    slot.variant->setObjectName(name + QStringLiteral("variant"));
    slot.variant->setAccessibleName(tr("Variant %1").arg(row + 1));
    slot.variant->addItem(tr("none"), QString());
    for (const relief::RowMethodDescription& method : relief::rowMethodList()) {
        if (!std::holds_alternative<relief::RowVariant>(method.kind)) continue;
        slot.variant->addItem(QString::fromStdString(method.name), QString::fromStdString(method.name));
        slot.variant->setItemData(slot.variant->count() - 1, coreText(method.help), Qt::ToolTipRole);
    }
    grid->addWidget(slot.variant, row, 1);
    const auto spin = [&](const char* option, int column, int low, int high, const QString& prefix,
                          const QString& help) {
        auto* const box = new QSpinBox(variants_);
        box->setObjectName(name + QString::fromLatin1(option));
        box->setRange(low, high);
        box->setPrefix(prefix);
        box->setToolTip(help);
        box->setAccessibleName(help);
        box->setKeyboardTracking(false);
        grid->addWidget(box, row, column);
        connect(box, qOverload<int>(&QSpinBox::valueChanged), this, &RowsView::readSlots);
        return box;
    };
    slot.streams = spin("streams", 2, 1, relief::kMostStreams, QStringLiteral("k = "), tr("Streams of the row"));
    slot.span = spin("span", 2, 1, relief::kLongestSpan, QStringLiteral("m = "), tr("Pixels between two divisions"));
    slot.error = new QDoubleSpinBox(variants_);
    slot.error->setObjectName(name + QStringLiteral("error"));
    slot.error->setLocale(QLocale::c());
    slot.error->setRange(0, 64);
    slot.error->setDecimals(3);
    slot.error->setSingleStep(0.05);
    slot.error->setPrefix(tr("error ≤ "));
    slot.error->setSpecialValueText(tr("given m"));
    slot.error->setToolTip(tr("Largest error, texels, which determines the span"));
    slot.error->setAccessibleName(slot.error->toolTip());
    slot.error->setKeyboardTracking(false);
    grid->addWidget(slot.error, row, 3);
    slot.anchor = spin("anchor", 4, relief::kRecommended, 1 << 20, tr("anchor "),
                       tr("Pixels between exact restarts; 0: never; auto: chosen to keep an error of 1/256 texel"));
    slot.anchor->setSpecialValueText(tr("anchor: auto"));
    // Another variant starts with its own defaults.
    connect(slot.variant, qOverload<int>(&QComboBox::activated), this, [this, slot] {
        setSettings(slot, {});
        readSlots();
    });
    connect(slot.error, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &RowsView::readSlots);
    slots_.push_back(slot);
}

// Composes the variants' descriptions, as for relief bench rows, from the controls.
void RowsView::readSlots() {
    RowsOptions next = options_;
    next.methods.clear();
    for (const Slot& slot : slots_) {
        const QString name = slot.variant->currentData().toString();
        const relief::RowMethodDescription* const method = description(name);
        if (method == nullptr) continue;
        std::string text = method->name;
        const auto add = [&](const char* option, const std::string& value) {
            if (takes(method, option) && method->defaults.at(option) != value) text += ':' + (option + ('=' + value));
        };
        add("streams", std::to_string(slot.streams->value()));
        add("span", std::to_string(slot.span->value()));
        add("error", relief::numberText(slot.error->value()));
        add("anchor", std::to_string(slot.anchor->value()));
        next.methods.push_back(text);
    }
    change(next);
    showControls();
}

void RowsView::setSettings(const Slot& slot, const relief::RowSettings& settings) {
    const QSignalBlocker quiet[] = {QSignalBlocker(slot.streams), QSignalBlocker(slot.span), QSignalBlocker(slot.error),
                                    QSignalBlocker(slot.anchor)};
    slot.streams->setValue(settings.streams);
    slot.span->setValue(settings.span);
    slot.error->setValue(settings.error);
    slot.anchor->setValue(settings.anchor);
}

// Sets the controls to what is shown.
void RowsView::showControls() {
    pixels_->setCurrentIndex(std::max(0, pixels_->findData(options_.pixels)));
    precision_->setCurrentIndex(options_.inDouble ? 1 : 0);
    logarithmic_->setChecked(options_.logarithmic);
    const std::vector<relief::RowMethod> methods = rowMethods(options_, "--variants");
    for (std::size_t s = 0; s < slots_.size(); ++s) {
        const Slot& slot = slots_[s];
        const relief::RowMethod* const method = s < methods.size() ? &methods[s] : nullptr;
        const relief::RowMethodDescription* const known = method == nullptr ? nullptr : method->description;
        const relief::RowSettings settings = method == nullptr ? relief::RowSettings{} : method->settings;
        const QString name = known == nullptr ? QString() : QString::fromStdString(known->name);
        slot.variant->setCurrentIndex(std::max(0, slot.variant->findData(name)));
        setSettings(slot, settings);
        slot.streams->setVisible(takes(known, "streams"));
        slot.span->setVisible(takes(known, "span"));
        slot.span->setEnabled(!(settings.error > 0));
        slot.error->setVisible(takes(known, "error"));
        slot.anchor->setVisible(takes(known, "anchor"));
    }
}

}  // namespace reliefui
