// Offers what windows left behind that did not end cleanly: one line in the window with "Restore" and "Discard", the
// newest first. Nothing is opened unasked; who closes the line is asked again at the next start.
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

    // Nobody has answered, nor closed the line: what another window is to offer, one in another language.
    std::vector<SessionFiles> unanswered();

  private:
    void offer();
    void restore();
    void discard();

    MainWindow* window_;
    Workspace* workspace_;
    StateKeeper* keeper_;
    std::vector<SessionFiles> left_;  // the first is being offered
    relief::Scenario scenario_;       // its
};

}  // namespace reliefui
