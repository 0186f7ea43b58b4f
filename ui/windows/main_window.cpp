#include "windows/main_window.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QTableView>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "panes/figure_view.h"
#include "panes/result/result_painting.h"
#include "panes/result/result_view.h"
#include "panes/steps/step_sentence.h"
#include "panes/steps/step_table.h"
#include "windows/home_view.h"
#include "windows/key_policy.h"
#include "windows/message_bar.h"
#include "windows/pane_title.h"
#include "windows/share.h"
#include "windows/status_line.h"
#include "windows/time_pane.h"
#include "windows/top_bar.h"
#include "workspace/pixel_finder.h"

namespace reliefui {

namespace {

// a pane that was closed by mistake and reopened within this time still has its contents
constexpr int kEmptyMs = 2000;

QString tabOf(const PaneKind& kind) {
    return kind.tab.isEmpty() ? kind.title : kind.tab;
}

QComboBox* makeLayerChooser(Workspace* workspace, QWidget* parent) {
    auto* const box = new QComboBox(parent);
    box->setObjectName(QStringLiteral("layer"));
    box->setAccessibleName(MainWindow::tr("Layer of the result"));
    box->setToolTip(MainWindow::tr("Property of the pixels that the result shows"));
    for (int i = 0; i < kLayers; ++i) box->addItem(layerTitle(static_cast<Layer>(i)));
    const auto follow = [workspace, box] { box->setCurrentIndex(static_cast<int>(workspace->layer())); };
    follow();
    QObject::connect(workspace, &Workspace::layerChanged, box, follow);  // a lesson's page sets it as well
    QObject::connect(box, qOverload<int>(&QComboBox::currentIndexChanged), workspace,
                     [workspace](int i) { workspace->setLayer(static_cast<Layer>(i)); });
    return box;
}

}  // namespace

MainWindow::MainWindow(Workspace* workspace, const QString& datasets, QWidget* parent)
    : QMainWindow(parent), workspace_(workspace), datasets_(datasets) {
    setObjectName(QStringLiteral("main-window"));
    keys_ = new KeyPolicy(this, [this] { return frontView(); });
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setAnimated(false);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    // Smaller if the screen is small or everything is scaled up.
    const QSize room = QSize(1600, 1000).boundedTo(QApplication::primaryScreen()->availableSize());
    resize(room);

    closed_ = new QTimer(this);
    closed_->setSingleShot(true);
    closed_->setInterval(kEmptyMs);
    connect(closed_, &QTimer::timeout, this, &MainWindow::emptyClosed);
    status_ = new StatusLine(workspace_, this);
    setStatusBar(status_);
    for (const PaneKind& kind : paneList()) kind.place == DockPlace::Center ? addResult(kind) : addPane(kind);
    time_ = pane<TimePane>();
    home_ = HomeView::of(workspace_);
    addTableMenus();
    makeMenus();
    topBar_ = new TopBar(workspace_, open_, {undo_, redo_, projector_}, this);
    addToolBar(topBar_);
    makeMessages();
    resetLayout();
    resize(room);  // again, because the panes demanded more room until they were stacked as tabs
    result_->setFocus();

    connect(workspace_, &Workspace::scenarioChanged, this, &MainWindow::refreshTitles);
    connect(workspace_, &Workspace::stepChanged, this, &MainWindow::refreshTitles);
    connect(workspace_, &Workspace::notesChanged, this, &MainWindow::refreshTitles);
    connect(workspace_, &Workspace::opened, this, &MainWindow::remember);
    connect(workspace_, &Workspace::opened, this, [this] { showLesson(); });
    refreshTitles();
}

MainWindow::~MainWindow() {
    // The docks are destroyed after the members of this class, and emit signals when they are hidden by that.
    for (const Pane& pane : panes_) {
        if (pane.dock == nullptr) continue;
        pane.dock->disconnect();
        pane.dock->toggleViewAction()->disconnect();
    }
}

PaneTitle* MainWindow::titleOf(const PaneKind& kind, QWidget* whole) {
    auto* const bar = new PaneTitle(kind.title, paneKey(panes_.size()), kind.help, this);
    connect(bar, &PaneTitle::fillRequested, this, [this, whole] { fill(whole); });
    return bar;
}

void MainWindow::addResult(const PaneKind& kind) {
    auto* const whole = new QWidget(this);
    auto* const column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* const title = titleOf(kind, whole);
    title->addControl(makeLayerChooser(workspace_, title));
    auto* const view = kind.make(workspace_, whole);
    result_ = qobject_cast<ResultView*>(view);
    title->addControl(result_->rangeButton());
    whole->setFocusProxy(result_);
    column->addWidget(title);
    column->addWidget(result_, 1);
    sentence_ = new StepSentence(workspace_, whole);
    sentence_->hide();
    column->addWidget(sentence_, 1);
    setCentralWidget(whole);
    panes_.push_back({kind, whole, result_, nullptr});
    connect(result_, &ResultView::hovered, title, &PaneTitle::setNote);
    connect(result_, &ResultView::menuRequested, this, &MainWindow::resultMenu);
}

void MainWindow::addPane(const PaneKind& kind) {
    auto* const dock = new QDockWidget(tabOf(kind), this);
    dock->setObjectName(kind.name + QStringLiteral("-pane"));
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable |
                      QDockWidget::DockWidgetFloatable);
    PaneTitle* const title = titleOf(kind, dock);
    title->setClosable();
    connect(title, &PaneTitle::closeRequested, this, [this, dock] { closePane(dock); });
    dock->setTitleBarWidget(title);
    QWidget* const whole = kind.make(workspace_, this);
    dock->setWidget(whole);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    connect(dock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        if (!visible) closed_->start();
        keys_->panesMoved();
        QTimer::singleShot(0, this, &MainWindow::styleTabs);
    });
    connect(dock, &QDockWidget::dockLocationChanged, this,
            [this] { QTimer::singleShot(0, this, &MainWindow::styleTabs); });
    QWidget* const proxy = kind.focus ? kind.focus(whole) : whole->focusProxy();
    QWidget* const focus = proxy != nullptr ? proxy : whole;
    panes_.push_back({kind, dock, focus, dock});
    if (auto* const view = qobject_cast<FigureView*>(whole)) {
        // The title shows the pane's readout; the status bar shows which file was saved.
        connect(view, &FigureView::hovered, title, &PaneTitle::setNote);
        connect(view, &FigureView::saved, this,
                [this](const QString& path) { status_->say(tr("Saved: %1").arg(path)); });
    }
}

QDockWidget* MainWindow::dockOf(const QString& pane) const {
    return findChild<QDockWidget*>(pane + QStringLiteral("-pane"));
}

QDockWidget* MainWindow::front(DockPlace place) const {
    return std::find_if(panes_.begin(), panes_.end(),
                        [&](const Pane& pane) { return pane.dock != nullptr && pane.kind.place == place; })
        ->dock;
}

// Shortcut of a pane: 1 to 9 and 0, then Alt with the same digits; empty for further panes.
QString MainWindow::paneKey(std::size_t pane) {
    constexpr std::size_t kPlain = 10;
    if (pane >= 2 * kPlain) return {};
    const QString digit = QString::number((pane + 1) % kPlain);
    return pane < kPlain ? digit : QStringLiteral("Alt+") + digit;
}

// Tables have no drawing with a context menu of its own; their menus consist of actions.
void MainWindow::addTableMenus() {
    const auto addExport = [this](QWidget* table, const QString& view) {
        auto* const action = new QAction(tr("Export figure…"), table);
        connect(action, &QAction::triggered, this, [this, view] { askView(view); });
        table->addAction(action);
        table->setContextMenuPolicy(Qt::ActionsContextMenu);
    };
    QDockWidget* const skipped = dockOf(QStringLiteral("skipped"));
    addExport(skipped->widget(), QStringLiteral("skipped"));
    addExport(time_->table()->table(), QStringLiteral("steps"));
    connect(status_, &StatusLine::ledgerRequested, skipped, [skipped] { skipped->setVisible(skipped->isHidden()); });
    // Its reasons are whole sentences, so it opens as wide as the steps, as a tab over them.
    connect(skipped->toggleViewAction(), &QAction::toggled, skipped, [this, skipped](bool shown) {
        if (!shown) return;
        if (!skipped->isFloating() && tabifiedDockWidgets(skipped).isEmpty()) {
            tabifyDockWidget(front(DockPlace::Bottom), skipped);
        }
        skipped->raise();
    });
}

void MainWindow::makeMessages() {
    addToolBarBreak();
    messageRow_ = new QToolBar(tr("Messages"), this);
    messageRow_->setObjectName(QStringLiteral("messages"));
    messageRow_->setMovable(false);
    messageRow_->toggleViewAction()->setVisible(false);
    messageRow_->setContentsMargins(0, 0, 0, 0);
    auto* const both = new QWidget(messageRow_);
    auto* const column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    messages_ = new MessageBar(both);
    question_ = new MessageBar(both);
    question_->setObjectName(QStringLiteral("question-bar"));
    for (MessageBar* const bar : {messages_, question_}) {
        column->addWidget(bar);
        bar->hide();
        connect(bar, &MessageBar::closed, this, &MainWindow::showMessages);
    }
    messageHolder_ = messageRow_->addWidget(both);
    addToolBar(messageRow_);
    showMessages();
    connect(workspace_, &Workspace::problem, this, [this](const QString& text) { report(text, true); });
    connect(workspace_, &Workspace::notice, this, [this](const QString& text) { report(text, false); });
    connect(workspace_, &Workspace::scenarioChanged, this, &MainWindow::dropStaleMessage);
    connect(workspace_, &Workspace::snapshotChanged, this, &MainWindow::dropStaleMessage);
    // A problem is no longer of interest once something else was opened.
    connect(workspace_, &Workspace::opened, this, [this] {
        if (messages_->isProblem()) messages_->close();
    });
}

void MainWindow::report(const QString& text, bool problem) {
    problem ? messages_->showProblem(text) : messages_->showNotice(text);
    // If something is being opened, the message refers to its pictures, which are known later.
    messagePictures_.reset();
    if (workspace_->version() > 0 && !workspace_->loading()) messagePictures_ = workspace_->scenario().pictures;
    // After a problem, the workspace takes the impossible change back; the version is that after the change back.
    QTimer::singleShot(0, this, [this] { messageVersion_ = workspace_->version(); });
    messageVersion_ = 0;
    showMessages();
}

// A message disappears when the pictures it refers to are replaced; a problem also after any later change.
void MainWindow::dropStaleMessage() {
    if (messages_->isHidden() || workspace_->loading()) return;
    const auto snapshot = workspace_->snapshot();
    const bool shown = snapshot && !snapshot->coarse && snapshot->version == workspace_->version();
    const bool later = messageVersion_ != 0 && shown && snapshot->version > messageVersion_;
    const relief::Pictures& pictures = workspace_->scenario().pictures;
    if (!messagePictures_) messagePictures_ = pictures;
    const bool others = !(*messagePictures_ == pictures);
    if (others || (messages_->isProblem() && later)) messages_->close();
}

void MainWindow::welcome(bool always) {
    const QString key = QStringLiteral("welcomed");
    QSettings settings;
    if (!always && settings.value(key).toBool()) return;
    settings.setValue(key, true);
    report(tr("Welcome. Three things to do: click a pixel to choose its ray; step along it with , and . (comma, full "
              "stop); drag the picture to look around. F1 lists all keys."),
           false);
}

// Cancels what is running. If nothing is, leaves what hides a part of the window: guessing, a pane that fills it, the
// projector mode.
void MainWindow::cancel() {
    bool ran = workspace_->busy() || workspace_->tasks().busy();
    workspace_->cancel();
    for (FigureView* const view : findChildren<FigureView*>()) ran = view->cancel() || ran;
    ran = finder_->cancel() || ran;
    ran = cancelWriting(workspace_) || ran;
    if (ran) return;
    if (workspace_->guessing()) return workspace_->setGuessing(false);
    if (filled_ != nullptr) return fill(filled_);
    setProjector(false);
}

void MainWindow::showMessages() {
    const bool any = !messages_->isHidden() || !question_->isHidden();
    messageHolder_->setVisible(any);
    messageRow_->setVisible(any);
}

}  // namespace reliefui
