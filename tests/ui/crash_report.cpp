#include "crash_report.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>

#include <execinfo.h>
#include <sys/prctl.h>
#include <unistd.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/common_interface_defs.h>
#endif

namespace reliefui {
namespace {

constexpr std::size_t kLines = 25;
constexpr std::size_t kLength = 160;
constexpr int kFrames = 64;

// Allocated in advance, because a signal handler must not allocate memory.
struct Remembered {
    std::array<std::array<char, kLength>, kLines> lines{};
    std::array<std::size_t, kLines> lengths{};
    std::size_t count = 0;
};
Remembered remembered;

void say(const char* text, std::size_t length) {
    while (length > 0) {
        const ssize_t written = write(STDERR_FILENO, text, length);
        if (written <= 0) return;
        text += written;
        length -= static_cast<std::size_t>(written);
    }
}

void say(const char* text) {
    say(text, std::strlen(text));
}

void sayRemembered() {
    if (remembered.count == 0) return;
    say("the last steps:\n");
    for (std::size_t i = remembered.count - std::min(remembered.count, kLines); i < remembered.count; ++i) {
        say(remembered.lines[i % kLines].data(), remembered.lengths[i % kLines]);
        say("\n");
    }
}

#ifndef __SANITIZE_ADDRESS__
// After a stack overflow the handler needs a stack of its own.
constexpr std::size_t kStackBytes = 1 << 16;
std::array<char, kStackBytes> handlerStack;

void onSignal(int signal) {
    std::array<char, 17> thread{};
    prctl(PR_GET_NAME, thread.data());
    say("\nthe tests crash: ");
    say(signal == SIGSEGV ? "SIGSEGV" : signal == SIGABRT ? "SIGABRT" : signal == SIGFPE ? "SIGFPE" : "SIGBUS");
    say(" in thread ");
    say(thread.data());
    say("\n");
    std::array<void*, kFrames> frames{};
    backtrace_symbols_fd(frames.data(), backtrace(frames.data(), kFrames), STDERR_FILENO);
    sayRemembered();
    raise(signal);  // the default handler ends the program
}
#endif

}  // namespace

void reportCrashes() {
#ifdef __SANITIZE_ADDRESS__
    // The sanitizer itself prints a stack trace with line numbers.
    __sanitizer_set_death_callback(&sayRemembered);
#else
    std::array<void*, 1> frame{};
    backtrace(frame.data(), 1);  // loads the library that backtrace() needs
    stack_t stack{};
    stack.ss_sp = handlerStack.data();
    stack.ss_size = handlerStack.size();
    sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = &onSignal;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) sigaction(signal, &action, nullptr);
#endif
}

void rememberForCrash(std::string_view text) {
    std::array<char, kLength>& line = remembered.lines[remembered.count % kLines];
    const std::size_t length = std::min(text.size(), kLength);
    std::copy_n(text.data(), length, line.data());
    remembered.lengths[remembered.count % kLines] = length;
    ++remembered.count;
}

}  // namespace reliefui
