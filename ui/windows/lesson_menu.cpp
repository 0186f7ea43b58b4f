#include "windows/lesson_menu.h"

#include <filesystem>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "lessons/lesson_pane.h"
#include "lessons/new_lesson.h"
#include "panes/file_dialogs.h"
#include "windows/share.h"
#include "workspace/start_scenario.h"

namespace reliefui {

namespace {

QString folderKind() {
    return QStringLiteral("lessons");
}

}  // namespace

LessonMenu::LessonMenu(Workspace* workspace, const QString& datasets, QMenu* menu, QMainWindow* window, Ways ways)
    : QObject(window),
      workspace_(workspace),
      datasets_(datasets),
      menu_(menu),
      window_(window),
      ways_(std::move(ways)),
      player_(new LessonPlayer(workspace, datasets, this)) {
    setObjectName(QStringLiteral("lesson-menu"));
    dock_ = new QDockWidget(tr("Lesson"), window_);
    dock_->setObjectName(QStringLiteral("lesson-dock"));
    pane_ = new LessonPane(workspace_, player_, dock_);
    dock_->setWidget(pane_);
    window_->addDockWidget(Qt::LeftDockWidgetArea, dock_);
    dock_->hide();
    connect(player_, &LessonPlayer::paneWanted, this, [this](const QString& pane) { ways_.focusPane(pane); });
    for (const auto signal : {&LessonPlayer::changedPage, &LessonPlayer::changedState}) {
        connect(player_, signal, this, [this] {
            if (notesText_) notesText_->setHtml(lessonNotesHtml(*player_));
        });
    }
    connect(pane_, &LessonPane::notesRequested, this, &LessonMenu::showNotes);
    connect(dock_, &QDockWidget::visibilityChanged, this, &LessonMenu::tellShown);
    const auto add = [&](const QString& text, const char* keys, const QString& help, void (LessonMenu::*slot)()) {
        QAction* const action = ways_.addAction(text, QLatin1String(keys), help);
        connect(action, &QAction::triggered, this, slot);
        return action;
    };
    end_ = menu_->addSeparator();
    add(tr("&Open a folder of lessons…"), "", tr("A lesson, or a folder of lessons, of your own"),
        &LessonMenu::askFolder);
    add(tr("&Make a lesson of this…"), "", tr("A new lesson whose first page is what the window shows now"),
        &LessonMenu::askNewLesson);
    add(tr("&Write as a page for browsers…"), "",
        tr("The open lesson as one HTML file, which needs no program and no network"), &LessonMenu::askPage);
    add(tr("Lecturer’s &notes"), "", tr("Notes on the page in a window of their own, for a second screen"),
        &LessonMenu::showNotes);
    lecture_ =
        ways_.addAction(tr("&Lecture"), QString(),
                        tr("Page Down: answer, then next page; Page Up: back; 1 to 9: count a guess; B: black screen"));
    lecture_->setCheckable(true);
    connect(lecture_, &QAction::toggled, this, &LessonMenu::setLecture);
    connect(menu_, &QMenu::aboutToShow, this, &LessonMenu::fill);
}

void LessonMenu::fill() {
    qDeleteAll(filled_);
    filled_.clear();
    addCourse(QString::fromStdString(lessonsFolder(datasets_.toStdString())));
    if (!own_.isEmpty()) addCourse(own_);
}

void LessonMenu::addCourse(const QString& folder) {
    relief::Course course;
    try {
        course = relief::readCourse(folder.toStdString());
    } catch (const relief::InputError&) {
        return;  // no lessons there; a named folder reports its fault when it is opened
    }
    const relief::Language language = workspace_->style().language;
    for (const relief::Chapter& chapter : course.chapters) {
        const QString title =
            chapter.title(language).empty() ? QDir(folder).dirName() : QString::fromStdString(chapter.title(language));
        auto* const part = new QMenu(QString(title).replace(QLatin1Char('&'), QLatin1String("&&")), menu_);
        for (const std::string& name : chapter.lessons) {
            const QString at = QString::fromStdString((std::filesystem::path(course.folder) / name).string());
            auto* const action =
                part->addAction(QString::fromStdString(name) + QStringLiteral("  ") +
                                lessonTitle(at, language).replace(QLatin1Char('&'), QLatin1String("&&")));
            connect(action, &QAction::triggered, this, [this, at] { open(at); });
        }
        menu_->insertMenu(end_, part);
        filled_ << part->menuAction();
        connect(part->menuAction(), &QObject::destroyed, part, &QObject::deleteLater);
    }
}

bool LessonMenu::open(const QString& folder, std::size_t page) {
    QString first = QFileInfo(folder).absoluteFilePath();
    if (!relief::isLesson(folder.toStdString())) {
        try {
            const relief::Course course = relief::readCourse(folder.toStdString());
            first = QDir(first).filePath(QString::fromStdString(course.lessons().front()));
        } catch (const relief::InputError& error) {
            Q_EMIT workspace_->problem(QString::fromStdString(error.text(workspace_->style().language)));
            return false;
        }
    }
    if (!player_->open(first, page)) return false;
    showDock();
    return true;
}

LessonMenu::Kept LessonMenu::kept() const {
    return {player_->kept(), !dock_->isHidden(), lecturing_, notes_ && notes_->isVisible(), own_};
}

void LessonMenu::resume(Kept kept) {
    own_ = kept.own;
    if (kept.shown) showDock();
    if (kept.notes) showNotes();
    tellShown();
    player_->resume(std::move(kept.lesson));
    setLecture(kept.lecture && player_->isOpen());
}

void LessonMenu::showDock() {
    if (dock_->isFloating() || !dock_->isHidden()) {
        dock_->show();
        return dock_->raise();
    }
    QDockWidget* const left = ways_.left();
    window_->addDockWidget(Qt::LeftDockWidgetArea, dock_);
    if (left != nullptr && !left->isHidden() && !left->isFloating()) window_->tabifyDockWidget(left, dock_);
    dock_->show();
    dock_->raise();
    constexpr double kShare = 0.27;  // of the window's width: lines of some forty letters
    window_->resizeDocks({dock_}, {static_cast<int>(kShare * window_->width())}, Qt::Horizontal);
}

void LessonMenu::askFolder() {
    const QString folder =
        QFileDialog::getExistingDirectory(window_, tr("Folder of lessons"), lastFolder(folderKind()));
    if (folder.isEmpty()) return;
    keepFolder(folderKind(), folder);
    if (!open(folder)) return;
    own_ = relief::isLesson(folder.toStdString()) ? QFileInfo(folder).path() : folder;
}

void LessonMenu::askNewLesson() {
    const QString folder = askSaveFile(window_, folderKind(), tr("Folder of the new lesson"), tr("my lesson"), {});
    if (folder.isEmpty()) return;
    try {
        writeNewLesson(folder, workspace_->scenario(), ways_.activePane(), datasets_);
    } catch (const relief::InputError& error) {
        Q_EMIT workspace_->problem(QString::fromStdString(error.text(workspace_->style().language)));
        return;
    }
    if (!open(folder)) return;
    own_ = QFileInfo(folder).path();
    Q_EMIT workspace_->notice(
        tr("The new lesson is in %1: write its texts there.").arg(QDir::toNativeSeparators(folder)));
}

void LessonMenu::askPage() {
    if (!player_->isOpen()) return Q_EMIT workspace_->notice(tr("No lesson is open"));
    askLessonPage(window_, workspace_, QString::fromStdString(player_->lesson().folder));
}

void LessonMenu::showNotes() {
    if (!notes_) {
        notes_ = new QDialog(window_);
        notes_->setObjectName(QStringLiteral("lesson-notes"));
        notes_->setAttribute(Qt::WA_DeleteOnClose);
        notes_->setWindowTitle(tr("Lecturer’s notes"));
        connect(notes_, &QDialog::finished, this, &LessonMenu::tellShown);
        auto* const column = new QVBoxLayout(notes_);
        notesText_ = new QTextBrowser(notes_);
        column->addWidget(notesText_);
        notes_->resize(420, 360);
    }
    notesText_->setHtml(lessonNotesHtml(*player_));
    notes_->show();
    notes_->raise();
    tellShown();
}

// A dock that is a tab behind another is not hidden: the reader may soon come back to it.
void LessonMenu::tellShown() {
    player_->setShown(!dock_->isHidden() || (notes_ && notes_->isVisible()));
}

void LessonMenu::setLecture(bool on) {
    if (on == lecturing_) return;
    lecturing_ = on;
    lecture_->setChecked(on);
    setBlack(false);
    if (on) {
        qApp->installEventFilter(this);
        if (player_->isOpen()) {
            showDock();
        } else {
            open(QString::fromStdString(lessonsFolder(datasets_.toStdString())));
        }
    } else {
        qApp->removeEventFilter(this);
    }
    pane_->setLecture(on);
}

void LessonMenu::setBlack(bool on) {
    if (on == !black_.isNull()) return;
    if (!on) {
        delete black_;
        return;
    }
    black_ = new QWidget(window_);
    black_->setObjectName(QStringLiteral("black-screen"));
    black_->setAutoFillBackground(true);
    QPalette black;
    black.setColor(QPalette::Window, Qt::black);
    black_->setPalette(black);
    black_->setGeometry(window_->rect());
    black_->show();
    black_->raise();
}

std::function<void()> LessonMenu::lectureAction(int key) {
    if (black_) return [this] { setBlack(false); };
    switch (key) {
        case Qt::Key_PageDown:
            return [this] { player_->forward(); };
        case Qt::Key_PageUp:
            return [this] { player_->previous(); };
        case Qt::Key_B:
            return [this] { setBlack(true); };
        case Qt::Key_Escape:
            return [this] { setLecture(false); };
        default:
            break;
    }
    if (key < Qt::Key_1 || key > Qt::Key_9 || player_->votes().empty() || player_->revealed()) return {};
    return [this, choice = static_cast<std::size_t>(key - Qt::Key_1)] { player_->vote(choice); };
}

bool LessonMenu::eventFilter(QObject* watched, QEvent* event) {
    const bool press = event->type() == QEvent::KeyPress, claim = event->type() == QEvent::ShortcutOverride;
    auto* const widget = qobject_cast<QWidget*>(watched);
    if (!lecturing_ || (!press && !claim) || widget == nullptr || widget->window() != window_) return false;
    const auto& key = *static_cast<QKeyEvent*>(event);
    if ((key.modifiers() & ~Qt::KeypadModifier) != 0) return false;
    const auto action = lectureAction(key.key());
    if (!action) return false;
    if (press) {
        action();
    } else {
        // Claimed from the shortcuts first, so that the key press itself arrives here.
        event->accept();
    }
    return true;
}

}  // namespace reliefui
