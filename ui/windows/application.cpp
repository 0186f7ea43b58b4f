#include "windows/application.h"

#include <QAbstractEventDispatcher>
#include <QEvent>
#include <QThread>

#include "workspace/discard.h"
#include "workspace/pause_log.h"

namespace reliefui {

Application::Application(int& count, char** values) : QApplication(count, values) {
    const auto* const dispatcher = QAbstractEventDispatcher::instance();
    const auto queuePolled = [] { PauseLog::instance().queuePolled(); };
    connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, queuePolled);
    connect(dispatcher, &QAbstractEventDispatcher::awake, this, queuePolled);
    freesInBackground() = true;
}

// Deferred destruction stops first: Qt's destructor waits for the background threads that free memory.
Application::~Application() {
    freesInBackground() = false;
}

bool Application::notify(QObject* receiver, QEvent* event) {
    // Only the window's thread is measured; other threads run their own event loops.
    if (receiver == nullptr || QThread::currentThread() != thread()) return QApplication::notify(receiver, event);
    struct Held {
        Held(const QObject* receiver, QEvent::Type type) {
            PauseLog::instance().enter(receiver, type, QThread::currentThread()->loopLevel());
        }
        ~Held() { PauseLog::instance().leave(); }
    };
    const Held held(receiver, event->type());
    return QApplication::notify(receiver, event);
}

}  // namespace reliefui
