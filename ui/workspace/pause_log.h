// How long the window's thread was held: from one look at its queue of events to the next, and with what. What
// QPainter, OpenGL and VTK take for putting pictures on the screen is told apart from what is computed there. The
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
        double ms = 0;       // in all
        double drawing = 0;  // of them ms of painting
        int times = 0;       // that it took kWorthTelling or longer
        double ours() const { return ms - drawing; }
    };
    static constexpr double kWorthTelling = 5;  // ms: shorter ones are not listed
    static constexpr double kMostOfOurs = 50;   // ms: what no computation may take

    static PauseLog& instance();

    void clear();
    // Between two looks at the queue, of all events and of one; ms are those of the longest.
    Pause longestGap() const { return gap_.ms > longestGap_.ms ? gap_ : longestGap_; }
    // One event, by what was computed for it.
    Pause longestOurs() const;
    // The longest of each kind of event, most computed first.
    std::vector<Pause> worst(std::size_t most) const;
    // For a person: a line each.
    QString text(std::size_t most) const;

    // Told by the application: an event begins (loop: how many event loops run inside one another), ends; the queue is
    // looked at.
    void enter(const QObject* receiver, QEvent::Type type, int loop);
    void leave();
    void looked();

    // A part of an event with a name of its own, for as long as it lives.
    class Part {
      public:
        explicit Part(const char* name, bool drawing = false);
        ~Part();
        Part(const Part&) = delete;
        Part& operator=(const Part&) = delete;

      private:
        bool told_;  // other threads hold nobody
    };

  private:
    using Clock = std::chrono::steady_clock;
    // An event, or a part of it, that has begun.
    struct Frame {
        const char* name = nullptr;  // of the class or the part
        QString object;
        int type = 0;          // of the event; 0: a part
        bool drawing = false;  // its own time is that of painting
        bool outermost = false;
        int loop = 0;
        Clock::time_point start;
        double inside = 0;   // ms of what it called
        double longest = 0;  // ms of the longest of those
        QString longestName;
    };

    void push(Frame frame);
    void pop();
    void open();
    void close(Clock::time_point now);
    static QString nameOf(const Frame& frame);
    static QString told(const Frame& frame, double ms);

    std::thread::id thread_;
    std::vector<Frame> stack_;
    bool running_ = false;  // since started_, without a look at the queue
    Clock::time_point started_;
    double drawing_ = 0;  // ms since then
    Pause gap_;           // since the last look
    double gapLongest_ = 0;
    Pause longestGap_;
    std::map<QString, Pause> worst_;
};

// A picture is painted, by QPainter or by VTK and OpenGL.
class DrawingTime {
  public:
    explicit DrawingTime(const char* name) : part_(name, true) {}

  private:
    PauseLog::Part part_;
};

}  // namespace reliefui
