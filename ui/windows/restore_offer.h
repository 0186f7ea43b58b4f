// Offers to restore the state of windows that did not end cleanly: one message with "Restore" and "Discard" at a time,
// the newest first. Nothing is opened without consent. If the message is closed without an answer, it is shown again at
// the next start.
#pragma once

#include <vector>

#include <QObject>

#include "scenario/scenario.h"
#include "workspace/session_files.h"

namespace reliefui {

class MainWindow;
class StateKeeper;
class Workspace;

class RestoreOffer : public QObject {
    Q_OBJECT
  public:
    RestoreOffer(MainWindow* window, Workspace* workspace, StateKeeper* keeper, std::vector<SessionFiles> left);

    // Returns the sessions that the user neither answered nor dismissed, for a window that replaces this one, for
    // instance after a change of language.
    std::vector<SessionFiles> unanswered();

  private:
    void offer();
    void restore();
    void discard();

    MainWindow* window_;
    Workspace* workspace_;
    StateKeeper* keeper_;
    std::vector<SessionFiles> left_;  // the first one is being offered
    relief::Scenario scenario_;       // scenario of the first one
};

}  // namespace reliefui
