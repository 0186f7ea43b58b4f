// The QApplication. Every event of the window's thread passes through notify(), which logs how long it occupied the
// thread (PauseLog).
#pragma once

#include <QApplication>

namespace reliefui {

class Application : public QApplication {
    Q_OBJECT
  public:
    Application(int& count, char** values);
    ~Application() override;

    bool notify(QObject* receiver, QEvent* event) override;
};

}  // namespace reliefui
