#include "workspace/background_tasks.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

#include "workspace/background_call.h"

namespace reliefui {

namespace {

// Forwards a task's progress, at a limited rate.
class Reporter {
  public:
    using Callback = std::function<void(const QString& what, double fraction)>;
    explicit Reporter(Callback callback) : callback_(std::move(callback)) {}

    void operator()(std::string_view what, double fraction) {
        constexpr auto kBetween = std::chrono::milliseconds(50);
        {
            const std::lock_guard lock(mutex_);
            const auto now = std::chrono::steady_clock::now();
            if (now - last_ < kBetween) return;
            last_ = now;
        }
        callback_(QString::fromUtf8(what.data(), static_cast<int>(what.size())), fraction);
    }

  private:
    Callback callback_;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point last_;
};

}  // namespace

BackgroundTasks::BackgroundTasks(QObject* parent) : QObject(parent) {}

BackgroundTasks::~BackgroundTasks() {
    for (Running& running : running_) running.stop.request_stop();
}

void BackgroundTasks::start(const QObject* receiver, Task task) {
    const std::uint64_t id = ++lastId_;
    running_.push_back({id, {}});
    if (running_.size() == 1) Q_EMIT busyChanged(true);
    const auto call = [this, id, task = std::move(task), stop = running_.back().stop.get_token(),
                       receiver = QPointer<const QObject>(receiver), back = mailbox_.address()] {
        Reporter reporter([this, back](const QString& what, double fraction) {
            back.post([this, what, fraction] {
                if (busy()) Q_EMIT progress(what, fraction);
            });
        });
        relief::Work work(0, stop, [&](std::string_view what, double fraction) { reporter(what, fraction); });
        back.post([this, id, receiver, callback = task(work)] {
            finish(id);
            if (receiver) callback();
        });
    };
    runInBackground(call);
}

void BackgroundTasks::finish(std::uint64_t id) {
    std::erase_if(running_, [&](const Running& running) { return running.id == id; });
    if (running_.empty()) Q_EMIT busyChanged(false);
}

void BackgroundTasks::cancel() {
    for (Running& running : running_) running.stop.request_stop();
}

}  // namespace reliefui
