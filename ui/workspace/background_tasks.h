// Tasks in the background that take long, several at once: each says how far it is, and all can be cancelled.
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
    // Runs on another thread; what it returns is called on the window's. Cancelled, thrown or found by `work`, is for
    // it to report.
    using Task = std::function<std::function<void()>(relief::Work& work)>;

    explicit BackgroundTasks(QObject* parent);
    // Cancels; nothing that is under way is reported any more.
    ~BackgroundTasks() override;

    // receiver: what is returned is dropped if it is gone by then.
    void start(const QObject* receiver, Task task);
    bool busy() const { return !running_.empty(); }

  public slots:
    void cancel();

  signals:
    void busyChanged(bool busy);
    void progress(const QString& what, double fraction);  // of the stage that is running, by its name

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
