#include "progress_bar.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace relief::app {

namespace {

constexpr double kShowAfter = 1.0;    // seconds
constexpr double kRedrawEvery = 0.1;  // seconds
constexpr double kLineEvery = 10;     // seconds between lines of a log
constexpr int kBarCells = 24;

int terminalColumns() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void writeTerminal(std::string_view text) {
    // The work does not depend on the bar: a closed terminal is not an error.
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

double secondsBetween(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

ProgressBar::ProgressBar(bool shown, bool lines, Language language)
    : shown_(shown && isatty(STDERR_FILENO) == 1),
      lines_(lines && !shown_),
      language_(language),
      begun_(Clock::now()),
      drawn_(begun_) {}

Progress::Listener ProgressBar::listener() {
    if (!shown_ && !lines_) return {};
    return [this](std::string_view what, double fraction) { update(what, fraction); };
}

void ProgressBar::update(std::string_view what, double fraction) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (what != what_ || fraction <= 0) {
        what_ = what;
        begun_ = now;
        lineWritten_ = false;
        return;
    }
    const double spent = secondsBetween(begun_, now);
    if (lines_) {
        if (spent < kShowAfter || fraction >= 1 || (lineWritten_ && secondsBetween(drawn_, now) < kLineEvery)) return;
        drawn_ = now;
        lineWritten_ = true;
        writeTerminal("relief: " + progressSentence(what, fraction, spent * (1 - fraction) / fraction, language_) +
                      "\n");
        return;
    }
    // Work that has almost finished within its first second shows no bar, which would only flash.
    if (!visible_ && (spent < kShowAfter || fraction >= 1)) return;
    if (secondsBetween(drawn_, now) < kRedrawEvery) return;
    drawn_ = now;
    visible_ = true;
    const double left = spent * (1 - fraction) / fraction;
    std::string text = "\r";
    text += progressLine(what, fraction, left, terminalColumns() - 1, language_);
    writeTerminal(text += "\033[K");
}

void ProgressBar::erase() {
    const std::lock_guard lock(mutex_);
    if (!visible_) return;
    visible_ = false;
    writeTerminal("\r\033[K");
}

std::string durationText(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(std::clamp(seconds, 1.0, 1e9)));
    if (whole < 60) return std::to_string(whole) + " s";
    const std::string rest = std::to_string(whole % 60);
    return std::to_string(whole / 60) + " min " + (rest.size() < 2 ? "0" : "") + rest + " s";
}

std::string progressSentence(std::string_view what, double fraction, double secondsLeft, Language language) {
    const int percent = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * 100);
    return sentence(Message(MessageId::ProgressSays,
                            {{"what", std::string(what)}, {"percent", percent}, {"time", durationText(secondsLeft)}}),
                    language);
}

std::string progressLine(std::string_view what, double fraction, double secondsLeft, int columns, Language language) {
    const int filled = static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * kBarCells));
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(kBarCells - filled), '-');
    const int percent = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * 100);
    const std::string left = sentence(Message(MessageId::TimeLeft, {{"time", durationText(secondsLeft)}}), language);
    std::string line = std::string(what) + "  [" + bar + "]  " + std::to_string(percent) + "%  " + left;
    // On a narrow terminal the line would wrap, and "\r" would erase only its last row; the shortest form is shown
    // instead.
    if (static_cast<int>(line.size()) > columns) line = std::to_string(percent) + "%";
    return line;
}

}  // namespace relief::app
