// Autosave: saves the state of the window during work, so that a crash loses only seconds. Every few seconds, changes
// are written to the session's files by a thread of its own. A clean exit stores the state as the last state
// (keepState()), with which the next window starts.
#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <QVariantMap>

#include "scenario/scenario.h"
#include "workspace/session_files.h"

namespace reliefui {

class Workspace;

class StateKeeper : public QObject {
    Q_OBJECT
  public:
    // layout: returns the current layout of the panes. `beginning`: the scenario with which the window started, which
    // is not saved.
    StateKeeper(Workspace* workspace, SessionFiles files, const relief::Scenario& beginning,
                std::function<QVariantMap()> layout);
    // Waits for pending writes. Files not removed by end() are kept.
    ~StateKeeper() override;

    static constexpr int kEveryMs = 3000;
    // For tests.
    void setInterval(int ms) { timer_.setInterval(ms); }

    // Keeps the files of a restored session until their contents have been saved in those of this session.
    void adopt(SessionFiles left, const relief::Scenario& scenario);
    // Call this after the window was closed. Returns an empty string on success, otherwise a one-line explanation; in
    // that case the session's files are kept.
    std::string end();

    // Saves the state at once and in this thread, for a program that ends without closing its window. The layout is
    // that of the last autosave. Returns true if the session's files hold the state, also from before.
    bool keepNow();

  signals:
    void problem(const QString& oneLine);  // the state cannot be written; emitted once

  private:
    struct State {
        relief::Scenario scenario;
        QVariantMap layout;
    };

    void checkForChanges();
    void checkAdopted();
    void write(State state);
    void written(const State& state, const QString& fault);

    Workspace* workspace_;
    SessionFiles files_;
    relief::Scenario saved_;
    QVariantMap layoutSaved_;
    std::function<QVariantMap()> layout_;
    std::optional<SessionFiles> adopted_;
    relief::Scenario adoptedScenario_;
    bool adoptedShown_ = false;
    bool shown_ = false;  // the first full picture has been shown
    bool writing_ = false;
    bool reported_ = false;
    QTimer timer_;
    QThreadPool writer_;
};

}  // namespace reliefui
