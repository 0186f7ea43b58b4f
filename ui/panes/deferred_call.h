// Schedules a call that runs once, however often it is requested: after the current event, but before the window is
// painted. A zero-timeout QTimer would fire only after painting, and the whole window would be composed again for each
// pane.
#pragma once

#include <functional>
#include <utility>

#include <QObject>

namespace reliefui {

class DeferredCall {
  public:
    DeferredCall(QObject* receiver, std::function<void()> call) : receiver_(receiver), call_(std::move(call)) {}

    void start() {
        if (pending_) return;
        pending_ = true;
        QMetaObject::invokeMethod(
            receiver_,
            [this] {
                const bool run = pending_;
                pending_ = false;
                if (run) call_();
            },
            Qt::QueuedConnection);
    }
    // Withdraws the request.
    void stop() { pending_ = false; }

  private:
    QObject* receiver_;  // must outlive this object
    std::function<void()> call_;
    bool pending_ = false;
};

}  // namespace reliefui
