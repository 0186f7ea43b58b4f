// A lesson that is open in the window: its page, the values of its texts, the reader's guess. It opens the page's
// scenario in the workspace, and measures on the scenario that is open there, so that the texts follow what is changed.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "measuring/lesson/course.h"
#include "measuring/lesson/lesson_check.h"
#include "workspace/latest_job.h"
#include "workspace/workspace.h"

namespace reliefui {

class LessonPlayer : public QObject {
    Q_OBJECT
  public:
    LessonPlayer(Workspace* workspace, QString datasets, QObject* parent);

    // Opens a lesson's folder, together with the course that it is in. Reports a fault as Workspace::problem() and
    // returns false.
    bool open(const QString& folder, std::size_t page = 0);
    bool isOpen() const { return kept_.lesson != nullptr; }
    // Whether the lesson is shown, true at first. While it is not, nothing is measured, and the scenes that the values
    // were measured on are freed.
    void setShown(bool shown);

    const relief::Lesson& lesson() const { return *kept_.lesson; }
    const relief::LessonPage& page() const { return kept_.lesson->pages[kept_.page]; }
    const relief::LessonText& text() const { return kept_.lesson->text(workspace_->style().language); }
    const relief::PageText& words() const { return text().pages[kept_.page]; }
    std::size_t pageNumber() const { return kept_.page; }
    const relief::Course& course() const { return kept_.course; }
    // The folder and number of the page after (before) the shown one, possibly of another lesson of the course.
    struct Place {
        QString folder;
        std::size_t page = 0;
    };
    std::optional<Place> after() const;
    std::optional<Place> before() const;

    // Returns the words with their values as HTML; "…" for a value that is being measured.
    QString html(const std::string& words) const;
    bool measuring() const { return job_.busy(); }
    // Why values could not be measured; empty if they could.
    const QString& problem() const { return measured_.problem; }
    // Returns true if the open scenario is not the page's.
    bool changed() const;

    // What the reader did on the shown page.
    struct Answers {
        std::optional<std::size_t> chosen;
        std::optional<double> guessed;
        bool revealed = false;
        bool hinted = false;
        std::vector<int> votes;
        std::map<int, std::vector<double>> turns;
    };
    // The open lesson, to show it again in a window that replaces this one, with the scene and the answers as the
    // reader left them.
    struct Kept {
        std::shared_ptr<const relief::Lesson> lesson;
        relief::Course course;
        std::size_t page = 0;
        relief::Scenario scenario;   // of the page, without the step that its rule finds
        std::set<std::size_t> seen;  // pages of the lesson
        bool stepDue = false;        // the page's step is chosen when its ray is known
        Answers answers;
    };
    const Kept& kept() const { return kept_; }
    void resume(Kept kept);

    // The guess. choice: number of the answer, from 0.
    void choose(std::size_t choice);
    void guessNumber(double number);
    const std::optional<std::size_t>& chosen() const { return kept_.answers.chosen; }
    const std::optional<double>& guessed() const { return kept_.answers.guessed; }
    bool revealed() const { return kept_.answers.revealed; }
    void reveal();
    // The answer that is right; std::nullopt while it is being measured, or if the scenario was changed so that none
    // is.
    const std::optional<std::size_t>& right() const { return measured_.right; }
    const std::optional<double>& number() const { return measured_.number; }
    bool guessIsRight() const;
    // Guesses of a class: how many chose each answer.
    const std::vector<int>& votes() const { return kept_.answers.votes; }
    void vote(std::size_t choice);

    bool hinted() const { return kept_.answers.hinted; }
    void hint();

    // The knob: number of its value in use, -1 if the scenario has another one; and the watched values at the turns
    // that were tried, by number of the turn.
    int turn() const;
    void turnTo(int turn);
    const std::map<int, std::vector<double>>& turns() const { return kept_.answers.turns; }

    // Returns true if every page of the lesson was shown while it was open; kept in the settings.
    static bool seenLesson(const QString& lesson);

  public slots:
    void next();
    void previous();
    // Opens the page's scenario again.
    void restore();
    // For a lecturer's remote control: first reveals the answer of a question, then goes to the next page.
    void forward();

  signals:
    void changedPage();
    void changedState();  // values, guess, hint, knob
    void paneWanted(const QString& pane);

  private:
    struct Measured {
        std::map<std::string, std::string> values;  // by ValueSlot
        std::optional<std::size_t> right;
        std::optional<double> number;
        std::vector<double> watched;
        QString problem;
    };

    void show(std::size_t page);
    void snapshotCame();
    void measure();
    static std::string key(const relief::ValueSlot& slot) { return slot.expression + "\n" + slot.format; }

    Workspace* workspace_;
    QString datasets_;
    Kept kept_;
    bool shown_ = true;
    bool measureDue_ = false;  // when the lesson is shown again
    Measured measured_;
    std::shared_ptr<relief::SceneCache> scenes_ = std::make_shared<relief::SceneCache>();
    LatestJob job_;  // last member: its thread ends before the others are destroyed
};

// Titles of lessons for menus, read without the rest of the lesson. Empty if there is none.
QString lessonTitle(const QString& folder, relief::Language language);

}  // namespace reliefui
