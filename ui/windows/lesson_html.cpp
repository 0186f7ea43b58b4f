#include "windows/lesson_html.h"

#include <algorithm>

#include "panes/figure_caption.h"
#include "windows/pane_list.h"
#include "workspace/annotation_state.h"
#include "workspace/hidden_answer.h"
#include "workspace/layer_names.h"
#include "workspace/pane_store.h"
#include "workspace/resized_snapshot.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

using relief::Language;
using relief::LessonQuestion;
using relief::PageText;

constexpr int kPictureWidth = 640;
constexpr int kTurnWidth = 420;  // of the pictures of a knob's turns
constexpr int kMostScale = 2;

std::string escaped(const std::string& text) {
    return relief::escapedHtml(text);
}

// Larger pictures than the lesson's own, unless the filter is hundreds of times slower than the others.
int pictureScale(const relief::Scenario& scenario) {
    const auto form = scenario.filter.options.find("form");
    const bool slow = form != scenario.filter.options.end() && form->second.starts_with("position");
    return slow ? 1 : kMostScale;
}

class PageWriter {
  public:
    PageWriter(const relief::Lesson& lesson, relief::SceneCache& scenes, const LanguageSetter& installLanguage,
               relief::Work& work)
        : lesson_(lesson), scenes_(scenes), installLanguage_(installLanguage), work_(work) {}

    HtmlParts parts;

    std::string page(std::size_t number) {
        number_ = number;
        scenario_ = relief::shownScenario(lesson_, number, scenes_, work_);
        source_ = relief::lessonSource(lesson_, scenario_, scenes_, work_);
        const relief::LessonPage& page = lesson_.pages[number];
        std::string html = "<section id=\"" + page.name + "\">\n<h2>" +
                           both([](const PageText& words) { return words.title; }, true) + "</h2>\n";
        html += both([](const PageText& words) { return words.text; });
        html += pictures(page);
        if (page.question) html += question(*page.question);
        html += detailsOf("Hint", "Підказка", [](const PageText& words) { return words.hint; });
        if (page.knob) html += knob(*page.knob);
        html += detailsOf("For the lecturer", "Для викладача", [](const PageText& words) { return words.note; });
        return html + "</section>\n";
    }
    // A part of the lesson's own words, filled in on the first page.
    std::string ofLesson(std::string relief::LessonText::*part, bool line = false) {
        if ((lesson_.english.*part).empty()) return {};
        scenario_ = relief::shownScenario(lesson_, 0, scenes_, work_);
        source_ = relief::lessonSource(lesson_, scenario_, scenes_, work_);
        return inBoth(filled(lesson_.english.*part, line), filled(lesson_.ukrainian.*part, line));
    }

  private:
    std::string filled(const std::string& words, bool line) const {
        const auto value = [&](const relief::ValueSlot& slot) { return relief::filledValue(slot, source_); };
        return line ? relief::lessonLine(words, value) : relief::lessonHtml(words, value);
    }
    template <class Part>
    std::string both(const Part& part, bool line = false) const {
        const PageText &english = lesson_.english.pages[number_], &ukrainian = lesson_.ukrainian.pages[number_];
        if (line) return inBoth(filled(part(english), true), filled(part(ukrainian), true));
        return "<div class=\"en\" lang=\"en\">" + filled(part(english), false) +
               "</div>\n<div class=\"uk\" lang=\"uk\">" + filled(part(ukrainian), false) + "</div>\n";
    }
    template <class Part>
    std::string detailsOf(const char* english, const char* ukrainian, const Part& part) const {
        if (part(lesson_.english.pages[number_]).empty()) return {};
        return "<details><summary>" + inBoth(english, ukrainian) + "</summary>\n" + both(part) + "</details>\n";
    }

    std::shared_ptr<const Snapshot> snapshotOf(const relief::Scenario& scenario, bool guessing) {
        SnapshotOrder order;
        order.scenario = scenario;
        order.layer = layerNamed(lesson_.pages[number_].layer).value_or(Layer::Color);
        auto snapshot = maker_.make(order, work_);
        if (!guessing) return snapshot;
        auto hidden = withoutAnswer(*snapshot);
        hidden->trace.exact = {};  // no guess is compared with it on a page
        return hidden;
    }
    std::string result(const std::shared_ptr<const Snapshot>& snapshot, int most) {
        const int width = std::min(most, pictureScale(snapshot->scenario) * snapshot->scenario.width);
        const FigureKind kind = figureKind("result");
        const auto drawn = [&](Language language) {
            installLanguage_(language);
            FigurePage page;
            page.caption = false;
            page.style.theme = Theme::Light;
            page.style.language = language;
            return figureImage(*kind.make(snapshot, snapshot->scenario), page, width, work_);
        };
        const QImage english = drawn(Language::English);
        const auto notes = stateOf<AnnotationState>(snapshot->scenario).list;
        const bool translated = std::ranges::any_of(
            notes, [&](const Annotation& note) { return note.view == "result" && !note.ukrainian.empty(); });
        if (snapshot->layer.layer == Layer::Color && !translated) return pictureHtml(english, "picture");
        // The legend of a layer has words, and so may annotations.
        return inBoth(pictureHtml(english, lesson_.pages[number_].layer),
                      pictureHtml(drawn(Language::Ukrainian), lesson_.pages[number_].layer));
    }
    std::string pictures(const relief::LessonPage& page) {
        const bool guess = page.question && page.question->kind == LessonQuestion::Kind::Hit;
        const auto snapshot = snapshotOf(scenario_, guess);
        const bool own = !page.pane.empty() && page.pane != "result";
        std::string html;
        if (!own || !page.layer.empty() || number_ == 0)
            html += "<figure>" + result(snapshot, kPictureWidth) + "</figure>\n";
        if (own) html += stepsFigure(figureKind(page.pane), snapshot, parts, installLanguage_, work_);
        return html;
    }

    std::string question(const LessonQuestion& question) {
        std::string html = "<div class=\"question\"";
        if (question.kind == LessonQuestion::Kind::Choose) {
            html += " data-right=\"" + std::to_string(relief::rightChoice(question, source_)) + "\"";
        } else if (question.kind == LessonQuestion::Kind::Number) {
            const double number = question.number->number(source_);
            html += " data-number=\"" + relief::numberText(number) + "\" data-within=\"" +
                    relief::numberText(question.within) + "\"";
        }
        html += ">\n" + both([](const PageText& words) { return words.question; });
        for (std::size_t n = 0; n < question.choices.size(); ++n) {
            html += "<label><input type=\"radio\" name=\"q-" + lesson_.pages[number_].name + "\" value=\"" +
                    std::to_string(n) + "\"> " + both([n](const PageText& words) { return words.choices[n]; }, true) +
                    "</label>\n";
        }
        if (question.number) {
            html += "<label><input type=\"text\" inputmode=\"decimal\" size=\"8\" aria-label=\"number\"></label>\n";
        }
        html += "<details><summary>" + inBoth("Answer", "Відповідь") + "</summary>\n" +
                both([](const PageText& words) { return words.answer; });
        if (question.kind == LessonQuestion::Kind::Hit) {
            html +=
                stepsFigure(figureKind(lesson_.pages[number_].pane.empty() ? "profile" : lesson_.pages[number_].pane),
                            snapshotOf(scenario_, false), parts, installLanguage_, work_);
        }
        return html + "</details>\n</div>\n";
    }

    std::string knob(const relief::LessonKnob& knob) {
        const auto turns = relief::turnedValues(lesson_, number_, scenes_, work_);
        std::string html = "<div class=\"knob\">\n" + both([](const PageText& words) { return words.knob; });
        std::string values;
        int own = 0;
        const relief::Json& now = lesson_.pages[number_].scenario;
        const relief::Json::json_pointer place(knob.set);
        for (std::size_t turn = 0; turn < knob.values.size(); ++turn) {
            values += (turn == 0 ? "" : "\x1f") + relief::knobValueText(knob.values[turn]);
            if (now.contains(place) && now[place] == knob.values[turn]) own = static_cast<int>(turn);
        }
        html += "<div class=\"slider\"><input type=\"range\" min=\"0\" max=\"" +
                std::to_string(knob.values.size() - 1) + "\" value=\"" + std::to_string(own) + "\" aria-label=\"" +
                escaped(knob.set) + "\" data-values=\"" + escaped(values) + "\"><output></output></div>\n";
        for (std::size_t turn = 0; turn < knob.values.size(); ++turn) {
            html += "<div class=\"turn\"" +
                    std::string(static_cast<int>(turn) == own ? "" : " style=\"display:none\"") + ">" +
                    result(snapshotOf(lesson_.scenarioOf(number_, turn), false), kTurnWidth) + "</div>\n";
        }
        html += "<div class=\"wide\"><table>\n<tr><th>" + escaped(knob.set.substr(knob.set.rfind('/') + 1)) + "</th>";
        for (const relief::Json& value : knob.values) html += "<th>" + escaped(relief::knobValueText(value)) + "</th>";
        html += "</tr>\n";
        for (std::size_t n = 0; n < knob.watch.size(); ++n) {
            html += "<tr><td><code>" + escaped(knob.watch[n].value.text()) + "</code></td>";
            for (const auto& turn : turns) html += "<td>" + relief::expressionValueText(turn[n]) + "</td>";
            html += "</tr>\n";
        }
        return html + "</table></div>\n</div>\n";
    }

    const relief::Lesson& lesson_;
    relief::SceneCache& scenes_;
    const LanguageSetter& installLanguage_;
    relief::Work& work_;
    std::size_t number_ = 0;
    relief::Scenario scenario_;
    relief::QuantitySource source_;
    SnapshotMaker maker_;
};

std::string navigation(const LessonLinks& links) {
    if (links.before.empty() && links.after.empty() && links.contents.empty()) return {};
    const auto to = [](const std::string& file, const std::string& text) {
        return file.empty() ? std::string("<span></span>") : "<a href=\"" + escaped(file) + "\">" + text + "</a>";
    };
    return "<nav>" + to(links.before, "◀") + to(links.contents, inBoth("Contents", "Зміст")) + to(links.after, "▶") +
           "</nav>\n";
}

}  // namespace

std::string lessonPage(const relief::Lesson& lesson, const LessonLinks& links, relief::SceneCache& scenes,
                       const LanguageSetter& installLanguage, relief::Work& work) {
    PageWriter writer(lesson, scenes, installLanguage, work);
    std::string body = navigation(links);
    body += "<h1>" + escaped(lesson.name) + " · " + writer.ofLesson(&relief::LessonText::title, true) + "</h1>\n";
    body += "<p>" + writer.ofLesson(&relief::LessonText::about, true) + "</p>\n";
    for (std::size_t page = 0; page < lesson.pages.size(); ++page) body += writer.page(page);
    const std::string remember = writer.ofLesson(&relief::LessonText::remember, true);
    if (!remember.empty()) {
        body += "<section>\n<div class=\"remember\"><b>" + inBoth("Remember.", "Запам’ятайте.") + "</b> " + remember +
                "</div>\n";
        const std::string note = writer.ofLesson(&relief::LessonText::note, true);
        if (!note.empty()) {
            body += "<details><summary>" + inBoth("For the lecturer", "Для викладача") + "</summary><p>" + note +
                    "</p></details>\n";
        }
        body += "<p class=\"source\">" + writer.ofLesson(&relief::LessonText::source, true) + "</p>\n</section>\n";
    }
    body += navigation(links);
    return wholePage(lesson.english.title, lesson.ukrainian.title, body, writer.parts);
}

std::string contentsPage(const relief::Course& course, const std::vector<relief::Lesson>& lessons) {
    std::string body = "<h1>" + inBoth("Contents", "Зміст") + "</h1>\n";
    for (const relief::Chapter& chapter : course.chapters) {
        body += "<section>\n";
        if (!chapter.english.empty())
            body += "<h2>" + inBoth(escaped(chapter.english), escaped(chapter.ukrainian)) + "</h2>\n";
        for (const std::string& name : chapter.lessons) {
            const auto found = std::find_if(lessons.begin(), lessons.end(),
                                            [&](const relief::Lesson& one) { return one.name == name; });
            if (found == lessons.end()) continue;
            body += "<p><a href=\"" + escaped(name) + ".html\">" + escaped(name) + " · " +
                    inBoth(escaped(found->english.title), escaped(found->ukrainian.title)) + "</a></p>\n";
        }
        body += "</section>\n";
    }
    return wholePage("Relief texturing: a course", "Рельєфне текстурування: курс", body, HtmlParts());
}

std::string viewPage(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot,
                     const LanguageSetter& installLanguage, relief::Work& work) {
    HtmlParts parts;
    const std::string figure = stepsFigure(kind, snapshot, parts, installLanguage, work);
    const auto captionIn = [&](Language language) {
        installLanguage(language);
        return escaped(kind.make(snapshot, snapshot->scenario)->caption(language));
    };
    const std::string body = "<h1>" + escaped(kind.name) + "</h1>\n" + figure + "<p class=\"source\">" +
                             inBoth(captionIn(Language::English), captionIn(Language::Ukrainian)) + "</p>\n";
    return wholePage(kind.name, kind.name, body, parts);
}

}  // namespace reliefui
