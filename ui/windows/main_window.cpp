#include "windows/main_window.h"

#include <QVTKOpenGLNativeWidget.h>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QTableView>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "panes/charts/charts_view.h"
#include "panes/compare/compare_view.h"
#include "panes/distance/distance_view.h"
#include "panes/drawing_canvas.h"
#include "panes/drawn/drawn_view.h"
#include "panes/duel/duel_view.h"
#include "panes/footprint/footprint_view.h"
#include "panes/profile/profile_view.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/result/result_painting.h"
#include "panes/result/result_view.h"
#include "panes/rows/rows_view.h"
#include "panes/skipped/skipped_panel.h"
#include "panes/steps/step_table.h"
#include "panes/trace/trace3d_view.h"
#include "windows/breakpoint_bar.h"
#include "windows/key_policy.h"
#include "windows/message_bar.h"
#include "windows/other_bar.h"
#include "windows/pane_title.h"
#include "windows/scene_panel.h"
#include "windows/status_line.h"
#include "windows/step_bar.h"
#include "windows/theme.h"
#include "windows/top_bar.h"

namespace reliefui {

namespace {

constexpr int kMessageMs = 4000;
constexpr int kEmptyMs = 2000;  // a pane that was closed by mistake is back at once

QComboBox* makeLayerChooser(Workspace* workspace, QWidget* parent) {
    auto* const box = new QComboBox(parent);
    box->setObjectName(QStringLiteral("layer"));
    box->setAccessibleName(MainWindow::tr("Layer of the result"));
    box->setToolTip(MainWindow::tr("What the result shows of each pixel"));
    for (int i = 0; i < kLayers; ++i) box->addItem(layerTitle(static_cast<Layer>(i)));
    QObject::connect(box, qOverload<int>(&QComboBox::currentIndexChanged), workspace,
                     [workspace](int i) { workspace->setLayer(static_cast<Layer>(i)); });
    return box;
}

}  // namespace

MainWindow::MainWindow(Workspace* workspace, const QString& datasets, QWidget* parent)
    : QMainWindow(parent), workspace_(workspace), datasets_(datasets) {
    setWindowTitle(tr("Reliefscope"));
    setObjectName(QStringLiteral("main-window"));
    keys_ = new KeyPolicy(this, [this] { return frontView(); });
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    // As much as there is, where the screen is small or all is drawn large.
    const QSize room = QSize(1600, 1000).boundedTo(QApplication::primaryScreen()->availableSize());
    resize(room);

    closed_ = new QTimer(this);
    closed_->setSingleShot(true);
    closed_->setInterval(kEmptyMs);
    connect(closed_, &QTimer::timeout, this, &MainWindow::emptyClosed);
    status_ = new StatusLine(workspace_, this);
    setStatusBar(status_);
    makeResult();
    makePanes();
    makeSkipped();
    makeMenus();
    topBar_ = new TopBar(workspace_, open_, {undo_, redo_, projector_}, this);
    addToolBar(topBar_);
    makeMessages();
    resetLayout();
    resize(room);  // panes wanted more until they stood behind each other
    result_->setFocus();

    connect(workspace_, &Workspace::scenarioChanged, this, &MainWindow::refreshTitles);
    connect(workspace_, &Workspace::stepChanged, this, &MainWindow::refreshTitles);
    connect(workspace_, &Workspace::notesChanged, this, &MainWindow::refreshTitles);
    connect(workspace_, &Workspace::opened, this, &MainWindow::remember);
    connect(workspace_, &Workspace::opened, this, [this] { showLesson(); });
    refreshTitles();
}

MainWindow::~MainWindow() {
    // The docks go after this part of the window, and tell as they go that they are hidden.
    for (const Pane& pane : panes_) {
        if (pane.dock == nullptr) continue;
        pane.dock->disconnect();
        pane.dock->toggleViewAction()->disconnect();
    }
}

PaneTitle* MainWindow::titleOf(const QString& title, QWidget* whole) {
    auto* const bar = new PaneTitle(title, paneKey(panes_.size()), this);
    connect(bar, &PaneTitle::fillRequested, this, [this, whole] { fill(whole); });
    return bar;
}

void MainWindow::makeResult() {
    auto* const whole = new QWidget(this);
    auto* const column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* const title = titleOf(tr("Result"), whole);
    title->addControl(makeLayerChooser(workspace_, title));
    result_ = new ResultView(workspace_, whole);
    whole->setFocusProxy(result_);
    column->addWidget(title);
    column->addWidget(result_, 1);
    setCentralWidget(whole);
    panes_.push_back({tr("Result"), whole, result_, nullptr});
    connect(result_, &ResultView::hovered, title, &PaneTitle::setNote);
    connect(result_, &ResultView::menuRequested, this, &MainWindow::resultMenu);
}

QDockWidget* MainWindow::addPane(const PaneName& name, const QString& objectName, QWidget* whole, QWidget* focus,
                                 Qt::DockWidgetArea area) {
    auto* const dock = new QDockWidget(name.tab, this);
    dock->setObjectName(objectName);
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable |
                      QDockWidget::DockWidgetFloatable);
    PaneTitle* const title = titleOf(name.title, dock);
    title->setClosable();
    connect(title, &PaneTitle::closeRequested, this, [this, dock] { closePane(dock); });
    dock->setTitleBarWidget(title);
    dock->setWidget(whole);
    addDockWidget(area, dock);
    connect(dock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        if (!visible) closed_->start();
        keys_->panesMoved();
    });
    panes_.push_back({name.title, dock, focus, dock});
    return dock;
}

void MainWindow::makePanes() {
    pyramid_ = new PyramidView(workspace_, this);
    profile_ = new ProfileView(workspace_, this);
    distance_ = new DistanceView(workspace_, this);
    rows_ = new RowsView(workspace_, this);
    trace_ = new Trace3dView(workspace_, this);
    auto* const time = new QWidget(this);
    auto* const column = new QVBoxLayout(time);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    stepBar_ = new StepBar(workspace_, time);
    breakpoints_ = new BreakpointBar(workspace_, time);
    steps_ = new StepTable(workspace_, time);
    column->addWidget(stepBar_);
    column->addWidget(breakpoints_);
    other_ = new OtherBar(workspace_, time);
    column->addWidget(other_);
    column->addWidget(steps_, 1);
    auto* const scroll = new QScrollArea(this);
    auto* const panel = new ScenePanel(workspace_, scroll);
    scroll->setWidget(panel);
    scroll->setAccessibleName(tr("Scene"));
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(panel->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());

    addPane({tr("Trace 3-D"), tr("Trace 3-D", "tab")}, QStringLiteral("trace-pane"), trace_,
            trace_->findChild<QVTKOpenGLNativeWidget*>(), Qt::RightDockWidgetArea);
    addPane(tr("Pyramid"), QStringLiteral("pyramid-pane"), pyramid_, pyramid_->canvas(), Qt::RightDockWidgetArea);
    linkFigure(pyramid_);
    addPane(tr("Steps"), QStringLiteral("steps-pane"), time, steps_->findChild<QTableView*>(),
            Qt::BottomDockWidgetArea);
    addPane(tr("Scene"), QStringLiteral("scene-pane"), scroll, scroll, Qt::LeftDockWidgetArea);
    addPane(tr("Profile"), QStringLiteral("profile-pane"), profile_, profile_->canvas(), Qt::RightDockWidgetArea);
    linkFigure(profile_);
    addPane({tr("Distance map"), tr("Distance map", "tab")}, QStringLiteral("distance-pane"), distance_,
            distance_->canvas(), Qt::RightDockWidgetArea);
    linkFigure(distance_);
    footprint_ = new FootprintView(workspace_, this);
    addPane({tr("Footprint"), tr("Footprint", "tab")}, QStringLiteral("footprint-pane"), footprint_,
            footprint_->canvas(), Qt::RightDockWidgetArea);
    linkFigure(footprint_);
    addPane(tr("Rows"), QStringLiteral("rows-pane"), rows_, rows_->canvas(), Qt::RightDockWidgetArea);
    linkFigure(rows_);
    charts_ = new ChartsView(workspace_, this);
    addPane(tr("Charts"), QStringLiteral("charts-pane"), charts_, charts_->canvas(), Qt::RightDockWidgetArea);
    linkFigure(charts_);
    compare_ = new CompareView(workspace_, this);
    addPane(tr("Compare"), QStringLiteral("compare-pane"), compare_, compare_->pictures(), Qt::RightDockWidgetArea);
    linkFigure(compare_);
    drawn_ = new DrawnView(workspace_, this);
    addPane(tr("By hand"), QStringLiteral("drawn-pane"), drawn_, drawn_->grid(), Qt::RightDockWidgetArea);
    linkFigure(drawn_);
    duel_ = new DuelView(workspace_, this);
    addPane(tr("Duel"), QStringLiteral("duel-pane"), duel_, duel_->canvas(), Qt::RightDockWidgetArea);
    linkFigure(duel_);
}

// Of the pane that was added last: its readout stands in the title, what it saved in the last line.
void MainWindow::linkFigure(FigureView* view) {
    connect(view, &FigureView::hovered, qobject_cast<PaneTitle*>(panes_.back().dock->titleBarWidget()),
            &PaneTitle::setNote);
    connect(view, &FigureView::saved, this,
            [this](const QString& path) { statusBar()->showMessage(tr("Saved: %1").arg(path), kMessageMs); });
}

// 1 to 9 and 0; panes after the tenth have Alt and the same again.
QString MainWindow::paneKey(std::size_t pane) {
    constexpr std::size_t kPlain = 10;
    const QString digit = QString::number((pane + 1) % kPlain);
    return pane < kPlain ? digit : QStringLiteral("Alt+") + digit;
}

// Closed at first: it is opened from the menu, by its key or from the bottom line.
void MainWindow::makeSkipped() {
    auto* const panel = new SkippedPanel(workspace_, this);
    skipped_ = addPane(tr("Skipped"), QStringLiteral("skipped-pane"), panel, panel, Qt::BottomDockWidgetArea);
    skipped_->hide();
    // Tables have no drawing to click on: their menus are made of actions.
    const auto addExport = [this](QWidget* table, const QString& view) {
        auto* const action = new QAction(tr("Export figure…"), table);
        connect(action, &QAction::triggered, this, [this, view] { askView(view); });
        table->addAction(action);
        table->setContextMenuPolicy(Qt::ActionsContextMenu);
    };
    addExport(panel, QStringLiteral("skipped"));
    addExport(steps_->table(), QStringLiteral("steps"));
    connect(status_, &StatusLine::ledgerWanted, skipped_, [this] { skipped_->setVisible(skipped_->isHidden()); });
    // Its reasons are sentences: as wide as the steps, over which it comes up.
    connect(skipped_->toggleViewAction(), &QAction::toggled, skipped_, [this](bool shown) {
        const auto steps = std::find_if(panes_.begin(), panes_.end(), [](const auto& pane) {
            return pane.dock != nullptr && pane.dock->objectName() == QStringLiteral("steps-pane");
        });
        if (!shown || steps == panes_.end()) return;
        if (!skipped_->isFloating() && tabifiedDockWidgets(skipped_).isEmpty()) tabifyDockWidget(steps->dock, skipped_);
        skipped_->raise();
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
    connect(workspace_, &Workspace::problem, this, [this](const QString& text) {
        messages_->showProblem(text);
        showMessages();
    });
    connect(workspace_, &Workspace::notice, this, [this](const QString& text) {
        messages_->showNotice(text);
        showMessages();
    });
}

void MainWindow::showMessages() {
    const bool any = !messages_->isHidden() || !question_->isHidden();
    messageHolder_->setVisible(any);
    messageRow_->setVisible(any);
}

}  // namespace reliefui
