#include "windows/status_line.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "panes/core_texts.h"
#include "panes/result/result_painting.h"
#include "relief/messages.h"
#include "scenario/step_sentence.h"
#include "workspace/change_name.h"
#include "workspace/language.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr int kBusyDelayMs = 250;
constexpr int kBeforeFrame = 12;  // pixels between a message and the frame's text

double counter(const relief::Frame& frame, relief::MessageId what) {
    const auto found = frame.counters.find(what);
    return found == frame.counters.end() ? 0 : found->second;
}

QString rounded(double value, int digits) {
    return QString::fromStdString(relief::numberText(value, digits));
}

// Formats with thin spaces between thousands, independent of the locale.
QString grouped(std::uint64_t value) {
    QString text = QString::number(value);
    for (int at = text.size() - 3; at > 0; at -= 3) text.insert(at, QChar(0x2009));
    return text;
}

QString inWords(relief::MessageId what) {
    return QString::fromStdString(relief::sentence(relief::Message(what), uiLanguage()));
}

// Lists the frame's stages with their times, and the work that was skipped.
QString ledger(const relief::Frame& frame) {
    QString text = StatusLine::tr("Click to see what was skipped, and why") + QLatin1Char('\n') +
                   StatusLine::tr("Stages of this frame (seconds of all threads together):");
    for (std::size_t s = 0; s < relief::kStages; ++s) {
        const relief::StageReport& stage = frame.stages[s];
        const QString done = stage.reused ? StatusLine::tr("kept") : rounded(stage.seconds, 3);
        text += QStringLiteral("\n  %1: %2").arg(inWords(relief::kStageNames[s]), done);
    }
    for (const auto& [what, value] : frame.counters) {
        text += QStringLiteral("\n%1: %2")
                    .arg(inWords(what), value == std::floor(value) && value >= 0 && value < 1e15
                                            ? grouped(static_cast<std::uint64_t>(value))
                                            : rounded(value, 4));
    }
    return text;
}

}  // namespace

StatusLine::StatusLine(Workspace* workspace, QWidget* parent)
    : QStatusBar(parent),
      workspace_(workspace),
      pixel_(new QLabel(this)),
      frame_(new QLabel(this)),
      what_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QToolButton(this)),
      walk_(new QToolButton(this)) {
    pixel_->setObjectName(QStringLiteral("status-pixel"));
    frame_->setObjectName(QStringLiteral("status-frame"));
    pixel_->setAccessibleName(tr("The chosen pixel"));
    frame_->setAccessibleName(tr("The frame"));
    frame_->installEventFilter(this);
    frame_->setCursor(Qt::PointingHandCursor);
    pixel_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    // The label may shrink, so that large type cannot make the window wider than the screen; the tool tip has the full
    // text.
    pixel_->setMinimumWidth(1);
    setContentsMargins(6, 0, 6, 0);
    bar_->setRange(0, 1000);
    bar_->setFixedWidth(160);
    bar_->setTextVisible(false);
    bar_->setAccessibleName(tr("Progress"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Cancel the running work (Esc)"));
    cancel_->setAccessibleName(tr("Cancel the running work"));
    addWidget(pixel_, 1);
    addPermanentWidget(what_);
    addPermanentWidget(bar_);
    addPermanentWidget(cancel_);
    walk_->setObjectName(QStringLiteral("status-walk"));
    walk_->setAutoRaise(true);
    walk_->setCursor(Qt::PointingHandCursor);
    walk_->hide();
    addPermanentWidget(frame_);
    addPermanentWidget(walk_);
    showBusy(false);
    busyDelay_.setSingleShot(true);
    busyDelay_.setInterval(kBusyDelayMs);
    connect(&busyDelay_, &QTimer::timeout, this, [this] { showBusy(busy()); });
    connect(workspace_, &Workspace::busyChanged, this, &StatusLine::takeBusy);
    connect(&workspace_->tasks(), &BackgroundTasks::busyChanged, this, &StatusLine::takeBusy);
    connect(workspace_, &Workspace::progress, this, &StatusLine::showProgress);
    connect(&workspace_->tasks(), &BackgroundTasks::progress, this, [this](const QString& what, double fraction) {
        // Progress of the picture takes precedence.
        if (workspace_->busy()) return;
        showProgress(what, fraction);
        what_->setText(tr("figure: %1").arg(what_->text()));
    });
    connect(workspace_, &Workspace::snapshotChanged, this, [this] {
        refresh();
        // The delay starts again with each picture: while pictures keep coming, no progress is shown.
        showBusy(workspace_->tasks().busy());
        if (workspace_->busy()) busyDelay_.start();
    });
    connect(cancel_, &QToolButton::clicked, workspace_, &Workspace::cancel);
    connect(walk_, &QToolButton::clicked, this, &StatusLine::takeWalk);
    refresh();  // for a workspace that already has a snapshot from a previous window
}

void StatusLine::say(const QString& message, int ms) {
    // A message is painted from the left end to the first visible part on the right.
    int room = width();
    for (const QWidget* const part : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (part->isVisible() && part != pixel_) room = std::min(room, part->x());
    }
    room -= contentsMargins().left() + 2 * kBeforeFrame;
    showMessage(fontMetrics().elidedText(message, Qt::ElideMiddle, room), ms);
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
    if (watched == frame_ && event->type() == QEvent::MouseButtonRelease) Q_EMIT ledgerRequested();
    // The tool tip is updated when it is about to be shown.
    if (watched == frame_ && event->type() == QEvent::ToolTip) showLedger();
    return QStatusBar::eventFilter(watched, event);
}

bool StatusLine::busy() const {
    return workspace_->busy() || workspace_->tasks().busy();
}

void StatusLine::takeBusy() {
    if (!busy()) {
        busyDelay_.stop();
        showBusy(false);
    } else if (!bar_->isVisible()) {
        busyDelay_.start();
    }
}

void StatusLine::showBusy(bool busy) {
    for (QWidget* const part :
         {static_cast<QWidget*>(what_), static_cast<QWidget*>(bar_), static_cast<QWidget*>(cancel_)}) {
        part->setVisible(busy);
    }
}

void StatusLine::showProgress(const QString& what, double fraction) {
    if (fraction < 0) return;
    const QString words = coreText(what.toStdString());
    // The core names the building of a map by the map alone.
    const QLatin1String map("map ");
    what_->setText(words.startsWith(map) ? tr("building the map “%1”").arg(words.mid(map.size())) : words);
    bar_->setValue(static_cast<int>(fraction * 1000));
}

void StatusLine::refresh() {
    const PauseLog::Part part("bottom line");
    pixel_->setText(pixelText());
    pixel_->setToolTip(pixel_->text());
    frame_->setText(frameText());
    refreshWalk();
}

// Names the tracer that drew the picture, if it is not the method whose steps are shown.
void StatusLine::refreshWalk() {
    const auto snapshot = workspace_->snapshot();
    const QString by = snapshot ? QString::fromStdString(snapshot->frame->tracedBy) : QString();
    const QString shown = snapshot ? QString::fromStdString(snapshot->request->method.name) : QString();
    walk_->setVisible(by != shown);
    walk_->setText(tr("drawn by %1").arg(by));
    walk_->setToolTip(tr("Drawn by %1, which is faster and has the same hits; the time shown is that of %1. The steps "
                         "shown are those of %2.\nClick to switch the method to %1")
                          .arg(by, shown));
    walk_->setAccessibleDescription(walk_->toolTip());
}

// Switches the method to the tracer that drew the picture.
void StatusLine::takeWalk() {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot) return;
    relief::Scenario scenario = workspace_->scenario();
    scenario.method = {snapshot->frame->tracedBy, {}};
    workspace_->change(scenario, changeName([] { return tr("Method"); }));
}

void StatusLine::showLedger() {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot) return;
    constexpr std::size_t kPauses = 3;
    QString text = ledger(*snapshot->frame) + QLatin1Char('\n');
    if (snapshot->frame->mappingOff > 0) {
        text += tr("Coordinates: %1, off by up to %2 texels")
                    .arg(QString::fromStdString(snapshot->scenario.mapping), rounded(snapshot->frame->mappingOff, 2)) +
                QLatin1Char('\n');
    }
    if (snapshot->ellipseOff > 0) {
        text += tr("Footprint ellipses: %1, semi-axes off by up to %2 %")
                    .arg(QString::fromStdString(snapshot->scenario.filter.options.at("ellipse")),
                         rounded(100 * snapshot->ellipseOff, 2)) +
                QLatin1Char('\n');
    }
    frame_->setToolTip(text + PauseLog::instance().text(kPauses));
}

QString StatusLine::pixelText() const {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot || (!snapshot->scenario.pixel && !snapshot->other)) return tr("no pixel chosen");
    const PixelTrace& trace = snapshot->trace;
    QString text = tr("pixel (%1, %2)").arg(trace.pixel.x).arg(trace.pixel.y) + QStringLiteral("     ");
    if (trace.fromFile || snapshot->other) {
        text = tr("ray %1 of the file").arg(snapshot->scenario.other.ray) + QStringLiteral("     ");
    }
    if (!trace.onRelief) return text + tr("sky: no polygon here");
    if (trace.hidden) return text + tr("hidden until you guess");
    if (trace.hit.outcome == relief::Outcome::Hit) {
        text += tr("hit at texel (%1, %2), λ %3")
                    .arg(trace.hit.s, 0, 'f', 2)
                    .arg(trace.hit.t, 0, 'f', 2)
                    .arg(trace.hit.lambda, 0, 'f', 3);
    } else {
        text += outcomeTitle(trace.hit.outcome);
    }
    const double off = relief::answerError(trace.hit, trace.exact, trace.ray);
    if (std::isinf(off)) {
        text +=
            trace.exact.outcome == relief::Outcome::Hit ? tr(", the exact answer is a hit") : tr(", there is no hit");
    } else if (off > relief::kSameAnswer) {
        text += tr(", %1 texels from the exact hit").arg(rounded(off, 2));
    }
    return text + QStringLiteral("     ") +
           tr("steps: %1, reads: %2").arg(grouped(trace.steps.size()), grouped(trace.reads));
}

QString StatusLine::frameText() const {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot) return {};
    const relief::Frame& frame = *snapshot->frame;
    const bool brief = frame.seconds < 0.9995;
    QString text = brief ? tr("frame %1 ms").arg(rounded(frame.seconds * 1000, 3))
                         : tr("frame %1 s").arg(rounded(frame.seconds, 3));
    if (frame.width < snapshot->scenario.width) {
        text += tr(" (%1 × %2)").arg(frame.width).arg(frame.height);
    } else if (snapshot->coarse) {
        text += QStringLiteral(" (%1)").arg(QString::fromStdString(relief::filterText(snapshot->request->filter)));
    }
    // Pixels without a search: sky, or no relief along the ray.
    const double pixels = counter(frame, relief::MessageId::CountPixels);
    const double spared = counter(frame, relief::MessageId::CountSky) +
                          counter(frame, relief::MessageId::CountRaysFlat) +
                          counter(frame, relief::MessageId::CountRaysParallax);
    if (frame.mappingOff > 0) {
        text += QStringLiteral("     ") + tr("coordinates ±%1 texels").arg(rounded(frame.mappingOff, 2));
    }
    if (snapshot->ellipseOff > 0) {
        text += QStringLiteral("     ") + tr("footprint axes ±%1 %").arg(rounded(100 * snapshot->ellipseOff, 2));
    }
    return text + QStringLiteral("     ") +
           tr("skipped: %1 %").arg(std::lround(pixels > 0 ? 100 * spared / pixels : 0));
}

}  // namespace reliefui
