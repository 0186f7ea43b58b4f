// Where the panes are: the layout at first, one pane that fills the window, the projector's layout.
#include <map>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <QTimer>

#include "panes/figure_view.h"
#include "windows/main_window.h"
#include "windows/status_line.h"
#include "windows/theme.h"
#include "windows/time_pane.h"

namespace reliefui {

namespace {

// Parts of the window that the panes get at first.
constexpr double kSceneWidth = 0.20;
constexpr double kTraceWidth = 0.36;
constexpr double kProjectorTraceWidth = 0.48;
constexpr int kLowWindow = 850;           // points
constexpr double kTraceHeight = 5.0 / 9;  // of what it has together with the pane below it
constexpr double kStepsHeight = 0.23;
constexpr double kProjectorStepsHeight = 0.3;

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
    if (filled_ != nullptr) fill(filled_);
    for (const Pane& pane : panes_) {
        if (pane.dock != nullptr) pane.dock->setFloating(false);
    }
    addDockWidget(Qt::RightDockWidgetArea, front(DockPlace::UpperRight));
    addDockWidget(Qt::RightDockWidgetArea, front(DockPlace::LowerRight));
    addDockWidget(Qt::BottomDockWidgetArea, front(DockPlace::Bottom));
    addDockWidget(Qt::LeftDockWidgetArea, front(DockPlace::Left));
    splitDockWidget(front(DockPlace::UpperRight), front(DockPlace::LowerRight), Qt::Vertical);
    std::map<DockPlace, QDockWidget*> last;
    for (const Pane& pane : panes_) {
        if (pane.dock == nullptr) continue;
        if (last.contains(pane.kind.place)) tabifyDockWidget(last[pane.kind.place], pane.dock);
        last[pane.kind.place] = pane.dock;
    }
    for (const Pane& pane : panes_) pane.whole->setVisible(pane.kind.open);
    for (const DockPlace place : {DockPlace::UpperRight, DockPlace::Left, DockPlace::LowerRight, DockPlace::Bottom})
        front(place)->raise();
    tipTabs();
    shareRoom();
    // Again when the window has its size: before that, docks are as small as they can be.
    QTimer::singleShot(0, this, &MainWindow::shareRoom);
}

// On a projector one pane beside the result, as high as it can be; the others wait in its tabs.
void MainWindow::gatherPanes() {
    QDockWidget* const trace = front(DockPlace::UpperRight);
    QDockWidget* chosen = trace;
    for (const Pane& pane : panes_) {
        if (pane.dock == nullptr || pane.dock == trace || pane.dock->isHidden() || pane.dock->isFloating()) continue;
        if (dockWidgetArea(pane.dock) != Qt::RightDockWidgetArea) continue;
        const bool seen = !pane.dock->visibleRegion().isEmpty();
        if (seen && (chosen == trace || pane.dock->isAncestorOf(QApplication::focusWidget()))) chosen = pane.dock;
    }
    for (const Pane& pane : panes_) {
        if (pane.dock == nullptr || pane.dock == trace || pane.dock->isHidden() || pane.dock->isFloating()) continue;
        if (dockWidgetArea(pane.dock) == Qt::RightDockWidgetArea) tabifyDockWidget(trace, pane.dock);
    }
    chosen->raise();
    tipTabs();
}

void MainWindow::closePane(QWidget* whole) {
    if (filled_ == whole) fill(whole);
    whole->hide();
}

// What a closed pane held goes; behind a tab, or behind the one that fills the window, it is soon back.
void MainWindow::emptyClosed() {
    if (filled_ != nullptr) return;
    for (const Pane& pane : panes_) {
        if (pane.dock == nullptr || !pane.dock->isHidden()) continue;
        if (auto* const view = qobject_cast<FigureView*>(pane.dock->widget())) view->giveBack();
    }
}

void MainWindow::shareRoom() {
    QDockWidget* const trace = front(DockPlace::UpperRight);
    QDockWidget* const pyramid = front(DockPlace::LowerRight);
    QDockWidget* const steps = front(DockPlace::Bottom);
    QDockWidget* const scene = front(DockPlace::Left);
    const auto part = [](double of, double share) { return static_cast<int>(of * share); };
    resizeDocks({scene, trace}, {part(width(), kSceneWidth), part(width(), kTraceWidth)}, Qt::Horizontal);
    resizeDocks({steps}, {part(height(), kStepsHeight)}, Qt::Vertical);
    // In low windows of the room there is: what asks for more makes the window larger, perhaps than the screen.
    const int room = height() < kLowWindow ? trace->height() + pyramid->height() : 2 * height();
    resizeDocks({trace, pyramid}, {part(room, kTraceHeight), part(room, 1 - kTraceHeight)}, Qt::Vertical);
}

// A pane fills the window; only time stays below it, so that one can go on stepping.
void MainWindow::fill(QWidget* pane) {
    QDockWidget* const steps = front(DockPlace::Bottom);
    if (filled_ == nullptr) {
        beforeFill_ = saveState();
        filled_ = pane;
        auto* const dock = qobject_cast<QDockWidget*>(pane);
        if (dock != nullptr) dock->setFloating(false);
        const bool time = pane != steps && !steps->isHidden();
        for (const Pane& other : panes_) {
            other.whole->setVisible(other.whole == pane || (time && other.dock == steps));
        }
        if (time) showTimeOnly(true);
    } else {
        filled_ = nullptr;
        closed_->start();
        showTimeOnly(false);
        panes_.front().whole->show();
        restorePanes(beforeFill_);
    }
    // Hiding the others has moved the focus.
    for (const Pane& one : panes_) {
        if (one.whole == pane) one.focus->setFocus(Qt::OtherFocusReason);
    }
}

QWidget* MainWindow::frontView() const {
    for (const Pane& pane : panes_) {
        if (pane.whole == filled_) return pane.focus;
    }
    return panes_.front().focus;
}

void MainWindow::showTimeOnly(bool only) {
    QDockWidget* const steps = front(DockPlace::Bottom);
    steps->titleBarWidget()->setVisible(!only);
    const int height = time_->showBarOnly(only);
    if (!only) return;
    // The room that it does not need any more is the pane's; when the layout knows of it.
    QTimer::singleShot(0, this, [this, steps, height] {
        if (filled_ != nullptr) resizeDocks({steps}, {height}, Qt::Vertical);
    });
}

void MainWindow::focusPane(const QString& name) {
    for (std::size_t n = 0; n < panes_.size(); ++n) {
        if (panes_[n].kind.name == name) focusPane(n);
    }
}

void MainWindow::focusPane(std::size_t number) {
    if (number >= panes_.size()) return;
    const Pane& pane = panes_[number];
    if (filled_ != nullptr && filled_ != pane.whole) fill(filled_);
    pane.whole->show();
    pane.whole->raise();
    pane.focus->setFocus(Qt::ShortcutFocusReason);
}

void MainWindow::setProjector(bool on) {
    if (on == workspace_->style().projector) return;
    Style style = workspace_->style();
    style.projector = on;
    QApplication::setFont(windowFont(on));
    const QFont small = tabFont(on, screen()->geometry().width());
    QApplication::setFont(small, "QTabBar");
    // It is the lecturer's: not everything in it fits in large type.
    status_->setFont(small);
    workspace_->setStyle(style);
    projector_->setChecked(on);
    if (on) {
        beforeProjector_ = saveState();
        // Nobody reads controls from the last row; the panes need the room.
        for (const Pane& pane : panes_) {
            if (pane.dock == nullptr || pane.kind.place != DockPlace::Left) continue;
            const bool worked = pane.dock != front(DockPlace::Left) && !pane.dock->visibleRegion().isEmpty();
            if (!worked) pane.dock->hide();
        }
        if (filled_ == nullptr) gatherPanes();
        showFullScreen();
        // The large type of the panes at the right wants half of the window.
        QTimer::singleShot(0, this, [this] {
            if (!workspace_->style().projector) return;
            resizeDocks({front(DockPlace::UpperRight)}, {static_cast<int>(width() * kProjectorTraceWidth)},
                        Qt::Horizontal);
            resizeDocks({front(DockPlace::Bottom)}, {static_cast<int>(height() * kProjectorStepsHeight)}, Qt::Vertical);
        });
    } else {
        showNormal();
        restorePanes(beforeProjector_);
    }
}

// Messages are where they are now, whatever was there when the state was kept.
void MainWindow::restorePanes(const QByteArray& state) {
    restoreState(state);
    tipTabs();
    showMessages();
}

QVariantMap MainWindow::layoutNow() const {
    const bool projector = workspace_->style().projector;
    QVariantMap layout;
    layout[layoutKey()] = filled_ != nullptr ? beforeFill_ : projector ? beforeProjector_ : saveState();
    layout[themeKey()] = workspace_->style().theme == Theme::Light;
    if (!projector) layout[placeKey()] = saveGeometry();
    return layout;
}

void MainWindow::takeLayout(const QVariantMap& layout) {
    if (filled_ != nullptr) fill(filled_);
    setProjector(false);
    restoreGeometry(layout[placeKey()].toByteArray());
    // After the share of the room that every window begins with.
    QTimer::singleShot(0, this, [this, panes = layout[layoutKey()].toByteArray()] { restorePanes(panes); });
    light_->setChecked(layout[themeKey()].toBool());
}

void MainWindow::keepLayout() const {
    const QVariantMap layout = layoutNow();
    QSettings settings;
    for (auto value = layout.begin(); value != layout.end(); ++value) settings.setValue(value.key(), value.value());
}

void MainWindow::restoreLayout() {
    const QSettings settings;
    QVariantMap layout;
    for (const QString& key : {layoutKey(), themeKey(), placeKey()}) layout[key] = settings.value(key);
    takeLayout(layout);
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
