#include <QAbstractButton>
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

#include "panes/figure_view.h"
#include "panes/result/result_painting.h"
#include "panes/result/result_view.h"
#include "windows/breakpoint_bar.h"
#include "windows/home_view.h"
#include "windows/layout_menu.h"
#include "windows/main_window.h"
#include "windows/moving_dialog.h"
#include "windows/share.h"
#include "windows/status_line.h"
#include "windows/step_bar.h"
#include "windows/time_pane.h"
#include "workspace/change_name.h"
#include "workspace/language.h"
#include "workspace/pause_log.h"

namespace reliefui {
namespace {

QString raysFromEndKey() {
    return QStringLiteral("raysFromEnd");
}

}  // namespace

QAction* MainWindow::addAction(QMenu* menu, const QString& text, const QKeySequence& keys, const QString& help) {
    auto* const action = new QAction(text, this);
    action->setShortcut(keys);
    const QString shown = keys.toString(QKeySequence::NativeText);
    action->setToolTip(shown.isEmpty() ? help : QStringLiteral("%1 (%2)").arg(help, shown));
    action->setStatusTip(QString());
    menu->addAction(action);
    return action;
}

void MainWindow::makeMenus() {
    makeFileMenu();
    makeEditMenu();
    makeViewMenu();
    makeRayMenu();
    makeLessonMenu();
    makeHelpMenu();
    for (QMenu* const menu : findChildren<QMenu*>()) menu->setToolTipsVisible(true);
}

void MainWindow::makeFileMenu() {
    QMenu* const menu = menuBar()->addMenu(tr("&File"));
    open_ = addAction(menu, tr("&Open…"), QKeySequence::Open, tr("Open a height map or a scenario"));
    connect(open_, &QAction::triggered, this, &MainWindow::askOpen);
    auto* const color = addAction(menu, tr("Open &colour…"), QKeySequence(QStringLiteral("Ctrl+Shift+O")),
                                  tr("Open the colour picture of the relief"));
    connect(color, &QAction::triggered, this, &MainWindow::askColor);
    fillExamples(menu->addMenu(tr("&Examples")));
    auto* const anew = addAction(menu, tr("Start a&new"), {}, tr("The pictures and the view of the first start"));
    connect(anew, &QAction::triggered, this, &MainWindow::startAnew);
    recent_ = menu->addMenu(tr("&Recent files"));
    connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
    menu->addSeparator();
    auto* const save = addAction(menu, tr("&Save scenario…"), QKeySequence::Save,
                                 tr("Save pictures, view and settings, to open them again"));
    connect(save, &QAction::triggered, this, &MainWindow::askSaveScenario);
    auto* const other = addAction(menu, tr("Open another &tracer's steps…"), QKeySequence(QStringLiteral("Ctrl+T")),
                                  tr("Open a file of rays and a file of the steps or hits of another tracer on them"));
    connect(other, &QAction::triggered, this, &MainWindow::askOtherTracer);
    auto* const picture = addAction(menu, tr("Save &picture…"), QKeySequence(QStringLiteral("Ctrl+Shift+S")),
                                    tr("Save the picture of the result"));
    connect(picture, &QAction::triggered, this, [this] { askSavePicture(); });
    auto* const figure = addAction(menu, tr("&Export the pane…"), QKeySequence(QStringLiteral("Ctrl+E")),
                                   tr("Export the pane that has the keyboard focus as SVG, PDF or PNG"));
    connect(figure, &QAction::triggered, this, &MainWindow::exportFocused);
    auto* const page = addAction(menu, tr("S&hare the pane as a page…"), {},
                                 tr("The pane in use as one HTML file with a slider over the steps, for any browser"));
    connect(page, &QAction::triggered, this, [this] {
        const QDockWidget* const active = activePane();
        for (const Pane& pane : panes_) {
            if (pane.dock != active || pane.kind.figures.empty()) continue;
            askPanePage(this, workspace_, QString::fromStdString(pane.kind.figures.front().name));
        }
    });
    auto* const moving = addAction(menu, tr("&Moving picture…"), {},
                                   tr("A pane at each step, from all sides, or while an option changes: as a page for "
                                      "browsers or as numbered pictures"));
    connect(moving, &QAction::triggered, this, [this] {
        const QDockWidget* const active = activePane();
        QString name = QStringLiteral("result");
        for (const Pane& pane : panes_) {
            if (pane.dock == active && active != nullptr && !result_->hasFocus()) name = pane.kind.name;
        }
        askMovingPicture(this, workspace_, name);
    });
    menu->addSeparator();
    auto* const quit = addAction(menu, tr("&Quit"), QKeySequence::Quit, tr("Close the window"));
    connect(quit, &QAction::triggered, this, &QWidget::close);
}

void MainWindow::makeEditMenu() {
    QMenu* const menu = menuBar()->addMenu(tr("&Edit"));
    undo_ = addAction(menu, tr("&Undo"), QKeySequence(QStringLiteral("Ctrl+Z")), tr("Undo the last change"));
    redo_ =
        addAction(menu, tr("&Redo"), QKeySequence(QStringLiteral("Ctrl+Shift+Z")), tr("Redo the last undone change"));
    undo_->setIconText(QStringLiteral("↶"));
    redo_->setIconText(QStringLiteral("↷"));
    connect(undo_, &QAction::triggered, workspace_, &Workspace::undo);
    connect(redo_, &QAction::triggered, workspace_, &Workspace::redo);
    menu->addSeparator();
    copyCommand_ = addAction(menu, tr("&Copy as command"), QKeySequence(QStringLiteral("Ctrl+Shift+C")),
                             tr("Copy the relief trace command of the chosen pixel"));
    connect(copyCommand_, &QAction::triggered, this, &MainWindow::copyCommand);
    auto* const copy = addAction(menu, tr("Copy &picture"), QKeySequence(QStringLiteral("Ctrl+Alt+C")),
                                 tr("Copy the picture of the result"));
    connect(copy, &QAction::triggered, this, [this] {
        if (const auto snapshot = workspace_->snapshot()) QApplication::clipboard()->setImage(snapshot->layer.image);
    });
    menu->addSeparator();
    auto* const cancel =
        addAction(menu, tr("C&ancel"), QKeySequence(Qt::Key_Escape),
                  tr("Cancel the running work; without any, leave guessing, a filled pane or the projector"));
    connect(cancel, &QAction::triggered, this, &MainWindow::cancel);
}

void MainWindow::makeViewMenu() {
    QMenu* const menu = menuBar()->addMenu(tr("&View"));
    QMenu* const go = menu->addMenu(tr("&Go to"));
    for (std::size_t i = 0; i < panes_.size(); ++i) {
        auto* const action = addAction(go, panes_[i].kind.title, QKeySequence(paneKey(i)), panes_[i].kind.help);
        connect(action, &QAction::triggered, this, [this, i] { focusPane(i); });
    }
    QMenu* const shown = menu->addMenu(tr("&Panes"));
    for (const Pane& pane : panes_) {
        if (pane.dock != nullptr) shown->addAction(pane.dock->toggleViewAction());
    }
    teach_ = addAction(menu, tr("T&each"), QKeySequence(Qt::Key_T),
                       tr("Show one pane large, the picture in a corner and the step in words"));
    teach_->setCheckable(true);
    connect(teach_, &QAction::toggled, this, &MainWindow::setTeaching);
    auto* const reset = addAction(menu, tr("Reset &layout"), {}, tr("Restore the original layout of the panes"));
    connect(reset, &QAction::triggered, this, &MainWindow::resetLayout);
    QMenu* const own = menu->addMenu(tr("Layo&uts of your own"));
    auto* const save = addAction(own, tr("&Save this layout…"), {}, tr("Save the layout of the panes under a name"));
    auto* const layouts = new LayoutMenu(this, own);
    connect(save, &QAction::triggered, layouts, &LayoutMenu::askName);
    menu->addSeparator();
    auto* const first = addAction(menu, tr("&First view"), QKeySequence(Qt::Key_H),
                                  tr("The camera as it was when the scene was opened"));
    connect(first, &QAction::triggered, home_, &HomeView::go);
    auto* const whole =
        addAction(menu, tr("Show the &whole picture"), {}, tr("Reset the zoom of the result (R in the result)"));
    connect(whole, &QAction::triggered, result_, &ResultView::resetZoom);
    menu->addSeparator();
    makeLanguageMenu(menu->addMenu(tr("La&nguage")));
    light_ = addAction(menu, tr("Ligh&t theme"), {}, tr("Dark on light instead of light on dark"));
    light_->setCheckable(true);
    connect(light_, &QAction::toggled, this, &MainWindow::setLightTheme);
    projector_ =
        addAction(menu, tr("Pro&jector"), QKeySequence(Qt::Key_F11), tr("Full screen, large text, thick lines"));
    projector_->setCheckable(true);
    connect(projector_, &QAction::toggled, this, &MainWindow::setProjector);
}

// Each language is listed by its own name, so that it can be found by those who do not read the current one.
void MainWindow::makeLanguageMenu(QMenu* menu) {
    auto* const all = new QActionGroup(menu);
    const QString now = chosenLanguage();
    const auto add = [&](const QString& text, const QString& language) {
        auto* const action = addAction(menu, text, {}, tr("The language of the window"));
        action->setObjectName(QStringLiteral("language-") + language);
        action->setCheckable(true);
        action->setChecked(language == now);
        all->addAction(action);
        // Queued until the menu is closed, because the window that owns the menu is replaced.
        connect(
            action, &QAction::triggered, this, [this, language] { Q_EMIT languageChosen(language); },
            Qt::QueuedConnection);
    };
    add(tr("As in the system"), {});
    add(QStringLiteral("English"), QStringLiteral("en"));
    add(QStringLiteral("Українська"), QStringLiteral("uk"));
}

void MainWindow::makeRayMenu() {
    QMenu* const menu = menuBar()->addMenu(tr("&Ray"));
    const auto add = [&](const QString& text, const QKeySequence& keys, const QString& help, void (StepBar::*slot)()) {
        connect(addAction(menu, text, keys, help), &QAction::triggered, time_->bar(), slot);
    };
    add(tr("&First step"), QKeySequence(Qt::Key_Home), tr("Go to the first step of the ray"), &StepBar::first);
    add(tr("&Previous step"), QKeySequence(Qt::Key_Comma), tr("Go one step back"), &StepBar::previous);
    add(tr("&Next step"), QKeySequence(Qt::Key_Period), tr("Go one step forward"), &StepBar::next);
    add(tr("&Last step"), QKeySequence(Qt::Key_End), tr("Go to the last step of the ray"), &StepBar::last);
    add(tr("Pla&y"), QKeySequence(Qt::Key_Space), tr("Play the steps until a breakpoint"), &StepBar::togglePlay);
    add(tr("Play fas&ter"), QKeySequence(Qt::Key_BracketRight), tr("More steps per second"), &StepBar::faster);
    add(tr("Play slo&wer"), QKeySequence(Qt::Key_BracketLeft), tr("Fewer steps per second"), &StepBar::slower);
    add(tr("Step &over a level"), QKeySequence(Qt::Key_F10), tr("Go forward, skipping steps on finer levels"),
        &StepBar::over);
    add(tr("Step &back over a level"), QKeySequence(QStringLiteral("Shift+F10")),
        tr("Go back, skipping steps on finer levels"), &StepBar::overBack);
    menu->addSeparator();
    add(tr("&Run to the next breakpoint"), QKeySequence(Qt::Key_F5),
        tr("Go to the next step that meets a breakpoint condition"), &StepBar::run);
    add(tr("Run bac&k to a breakpoint"), QKeySequence(QStringLiteral("Shift+F5")),
        tr("Go back to the previous breakpoint"), &StepBar::runBack);
    add(tr("Run to the next &change"), QKeySequence(Qt::Key_F8),
        tr("Go to the next step at which the chosen value of the pane Watch changes"), &StepBar::runToChange);
    add(tr("Run back to a c&hange"), QKeySequence(QStringLiteral("Shift+F8")),
        tr("Go back to the step before the watched value became what it is"), &StepBar::runBackToChange);
    connect(addAction(menu, tr("&Stop at this texel"), QKeySequence(Qt::Key_F9),
                      tr("Set a breakpoint at the texel of the chosen step, or remove it")),
            &QAction::triggered, time_->breakpoints(), &BreakpointBar::toggleHere);
    menu->addSeparator();
    makeWorthMenu(menu);
    makeDuelMenu(menu);
    makeBookmarkMenu(menu);
    auto* const end = addAction(menu, tr("Show rays from the&ir end"), {},
                                tr("Show the last step of the ray instead of the first when a pixel is chosen"));
    end->setCheckable(true);
    connect(end, &QAction::toggled, workspace_, &Workspace::setRaysFromEnd);
    end->setChecked(QSettings().value(raysFromEndKey()).toBool());
    connect(end, &QAction::toggled, this, [](bool on) { QSettings().setValue(raysFromEndKey(), on); });
    auto* const guess = addAction(menu, tr("G&uess the hit"), QKeySequence(Qt::Key_G),
                                  tr("Hide the answer; a click in the profile guesses where the ray hits"));
    guess->setCheckable(true);
    guess->setChecked(workspace_->guessing());
    connect(guess, &QAction::toggled, workspace_, &Workspace::setGuessing);
    connect(workspace_, &Workspace::guessingChanged, guess, &QAction::setChecked);
    menu->addSeparator();
    auto* const pixel = addAction(menu, tr("&Go to pixel…"), QKeySequence(QStringLiteral("Ctrl+G")),
                                  tr("Choose a pixel by its coordinates"));
    connect(pixel, &QAction::triggered, this, &MainWindow::askPixel);
}

void MainWindow::makeHelpMenu() {
    QMenu* const menu = menuBar()->addMenu(tr("&Help"));
    auto* const keys =
        addAction(menu, tr("&Mouse and keys"), QKeySequence(Qt::Key_F1), tr("List the mouse actions and keys"));
    connect(keys, &QAction::triggered, this, &MainWindow::showShortcuts);
    auto* const manual =
        addAction(menu, tr("Man&ual"), {}, tr("The guide, the methods and the commands, in the browser"));
    connect(manual, &QAction::triggered, this, &MainWindow::showManual);
    auto* const pauses = addAction(menu, tr("&Longest pauses…"), {}, tr("Work that blocked the window longest"));
    connect(pauses, &QAction::triggered, this, &MainWindow::showPauses);
    auto* const about = addAction(menu, tr("&About Reliefscope"), {}, tr("About this program"));
    connect(about, &QAction::triggered, this, &MainWindow::showAbout);
}

void MainWindow::refreshTitles() {
    const relief::Pictures& pictures = workspace_->scenario().pictures;
    const QFileInfo file(QString::fromStdString(pictures.height));
    const QString made = pictures.drawn.empty() ? QString::fromStdString(pictures.recipe) : tr("drawn by hand");
    const QString name = pictures.height.empty() ? made : file.dir().dirName() + '/' + file.fileName();
    setWindowTitle(name.isEmpty() ? tr("Reliefscope") : tr("%1 – Reliefscope").arg(name));
    undo_->setEnabled(workspace_->canUndo());
    redo_->setEnabled(workspace_->canRedo());
    const auto rename = [](QAction* action, const QString& plain, const QString& what) {
        const QString text = what.isEmpty() ? plain : plain + QStringLiteral(": ") + what;
        action->setText(text);
        action->setToolTip(QStringLiteral("%1 (%2)").arg(QString(text).remove('&'),
                                                         action->shortcut().toString(QKeySequence::NativeText)));
    };
    // The tool bar keeps its symbol; only menu text and tool tip name the change.
    const QString undoSign = undo_->iconText();
    const QString redoSign = redo_->iconText();
    rename(undo_, tr("&Undo"), translatedChangeName(workspace_->undoText()));
    rename(redo_, tr("&Redo"), translatedChangeName(workspace_->redoText()));
    undo_->setIconText(undoSign);
    redo_->setIconText(redoSign);
}

void MainWindow::copyCommand() {
    const QString command = workspace_->traceCommand();
    QApplication::clipboard()->setText(command);
    status_->say(tr("Copied: %1").arg(command));
}

void MainWindow::resultMenu(const QPoint& global) {
    QMenu menu(this);
    const auto pixel = result_->pixelAt(result_->mapFromGlobal(global));
    const auto snapshot = workspace_->snapshot();
    if (pixel && snapshot) {
        menu.addAction(tr("Copy value"), this, [snapshot, pixel] {
            QApplication::clipboard()->setText(pixelReadout(*snapshot, *pixel).join('\n'));
        });
        menu.addAction(tr("Choose this pixel"), this, [this, pixel] {
            workspace_->finishInteraction();  // each choice is an undo step of its own
            workspace_->choosePixel(pixel->x, pixel->y);
        });
    }
    result_->addToMenu(menu);
    menu.addAction(copyCommand_);
    menu.addAction(tr("Copy picture"), this, [this] {
        if (const auto now = workspace_->snapshot()) QApplication::clipboard()->setImage(now->layer.image);
    });
    menu.addAction(tr("Save picture…"), this, [this] { askSavePicture(); });
    if (workspace_->layer() != Layer::Color) {
        menu.addAction(tr("Save picture with its legend…"), this, [this] { askSavePicture(true); });
    }
    menu.addAction(tr("Export figure…"), this, [this] { askView(QStringLiteral("result")); });
    menu.exec(global);
}

void MainWindow::askPixel() {
    const relief::Scenario& scenario = workspace_->scenario();
    const relief::PixelChoice now = scenario.pixel.value_or(relief::PixelChoice{});
    bool accepted = false;
    const QString text = QInputDialog::getText(
        this, tr("Go to pixel"), tr("Column, row (0 to %1, 0 to %2):").arg(scenario.width - 1).arg(scenario.height - 1),
        QLineEdit::Normal, QStringLiteral("%1, %2").arg(now.x).arg(now.y), &accepted);
    if (!accepted) return;
    const QStringList parts = text.split(',');
    bool xIsNumber = false;
    bool yIsNumber = false;
    const int x = parts.value(0).trimmed().toInt(&xIsNumber);
    const int y = parts.value(1).trimmed().toInt(&yIsNumber);
    if (parts.size() != 2 || !xIsNumber || !yIsNumber) {
        Q_EMIT workspace_->problem(tr("“%1” is not a pixel; write column, row").arg(text));
        return;
    }
    workspace_->finishInteraction();  // each choice is an undo step of its own
    workspace_->choosePixel(x, y);
}

void MainWindow::showShortcuts() {
    const QList<QPair<QString, QString>> rows{
        {tr("Click in the result"), tr("choose the pixel")},
        {tr("Drag in the result"), tr("turn the camera")},
        {tr("Wheel in the result"), tr("change the camera's distance")},
        {tr("Ctrl + drag, Ctrl + wheel"), tr("pan and zoom the picture")},
        {QStringLiteral("R"), tr("the whole picture again")},
        {QStringLiteral("H"), tr("first view of the camera")},
        {tr("Arrows in the result (with Shift: ten)"), tr("move the pixel")},
        {QStringLiteral(",   ."), tr("previous and next step")},
        {tr("Home   End"), tr("first and last step")},
        {tr("Space"), tr("play the steps, until a breakpoint")},
        {QStringLiteral("[   ]"), tr("play slower, faster")},
        {QStringLiteral("F10   Shift+F10"), tr("step over a level, and back")},
        {QStringLiteral("F5   Shift+F5"), tr("run to the next breakpoint, and back")},
        {QStringLiteral("F8   Shift+F8"), tr("run to the next change of the watched value, and back")},
        {QStringLiteral("F9"), tr("set a breakpoint at this texel")},
        {QStringLiteral("Shift+E   Shift+S   Shift+O   Shift+D"),
         tr("next pixel: largest error, most steps, overshoot, disagreement")},
        {QStringLiteral("Ctrl+D"), tr("first divergence of the duel")},
        {QStringLiteral("Ctrl+B   Ctrl+Shift+B"), tr("add a bookmark, go to the next one")},
        {QStringLiteral("Insert   Shift+Insert"), tr("add an annotation to the pane, choose the next one")},
        {QStringLiteral("G"), tr("guess where the ray hits, by a click in the profile")},
        {tr("Ctrl + click in the profile or the distance map"),
         tr("show the distances at that point; again: remove the point")},
        {QStringLiteral("1 – 9, 0, Alt+1 – %1").arg(paneKey(panes_.size() - 1)), tr("go to a pane")},
        {tr("Double click on a title"), tr("fill the window with the pane, and back")},
        {tr("Arrows in the trace (with Shift: move), + −"), tr("turn the trace, zoom")},
        {tr("Alt + arrows in the comparison"), tr("move the divider, take the next one")},
        {tr("Digits in the relief by hand"), tr("type the height of the chosen texel")},
        {tr("Tab, arrows"), tr("go to a control and change it; Enter in a number field: back to the view")},
        {QStringLiteral("Ctrl+E"), tr("export the pane as SVG, PDF or PNG")},
        {QStringLiteral("Ctrl+Z   Ctrl+Shift+Z"), tr("undo and redo")},
        {QStringLiteral("Ctrl+Shift+C"), tr("copy the relief trace command of the pixel")},
        {QStringLiteral("T"), tr("teach: one pane large, the picture in a corner")},
        {QStringLiteral("F11"), tr("projector")},
        {QStringLiteral("Esc"),
         tr("cancel the running work; without any, leave guessing, a filled pane or the projector")},
    };
    QString html = QStringLiteral("<table cellpadding=4>");
    for (const auto& [keys, what] : rows) {
        html +=
            QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>").arg(keys.toHtmlEscaped(), what.toHtmlEscaped());
    }
    auto* const dialog = new QDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Mouse and keys"));
    auto* const column = new QVBoxLayout(dialog);
    auto* const list = new QTextBrowser(dialog);
    list->setAccessibleName(dialog->windowTitle());
    list->setFrameShape(QFrame::NoFrame);
    list->setHtml(html + QStringLiteral("</table>"));
    column->addWidget(list);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    column->addWidget(buttons);
    // Full height of the text, or what fits the screen; the rest scrolls.
    constexpr double kMost = 0.85;
    QTextDocument document;
    document.setDefaultFont(dialog->font());
    document.setHtml(list->toHtml());
    const QSize around(60, 80);
    dialog->resize((document.size().toSize() + around).boundedTo(screen()->availableSize() * kMost));
    dialog->show();
}

void MainWindow::showPauses() {
    constexpr std::size_t kShown = 20;
    auto* const box = new QMessageBox(this);
    box->setObjectName(QStringLiteral("pauses"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("Longest pauses"));
    box->setTextFormat(Qt::PlainText);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse);
    box->setText(PauseLog::instance().text(kShown));
    box->setStandardButtons(QMessageBox::Reset | QMessageBox::Close);
    connect(box->button(QMessageBox::Reset), &QAbstractButton::clicked, [] { PauseLog::instance().clear(); });
    box->show();
}

void MainWindow::showAbout() {
    auto* const box = new QMessageBox(this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("About Reliefscope"));
    box->setTextFormat(Qt::PlainText);
    box->setText(tr("Reliefscope %1\n\nRelief texturing on height maps, in a window that explains why a pixel looks "
                    "as it does.")
                     .arg(QApplication::applicationVersion()));
    box->setInformativeText(tr("Numbers are written with a decimal point: 12.5."));
    box->show();
}

}  // namespace reliefui
