// The home view: the camera with which the scene was opened.
#pragma once

#include <QObject>

#include "workspace/workspace.h"

namespace reliefui {

class HomeView : public QObject {
    Q_OBJECT
  public:
    explicit HomeView(Workspace* workspace, QObject* parent = nullptr);

    void go();

  private:
    void watch();

    Workspace* workspace_;
    relief::Scenario seen_;
    relief::Camera camera_;
};

}  // namespace reliefui
