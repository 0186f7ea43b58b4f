// Runs a call once, soon, however often it is asked for: when what happens now is over, but before the window is put on
// the screen. A timer of no time would come after that, and the whole window would be composed again for each pane.
#pragma once

#include <functional>
#include <utility>

#include <QObject>

namespace reliefui {

class Soon {
  public:
    Soon(QObject* receiver, std::function<void()> call) : receiver_(receiver), call_(std::move(call)) {}

    void start() {
        if (wanted_) return;
        wanted_ = true;
        QMetaObject::invokeMethod(
            receiver_,
            [this] {
                const bool run = wanted_;
                wanted_ = false;
                if (run) call_();
            },
            Qt::QueuedConnection);
    }
    // What was asked for is not run.
    void stop() { wanted_ = false; }

  private:
    QObject* receiver_;  // lives as long as this
    std::function<void()> call_;
    bool wanted_ = false;
};

}  // namespace reliefui
