#include "panes/screen_gl.h"

#include <QBoxLayout>
#include <QLabel>

#include "relief/messages.h"
#include "workspace/language.h"

// Included after Qt, because it defines the macro Bool.
#include <X11/Xlib.h>

namespace reliefui {

namespace {

bool askedForGl() {
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) return true;
    int opcode = 0, event = 0, error = 0;
    const bool glx = XQueryExtension(display, "GLX", &opcode, &event, &error) != 0;
    XCloseDisplay(display);
    return glx;
}

}  // namespace

bool screenHasGl() {
    static const bool has = askedForGl();
    return has;
}

QWidget* glParent(QWidget* pane) {
    return screenHasGl() ? pane : nullptr;
}

void addGlWidget(QWidget& widget, QBoxLayout& layout, QWidget& pane) {
    if (screenHasGl()) return layout.addWidget(&widget, 1);
    pane.setFocusProxy(nullptr);
    QObject::connect(&pane, &QObject::destroyed, [hidden = &widget] { delete hidden; });
    const relief::Message why(relief::MessageId::PaneNoGl);
    auto* const note = new QLabel(QString::fromStdString(relief::sentence(why, uiLanguage())), &pane);
    note->setObjectName(QStringLiteral("no-opengl"));
    note->setAlignment(Qt::AlignCenter);
    note->setWordWrap(true);
    layout.addWidget(note, 1);
}

}  // namespace reliefui
