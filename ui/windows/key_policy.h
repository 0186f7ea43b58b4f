// Who gets the keys of the window.
//
// The keys that look at things (Home, End, Space, digits, letters, `,` `.` `[` `]`) mean the same wherever the focus
// is; a control gets them only while somebody types into it. One event filter on the application decides it for all
// controls of the window and of its floating panes, also for those that are made later:
//
//   number, line of text        typed characters, Home and End: after a click into its text, or after Tab
//   button, box to tick         Space: after Tab
//   list, slider, tabs, label   none of these keys; arrows after Tab (sliders: also after a click)
//
// While a list is open, all keys are the list's: it is a window of its own. A control that got the focus in another
// way (Qt passes it on when a pane is hidden; a click on a list) gets no key at all, and the focus goes back to a view.
// Nothing out of sight keeps the focus. The wheel turns a control only if the control has the focus in one of these
// ways; otherwise it scrolls what is around.
#pragma once

#include <functional>

#include <QObject>
#include <QPointer>

#include "panes/soon.h"

class QKeyEvent;
class QMainWindow;
class QWidget;

namespace reliefui {

class KeyPolicy : public QObject {
    Q_OBJECT
  public:
    // Lives as long as `window`. fallback: the view that gets the focus if the last one that had it is out of sight.
    KeyPolicy(QMainWindow* window, std::function<QWidget*()> fallback);

    // To be called when panes have come into sight or gone out of it: checks where the focus is, after the layout.
    void panesMoved() { settle_.start(); }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool ours(const QWidget* widget) const;
    bool keepsKey(QWidget* widget, const QKeyEvent& event);
    void focusCame(QWidget* widget, Qt::FocusReason reason);
    void pressed(QWidget* widget);
    void settle();
    QWidget* viewFor(const QWidget* control) const;

    QMainWindow* window_;
    std::function<QWidget*()> fallback_;
    QPointer<QWidget> view_;  // the last one with the focus
    QPointer<QWidget> held_;  // the control that was chosen on purpose
    bool tab_ = false;        // the focus is being moved by Tab
    bool tabBack_ = false;
    Soon settle_{this, [this] { settle(); }};
};

}  // namespace reliefui
