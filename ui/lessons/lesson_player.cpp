#include "lessons/lesson_player.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <QFileInfo>
#include <QSettings>

#include "relief/files.h"
#include "workspace/change_name.h"
#include "workspace/layer_names.h"
#include "workspace/pane_store.h"

namespace reliefui {

namespace {

// The lessons of which every page was shown.
QString wholeKey() {
    return QStringLiteral("lessons/whole");
}

QString folderOf(const relief::Course& course, const std::string& lesson) {
    return QString::fromStdString((std::filesystem::path(course.folder) / lesson).string());
}

// All words of a page and of the lesson that can be shown with it.
std::vector<std::string> wordsOf(const relief::LessonText& text, std::size_t page) {
    const relief::PageText& words = text.pages[page];
    std::vector<std::string> all{text.about,     text.remember, text.note,    text.source, words.title, words.text,
                                 words.question, words.hint,    words.answer, words.knob,  words.note};
    all.insert(all.end(), words.choices.begin(), words.choices.end());
    return all;
}

}  // namespace

LessonPlayer::LessonPlayer(Workspace* workspace, QString datasets, QObject* parent)
    : QObject(parent),
      workspace_(workspace),
      datasets_(std::move(datasets)),
      job_(this, {[](const QString&) {}, [](const QString&, double) {}}) {
    connect(workspace_, &Workspace::snapshotChanged, this, &LessonPlayer::snapshotCame);
    connect(workspace_, &Workspace::stepChanged, this, [this] { measure(); });
    // A page that shows the same picture as the one before it makes no new snapshot.
    connect(workspace_, &Workspace::busyChanged, this, [this](bool busy) {
        if (!busy) snapshotCame();
    });
}

bool LessonPlayer::open(const QString& folder, std::size_t page) {
    try {
        if (!kept_.lesson || QString::fromStdString(kept_.lesson->folder) != folder) {
            auto lesson = std::make_shared<const relief::Lesson>(
                relief::readLesson(folder.toStdString(), datasets_.toStdString()));
            kept_.course = relief::readCourse(QFileInfo(QFileInfo(folder).absoluteFilePath()).path().toStdString());
            kept_.lesson = std::move(lesson);
            kept_.seen.clear();
        }
        show(std::min(page, kept_.lesson->pages.size() - 1));
    } catch (const relief::InputError& error) {
        Q_EMIT workspace_->problem(QString::fromStdString(error.text(workspace_->style().language)));
        return false;
    }
    return true;
}

void LessonPlayer::setShown(bool shown) {
    if (shown == shown_) return;
    shown_ = shown;
    if (shown) {
        if (!measureDue_) return;
        measured_ = {};  // of another scenario
        return measure();
    }
    measureDue_ = measureDue_ || job_.busy();
    job_.drop();
    scenes_ = std::make_shared<relief::SceneCache>();
}

void LessonPlayer::show(std::size_t page) {
    kept_.scenario = kept_.lesson->scenarioOf(page);  // throws before anything changes
    job_.drop();                                      // its values are those of the page before
    kept_.page = page;
    measured_ = {};
    kept_.answers = {};
    kept_.answers.votes.assign(this->page().question ? this->page().question->choices.size() : 0, 0);
    kept_.stepDue = this->page().step.has_value();
    kept_.seen.insert(kept_.page);
    if (kept_.seen.size() == kept_.lesson->pages.size()) {
        QSettings settings;
        const QStringList whole = settings.value(wholeKey()).toStringList();
        const QString name = QString::fromStdString(kept_.lesson->name);
        if (!whole.contains(name)) settings.setValue(wholeKey(), whole + QStringList(name));
    }
    workspace_->setGuessing(this->page().question && this->page().question->kind == relief::LessonQuestion::Kind::Hit);
    workspace_->setLayer(layerNamed(this->page().layer).value_or(Layer::Color));
    workspace_->show(kept_.scenario, changeName([title = QString::fromStdString(kept_.lesson->name)] {
                         return LessonPlayer::tr("Lesson %1").arg(title);
                     }));
    Q_EMIT changedPage();
    if (!this->page().pane.empty()) Q_EMIT paneWanted(QString::fromStdString(this->page().pane));
}

void LessonPlayer::resume(Kept kept) {
    if (!kept.lesson) return;
    kept_ = std::move(kept);
    measured_ = {};
    Q_EMIT changedPage();
    // The workspace has its snapshot already, so that none comes that would start the measuring.
    snapshotCame();
}

void LessonPlayer::restore() {
    if (kept_.lesson) open(QString::fromStdString(kept_.lesson->folder), kept_.page);
}

void LessonPlayer::snapshotCame() {
    if (!kept_.lesson || workspace_->loading()) return;
    const auto snapshot = workspace_->snapshot();
    if (!snapshot || snapshot->coarse || (workspace_->busy() && snapshot->version != workspace_->version())) return;
    if (kept_.stepDue && !workspace_->guessing()) {
        kept_.stepDue = false;
        const PixelTrace& trace = snapshot->trace;
        const bool departs = trace.judgement.kind != relief::Departure::None;
        const auto step =
            relief::stepOf(*page().step, trace.steps, departs ? std::optional(trace.judgement.step) : std::nullopt,
                           trace.judgement.overshoot);
        if (step && *step != workspace_->scenario().step) workspace_->chooseStep(*step);
    }
    measure();
}

void LessonPlayer::measure() {
    if (!kept_.lesson || workspace_->loading()) return;
    measureDue_ = !shown_;
    if (measureDue_) return;
    const auto result = std::make_shared<Measured>();
    const auto work = [result, lesson = kept_.lesson, page = kept_.page, scenes = scenes_,
                       scenario = workspace_->scenario(), language = workspace_->style().language,
                       turned = page().knob.has_value() && turn() >= 0](relief::Work& w) {
        const auto source = relief::lessonSource(*lesson, scenario, *scenes, w);
        const auto guarded = [&](const auto& body) {
            try {
                body();
            } catch (const relief::InputError& error) {
                if (result->problem.isEmpty()) result->problem = QString::fromStdString(error.text(language));
            }
        };
        for (const std::string& words : wordsOf(lesson->text(language), page)) {
            for (const relief::ValueSlot& slot : relief::valueSlots(words)) {
                guarded([&] { result->values[key(slot)] = relief::filledValue(slot, source); });
            }
        }
        const relief::LessonPage& shown = lesson->pages[page];
        if (shown.question && shown.question->kind == relief::LessonQuestion::Kind::Choose) {
            // None is right where the reader has changed the scenario.
            try {
                result->right = relief::rightChoice(*shown.question, source);
            } catch (const relief::InputError&) {
                result->right.reset();
            }
        }
        if (shown.question && shown.question->number) {
            guarded([&] { result->number = shown.question->number->number(source); });
        }
        for (std::size_t n = 0; turned && n < shown.knob->watch.size(); ++n) {
            guarded([&] { result->watched.push_back(shown.knob->watch[n].value.number(source)); });
        }
    };
    const int at = turn();
    job_.start({work, [this, result, at] {
                    measured_ = std::move(*result);
                    if (at >= 0 && page().knob && measured_.watched.size() == page().knob->watch.size()) {
                        kept_.answers.turns[at] = measured_.watched;
                    }
                    Q_EMIT changedState();
                }});
    Q_EMIT changedState();
}

QString LessonPlayer::html(const std::string& words) const {
    return QString::fromStdString(relief::lessonHtml(words, [this](const relief::ValueSlot& slot) {
        const auto found = measured_.values.find(key(slot));
        return found == measured_.values.end() ? std::string("…") : found->second;
    }));
}

bool LessonPlayer::changed() const {
    if (!kept_.lesson) return false;
    return !(relief::withNotesOf(workspace_->scenario(), kept_.scenario) == kept_.scenario);
}

void LessonPlayer::choose(std::size_t choice) {
    if (kept_.answers.revealed) return;
    kept_.answers.chosen = choice;
    Q_EMIT changedState();
}

void LessonPlayer::guessNumber(double number) {
    if (kept_.answers.revealed) return;
    kept_.answers.guessed = number;
    Q_EMIT changedState();
}

void LessonPlayer::reveal() {
    if (!kept_.lesson || !page().question || kept_.answers.revealed) return;
    kept_.answers.revealed = true;
    workspace_->setGuessing(false);
    Q_EMIT changedState();
}

bool LessonPlayer::guessIsRight() const {
    if (kept_.answers.chosen) return kept_.answers.chosen == measured_.right;
    return kept_.answers.guessed && measured_.number &&
           std::abs(*kept_.answers.guessed - *measured_.number) <= page().question->within;
}

void LessonPlayer::vote(std::size_t choice) {
    if (kept_.answers.revealed || choice >= kept_.answers.votes.size()) return;
    ++kept_.answers.votes[choice];
    Q_EMIT changedState();
}

void LessonPlayer::hint() {
    kept_.answers.hinted = true;
    Q_EMIT changedState();
}

int LessonPlayer::turn() const {
    if (!kept_.lesson || !page().knob) return -1;
    const auto& knob = *page().knob;
    const relief::Json now = relief::Json::parse(relief::scenarioText(workspace_->scenario()));
    const relief::Json::json_pointer place(knob.set);
    if (!now.contains(place)) return -1;
    const auto found = std::find(knob.values.begin(), knob.values.end(), now[place]);
    return found == knob.values.end() ? -1 : static_cast<int>(found - knob.values.begin());
}

void LessonPlayer::turnTo(int turn) {
    if (!kept_.lesson || !page().knob || turn < 0 || turn >= static_cast<int>(page().knob->values.size())) return;
    const relief::LessonKnob& knob = *page().knob;
    relief::Json now = relief::Json::parse(relief::scenarioText(workspace_->scenario()));
    // Without the chosen pixel, which may lie outside a smaller picture: change() moves it inside.
    const bool resizes = knob.set.starts_with("/size");
    if (resizes) now.erase("pixel");
    // The reader's scenario may have no place for the value.
    if (!relief::putValue(now, knob.set, knob.values[static_cast<std::size_t>(turn)])) return Q_EMIT changedState();
    try {
        relief::Scenario turned = relief::parseScenario(now.dump(), kept_.lesson->file());
        if (resizes) turned.pixel = workspace_->scenario().pixel;
        workspace_->change(turned, changeName([] { return LessonPlayer::tr("Knob of the lesson"); }),
                           QStringLiteral("lesson-knob"));
    } catch (const relief::InputError& error) {
        // The reader may have chosen a method without the knob's option. The lines are those of no file.
        Q_EMIT workspace_->problem(
            QString::fromStdString(relief::sentence(withoutLine(error.message()), workspace_->style().language)));
        Q_EMIT changedState();  // sets the knob back
    }
}

std::optional<LessonPlayer::Place> LessonPlayer::after() const {
    if (!kept_.lesson) return std::nullopt;
    if (kept_.page + 1 < kept_.lesson->pages.size())
        return Place{QString::fromStdString(kept_.lesson->folder), kept_.page + 1};
    const auto all = kept_.course.lessons();
    const auto here = std::find(all.begin(), all.end(), kept_.lesson->name);
    if (here == all.end() || here + 1 == all.end()) return std::nullopt;
    return Place{folderOf(kept_.course, *(here + 1)), 0};
}

std::optional<LessonPlayer::Place> LessonPlayer::before() const {
    if (!kept_.lesson) return std::nullopt;
    if (kept_.page > 0) return Place{QString::fromStdString(kept_.lesson->folder), kept_.page - 1};
    const auto all = kept_.course.lessons();
    const auto here = std::find(all.begin(), all.end(), kept_.lesson->name);
    if (here == all.end() || here == all.begin()) return std::nullopt;
    // The last page of the lesson before, whose number open() limits.
    return Place{folderOf(kept_.course, *(here - 1)), static_cast<std::size_t>(-1)};
}

void LessonPlayer::next() {
    if (const auto place = after()) open(place->folder, place->page);
}

void LessonPlayer::previous() {
    if (const auto place = before()) open(place->folder, place->page);
}

void LessonPlayer::forward() {
    if (!kept_.lesson) return;
    page().question && !kept_.answers.revealed ? reveal() : next();
}

bool LessonPlayer::seenLesson(const QString& lesson) {
    return QSettings().value(wholeKey()).toStringList().contains(lesson);
}

QString lessonTitle(const QString& folder, relief::Language language) {
    const bool ukrainian = language == relief::Language::Ukrainian;
    for (const char* const name : {ukrainian ? "/text.uk.md" : "/text.en.md", "/text.en.md", "/text.uk.md"}) {
        try {
            return QString::fromStdString(
                relief::parseLessonText(relief::readTextFile(folder.toStdString() + name), name).title);
        } catch (const relief::InputError&) {
            continue;
        }
    }
    return {};
}

}  // namespace reliefui
