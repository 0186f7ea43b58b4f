#include "workspace/mailbox.h"

#include <utility>

namespace reliefui {

struct Mailbox::Address::Queue {
    std::mutex mutex;
    std::deque<std::function<void()>> calls;
    Mailbox* mailbox = nullptr;  // null after the mailbox was destroyed
};

void Mailbox::Address::post(std::function<void()> call) const {
    const std::lock_guard lock(queue_->mutex);
    if (queue_->mailbox == nullptr) return;
    queue_->calls.push_back(std::move(call));
    QMetaObject::invokeMethod(queue_->mailbox, "deliver", Qt::QueuedConnection);
}

Mailbox::Mailbox(const QObject* owner) : address_(std::make_shared<Address::Queue>()) {
    setObjectName(QString::fromLatin1(owner->metaObject()->className()));
    address_.queue_->mailbox = this;
}

Mailbox::~Mailbox() {
    // destroyed after the lock is released, because objects held by the calls may post in their destructors
    std::deque<std::function<void()>> dropped;
    const std::lock_guard lock(address_.queue_->mutex);
    address_.queue_->mailbox = nullptr;
    dropped.swap(address_.queue_->calls);
}

void Mailbox::deliver() {
    std::function<void()> call;
    {
        const std::lock_guard lock(address_.queue_->mutex);
        if (address_.queue_->calls.empty()) return;
        call = std::move(address_.queue_->calls.front());
        address_.queue_->calls.pop_front();
    }
    call();
}

}  // namespace reliefui
