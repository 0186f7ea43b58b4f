// Arrangement of the panes: the default layout, one pane that fills the window, teaching mode, projector mode.
#include <algorithm>
#include <map>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <QStyle>
#include <QTabBar>
#include <QTimer>

#include "panes/figure_view.h"
#include "panes/steps/step_sentence.h"
#include "windows/main_window.h"
#include "windows/status_line.h"
#include "windows/theme.h"
#include "windows/time_pane.h"

namespace reliefui {

namespace {

QString layoutKey() {
    return QStringLiteral("window/panes");
}
QString placeKey() {
    return QStringLiteral("window/place");
}
QString themeKey() {
    return QStringLiteral("window/light");
}

}  // namespace

void MainWindow::resetLayout() {
    showView(View::All);
    // Panes are hidden according to the plan first: showing more than fits would enlarge the window.
    const LayoutPlan plan = layoutPlan(false, workspace_->style().projector, size());
    for (const Pane& pane : panes_) {
        if (pane.dock != nullptr) pane.dock->setFloating(false);
        pane.whole->setVisible(pane.kind.open && (plan.controls || pane.dock != front(DockPlace::Left)));
    }
    arrange();
}

void MainWindow::arrange() {
    arrange(workspace_->style().projector);
}

// Arranges the panes as the mode's plan says. Closed and floating panes stay as they are.
void MainWindow::arrange(bool projector) {
    plan_ = layoutPlan(view_ == View::Teach, projector, size());
    QDockWidget* const active = activePane();
    addDockWidget(Qt::RightDockWidgetArea, front(DockPlace::UpperRight));
    addDockWidget(Qt::RightDockWidgetArea, front(DockPlace::LowerRight));
    addDockWidget(Qt::BottomDockWidgetArea, front(DockPlace::Bottom));
    addDockWidget(Qt::LeftDockWidgetArea, front(DockPlace::Left));
    if (!plan_.oneStack) splitDockWidget(front(DockPlace::UpperRight), front(DockPlace::LowerRight), Qt::Vertical);
    std::map<DockPlace, QDockWidget*> last;
    for (const Pane& pane : panes_) {
        if (pane.dock == nullptr || pane.dock->isFloating()) continue;
        const DockPlace place = placeOf(pane);
        if (last.contains(place)) tabifyDockWidget(last[place], pane.dock);
        last[place] = pane.dock;
    }
    if (!plan_.controls) front(DockPlace::Left)->hide();
    for (const DockPlace place : {DockPlace::UpperRight, DockPlace::Left, DockPlace::LowerRight, DockPlace::Bottom}) {
        if (!plan_.oneStack || place != DockPlace::LowerRight) front(place)->raise();
    }
    if (plan_.oneStack) active->raise();
    styleTabs();
    arranged_ = true;
    shareRoom();
    // Repeated once the window has its final size: until then, docks are at their minimum size.
    QTimer::singleShot(0, this, &MainWindow::shareRoom);
}

DockPlace MainWindow::placeOf(const Pane& pane) const {
    const bool controls = pane.dock == front(DockPlace::Left);
    const bool joins = pane.kind.place == DockPlace::LowerRight || pane.kind.place == DockPlace::UpperRight ||
                       (pane.kind.place == DockPlace::Left && !plan_.controls && !controls);
    return plan_.oneStack && joins ? DockPlace::UpperRight : pane.kind.place;
}

// The explaining pane in use: of those on screen the one with the keyboard focus, otherwise a lower one. Before any is
// on screen, the profile, which explains most.
QDockWidget* MainWindow::activePane() const {
    QDockWidget* chosen = nullptr;
    for (const Pane& pane : panes_) {
        if (pane.dock == nullptr || pane.dock->isFloating() || pane.dock->visibleRegion().isEmpty()) continue;
        const bool explains = pane.kind.place != DockPlace::Bottom && pane.dock != front(DockPlace::Left);
        const bool upper = chosen == nullptr || chosen == front(DockPlace::UpperRight);
        if (explains && (upper || pane.dock->isAncestorOf(QApplication::focusWidget()))) chosen = pane.dock;
    }
    return chosen != nullptr ? chosen : dockOf(QStringLiteral("profile"));
}

// Sizes the docks as planned, until the user moves a divider between them.
void MainWindow::shareRoom() {
    if (!arranged_) return;
    const auto part = [](double of, double share) { return static_cast<int>(of * share); };
    QDockWidget* const upper = front(DockPlace::UpperRight);
    QDockWidget* const lower = front(DockPlace::LowerRight);
    QDockWidget* const steps = front(DockPlace::Bottom);
    if (plan_.controls) resizeDocks({front(DockPlace::Left)}, {part(width(), plan_.left)}, Qt::Horizontal);
    resizeDocks({upper}, {part(width(), plan_.right)}, Qt::Horizontal);
    if (plan_.table) resizeDocks({steps}, {part(height(), plan_.steps)}, Qt::Vertical);
    // Shares of the current room: asking for more would enlarge the window, perhaps beyond the screen.
    const int room = upper->height() + lower->height();
    if (!plan_.oneStack)
        resizeDocks({upper, lower}, {part(room, plan_.upper), part(room, 1 - plan_.upper)}, Qt::Vertical);
    // The tab bars have changed their width.
    QTimer::singleShot(0, this, &MainWindow::styleTabs);
}

void MainWindow::closePane(QWidget* whole) {
    if (filled_ == whole) showView(View::All);
    whole->hide();
}

// Releases the contents of closed panes. Not while panes are only hidden by the one that fills the window, because
// those come back soon.
void MainWindow::emptyClosed() {
    if (view_ != View::All) return;
    for (const Pane& pane : panes_) {
        if (pane.dock == nullptr || !pane.dock->isHidden()) continue;
        if (auto* const view = qobject_cast<FigureView*>(pane.dock->widget())) view->releaseClosed();
    }
}

// All: the panes as arranged. Filled: one pane, with the bar for stepping and the step in words below it. Teach: the
// explaining panes, one of them large, with the result in a corner and the step in words below it.
void MainWindow::showView(View view, QWidget* pane) {
    if (view == View::All && view_ == View::All) return;
    if (view_ == View::All) {
        kept_[workspace_->style().projector] = saveState();
    } else {
        restoreKept();
    }
    view_ = view;
    filled_ = view == View::Filled ? pane : nullptr;
    QDockWidget* const steps = front(DockPlace::Bottom);
    if (view == View::Filled) {
        auto* const dock = qobject_cast<QDockWidget*>(pane);
        if (dock != nullptr) dock->setFloating(false);
        const bool time = pane != steps && !steps->isHidden();
        for (const Pane& other : panes_) {
            other.whole->setVisible(other.whole == pane || (time && other.dock == steps));
        }
    } else if (view == View::Teach) {
        steps->show();
        for (const Pane& other : panes_) {
            if (other.kind.place == DockPlace::Bottom && other.dock != steps) other.dock->hide();
        }
        arrange();
    }
    adaptToView();
}

// Adapts the time pane and the sentence below the result to the view.
void MainWindow::adaptToView() {
    QDockWidget* const steps = front(DockPlace::Bottom);
    const bool whole = view_ == View::All || filled_ == steps;
    steps->titleBarWidget()->setVisible(whole);
    using Parts = TimePane::Parts;
    const int height = time_->showParts(whole ? Parts::All : view_ == View::Teach ? Parts::Bar : Parts::BarAndSentence);
    sentence_->setVisible(view_ == View::Teach);
    teach_->setChecked(view_ == View::Teach);
    if (whole) return;
    // Gives the remaining height to the pane, after the layout has been updated.
    QTimer::singleShot(0, this, [this, steps, height] {
        if (view_ != View::All) resizeDocks({steps}, {height}, Qt::Vertical);
    });
}

void MainWindow::restoreKept() {
    closed_->start();
    panes_.front().whole->show();
    const QByteArray& kept = kept_[workspace_->style().projector];
    view_ = View::All;
    filled_ = nullptr;
    adaptToView();
    kept.isEmpty() ? arrange() : restorePanes(kept);
}

void MainWindow::fill(QWidget* pane) {
    showView(filled_ == nullptr ? View::Filled : View::All, pane);
    focusWhole(pane);
}

void MainWindow::setTeaching(bool on) {
    if (on == (view_ == View::Teach)) return;
    QDockWidget* const active = visiblePane();
    showView(on ? View::Teach : View::All);
    keepInFront(active);
    focusWhole(active != nullptr ? active : activePane());
}

// The explaining pane in use; null if none is on screen.
QDockWidget* MainWindow::visiblePane() const {
    QDockWidget* const active = activePane();
    return active->visibleRegion().isEmpty() ? nullptr : active;
}

// Shows a pane that was in use before the panes were arranged in another way, which may have hidden it.
void MainWindow::keepInFront(QDockWidget* pane) {
    if (pane == nullptr) return;
    pane->show();
    pane->raise();
}

// Gives a pane the focus; hiding the others has moved it.
void MainWindow::focusWhole(QWidget* whole) {
    for (const Pane& one : panes_) {
        if (one.whole == whole) one.focus->setFocus(Qt::OtherFocusReason);
    }
}

QWidget* MainWindow::frontView() const {
    for (const Pane& pane : panes_) {
        if (pane.whole == filled_) return pane.focus;
    }
    return panes_.front().focus;
}

void MainWindow::focusPane(const QString& name) {
    for (std::size_t n = 0; n < panes_.size(); ++n) {
        if (panes_[n].kind.name == name) focusPane(n);
    }
}

void MainWindow::focusPane(std::size_t number) {
    if (number >= panes_.size()) return;
    const Pane& pane = panes_[number];
    if (filled_ != nullptr && filled_ != pane.whole) showView(View::All);
    pane.whole->show();
    pane.whole->raise();
    pane.focus->setFocus(Qt::ShortcutFocusReason);
}

// Enters or leaves projector mode. Leaving restores the panes, size and maximised state of the window.
void MainWindow::setProjector(bool on) {
    if (on == workspace_->style().projector) return;
    const View view = view_;
    QWidget* const filled = filled_;
    QDockWidget* const active = view == View::Filled ? nullptr : visiblePane();
    showView(View::All);
    kept_[!on] = saveState();
    kept_[on] = on ? QByteArray() : kept_[on];
    if (on) {
        front(DockPlace::Left)->hide();  // too wide in large type
        place_ = saveGeometry();
        setWindowState(windowState() | Qt::WindowFullScreen);
    } else {
        // Stated apart: with the state of a maximised window in the same request, window managers keep the full screen.
        setWindowState(windowState() & ~Qt::WindowFullScreen);
        restoreGeometry(place_);
    }
    // While the type is small: in large type the panes of the other arrangement would make the window wider than the
    // screen, and it would stay so.
    if (on) arrange(true);
    Style style = workspace_->style();
    style.projector = on;
    style.projectorScale = projectorScale(on ? screen()->geometry().height() : height());
    applyType(style);
    projector_->setChecked(on);
    on ? shareRoom() : restorePanes(kept_[on]);
    if (view != View::All) showView(view, filled);
    keepInFront(active);
}

// Sets fonts and style for the window's mode and size.
void MainWindow::applyType(const Style& style) {
    QApplication::setFont(windowFont(style.scale()));
    // The status bar is for the lecturer and would not fit in large type.
    status_->setFont(windowFont(1));
    workspace_->setStyle(style);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    QTimer::singleShot(0, this, &MainWindow::styleTabs);
    Style style = workspace_->style();
    QTimer::singleShot(0, this, &MainWindow::shareRoom);
    if (!style.projector) return;
    style.projectorScale = projectorScale(height());
    if (!(style == workspace_->style())) applyType(style);
}

bool MainWindow::event(QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) arranged_ = false;
    return QMainWindow::event(event);
}

// Qt creates the tab bars of stacked docks, which know only the docks' titles. Adds the tool tips and chooses the
// largest font in which all tabs of a bar fit; if even the smallest does not fit, the bar scrolls.
void MainWindow::styleTabs() {
    constexpr double kSmallest = 7;
    const double largest = Style::kTextPoints * std::min(workspace_->style().scale(), 1.4);
    for (QTabBar* const bar : findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
        bar->setElideMode(Qt::ElideNone);
        for (int n = 0; n < bar->count(); ++n) {
            for (const Pane& pane : panes_) {
                if (pane.dock != nullptr && pane.dock->windowTitle() == bar->tabText(n)) {
                    bar->setTabToolTip(n, pane.kind.help);
                }
            }
        }
        QFont type = bar->font();
        for (double points = largest; points >= kSmallest; points -= 0.5) {
            type.setPointSizeF(points);
            bar->setFont(type);
            if (bar->sizeHint().width() <= bar->width()) break;
        }
    }
}

// Restores a saved state of the panes, except for the message lines, which show the current messages.
void MainWindow::restorePanes(const QByteArray& state) {
    arranged_ = false;
    restoreState(state);
    styleTabs();
    showMessages();
}

QVariantMap MainWindow::layoutNow() const {
    const bool projector = workspace_->style().projector;
    QVariantMap layout;
    layout[layoutKey()] = projector || view_ != View::All ? kept_[0] : saveState();
    layout[themeKey()] = workspace_->style().theme == Theme::Light;
    layout[placeKey()] = projector ? place_ : saveGeometry();
    return layout;
}

void MainWindow::takeLayout(const QVariantMap& layout) {
    showView(View::All);
    setProjector(false);
    restoreGeometry(layout[placeKey()].toByteArray());
    // Delayed, because showing a window first applies the default shares.
    QTimer::singleShot(0, this, [this, panes = layout[layoutKey()].toByteArray()] {
        if (!panes.isEmpty()) restorePanes(panes);
    });
    light_->setChecked(layout[themeKey()].toBool());
}

QVariantMap MainWindow::arrangement() const {
    QVariantMap arrangement;
    arrangement[layoutKey()] = view_ == View::All ? saveState() : kept_[workspace_->style().projector];
    arrangement[QStringLiteral("teach")] = view_ == View::Teach;
    for (const Pane& pane : panes_) {
        if (pane.whole == filled_) arrangement[QStringLiteral("filled")] = pane.kind.name;
    }
    return arrangement;
}

void MainWindow::takeArrangement(const QVariantMap& arrangement) {
    showView(View::All);
    restorePanes(arrangement[layoutKey()].toByteArray());
    const QString filled = arrangement[QStringLiteral("filled")].toString();
    for (const Pane& pane : panes_) {
        if (pane.kind.name == filled) fill(pane.whole);
    }
    if (arrangement[QStringLiteral("teach")].toBool()) setTeaching(true);
}

void MainWindow::keepLayout() const {
    const QVariantMap layout = layoutNow();
    QSettings settings;
    for (auto value = layout.begin(); value != layout.end(); ++value) settings.setValue(value.key(), value.value());
}

void MainWindow::restoreLayout() {
    const QSettings settings;
    if (!settings.contains(placeKey())) return fitScreen();
    QVariantMap layout;
    for (const QString& key : {layoutKey(), themeKey(), placeKey()}) layout[key] = settings.value(key);
    takeLayout(layout);
}

// Size and position of the first window: inside the screen's available area, including the frame; maximised if it takes
// all of that.
void MainWindow::fitScreen() {
    const QRect area = screen()->availableGeometry();
    const int frame =
        style()->pixelMetric(QStyle::PM_TitleBarHeight) + 2 * style()->pixelMetric(QStyle::PM_MdiSubWindowFrameWidth);
    const QSize room = area.size() - QSize(frame, 2 * frame);
    resize(size().boundedTo(room));
    move(area.topLeft() + QPoint((area.width() - width()) / 2, (area.height() - height()) / 2));
    const bool all = width() >= room.width() || height() >= room.height();
    if (all) setWindowState(windowState() | Qt::WindowMaximized);
}

void MainWindow::setLightTheme(bool on) {
    if (on == (workspace_->style().theme == Theme::Light)) return;
    Style style = workspace_->style();
    style.theme = on ? Theme::Light : Theme::Dark;
    QApplication::setPalette(themePalette(style.theme));
    workspace_->setStyle(style);
    light_->setChecked(on);
}

}  // namespace reliefui
