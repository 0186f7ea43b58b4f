#include "measuring/lesson/lesson_check.h"

#include <cmath>

namespace relief {

namespace {

class Check {
  public:
    Check(const Lesson& lesson, SceneCache& scenes, Work& work) : lesson_(lesson), scenes_(scenes), work_(work) {}

    void page(std::size_t number) {
        page_ = &lesson_.pages[number];
        guarded([&] {
            const Scenario scenario = shownScenario(lesson_, number, scenes_, work_);
            const QuantitySource source = lessonSource(lesson_, scenario, scenes_, work_);
            for (const Expression& claim : page_->claims) guarded([&] { claimed(claim, source); });
            if (page_->question) guarded([&] { asked(*page_->question, source); });
            if (page_->knob) guarded([&] { turned(number); });
            for (const LessonText* text : {&lesson_.english, &lesson_.ukrainian}) words(text->pages[number], source);
        });
    }
    // The words that belong to no page are filled in on the first one.
    void lessonWords() {
        page_ = &lesson_.pages.front();
        guarded([&] {
            const QuantitySource source =
                lessonSource(lesson_, shownScenario(lesson_, 0, scenes_, work_), scenes_, work_);
            for (const LessonText* text : {&lesson_.english, &lesson_.ukrainian}) {
                for (const auto* part : {&text->about, &text->remember, &text->note, &text->source})
                    filled(*part, source);
            }
        });
    }
    LessonReport report;

  private:
    void fault(const Message& why) { report.faults.push_back({page_->name, why}); }
    template <class Body>
    void guarded(const Body& body) {
        try {
            body();
        } catch (const InputError& error) {
            fault(error.subject().empty()
                      ? error.message()
                      : Message(MessageId::SubjectSays, {{"subject", error.subject()}, {"why", error.message()}}));
        }
    }
    void claimed(const Expression& claim, const QuantitySource& source) {
        ++report.claims;
        if (!claim.holds(source)) fault(Message(MessageId::LessonClaimFails, {{"claim", claim.explained(source)}}));
    }
    void asked(const LessonQuestion& question, const QuantitySource& source) {
        ++report.claims;
        switch (question.kind) {
            case LessonQuestion::Kind::Choose:
                rightChoice(question, source);
                break;
            case LessonQuestion::Kind::Number: {
                const double number = question.number->number(source);
                if (!std::isfinite(number)) {
                    fault(Message(MessageId::LessonNoNumber, {{"value", expressionValueText(number)}}));
                }
                break;
            }
            case LessonQuestion::Kind::Hit:
                if (source({"exact.outcome", {}, {}}) != ExpressionValue(std::string("hit")))
                    fault(Message(MessageId::LessonNoHit));
                break;
        }
    }
    void turned(std::size_t number) {
        const auto values = turnedValues(lesson_, number, scenes_, work_);
        for (std::size_t watched = 0; watched < page_->knob->watch.size(); ++watched) {
            const auto& watch = page_->knob->watch[watched];
            if (watch.trend == Trend::None) continue;
            ++report.claims;
            for (std::size_t turn = 1; turn < values.size(); ++turn) {
                const double before = values[turn - 1][watched], after = values[turn][watched];
                const bool holds = watch.trend == Trend::Falls   ? after < before
                                   : watch.trend == Trend::Rises ? after > before
                                                                 : after == before;
                if (holds) continue;
                fault(Message(MessageId::LessonTrendFails, {{"value", watch.value.text()},
                                                            {"before", expressionValueText(before)},
                                                            {"after", expressionValueText(after)},
                                                            {"turn", page_->knob->values[turn].dump()}}));
            }
        }
    }
    void filled(const std::string& words, const QuantitySource& source) {
        for (const ValueSlot& slot : valueSlots(words)) {
            guarded([&] {
                ++report.values;
                if (filledValue(slot, source) == expressionValueText(std::nan(""))) {
                    fault(Message(MessageId::LessonNoNumber, {{"value", slot.expression}}));
                }
            });
        }
    }
    void words(const PageText& page, const QuantitySource& source) {
        for (const auto* part :
             {&page.text, &page.question, &page.hint, &page.answer, &page.knob, &page.note, &page.title}) {
            filled(*part, source);
        }
        for (const std::string& choice : page.choices) filled(choice, source);
    }

    const Lesson& lesson_;
    SceneCache& scenes_;
    Work& work_;
    const LessonPage* page_ = nullptr;
};

}  // namespace

Scenario shownScenario(const Lesson& lesson, std::size_t page, SceneCache& scenes, Work& work) {
    Scenario scenario = lesson.scenarioOf(page);
    const auto& rule = lesson.pages[page].step;
    if (!rule) return scenario;
    const LoggedRay& ray = scenes.scene(scenario).ray(work);
    const bool departs = ray.judgement.kind != Departure::None;
    const auto step =
        stepOf(*rule, ray.steps, departs ? std::optional(ray.judgement.step) : std::nullopt, ray.judgement.overshoot);
    if (!step) throw InputError("", Message(MessageId::LessonNoStep));
    scenario.step = *step;
    return scenario;
}

std::string filledValue(const ValueSlot& slot, const QuantitySource& source) {
    return expressionValueText(Expression(slot.expression).value(source), slot.format);
}

std::size_t rightChoice(const LessonQuestion& question, const QuantitySource& source) {
    std::vector<std::size_t> right;
    std::string explained;
    for (std::size_t n = 0; n < question.choices.size(); ++n) {
        if (question.choices[n].holds(source)) right.push_back(n);
        explained += (n == 0 ? "" : "; ") + question.choices[n].explained(source);
    }
    if (right.size() != 1) {
        throw InputError("", Message(MessageId::LessonChoicesFail, {{"count", right.size()}, {"choices", explained}}));
    }
    return right.front();
}

std::vector<std::vector<double>> turnedValues(const Lesson& lesson, std::size_t page, SceneCache& scenes, Work& work) {
    const LessonKnob& knob = *lesson.pages[page].knob;
    std::vector<std::vector<double>> turns;
    for (std::size_t turn = 0; turn < knob.values.size(); ++turn) {
        const QuantitySource source = lessonSource(lesson, lesson.scenarioOf(page, turn), scenes, work);
        std::vector<double> values;
        for (const auto& watch : knob.watch) {
            const double value = watch.value.number(source);
            if (std::isnan(value)) {
                throw InputError(watch.value.text(),
                                 Message(MessageId::LessonNoNumber, {{"value", expressionValueText(value)}}));
            }
            values.push_back(value);
        }
        turns.push_back(std::move(values));
    }
    return turns;
}

LessonReport checkLesson(const Lesson& lesson, SceneCache& scenes, Work& work) {
    Check check(lesson, scenes, work);
    check.lessonWords();
    for (std::size_t page = 0; page < lesson.pages.size(); ++page) check.page(page);
    return std::move(check.report);
}

std::string reportText(const Lesson& lesson, const LessonReport& report, Language language) {
    const Message line(report.holds() ? MessageId::LessonHolds : MessageId::LessonFails,
                       {{"lesson", lesson.name},
                        {"pages", lesson.pages.size()},
                        {"claims", report.claims},
                        {"values", report.values},
                        {"faults", report.faults.size()}});
    std::string out = sentence(line, language) + "\n";
    for (const LessonFault& fault : report.faults) {
        out += "    " +
               sentence(Message(MessageId::LessonFaultLine, {{"page", fault.page}, {"why", fault.why}}), language) +
               "\n";
    }
    return out;
}

}  // namespace relief
