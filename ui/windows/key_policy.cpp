#include "windows/key_policy.h"

#include <utility>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>

namespace reliefui {

namespace {

enum class Kind : std::uint8_t { None, List, Slider, Text, Button, Tabs, Label };

// Kind::None is a view, which receives keys as Qt delivers them.
Kind kindOf(const QWidget* widget) {
    if (const auto* const list = qobject_cast<const QComboBox*>(widget)) {
        return list->isEditable() ? Kind::Text : Kind::List;
    }
    if (qobject_cast<const QAbstractSpinBox*>(widget) != nullptr) return Kind::Text;
    if (qobject_cast<const QLineEdit*>(widget) != nullptr) return Kind::Text;
    if (qobject_cast<const QScrollBar*>(widget) != nullptr) return Kind::None;
    if (qobject_cast<const QAbstractSlider*>(widget) != nullptr) return Kind::Slider;
    if (qobject_cast<const QAbstractButton*>(widget) != nullptr) return Kind::Button;
    if (qobject_cast<const QTabBar*>(widget) != nullptr) return Kind::Tabs;
    if (qobject_cast<const QLabel*>(widget) != nullptr) return Kind::Label;
    return Kind::None;
}

// Scroll areas with controls do not count as views, although they take the focus when their background is clicked.
bool scrolls(const QWidget* widget) {
    return qobject_cast<const QScrollArea*>(widget) != nullptr;
}

// The keys with the same meaning everywhere: all printable characters, Home and End.
bool actsOnView(const QKeyEvent& event) {
    if ((event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != 0) return false;
    if (event.key() == Qt::Key_Home || event.key() == Qt::Key_End) return true;
    return !event.text().isEmpty() && event.text().front().isPrint();
}

bool isTab(const QKeyEvent& event) {
    return event.key() == Qt::Key_Tab || event.key() == Qt::Key_Backtab;
}

bool isSpace(const QKeyEvent& event) {
    return event.key() == Qt::Key_Space && event.modifiers() == Qt::NoModifier;
}

// Returns true if the widget is on screen. A pane behind another one's tab lies outside the window, yet isVisible() is
// true for it.
bool isOnScreen(const QWidget* widget) {
    if (!widget->isVisible()) return false;
    for (; widget != nullptr; widget = widget->parentWidget()) {
        const auto* const dock = qobject_cast<const QDockWidget*>(widget);
        if (dock != nullptr) return dock->isFloating() || !dock->visibleRegion().isEmpty();
    }
    return true;
}

// The next widget in Tab order that is on screen; null if there is no other.
QWidget* nextOnScreen(const QWidget* from, bool back) {
    const auto step = [back](const QWidget* at) { return back ? at->previousInFocusChain() : at->nextInFocusChain(); };
    for (QWidget* at = step(from); at != from; at = step(at)) {
        const bool takesTab = (at->focusPolicy() & Qt::TabFocus) != 0 && at->focusProxy() == nullptr;
        if (takesTab && at->isEnabled() && at->window() == from->window() && isOnScreen(at)) return at;
    }
    return nullptr;
}

}  // namespace

KeyPolicy::KeyPolicy(QMainWindow* window, std::function<QWidget*()> fallback)
    : QObject(window), window_(window), fallback_(std::move(fallback)) {
    QApplication::instance()->installEventFilter(this);
}

// True for widgets of the window and its floating panes; false for dialogs and open lists.
bool KeyPolicy::belongsToWindow(const QWidget* widget) const {
    const QWidget* const top = widget->window();
    return top == window_ || (qobject_cast<const QDockWidget*>(top) != nullptr && top->parentWidget() == window_);
}

bool KeyPolicy::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Polish:
        case QEvent::FocusIn:
        case QEvent::KeyPress:
        case QEvent::ShortcutOverride:
        case QEvent::Wheel:
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseButtonRelease:
            break;
        default:
            return false;
    }
    auto* const widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr || !belongsToWindow(widget)) return false;
    const Kind kind = kindOf(widget);
    switch (event->type()) {
        case QEvent::Polish:
            // Turning the wheel must not move the focus.
            if (kind != Kind::None && widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
            // Tab leaves a table instead of moving between its cells.
            if (auto* const table = qobject_cast<QAbstractItemView*>(widget)) table->setTabKeyNavigation(false);
            return false;
        case QEvent::FocusIn:
            focusCame(widget, static_cast<QFocusEvent*>(event)->reason());
            return false;
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
            pressed(widget);
            return false;
        case QEvent::MouseButtonRelease:
            focusCheck_.start();
            return false;
        case QEvent::Wheel:
            if (widget == held_ || (kind != Kind::List && kind != Kind::Slider && kind != Kind::Text)) return false;
            break;
        default:
            if (!keepsKey(widget, *static_cast<QKeyEvent*>(event))) break;
            // Buttons do not claim Space from the shortcuts themselves, so it is claimed for them.
            if (kind != Kind::Button || widget != held_ || !isSpace(*static_cast<QKeyEvent*>(event))) return false;
            if (event->type() != QEvent::ShortcutOverride) return false;
            event->accept();
            return true;
    }
    // Passes the event on to the parents and finally to the window and its shortcuts.
    event->ignore();
    return true;
}

// Returns true if the widget may receive the key.
bool KeyPolicy::keepsKey(QWidget* widget, const QKeyEvent& event) {
    if (event.type() == QEvent::KeyPress && isTab(event)) {
        tab_ = true;
        tabBack_ = event.key() == Qt::Key_Backtab || (event.modifiers() & Qt::ShiftModifier) != 0;
        focusCheck_.start();
        return true;
    }
    const Kind kind = kindOf(widget);
    // Events that pass this widget on their way to a parent, and Tab, are not filtered.
    if (kind == Kind::None || !widget->hasFocus() || isTab(event)) return true;
    if (widget != held_) return false;
    if (kind == Kind::Text) {
        const bool done = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
        if (done && event.type() == QEvent::KeyPress) {
            // The box accepts the number; after that, keys act on the view again.
            held_ = nullptr;
            focusCheck_.start();
        }
        return true;
    }
    return !actsOnView(event) || (kind == Kind::Button && isSpace(event));
}

void KeyPolicy::focusCame(QWidget* widget, Qt::FocusReason reason) {
    const bool byTab = tab_ && (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason);
    if (kindOf(widget) != Kind::None) {
        if (byTab || reason == Qt::ShortcutFocusReason) {
            held_ = widget;
        } else if (held_ != widget) {
            held_ = nullptr;
        }
    } else if (qobject_cast<QMenuBar*>(widget) == nullptr) {
        if (!scrolls(widget)) view_ = widget;
        held_ = nullptr;
    }
    focusCheck_.start();
}

void KeyPolicy::pressed(QWidget* widget) {
    tab_ = false;
    const Kind kind = kindOf(widget);
    if (qobject_cast<QLineEdit*>(widget) != nullptr) {
        // The line edit inside a spin box: the focus belongs to the box.
        QWidget* const box = widget->parentWidget();
        held_ = kindOf(box) == Kind::Text ? box : widget;
    } else if (kind == Kind::Slider || kind == Kind::Label) {
        held_ = widget;
    } else if (widget == held_) {
        held_ = nullptr;
    }
}

void KeyPolicy::checkFocus() {
    const bool tab = std::exchange(tab_, false);
    // Called again when the mouse button is released or the list is closed.
    if (QApplication::mouseButtons() != Qt::NoButton || QApplication::activePopupWidget() != nullptr) return;
    QWidget* const now = QApplication::focusWidget();
    if (now == nullptr ? QApplication::activeWindow() != window_ : !belongsToWindow(now)) return;
    const bool seen = now != nullptr && isOnScreen(now);
    if (seen && (kindOf(now) == Kind::None || now == held_)) return;
    QWidget* const next = tab && now != nullptr && !seen ? nextOnScreen(now, tabBack_) : nullptr;
    if (next != nullptr) {
        tab_ = true;
        next->setFocus(tabBack_ ? Qt::BacktabFocusReason : Qt::TabFocusReason);
        tab_ = false;
    } else if (QWidget* const view = viewFor(now)) {
        view->setFocus(Qt::OtherFocusReason);
    }
}

// The view of the control's pane; otherwise the last view that had the focus; otherwise the fallback.
QWidget* KeyPolicy::viewFor(const QWidget* control) const {
    for (const QWidget* at = control; at != nullptr && at != window_; at = at->parentWidget()) {
        QWidget* const proxy = at->focusProxy();
        if (proxy != nullptr && kindOf(proxy) == Kind::None && !scrolls(proxy) && isOnScreen(proxy)) return proxy;
    }
    if (view_ && belongsToWindow(view_) && isOnScreen(view_)) return view_;
    return fallback_();
}

}  // namespace reliefui
