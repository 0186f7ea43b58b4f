#include "display_loss.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>

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
};
Handling* handling = nullptr;

// Time for the window's thread to notice what another thread has noticed first.
constexpr int kNoticeSeconds = 5;

// Ends the process at once: libraries would use the display again when they are destroyed.
[[noreturn]] void end() {
    // The window's thread holds the state. It notices the loss as well, because it waits for events of the display.
    if (std::this_thread::get_id() != handling->windowThread) {
        ::sleep(kNoticeSeconds);
        ::_exit(DisplayLoss::kStatus);
    }
    static bool ending = false;
    if (std::exchange(ending, true)) ::_exit(DisplayLoss::kStatus);
    const char* const display = std::getenv("DISPLAY");
    const Message message(handling->save() ? MessageId::DisplayLostKept : MessageId::DisplayLost,
                          {{"name", display != nullptr ? display : ""}});
    std::fprintf(stderr, "reliefscope: %s\n", sentence(message, reliefui::uiLanguage()).c_str());
    ::_exit(DisplayLoss::kStatus);
}

int onBrokenConnection(Display*) {
    end();
}

// Qt has a connection of its own. When it is broken, Qt reports that by the first message, and then calls exit(); when
// it cannot be opened, although it could just before (displayProblem()), by the second, and then calls abort().
void onMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    for (const char* const broken : {"The X11 connection broke", "could not connect to display"}) {
        if (text.startsWith(QLatin1String(broken))) end();
    }
    if (handling->earlier != nullptr) return handling->earlier(type, context, text);
    std::fprintf(stderr, "%s\n", qPrintable(qFormatLogMessage(type, context, text)));
    if (type == QtFatalMsg) std::abort();
}

}  // namespace

DisplayLoss::DisplayLoss() {
    handling = new Handling;
    handling->windowThread = std::this_thread::get_id();
    handling->earlier = qInstallMessageHandler(onMessage);
}

void DisplayLoss::saveBy(std::function<bool()> save) {
    handling->save = std::move(save);
    XSetIOErrorHandler(onBrokenConnection);
}

// What the handlers use is kept, because other threads may be running them.
DisplayLoss::~DisplayLoss() {
    XSetIOErrorHandler(nullptr);
    qInstallMessageHandler(handling->earlier);
    handling->save = [] { return false; };
}

}  // namespace relief::app
