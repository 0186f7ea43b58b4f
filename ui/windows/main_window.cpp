#include "windows/main_window.h"

#include <QVTKOpenGLNativeWidget.h>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QTableView>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "views/charts_view.h"
#include "views/compare_view.h"
#include "views/distance_view.h"
#include "views/drawing_canvas.h"
#include "views/drawn_view.h"
#include "views/duel_view.h"
#include "views/footprint_view.h"
#include "views/profile_view.h"
#include "views/pyramid_view.h"
#include "views/result_painting.h"
#include "views/result_view.h"
#include "views/rows_view.h"
#include "views/step_table.h"
#include "views/trace3d_view.h"
#include "windows/breakpoint_bar.h"
#include "windows/message_bar.h"
#include "windows/other_bar.h"
#include "windows/pane_title.h"
#include "windows/scene_panel.h"
#include "windows/skipped_panel.h"
#include "windows/status_line.h"
#include "windows/step_bar.h"
#include "windows/theme.h"
#include "windows/top_bar.h"

namespace reliefui {

namespace {

// Parts of the window that the panes get at first.
constexpr double kSceneWidth = 0.20;
constexpr double kTraceWidth = 0.36;
constexpr double kProjectorTraceWidth = 0.48;
constexpr double kStepsHeight = 0.23;
constexpr int kMessageMs = 4000;

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
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    resize(1600, 1000);

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
    result_->setFocus();

    connect(workspace_, &Workspace::scenarioChanged, this, &MainWindow::refreshTitles);
    connect(workspace_, &Workspace::stepChanged, this, &MainWindow::refreshTitles);
    connect(workspace_, &Workspace::notesChanged, this, &MainWindow::refreshTitles);
    connect(workspace_, &Workspace::opened, this, &MainWindow::remember);
    refreshTitles();
}

MainWindow::~MainWindow() = default;

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
    column->addWidget(title);
    column->addWidget(result_, 1);
    setCentralWidget(whole);
    panes_.push_back({tr("Result"), whole, result_, nullptr});
    connect(result_, &ResultView::hovered, title, &PaneTitle::setNote);
    connect(result_, &ResultView::menuRequested, this, &MainWindow::resultMenu);
}

QDockWidget* MainWindow::addPane(const QString& title, const QString& name, QWidget* whole, QWidget* focus,
                                 Qt::DockWidgetArea area) {
    auto* const dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    // Not floating: a pane of OpenGL does not survive the move to a window of its own everywhere.
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    dock->setTitleBarWidget(titleOf(title, dock));
    dock->setWidget(whole);
    addDockWidget(area, dock);
    panes_.push_back({title, dock, focus, dock});
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
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(panel->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());

    addPane(tr("Trace 3-D"), QStringLiteral("trace-pane"), trace_, trace_->findChild<QVTKOpenGLNativeWidget*>(),
            Qt::RightDockWidgetArea);
    addPane(tr("Pyramid"), QStringLiteral("pyramid-pane"), pyramid_, pyramid_->canvas(), Qt::RightDockWidgetArea);
    linkFigure(pyramid_);
    addPane(tr("Steps"), QStringLiteral("steps-pane"), time, steps_->findChild<QTableView*>(),
            Qt::BottomDockWidgetArea);
    addPane(tr("Scene"), QStringLiteral("scene-pane"), scroll, panel, Qt::LeftDockWidgetArea);
    addPane(tr("Profile"), QStringLiteral("profile-pane"), profile_, profile_->canvas(), Qt::RightDockWidgetArea);
    linkFigure(profile_);
    addPane(tr("Distance map"), QStringLiteral("distance-pane"), distance_, distance_->canvas(),
            Qt::RightDockWidgetArea);
    linkFigure(distance_);
    footprint_ = new FootprintView(workspace_, this);
    addPane(tr("Footprint"), QStringLiteral("footprint-pane"), footprint_, footprint_->canvas(),
            Qt::RightDockWidgetArea);
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

// Not one of the panes: it is opened from the menu or from the bottom line.
void MainWindow::makeSkipped() {
    skipped_ = new QDockWidget(tr("Skipped"), this);
    skipped_->setObjectName(QStringLiteral("skipped-pane"));
    skipped_->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    skipped_->setWidget(new SkippedPanel(workspace_, skipped_));
    addDockWidget(Qt::BottomDockWidgetArea, skipped_);
    skipped_->hide();
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
    auto* const bar = new QToolBar(tr("Messages"), this);
    bar->setObjectName(QStringLiteral("messages"));
    bar->setMovable(false);
    bar->toggleViewAction()->setVisible(false);
    bar->setContentsMargins(0, 0, 0, 0);
    messages_ = new MessageBar(bar);
    QAction* const holder = bar->addWidget(messages_);
    addToolBar(bar);
    bar->hide();
    connect(workspace_, &Workspace::problem, this, [this, bar, holder](const QString& text) {
        messages_->showProblem(text);
        holder->setVisible(true);
        bar->show();
    });
    connect(workspace_, &Workspace::notice, this, [this, bar, holder](const QString& text) {
        messages_->showNotice(text);
        holder->setVisible(true);
        bar->show();
    });
    connect(messages_, &MessageBar::closed, bar, &QWidget::hide);
}

void MainWindow::resetLayout() {
    if (filled_ != nullptr) fill(filled_);
    QDockWidget* const trace = panes_[1].dock;
    QDockWidget* const pyramid = panes_[2].dock;
    QDockWidget* const steps = panes_[3].dock;
    QDockWidget* const scene = panes_[4].dock;
    addDockWidget(Qt::RightDockWidgetArea, trace);
    addDockWidget(Qt::RightDockWidgetArea, pyramid);
    addDockWidget(Qt::BottomDockWidgetArea, steps);
    addDockWidget(Qt::LeftDockWidgetArea, scene);
    splitDockWidget(trace, pyramid, Qt::Vertical);
    tabifyDockWidget(pyramid, panes_[5].dock);
    QDockWidget* last = panes_[5].dock;
    for (std::size_t i = 6; i < panes_.size(); ++i) {
        QDockWidget* const dock = panes_[i].dock;
        // Pictures want height; who draws by hand looks at all that follows.
        const bool high = dock->objectName() == QStringLiteral("compare-pane");
        const bool beside = dock->objectName() == QStringLiteral("drawn-pane");
        tabifyDockWidget(high ? trace : (beside ? scene : last), dock);
        if (!high && !beside) last = dock;
    }
    for (const Pane& pane : panes_) pane.whole->show();
    for (QDockWidget* const front : {trace, scene, pyramid}) front->raise();
    shareRoom();
    // Again when the window has its size: before that, docks are as small as they can be.
    QTimer::singleShot(0, this, &MainWindow::shareRoom);
}

void MainWindow::shareRoom() {
    QDockWidget* const trace = panes_[1].dock;
    QDockWidget* const pyramid = panes_[2].dock;
    QDockWidget* const steps = panes_[3].dock;
    QDockWidget* const scene = panes_[4].dock;
    const auto part = [](double of, double share) { return static_cast<int>(of * share); };
    resizeDocks({scene, trace}, {part(width(), kSceneWidth), part(width(), kTraceWidth)}, Qt::Horizontal);
    resizeDocks({steps}, {part(height(), kStepsHeight)}, Qt::Vertical);
    resizeDocks({trace, pyramid}, {1000, 800}, Qt::Vertical);
}

void MainWindow::fill(QWidget* pane) {
    if (filled_ == nullptr) {
        beforeFill_ = saveState();
        filled_ = pane;
        for (const Pane& other : panes_) other.whole->setVisible(other.whole == pane);
        return;
    }
    filled_ = nullptr;
    panes_.front().whole->show();
    restoreState(beforeFill_);
}

void MainWindow::focusPane(std::size_t number) {
    if (number >= panes_.size()) return;
    const Pane& pane = panes_[number];
    if (filled_ != nullptr && filled_ != pane.whole) fill(filled_);
    pane.whole->show();
    pane.whole->raise();
    QWidget* target = pane.focus;
    // A panel of controls has no focus of its own: its first control.
    if (target->focusPolicy() == Qt::NoFocus && target->focusProxy() == nullptr) {
        for (QWidget* const child : target->findChildren<QWidget*>()) {
            if ((child->focusPolicy() & Qt::TabFocus) == 0 || !child->isEnabled() || !child->isVisible()) continue;
            target = child;
            break;
        }
    }
    target->setFocus(Qt::ShortcutFocusReason);
}

void MainWindow::setProjector(bool on) {
    if (on == workspace_->style().projector) return;
    Style style = workspace_->style();
    style.projector = on;
    QApplication::setFont(windowFont(on));
    workspace_->setStyle(style);
    projector_->setChecked(on);
    if (on) {
        beforeProjector_ = saveState();
        // Nobody reads controls from the last row; the panes need the room.
        const bool byHand = !drawn_->visibleRegion().isEmpty();
        panes_[4].whole->hide();
        if (!byHand) drawn_->parentWidget()->hide();
        showFullScreen();
        // The large type of the panes at the right wants half of the window.
        QTimer::singleShot(0, this, [this] {
            if (!workspace_->style().projector) return;
            resizeDocks({panes_[1].dock}, {static_cast<int>(width() * kProjectorTraceWidth)}, Qt::Horizontal);
        });
    } else {
        showNormal();
        restoreState(beforeProjector_);
    }
}

void MainWindow::setLightTheme(bool on) {
    Style style = workspace_->style();
    style.theme = on ? Theme::Light : Theme::Dark;
    QApplication::setPalette(themePalette(style.theme));
    workspace_->setStyle(style);
}

// Keys that a control in focus needs for itself (a button its Space, a table its End) come here only when it did not.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->modifiers() != Qt::NoModifier) return QMainWindow::keyPressEvent(event);
    switch (event->key()) {
        case Qt::Key_Home:
            stepBar_->first();
            break;
        case Qt::Key_End:
            stepBar_->last();
            break;
        case Qt::Key_Space:
            stepBar_->togglePlay();
            break;
        default:
            QMainWindow::keyPressEvent(event);
    }
}

}  // namespace reliefui
