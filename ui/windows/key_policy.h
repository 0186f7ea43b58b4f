// Decides which widget of the window receives a key.
//
// The keys that act on the view (Home, End, Space, digits, letters, `,` `.` `[` `]`) have the same meaning wherever the
// focus is; a control receives them only while the user is typing into it. One event filter on the application decides
// this for all controls of the window and of its floating panes, including those created later:
//
//   number, line of text        typed characters, Home and End: after a click into its text, or after Tab
//   button, check box           Space: after Tab
//   list, slider, tabs, label   none of these keys; arrows after Tab (sliders: also after a click)
//
// While a list is open, it receives all keys, because it is a window of its own. A control that got the focus in
// another way (Qt passes it on when a pane is hidden, or after a click on a list) receives no keys, and the focus
// returns to a view. Widgets that are not on screen do not keep the focus. The wheel changes a control only if the
// control got the focus in one of the ways listed; otherwise it scrolls the surrounding panel.
#pragma once

#include <functional>

#include <QObject>
#include <QPointer>

#include "panes/deferred_call.h"

class QKeyEvent;
class QMainWindow;
class QWidget;

namespace reliefui {

class KeyPolicy : public QObject {
    Q_OBJECT
  public:
    // Lives as long as `window`. fallback: returns the view that gets the focus if the last one that had it is not on
    // screen.
    KeyPolicy(QMainWindow* window, std::function<QWidget*()> fallback);

    // Call this after panes were shown or hidden. The focus is checked after the layout is done.
    void panesMoved() { focusCheck_.start(); }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool belongsToWindow(const QWidget* widget) const;
    bool keepsKey(QWidget* widget, const QKeyEvent& event);
    void focusCame(QWidget* widget, Qt::FocusReason reason);
    void pressed(QWidget* widget);
    void checkFocus();
    QWidget* viewFor(const QWidget* control) const;

    QMainWindow* window_;
    std::function<QWidget*()> fallback_;
    QPointer<QWidget> view_;  // the last view that had the focus
    QPointer<QWidget> held_;  // the control that the user chose explicitly, by Tab or a click
    bool tab_ = false;        // the focus is being moved by Tab
    bool tabBack_ = false;
    DeferredCall focusCheck_{this, [this] { checkFocus(); }};
};

}  // namespace reliefui
