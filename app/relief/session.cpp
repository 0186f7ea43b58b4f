#include "session.h"

#include <unistd.h>

namespace relief::app {

Work& Session::work() {
    if (!work_) {
        bar_ = std::make_unique<ProgressBar>(!quiet_, !quiet_ && verbose_, language_);
        work_ = std::make_unique<Work>(threads_, stop_, bar_->listener());
    }
    return *work_;
}

void Session::note(const std::string& subject, const Message& message) {
    if (quiet_) return;
    eraseBar();
    sayLine(subject + ": " + sentence(message, language_));
}

void sayLine(const std::string& text) {
    std::string line = "relief: " + text;
    for (char& c : line) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    line += '\n';
    // If standard error is closed, the message cannot be delivered; that is ignored.
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
}

int sayMemoryEnded() {
    constexpr std::string_view kLine = "relief: not enough memory\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kLine.data(), kLine.size());
    return kBadUsage;
}

}  // namespace relief::app
