// The main window's menus about rays: notable pixels, bookmarks, another program's tracer.
#include <algorithm>

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>

#include "lessons/lessons.h"
#include "panes/duel/duel_view.h"
#include "panes/file_dialogs.h"
#include "scenario/variation.h"
#include "windows/bookmarks.h"
#include "windows/lesson_menu.h"
#include "windows/main_window.h"
#include "windows/other_bar.h"
#include "windows/status_line.h"
#include "windows/time_pane.h"
#include "workspace/change_name.h"
#include "workspace/pixel_finder.h"

namespace reliefui {

namespace {

constexpr int kMessageMs = 8000;

}  // namespace

void MainWindow::makeWorthMenu(QMenu* menu) {
    finder_ = new PixelFinder(workspace_, this);
    connect(finder_, &PixelFinder::reported, this, [this](const QString& text) { status_->say(text, kMessageMs); });
    QMenu* const worth = menu->addMenu(tr("Next pixel &worth seeing"));
    const auto add = [&](const QString& text, const char* keys, const QString& help, relief::Worth kind) {
        auto* const action = addAction(worth, text, QKeySequence(QLatin1String(keys)), help);
        connect(action, &QAction::triggered, this,
                [this, kind] { finder_->next(kind, relief::rivalOf(workspace_->scenario())); });
    };
    add(tr("Largest &error"), "Shift+E", tr("The pixel whose hit is farthest from the exact one; again: the next"),
        relief::Worth::Error);
    add(tr("Most &steps"), "Shift+S", tr("The pixel whose ray takes the most steps; again: the next"),
        relief::Worth::Steps);
    add(tr("&Overshoot"), "Shift+O", tr("The pixel whose ray goes farthest past the surface; again: the next"),
        relief::Worth::Overshoot);
    add(tr("&Disagreement"), "Shift+D", tr("The pixel where the compared methods are farthest apart; again: the next"),
        relief::Worth::Disagreement);
}

void MainWindow::makeDuelMenu(QMenu* menu) {
    auto* const action = addAction(menu, tr("First di&vergence of the duel"), QKeySequence(QStringLiteral("Ctrl+D")),
                                   tr("Go to the first step that contradicts the exact answer"));
    connect(action, &QAction::triggered, this, [this] {
        // Brings the pane to the front first.
        focusPane(QStringLiteral("duel"));
        pane<DuelView>()->toDivergence();
    });
}

void MainWindow::makeLessonMenu() {
    QMenu* const menu = menuBar()->addMenu(tr("&Lessons"));
    LessonMenu::Ways ways;
    ways.focusPane = [this](const QString& name) { focusPane(name); };
    ways.left = [this] { return front(DockPlace::Left); };
    ways.activePane = [this] {
        const QDockWidget* const active = activePane();
        const auto found =
            std::find_if(panes_.begin(), panes_.end(), [&](const Pane& pane) { return pane.dock == active; });
        return found == panes_.end() ? QString() : found->kind.name;
    };
    ways.addAction = [this, menu](const QString& text, const QString& keys, const QString& help) {
        return addAction(menu, text, QKeySequence(keys), help);
    };
    new LessonMenu(workspace_, datasets_, menu, this, std::move(ways));
    menu->addSeparator();
    QMenu* const scenes = menu->addMenu(tr("&Short scenes"));
    int number = 0;
    for (const Lesson& lesson : lessons()) {
        // Only the first nine have a key: "1" would also match the tenth.
        const QString key = ++number < 10 ? QStringLiteral("&%1  %2") : QStringLiteral("%1  %2");
        auto* const action = addAction(scenes, key.arg(number).arg(lesson.title), {}, lesson.about);
        action->setObjectName(QStringLiteral("lesson-") + lesson.name);
        connect(action, &QAction::triggered, this, [this, name = lesson.name] { openLesson(name); });
    }
}

namespace {

QString lessonChange(const QString& name) {
    for (const Lesson& lesson : lessons()) {
        if (lesson.name == name) return MainWindow::tr("Lesson: %1").arg(lesson.title);
    }
    return name;
}

}  // namespace

void MainWindow::openLesson(const QString& name) {
    for (const Lesson& lesson : lessons()) {
        if (lesson.name != name) continue;
        try {
            workspace_->show(lessonScenario(name), changeName([name] { return lessonChange(name); }));
        } catch (const relief::InputError& error) {
            Q_EMIT workspace_->problem(QString::fromStdString(error.text(workspace_->style().language)));
            return;
        }
        showLesson(lesson);
    }
}

void MainWindow::showLesson(const Lesson& lesson) {
    Q_EMIT workspace_->notice(lesson.about);
    focusPane(lesson.pane);
}

void MainWindow::showLesson() {
    for (const Lesson& lesson : lessons()) {
        if (workspace_->scenario() == lessonScenario(lesson.name)) return showLesson(lesson);
    }
}

void MainWindow::makeBookmarkMenu(QMenu* menu) {
    QMenu* const marks = menu->addMenu(tr("Book&marks"));
    auto* const here = addAction(marks, tr("&Add bookmark"), QKeySequence(QStringLiteral("Ctrl+B")),
                                 tr("Keep this pixel, the camera and the step"));
    auto* const next = addAction(marks, tr("&Next bookmark"), QKeySequence(QStringLiteral("Ctrl+Shift+B")),
                                 tr("Go to the next bookmark"));
    auto* const all = addAction(marks, tr("Na&mes…"), {}, tr("Rename and remove bookmarks"));
    bookmarks_ = new BookmarkMenu(workspace_, marks, this);
    connect(here, &QAction::triggered, bookmarks_, &BookmarkMenu::addHere);
    connect(next, &QAction::triggered, bookmarks_, &BookmarkMenu::next);
    connect(all, &QAction::triggered, this, &MainWindow::showBookmarks);
}

void MainWindow::showBookmarks() {
    auto* const dialog = new BookmarkDialog(workspace_, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

void MainWindow::askOtherTracer() {
    const QString kind = QStringLiteral("rays");
    const QString rays =
        askOpenFile(this, kind, tr("Rays of another tracer: s0,t0,a,b in texels"), tr("Rays (*.csv);;All files (*)"));
    if (rays.isEmpty()) return;
    const QString steps =
        askOpenFile(this, kind, tr("Its steps or hits on them"), tr("Steps or hits (*.csv *.json);;All files (*)"));
    if (!steps.isEmpty()) time_->other()->open(rays, steps);
}

}  // namespace reliefui
