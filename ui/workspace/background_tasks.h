// Long tasks in the background, several at once; each reports its progress, and all can be cancelled.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QString>

#include "relief/work.h"
#include "workspace/mailbox.h"

namespace reliefui {

class BackgroundTasks : public QObject {
    Q_OBJECT
  public:
    // Runs on another thread; the function it returns is then called on the window's thread. The task itself has to
    // report cancellation, exceptions and errors.
    using Task = std::function<std::function<void()>(relief::Work& work)>;

    explicit BackgroundTasks(QObject* parent);
    // Cancels all tasks; their results are dropped.
    ~BackgroundTasks() override;

    // receiver: the task's result is dropped if this object no longer exists.
    void start(const QObject* receiver, Task task);
    bool busy() const { return !running_.empty(); }

  public slots:
    void cancel();

  signals:
    void busyChanged(bool busy);
    void progress(const QString& what, double fraction);  // of the current stage, by its name

  private:
    void finish(std::uint64_t id);

    struct Running {
        std::uint64_t id = 0;
        std::stop_source stop;
    };
    std::vector<Running> running_;
    std::uint64_t lastId_ = 0;
    Mailbox mailbox_{this};
};

}  // namespace reliefui
