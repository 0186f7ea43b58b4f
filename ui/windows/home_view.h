// The home view: the camera with which the scene was opened. It belongs to the workspace, because a window that
// replaces another, after a change of language, finds the camera already turned.
#pragma once

#include <QObject>

#include "workspace/workspace.h"

namespace reliefui {

class HomeView : public QObject {
    Q_OBJECT
  public:
    // Returns that of the workspace, which is made for the first window.
    static HomeView* of(Workspace* workspace);

    void go();

  private:
    explicit HomeView(Workspace* workspace);
    void watch();

    Workspace* workspace_;
    relief::Scenario seen_;
    relief::Camera camera_;
};

}  // namespace reliefui
