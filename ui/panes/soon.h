// Schedules a call that runs once, however often it is requested: after the current event, but before the window is
// painted. A zero-timeout QTimer would fire only after painting, and the whole window would be composed again for each
// pane.
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
    // Withdraws the request.
    void stop() { wanted_ = false; }

  private:
    QObject* receiver_;  // must outlive this object
    std::function<void()> call_;
    bool wanted_ = false;
};

}  // namespace reliefui
