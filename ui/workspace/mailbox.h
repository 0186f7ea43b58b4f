// Calls from any thread to the thread of an event loop. Calls are kept in a queue under a mutex of our own, and Qt's
// event says only that there is one: so the order of the memory that a call brings along rests on std::mutex, which the
// thread sanitizer understands, and not on Qt's queues, which it does not see.
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
    // Where calls are posted; may outlive the mailbox: then they are dropped. Thread safe.
    class Address {
      public:
        void post(std::function<void()> call) const;

      private:
        friend class Mailbox;
        struct Queue;
        explicit Address(std::shared_ptr<Queue> queue) : queue_(std::move(queue)) {}
        std::shared_ptr<Queue> queue_;
    };

    // Calls run on the thread that makes the mailbox, in the order in which they were posted, each in an event of its
    // own. owner: named where it is said what holds the window's thread.
    explicit Mailbox(const QObject* owner);
    // On the same thread. What has not run is dropped.
    ~Mailbox() override;

    Address address() const { return address_; }
    void post(std::function<void()> call) const { address_.post(std::move(call)); }

  private:
    Q_INVOKABLE void deliver();

    Address address_;
};

}  // namespace reliefui
