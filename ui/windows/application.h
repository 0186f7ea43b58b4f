// The application: every event of the window's thread goes through here, and how long each held it is logged.
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
