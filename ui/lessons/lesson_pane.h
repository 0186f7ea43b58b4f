// Shows the open lesson: its text with live values, question, hint, knob, and the way to the next page; or the contents
// of the course.
#pragma once

#include <QWidget>

#include "lessons/lesson_player.h"

class QLabel;
class QLineEdit;
class QSlider;
class QTextBrowser;
class QToolButton;
class QUrl;

namespace reliefui {

class LessonPane : public QWidget {
    Q_OBJECT
  public:
    LessonPane(Workspace* workspace, LessonPlayer* player, QWidget* parent = nullptr);

    LessonPlayer* player() const { return player_; }
    void showContents();
    // For a lecture: larger type, and the number of guesses at each answer instead of one reader's own.
    void setLecture(bool on);
    // What the page shows, as plain text.
    QString plainText() const;

  signals:
    void notesRequested();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void refresh();
    void pageCame();
    void linkClicked(const QUrl& link);
    void applyType();
    QString pageHtml() const;
    QString contentsHtml() const;
    QString questionHtml() const;
    QString answerHtml() const;
    QString knobHtml() const;

    Workspace* workspace_;
    LessonPlayer* player_;
    bool contents_ = false;
    bool lecture_ = false;
    QLabel* heading_;
    QTextBrowser* text_;
    QLineEdit* number_;
    QWidget* knobRow_;
    QSlider* knob_;
    int knobAt_ = 0;  // the last turn in use, where the knob stays while the scenario has another value
    QLabel* knobValue_;
    QToolButton* back_;
    QToolButton* all_;
    QToolButton* forward_;
    QLabel* place_;
};

// The notes of the page and the lesson for the lecturer, as HTML, with the title of the page that follows.
QString lessonNotesHtml(const LessonPlayer& player);

}  // namespace reliefui
