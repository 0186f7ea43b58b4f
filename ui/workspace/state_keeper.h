// Saves the state of the window while somebody works in it, so that a crash costs seconds: what has changed is looked
// for every few seconds and written on a thread of its own into the files of the session. A clean end makes it the last
// state (keepState()), with which the next window begins.
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
    // layout: where the panes are now. `beginning`: the scenario that the window was started with, worth no file.
    StateKeeper(Workspace* workspace, SessionFiles files, const relief::Scenario& beginning,
                std::function<QVariantMap()> layout);
    // Waits for what is being written. Files that were not removed by end() stay.
    ~StateKeeper() override;

    static constexpr int kEveryMs = 3000;
    // For tests.
    void setInterval(int ms) { timer_.setInterval(ms); }

    // Keeps the files that somebody has chosen to restore until what they hold is in the files of this session.
    void adopt(SessionFiles left, const relief::Scenario& scenario);
    // After the window was closed. Returns in one line why the state cannot be written; then the session's files stay.
    std::string end();

  signals:
    void problem(const QString& oneLine);  // it cannot be written; said once

  private:
    struct State {
        relief::Scenario scenario;
        QVariantMap layout;
    };

    void look();
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
    bool shown_ = false;  // the first full picture
    bool writing_ = false;
    bool told_ = false;
    QTimer timer_;
    QThreadPool writer_;
};

}  // namespace reliefui
