// Controls of the compare pane: what is compared, how it is shown, and against which reference.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/compare/compare_view.h"
#include "panes/narrow_bar.h"
#include "panes/pane_controls.h"
#include "panes/range_button.h"
#include "workspace/change_name.h"

namespace reliefui {

namespace {

// In pixels. Small, because the window must fit a screen of 800 lines and there are two rows of controls.
constexpr int kLeastPicture = 80;

}  // namespace

CompareView::CompareView(Workspace* workspace, QWidget* parent)
    : FigureView(workspace, tr("Compare"), QStringLiteral("compare"), tr("Export the comparison"), parent),
      pictures_(new ComparePictures(workspace, this)) {
    setFace(pictures_);
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) {
        coarseRunning_ = false;
        ++run_;
        if (view_ && view_->complete && !view_->coarse && !outdated()) {
            // Only measuring the rates was cancelled: the view is complete without them.
            auto unrated = std::make_shared<ComparedView>(*view_);
            unrated->rated = true;
            view_ = std::move(unrated);
            pictures_->show(view_, {});
        } else {
            pictures_->setStopped();
        }
        if (!problem.isEmpty()) Q_EMIT workspace_->problem(problem);
    };
    listener.progress = [this](const QString&, double fraction) { pictures_->setProgress(fraction); };
    job_ = std::make_unique<LatestJob>(this, std::move(listener));
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeMethodBar());
    auto* const modes = new NarrowBar(this);
    bar_ = modes->row();
    column->addWidget(modes);
    makeModeBar();
    column->addWidget(makeOptions());
    // The area scrolls if the pictures would become too small.
    auto* const area = new QScrollArea(this);
    area->setObjectName(QStringLiteral("compare-area"));
    area->setAccessibleName(accessibleName());
    area->setFocusPolicy(Qt::NoFocus);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidgetResizable(true);
    area->setMinimumHeight(kLeastPicture);
    area->setWidget(pictures_);
    column->addWidget(area, 1);
    connect(pictures_, &ComparePictures::hovered, this, &CompareView::setReadout);
    connect(pictures_, &ComparePictures::flickerStopped, this, [this] { play_->setChecked(false); });
    connect(&flicker_, &QTimer::timeout, this, &CompareView::tick);
    connect(workspace, &Workspace::scenarioChanged, this, [this] {
        showControls();
        pictures_->relayout();
    });
    connect(workspace, &Workspace::panesChanged, this, [this] {
        if (!markStaleIfHidden()) proceed();
    });
    connect(workspace, &Workspace::styleChanged, pictures_, &ComparePictures::relayout);
    showControls();
    refresh();
}

CompareView::~CompareView() = default;

// The choosers may be wider than the pane and scroll; the buttons stay visible.
QWidget* CompareView::makeMethodBar() {
    auto* const whole = new QWidget(this);
    auto* const row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 6, 0);
    row->setSpacing(2);
    auto* const names = new NarrowBar(whole);
    row->addWidget(names, 1);
    bar_ = names->row();
    for (std::size_t n = 0; n < relief::kMostCompared; ++n) {
        const QString letter(QChar(static_cast<char>('A' + n)));
        QComboBox* const box =
            addChooser(bar_, qPrintable(QStringLiteral("compare-method-") + letter), tr("Compared: %1").arg(letter));
        connect(box, qOverload<int>(&QComboBox::activated), this,
                [this, n, box](int at) { setChoice(n, box->itemData(at).toString()); });
        choosers_.push_back(box);
    }
    bar_->addStretch(1);
    add_ = addToolButton(row, QStringLiteral("+"), tr("Add another one to the comparison"));
    add_->setObjectName(QStringLiteral("compare-add"));
    remove_ = addToolButton(row, QStringLiteral("−"), tr("Remove the last one"));
    remove_->setObjectName(QStringLiteral("compare-remove"));
    showOptions_ = addToolButton(row, tr("options"), tr("The options of each"));
    showOptions_->setObjectName(QStringLiteral("compare-options"));
    showOptions_->setCheckable(true);
    connect(showOptions_, &QToolButton::clicked, this, &CompareView::showOptions);
    connect(add_, &QToolButton::clicked, this, &CompareView::addOther);
    connect(remove_, &QToolButton::clicked, this, &CompareView::removeOther);
    return whole;
}

void CompareView::makeModeBar() {
    subject_ = addChooser(bar_, "compare-subject", tr("Property in which the pictures differ"));
    for (const QString& subject : {tr("methods"), tr("filters"), tr("coordinates"), tr("heights")}) {
        subject_->addItem(subject);
    }
    mode_ = addChooser(bar_, "compare-mode", tr("How the pictures are compared"));
    mode_->addItem(tr("side by side"));
    mode_->addItem(tr("swipe"));
    mode_->addItem(tr("flicker"));
    mode_->addItem(tr("difference"));
    measure_ = addChooser(bar_, "compare-measure", tr("Difference of the colours to show"));
    measure_->addItem(QStringLiteral("L1"));
    measure_->addItem(QStringLiteral("FLIP"));
    range_ = new RangeButton(
        workspace_, [this] { return pictures_->errors(); }, this);
    bar_->addWidget(range_);
    connect(pictures_, &ComparePictures::rangeRequested, range_, &RangeButton::open);
    rate_ = new QDoubleSpinBox(this);
    rate_->setObjectName(QStringLiteral("compare-rate"));
    rate_->setLocale(QLocale::c());
    rate_->setRange(relief::kSlowestFlicker, relief::kFastestFlicker);
    rate_->setSingleStep(0.5);
    rate_->setDecimals(1);
    rate_->setSuffix(tr(" per second"));
    rate_->setToolTip(tr("Pictures per second"));
    rate_->setAccessibleName(rate_->toolTip());
    rate_->setKeyboardTracking(false);
    bar_->addWidget(rate_);
    play_ = addToolButton(bar_, QStringLiteral("▷"), tr("Show one after the other; A, B, C, D show a single one"));
    play_->setObjectName(QStringLiteral("compare-play"));
    play_->setCheckable(true);
    play_->setChecked(true);
    auto* const against = new QLabel(tr("against"), this);
    bar_->addWidget(against);
    reference_ = addChooser(bar_, "compare-reference", tr("Reference for measuring the pictures"));
    // The reference with the least error has another name for each subject.
    reference_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    reference_->addItem(QString());
    reference_->addItem(QStringLiteral("A"));
    bar_->addStretch(1);
    QToolButton* const fit =
        addToolButton(bar_, tr("fit"), tr("The whole pictures (R); Ctrl+wheel zooms, Ctrl+drag moves"));
    fit->setObjectName(QStringLiteral("compare-fit"));
    connect(fit, &QToolButton::clicked, pictures_, &PictureView::resetZoom);
    connect(subject_, qOverload<int>(&QComboBox::activated), this,
            [this](int subject) { setSubject(static_cast<relief::CompareSubject>(subject)); });
    connect(mode_, qOverload<int>(&QComboBox::activated), this,
            [this](int mode) { setMode(static_cast<relief::CompareMode>(mode)); });
    connect(measure_, qOverload<int>(&QComboBox::activated), this,
            [this](int measure) { setMeasure(static_cast<relief::CompareMeasure>(measure)); });
    connect(reference_, qOverload<int>(&QComboBox::activated), this,
            [this](int reference) { setReference(static_cast<relief::CompareReference>(reference)); });
    connect(play_, &QToolButton::toggled, this, &CompareView::showControls);
    connect(rate_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double rate) {
        relief::Comparison comparison = workspace_->scenario().comparison;
        comparison.rate = rate;
        change(comparison, changeName([] { return tr("Speed of flicker"); }));
    });
}

// Fills the lists with the variations of the current subject.
void CompareView::fillChoosers() {
    const relief::CompareSubject subject = workspace_->scenario().comparison.subject;
    if (offered_ == subject) return;
    offered_ = subject;
    for (std::size_t n = 0; n < choosers_.size(); ++n) {
        choosers_[n]->clear();
        for (const std::string& text : relief::variationNames(subject)) {
            // The scenario's own heights (A) are always those of its file.
            if (n == 0 && text == relief::kQuantised) continue;
            const QString name = QString::fromStdString(text);
            choosers_[n]->addItem(QChar(static_cast<char>('A' + n)) + QStringLiteral(" ") + name, name);
        }
    }
}

// Sets the controls to the scenario's values.
void CompareView::showControls() {
    const relief::Scenario& scenario = workspace_->scenario();
    const relief::Comparison& how = scenario.comparison;
    const std::vector<relief::MethodChoice> all = relief::comparedOf(scenario);
    fillChoosers();
    for (std::size_t n = 0; n < choosers_.size(); ++n) {
        choosers_[n]->setVisible(n < all.size());
        if (n >= all.size()) continue;
        choosers_[n]->setCurrentIndex(choosers_[n]->findData(QString::fromStdString(all[n].name)));
    }
    refreshOptions();
    subject_->setCurrentIndex(static_cast<int>(how.subject));
    reference_->setItemText(0, QString::fromStdString(relief::referenceVariation(scenario).name));
    add_->setEnabled(all.size() < relief::kMostCompared && relief::nextVariation(scenario));
    remove_->setEnabled(all.size() > 1);
    mode_->setCurrentIndex(static_cast<int>(how.mode));
    measure_->setCurrentIndex(static_cast<int>(how.measure));
    measure_->setVisible(how.mode == relief::CompareMode::Difference);
    range_->setVisible(how.mode == relief::CompareMode::Difference);
    range_->refresh();
    reference_->setCurrentIndex(static_cast<int>(how.reference));
    const bool flicker = how.mode == relief::CompareMode::Flicker;
    rate_->setVisible(flicker);
    play_->setVisible(flicker);
    const QSignalBlocker quiet(rate_);
    rate_->setValue(how.rate);
    constexpr int kSecond = 1000;
    const int interval = static_cast<int>(kSecond / how.rate);
    if (!flicker || !play_->isChecked() || stale()) {
        flicker_.stop();
    } else if (!flicker_.isActive() || flicker_.interval() != interval) {
        flicker_.start(interval);
    }
}

}  // namespace reliefui
