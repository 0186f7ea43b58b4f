// The menu of lessons and what it opens: the dock of the open lesson at the left, the lecturer's notes, the lecture
// mode.
//
// Lecture mode: Page Down (what a remote control sends) first reveals the answer of a question, then goes to the next
// page, at the end of a lesson to the next lesson; Page Up goes back; 1 to 9 count a guess of the class for an answer;
// B makes the screen black until the next key; Esc ends the mode.
#pragma once

#include <functional>

#include <QObject>
#include <QPointer>

#include "lessons/lesson_player.h"

class QAction;
class QDialog;
class QDockWidget;
class QMainWindow;
class QMenu;
class QTextBrowser;

namespace reliefui {

class LessonPane;
class Workspace;

class LessonMenu : public QObject {
    Q_OBJECT
  public:
    struct Ways {
        std::function<void(const QString& pane)> focusPane;  // brings a pane of the window to the front
        // The dock behind which the lesson is put as a tab; null or hidden: the lesson has the left side for itself.
        std::function<QDockWidget*()> left;
        std::function<QString()> activePane;  // name of the pane in use
        std::function<QAction*(const QString& text, const QString& keys, const QString& help)> addAction;
    };

    LessonMenu(Workspace* workspace, const QString& datasets, QMenu* menu, QMainWindow* window, Ways ways);

    LessonPlayer* player() const { return player_; }
    LessonPane* pane() const { return pane_; }
    // Opens the lesson in this folder, or the first one of a folder of lessons, and shows it.
    bool open(const QString& folder, std::size_t page = 0);
    bool lecturing() const { return lecturing_; }

    // What a menu of a window that replaces this one needs to go on with the open lesson. shown: whether its dock is
    // shown; notes: whether the lecturer's notes are; own: the user's folder of lessons, opened last.
    struct Kept {
        LessonPlayer::Kept lesson;
        bool shown = false;
        bool lecture = false;
        bool notes = false;
        QString own;
    };
    Kept kept() const;
    // Changes nothing in the workspace.
    void resume(Kept kept);

  public slots:
    void showDock();
    void setLecture(bool on);
    void showNotes();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void tellShown();
    void fill();
    void addCourse(const QString& folder);
    void askFolder();
    void askNewLesson();
    void askPage();
    void setBlack(bool on);
    // Returns what the key does in a lecture; empty: nothing of the lecture's.
    std::function<void()> lectureAction(int key);

    Workspace* workspace_;
    QString datasets_;
    QMenu* menu_;
    QMainWindow* window_;
    Ways ways_;
    LessonPlayer* player_;
    LessonPane* pane_;
    QDockWidget* dock_;
    QAction* end_ = nullptr;  // the courses stand before this entry of the menu
    QAction* lecture_ = nullptr;
    QList<QAction*> filled_;
    QString own_;  // the user's folder of lessons, opened last
    bool lecturing_ = false;
    QPointer<QWidget> black_;
    QPointer<QDialog> notes_;
    QPointer<QTextBrowser> notesText_;
};

}  // namespace reliefui
