#include "workspace/latest_job.h"

#include <new>

#include <QCoreApplication>

#include "workspace/language.h"

namespace reliefui {

namespace {

constexpr auto kBetweenProgress = std::chrono::milliseconds(50);

}  // namespace

LatestJob::LatestJob(const QObject* receiver, Listener listener)
    : mailbox_(receiver), listener_(std::move(listener)), thread_([this](const std::stop_token& quit) { run(quit); }) {}

LatestJob::~LatestJob() {
    thread_.request_stop();
    drop();
    wake_.notify_all();
}

void LatestJob::start(Job job) {
    {
        const std::lock_guard lock(mutex_);
        next_ = std::move(job);
        ++latest_;
        stop_.request_stop();
    }
    wake_.notify_all();
}

bool LatestJob::cancel() {
    const std::lock_guard lock(mutex_);
    if (answered_ == latest_) return false;
    next_.reset();
    stop_.request_stop();
    // The job may just have ended: its result, which is on its way, is that of an older job then.
    ++latest_;
    post(latest_, [this] { listener_.failed({}); });
    return true;
}

void LatestJob::drop() {
    const std::lock_guard lock(mutex_);
    next_.reset();
    answered_ = ++latest_;
    stop_.request_stop();
}

bool LatestJob::busy() const {
    const std::lock_guard lock(mutex_);
    return answered_ != latest_;
}

void LatestJob::post(std::uint64_t id, std::function<void()> call) {
    mailbox_.post([this, id, call = std::move(call)] {
        {
            const std::lock_guard lock(mutex_);
            if (id != latest_) return;
            answered_ = id;
        }
        call();
    });
}

void LatestJob::run(const std::stop_token& quit) {
    while (!quit.stop_requested()) {
        std::optional<Job> job;
        std::uint64_t id = 0;
        std::stop_token stop;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, quit, [&] { return next_.has_value(); });
            if (quit.stop_requested() || !next_) return;
            job.swap(next_);
            id = latest_;
            stop_ = std::stop_source();
            stop = stop_.get_token();
        }
        runOne(*job, id, stop);
    }
}

void LatestJob::runOne(const Job& job, std::uint64_t id, const std::stop_token& stop) {
    const auto report = [&](std::string_view what, double fraction) {
        {
            const std::lock_guard lock(progressMutex_);
            const auto now = Clock::now();
            if (now - lastProgress_ < kBetweenProgress) return;
            lastProgress_ = now;
        }
        const QString text = QString::fromUtf8(what.data(), static_cast<int>(what.size()));
        mailbox_.post([this, id, text, fraction] {
            {
                const std::lock_guard lock(mutex_);
                if (id != latest_ || answered_ == id) return;
            }
            listener_.progress(text, fraction);
        });
    };
    relief::Work work(0, stop, report);
    QString problem;
    try {
        job.work(work);
        post(id, job.done);
        return;
    } catch (const relief::Cancelled&) {
        return;  // replaced, dropped or cancelled; cancel() has reported that
    } catch (const relief::InputError& error) {
        problem = QString::fromStdString(error.text(uiLanguage()));
    } catch (const std::bad_alloc&) {
        problem = QCoreApplication::translate("reliefui::LatestJob", "not enough memory for this");
    } catch (const std::exception& error) {
        problem = QString::fromUtf8(error.what());
    }
    post(id, [this, problem] { listener_.failed(problem); });
}

}  // namespace reliefui
