#include "end_signals.h"

#include <unistd.h>
#include <csignal>

#include <QApplication>
#include <QSocketNotifier>

namespace relief::app {

namespace {

constexpr std::array kSignals{SIGTERM, SIGINT, SIGHUP};

// Write end of the pipe. A handler may call no function of Qt, but may write.
volatile std::sig_atomic_t wakeEnd = -1;

void wake(int) {
    const char byte = 0;
    [[maybe_unused]] const auto written = ::write(static_cast<int>(wakeEnd), &byte, 1);
}

}  // namespace

EndSignals::EndSignals() {
    if (::pipe(pipe_.data()) != 0) return;
    wakeEnd = pipe_[1];
    notifier_ = std::make_unique<QSocketNotifier>(pipe_[0], QSocketNotifier::Read);
    QObject::connect(notifier_.get(), &QSocketNotifier::activated, notifier_.get(), [this] {
        notifier_->setEnabled(false);
        QApplication::quit();
    });
    for (const int signal : kSignals) std::signal(signal, wake);
}

EndSignals::~EndSignals() {
    for (const int signal : kSignals) std::signal(signal, SIG_DFL);
    notifier_.reset();
    for (const int end : pipe_) {
        if (end >= 0) ::close(end);
    }
}

}  // namespace relief::app
