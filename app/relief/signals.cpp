#include "signals.h"

#include <pthread.h>
#include <string.h>
#include <unistd.h>

namespace relief::app {

namespace {

constexpr long kWakeNanoseconds = 50'000'000;

}  // namespace

std::string signalName(int status) {
    const char* const name = ::sigabbrev_np(status - 128);
    return "SIG" + std::string(name != nullptr ? name : "");
}

SignalWatch::SignalWatch() {
    // A closed pipe becomes an error of write(), so that temporary files are removed before the program ends
    // (program.cpp). A file that exceeds the size limit is handled in the same way and reported in a line.
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    sigemptyset(&signals_);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        // Signals that the caller has set to be ignored (nohup, a background job) stay ignored.
        struct sigaction action {};
        if (sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
        sigaddset(&signals_, number);
        watching_ = true;
    }
    if (!watching_) return;
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    thread_ = std::jthread([this](const std::stop_token& end) { watch(end); });
}

SignalWatch::~SignalWatch() {
    if (thread_.joinable()) {
        thread_.request_stop();
        // Makes sigtimedwait() return at once.
        pthread_kill(thread_.native_handle(), SIGTERM);
        thread_.join();
    }
}

void SignalWatch::watch(const std::stop_token& end) {
    const timespec wait{0, kWakeNanoseconds};
    while (!end.stop_requested()) {
        const int number = sigtimedwait(&signals_, nullptr, &wait);
        if (number <= 0 || end.stop_requested()) continue;
        if (status_ != 0) _exit(status_);
        status_ = 128 + number;
        source_.request_stop();
    }
}

}  // namespace relief::app
