// Measures how long the window's thread is blocked: the time from one poll of its event queue to the next, and the
// event responsible. Time that QPainter, OpenGL and VTK spend on painting is separated from computation. For the
// window's thread only.
#pragma once

#include <chrono>
#include <map>
#include <thread>
#include <vector>

#include <QCoreApplication>
#include <QEvent>
#include <QString>

class QObject;

namespace reliefui {

class PauseLog {
    Q_DECLARE_TR_FUNCTIONS(reliefui::PauseLog)
  public:
    struct Pause {
        QString what;        // "Workspace MetaCall › trace 3-D"
        double ms = 0;       // in total
        double drawing = 0;  // part of `ms` spent on painting
        int times = 0;       // number of pauses of at least kListedFromMs
        double computed() const { return ms - drawing; }
    };
    static constexpr double kListedFromMs = 5;     // shorter pauses are not listed
    static constexpr double kMostComputedMs = 50;  // limit for computation in one event

    static PauseLog& instance();

    void clear();
    // The longest interval between two polls of the queue, which may comprise several events; `what` is the longest of
    // these.
    Pause longestGap() const { return gap_.ms > longestGap_.ms ? gap_ : longestGap_; }
    // The single event with the longest computation.
    Pause longestComputation() const;
    // The longest pause of each kind of event, sorted by computation time in descending order.
    std::vector<Pause> worst(std::size_t most) const;
    // Text for the user: one line per pause.
    QString text(std::size_t most) const;

    // Called by the application when an event begins (loop: nesting depth of event loops), when it ends, and when the
    // queue is polled.
    void enter(const QObject* receiver, QEvent::Type type, int loop);
    void leave();
    void queuePolled();

    // A named part of an event; it is measured from construction to destruction.
    class Part {
      public:
        explicit Part(const char* name, bool drawing = false);
        ~Part();
        Part(const Part&) = delete;
        Part& operator=(const Part&) = delete;

      private:
        bool measured_;  // false on other threads, which do not block the window
    };

  private:
    using Clock = std::chrono::steady_clock;
    // An event, or a part of one, in progress.
    struct Frame {
        const char* name = nullptr;  // name of the class or the part
        QString object;
        int type = 0;          // event type; 0 for a part
        bool drawing = false;  // counts as painting, except for nested parts
        bool outermost = false;
        int loop = 0;
        Clock::time_point start;
        double inside = 0;   // ms spent in nested parts
        double longest = 0;  // ms of the longest nested part
        QString longestName;
    };

    void push(Frame frame);
    void pop();
    void open();
    void close(Clock::time_point now);
    static QString nameOf(const Frame& frame);
    static QString describe(const Frame& frame, double ms);

    std::thread::id thread_;
    std::vector<Frame> stack_;
    bool running_ = false;  // an interval without a poll of the queue has begun, at started_
    Clock::time_point started_;
    double drawing_ = 0;  // ms of painting since started_
    Pause gap_;           // since the last poll
    double gapLongest_ = 0;
    Pause longestGap_;
    std::map<QString, Pause> worst_;
};

// Marks its lifetime as painting, by QPainter or by VTK and OpenGL.
class DrawingTime {
  public:
    explicit DrawingTime(const char* name) : part_(name, true) {}

  private:
    PauseLog::Part part_;
};

}  // namespace reliefui
