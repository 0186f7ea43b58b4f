// Passes calls from any thread to the thread of an event loop. The calls are kept in a queue under a mutex of our own,
// and Qt's event only signals that there is one. Memory ordering thus depends on std::mutex, which the thread sanitizer
// understands, and not on Qt's queues, which it cannot see.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>

#include <QObject>

namespace reliefui {

class Mailbox : public QObject {
    Q_OBJECT
  public:
    // Handle for posting calls. It may outlive the mailbox; calls are then dropped. Thread safe.
    class Address {
      public:
        void post(std::function<void()> call) const;

      private:
        friend class Mailbox;
        struct Queue;
        explicit Address(std::shared_ptr<Queue> queue) : queue_(std::move(queue)) {}
        std::shared_ptr<Queue> queue_;
    };

    // Calls run on the thread that constructs the mailbox, in the order in which they were posted, each in an event of
    // its own. owner: its class name identifies these events in PauseLog.
    explicit Mailbox(const QObject* owner);
    // Must run on the same thread. Pending calls are dropped.
    ~Mailbox() override;

    Address address() const { return address_; }
    void post(std::function<void()> call) const { address_.post(std::move(call)); }

  private:
    Q_INVOKABLE void deliver();

    Address address_;
};

}  // namespace reliefui
