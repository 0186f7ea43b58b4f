#include "display_loss.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <QApplication>
#include <QString>
#include <QtGlobal>

#include "relief/messages.h"
#include "workspace/language.h"

// Included after Qt, because it defines the macro Bool.
#include <X11/Xlib.h>

namespace relief::app {

namespace {

// Neither Qt nor Xlib passes data to its handlers.
struct Handling {
    std::function<bool()> save = [] { return false; };
    std::thread::id windowThread;
    QtMessageHandler earlier = nullptr;
    std::array<struct sigaction, 2> earlierActions{};  // of kCrashes
    std::string lostLine;                              // prepared, because a signal handler must not allocate
    std::mutex mutex;                                  // of what follows
    std::string held;                                  // Qt's lines that are not printed yet
};
Handling* handling = nullptr;

// How libraries end a process that lost its display in the middle of a request: replies that did not come are read
// through null pointers (Qt, while it sets up its screens), or assertions fail.
constexpr std::array<int, 2> kCrashes = {SIGSEGV, SIGABRT};

constexpr std::string_view kSocketFolder = "/tmp/.X11-unix/";

// Time for another process to try the display, which then answers at once or has gone.
constexpr int kTrySeconds = 10;

// Time for the window's thread to notice what another thread has noticed first.
constexpr int kNoticeSeconds = 5;

std::string lineOf(MessageId what) {
    const char* const display = std::getenv("DISPLAY");
    const Message message(what, {{"name", display != nullptr ? display : ""}});
    return "reliefscope: " + sentence(message, reliefui::uiLanguage()) + "\n";
}

// Ends the process at once: libraries would use the display again when they are destroyed.
[[noreturn]] void end() {
    // The window's thread holds the state. It notices the loss as well, because it waits for events of the display.
    if (std::this_thread::get_id() != handling->windowThread) {
        ::sleep(kNoticeSeconds);
        ::_exit(DisplayLoss::kStatus);
    }
    static bool ending = false;
    if (std::exchange(ending, true)) ::_exit(DisplayLoss::kStatus);
    const std::string line = lineOf(handling->save() ? MessageId::DisplayLostKept : MessageId::DisplayLost);
    std::fputs(line.c_str(), stderr);
    ::_exit(DisplayLoss::kStatus);
}

// Only functions that a signal handler may call. Returns true if a connection to an X server has ended.
bool connectionHasEnded() {
    constexpr int kMostFiles = 1024;
    constexpr int kFirstPort = 6000, kPastPorts = 6064;
    for (int file = 0; file < kMostFiles; ++file) {
        sockaddr_storage address{};
        socklen_t size = sizeof address;
        if (::getpeername(file, reinterpret_cast<sockaddr*>(&address), &size) != 0) continue;
        bool server = false;
        if (address.ss_family == AF_UNIX) {
            const char* path = reinterpret_cast<const sockaddr_un&>(address).sun_path;
            if (*path == '\0') ++path;  // a name outside the file system
            server = std::strncmp(path, kSocketFolder.data(), kSocketFolder.size()) == 0;
        } else if (address.ss_family == AF_INET || address.ss_family == AF_INET6) {
            // Both have the port at the same place.
            const int port = ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
            server = port >= kFirstPort && port < kPastPorts;
        }
        pollfd ended{file, POLLRDHUP, 0};
        if (server && ::poll(&ended, 1, 0) > 0) return true;
    }
    return false;
}

// Only functions that a signal handler may call: another process of this program tries the display.
bool displayHasGone() {
    if (connectionHasEnded()) return true;
    const pid_t child = ::_Fork();  // unlike fork(), allowed in a signal handler
    if (child < 0) return false;
    if (child == 0) {
        for (const int signal : kCrashes) std::signal(signal, SIG_DFL);
        ::alarm(kTrySeconds);
        const int nothing = ::open("/dev/null", O_WRONLY);
        ::dup2(nothing, STDOUT_FILENO);
        ::dup2(nothing, STDERR_FILENO);
        ::execl("/proc/self/exe", "reliefscope", "--check-display", nullptr);
        ::_exit(0);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return false;
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == DisplayLoss::kNoDisplay;
}

void printHeld() {
    const std::lock_guard lock(handling->mutex);
    std::fputs(handling->held.c_str(), stderr);
    handling->held.clear();
}

// A crash of another cause ends the process as if this had not been called.
void onCrash(int signal) {
    if (displayHasGone()) {
        // As in end(): the window's thread saves the state.
        if (std::this_thread::get_id() != handling->windowThread) ::sleep(kNoticeSeconds);
        [[maybe_unused]] const auto written =
            ::write(STDERR_FILENO, handling->lostLine.data(), handling->lostLine.size());
        ::_exit(DisplayLoss::kStatus);
    }
    for (std::size_t n = 0; n < kCrashes.size(); ++n) ::sigaction(kCrashes[n], &handling->earlierActions[n], nullptr);
    ::raise(signal);
}

int onBrokenConnection(Display*) {
    end();
}

// Qt has a connection of its own. When it is broken, Qt reports that by the first message, and then calls exit(); when
// it cannot be opened, although it could just before (displayProblem()), by the second, and then calls abort().
// Warnings about missing replies may come first: they are held back until the next event, which then does not come.
void onMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    for (const char* const broken : {"The X11 connection broke", "could not connect to display"}) {
        if (text.startsWith(QLatin1String(broken))) end();
    }
    if (type == QtFatalMsg && displayHasGone()) end();
    {
        const std::lock_guard lock(handling->mutex);
        handling->held += qFormatLogMessage(type, context, text).toStdString() + '\n';
    }
    if (type == QtFatalMsg) {
        printHeld();
        std::abort();
    }
    if (qApp != nullptr) QMetaObject::invokeMethod(qApp, &printHeld, Qt::QueuedConnection);
}

}  // namespace

DisplayLoss::DisplayLoss() {
    handling = new Handling;
    handling->windowThread = std::this_thread::get_id();
    handling->lostLine = lineOf(MessageId::DisplayLost);
    handling->earlier = qInstallMessageHandler(onMessage);
    struct sigaction action {};
    action.sa_handler = onCrash;
    sigemptyset(&action.sa_mask);
    for (std::size_t n = 0; n < kCrashes.size(); ++n) {
        ::sigaction(kCrashes[n], &action, &handling->earlierActions[n]);
    }
    XSetIOErrorHandler(onBrokenConnection);
}

void DisplayLoss::saveBy(std::function<bool()> save) {
    handling->save = std::move(save);
    // Lines from before there was an application.
    QMetaObject::invokeMethod(qApp, &printHeld, Qt::QueuedConnection);
    XSetIOErrorHandler(onBrokenConnection);  // Qt may have set its own
}

void DisplayLoss::endQuietly() {
    // Xlib's own handler would print and end with status 1.
    XSetIOErrorHandler([](Display*) -> int { ::_exit(kNoDisplay); });
}

// What the handlers use is kept, because other threads may be running them.
DisplayLoss::~DisplayLoss() {
    for (std::size_t n = 0; n < kCrashes.size(); ++n) ::sigaction(kCrashes[n], &handling->earlierActions[n], nullptr);
    XSetIOErrorHandler(nullptr);
    qInstallMessageHandler(handling->earlier);
    printHeld();
    handling->save = [] { return false; };
}

}  // namespace relief::app
