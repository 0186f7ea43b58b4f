#include "workspace/pause_log.h"

#include <algorithm>

#include <QCoreApplication>
#include <QMetaEnum>
#include <QObject>
#include <QOpenGLWidget>

#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

// A nested part that takes at least this share of an event's time is included in the event's name.
constexpr double kNamingShare = 0.5;

double msBetween(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

QString number(double ms) {
    return QString::fromStdString(relief::fixedText(ms, 1));
}

QString between() {
    return QStringLiteral(" › ");
}

// Translatable names of parts, as passed to PauseLog::Part.
constexpr const char* kParts[] = {
    QT_TRANSLATE_NOOP("parts", "bottom line"),
    QT_TRANSLATE_NOOP("parts", "breakpoints"),
    QT_TRANSLATE_NOOP("parts", "by hand"),
    QT_TRANSLATE_NOOP("parts", "by hand: grid"),
    QT_TRANSLATE_NOOP("parts", "charts"),
    QT_TRANSLATE_NOOP("parts", "charts: drawing"),
    QT_TRANSLATE_NOOP("parts", "compare"),
    QT_TRANSLATE_NOOP("parts", "compare: pictures"),
    QT_TRANSLATE_NOOP("parts", "distance"),
    QT_TRANSLATE_NOOP("parts", "distance: marks"),
    QT_TRANSLATE_NOOP("parts", "duel"),
    QT_TRANSLATE_NOOP("parts", "duel: drawing"),
    QT_TRANSLATE_NOOP("parts", "figure"),
    QT_TRANSLATE_NOOP("parts", "footprint"),
    QT_TRANSLATE_NOOP("parts", "footprint: marks"),
    QT_TRANSLATE_NOOP("parts", "formulas"),
    QT_TRANSLATE_NOOP("parts", "pane"),
    QT_TRANSLATE_NOOP("parts", "profile"),
    QT_TRANSLATE_NOOP("parts", "profile: marks"),
    QT_TRANSLATE_NOOP("parts", "profile: relief"),
    QT_TRANSLATE_NOOP("parts", "pyramid"),
    QT_TRANSLATE_NOOP("parts", "pyramid in 3-D"),
    QT_TRANSLATE_NOOP("parts", "pyramid: marks"),
    QT_TRANSLATE_NOOP("parts", "pyramid: marks on slabs"),
    QT_TRANSLATE_NOOP("parts", "pyramid: slabs"),
    QT_TRANSLATE_NOOP("parts", "result"),
    QT_TRANSLATE_NOOP("parts", "rows"),
    QT_TRANSLATE_NOOP("parts", "rows: drawing"),
    QT_TRANSLATE_NOOP("parts", "scene"),
    QT_TRANSLATE_NOOP("parts", "skipped"),
    QT_TRANSLATE_NOOP("parts", "step bar"),
    QT_TRANSLATE_NOOP("parts", "steps"),
    QT_TRANSLATE_NOOP("parts", "top bar"),
    QT_TRANSLATE_NOOP("parts", "trace 3-D"),
    QT_TRANSLATE_NOOP("parts", "trace 3-D: scene"),
    QT_TRANSLATE_NOOP("parts", "trace 3-D: step"),
    QT_TRANSLATE_NOOP("parts", "doctor"),
    QT_TRANSLATE_NOOP("parts", "doctor: drawing"),
    QT_TRANSLATE_NOOP("parts", "shader"),
    QT_TRANSLATE_NOOP("parts", "shader: drawing"),
    QT_TRANSLATE_NOOP("parts", "watch"),
    QT_TRANSLATE_NOOP("parts", "why"),
};

// Translates the names of parts; names of classes and events are Qt's own and stay.
QString translated(const QString& what) {
    QStringList parts = what.split(between());
    for (QString& part : parts) {
        for (const char* const known : kParts) {
            if (part == QLatin1String(known)) part = QCoreApplication::translate("parts", known);
        }
    }
    return parts.join(between());
}

}  // namespace

PauseLog& PauseLog::instance() {
    static PauseLog log;
    return log;
}

// Events that are being handled are still measured, from now on.
void PauseLog::clear() {
    gap_ = longestGap_ = {};
    gapLongest_ = 0;
    worst_.clear();
    drawing_ = 0;
    started_ = Clock::now();
}

PauseLog::Pause PauseLog::longestComputation() const {
    Pause longest;
    for (const auto& [what, pause] : worst_) {
        if (pause.computed() > longest.computed()) longest = pause;
    }
    return longest;
}

std::vector<PauseLog::Pause> PauseLog::worst(std::size_t most) const {
    std::vector<Pause> all;
    for (const auto& [what, pause] : worst_) all.push_back(pause);
    std::sort(all.begin(), all.end(), [](const Pause& a, const Pause& b) { return a.computed() > b.computed(); });
    if (all.size() > most) all.resize(most);
    return all;
}

QString PauseLog::text(std::size_t most) const {
    const auto line = [](const Pause& pause) {
        return tr("%1 ms, of which %2 ms of painting: %3")
            .arg(number(pause.ms), number(pause.drawing), translated(pause.what));
    };
    QString text = tr("longest pause of the window: ") + line(longestGap());
    for (const Pause& pause : worst(most)) {
        text += QStringLiteral("\n  ") + line(pause) + QStringLiteral(" × ") + QString::number(pause.times);
    }
    return text;
}

QString PauseLog::nameOf(const Frame& frame) {
    QString text = QString::fromLatin1(frame.name);
    text.remove(QStringLiteral("reliefui::"));
    if (!frame.object.isEmpty()) text += QLatin1Char(' ') + frame.object;
    if (frame.type == 0) return text;
    const char* const type = QMetaEnum::fromType<QEvent::Type>().valueToKey(frame.type);
    return text + QLatin1Char(' ') + (type != nullptr ? QString::fromLatin1(type) : QString::number(frame.type));
}

QString PauseLog::describe(const Frame& frame, double ms) {
    const QString name = nameOf(frame);
    const bool more = frame.longest > kNamingShare * ms && !frame.longestName.isEmpty();
    return more ? name + between() + frame.longestName : name;
}

void PauseLog::open() {
    running_ = true;
    drawing_ = 0;
    started_ = Clock::now();
}

// Ends the current interval without a poll of the event queue and attributes it to the innermost event loop's event.
void PauseLog::close(Clock::time_point now) {
    if (!running_) return;
    running_ = false;
    const double ms = msBetween(started_, now);
    gap_.ms += ms;
    gap_.drawing += drawing_;
    if (ms < kListedFromMs) return;
    const auto frame = std::find_if(stack_.rbegin(), stack_.rend(), [](const Frame& f) { return f.outermost; });
    if (frame == stack_.rend()) return;
    const QString what = describe(*frame, ms);
    if (ms > gapLongest_) {
        gapLongest_ = ms;
        gap_.what = what;
    }
    Pause& pause = worst_[what];
    const int times = pause.times + 1;
    if (times == 1 || ms - drawing_ > pause.computed()) pause = {what, ms, drawing_, 0};
    pause.times = times;
}

void PauseLog::queuePolled() {
    close(Clock::now());
    if (gap_.ms > longestGap_.ms) longestGap_ = gap_;
    gap_ = {};
    gapLongest_ = 0;
}

void PauseLog::push(Frame frame) {
    frame.start = Clock::now();
    stack_.push_back(std::move(frame));
}

void PauseLog::pop() {
    const auto now = Clock::now();
    const Frame& frame = stack_.back();
    const double ms = msBetween(frame.start, now);
    if (frame.drawing) drawing_ += std::max(0.0, ms - frame.inside);
    if (frame.outermost) {
        close(now);
        stack_.pop_back();
        if (!stack_.empty()) open();  // the event that ran a nested loop continues
        return;
    }
    if (stack_.size() > 1) {
        Frame& outer = stack_[stack_.size() - 2];
        // Subtracted from the enclosing part, so that painting time is not counted twice.
        outer.inside += ms;
        if (ms >= kListedFromMs && ms > outer.longest) {
            outer.longest = ms;
            outer.longestName = describe(frame, ms);
            // If an event was only forwarded to another object, the part inside it is the better name.
            if (frame.type != 0 && frame.longest > kNamingShare * ms) outer.longestName = frame.longestName;
        }
    }
    stack_.pop_back();
}

void PauseLog::enter(const QObject* receiver, QEvent::Type type, int loop) {
    thread_ = std::this_thread::get_id();
    Frame frame;
    frame.name = receiver->metaObject()->className();
    frame.object = receiver->objectName();
    frame.type = type;
    frame.loop = loop;
    frame.outermost = stack_.empty() || loop > stack_.back().loop;
    // These events compose the window from its panes' pictures, or create its surface, which counts as painting.
    frame.drawing = type == QEvent::UpdateRequest || type == QEvent::Expose ||
                    (type == QEvent::Paint && qobject_cast<const QOpenGLWidget*>(receiver) != nullptr);
    if (frame.outermost) {
        close(Clock::now());
        open();
    }
    push(std::move(frame));
}

void PauseLog::leave() {
    if (!stack_.empty()) pop();
}

PauseLog::Part::Part(const char* name, bool drawing) : measured_(instance().thread_ == std::this_thread::get_id()) {
    if (!measured_) return;
    PauseLog& log = instance();
    Frame frame;
    frame.name = name;
    frame.drawing = drawing;
    frame.loop = log.stack_.empty() ? 0 : log.stack_.back().loop;
    log.push(std::move(frame));
}

PauseLog::Part::~Part() {
    if (measured_ && !instance().stack_.empty()) instance().pop();
}

}  // namespace reliefui
