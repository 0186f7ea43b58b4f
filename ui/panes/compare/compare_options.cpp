// The options of the compared choices, side by side, generated from their descriptions.
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/compare/compare_view.h"
#include "panes/core_texts.h"
#include "panes/options_form.h"
#include "workspace/change_name.h"

namespace reliefui {

namespace {

constexpr int kMostHeight = 190;  // in pixels; the rest is for the pictures

}  // namespace

QWidget* CompareView::makeOptions() {
    auto* const area = new QScrollArea(this);
    area->setObjectName(QStringLiteral("compare-options-area"));
    area->setAccessibleName(accessibleName());
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setMaximumHeight(kMostHeight);
    auto* const inner = new QWidget(area);
    auto* const row = new QHBoxLayout(inner);
    row->setContentsMargins(6, 2, 6, 4);
    for (std::size_t n = 0; n < relief::kMostCompared; ++n) {
        OptionsOf one;
        one.whole = new QWidget(inner);
        one.whole->setObjectName(QStringLiteral("compare-options-") + QChar(static_cast<char>('A' + n)));
        auto* const column = new QVBoxLayout(one.whole);
        column->setContentsMargins(0, 0, 8, 0);
        one.title = new QLabel(one.whole);
        one.form = new OptionsForm(one.whole);
        column->addWidget(one.title);
        column->addWidget(one.form);
        column->addStretch(1);
        row->addWidget(one.whole, 1);
        connect(one.form, &OptionsForm::editFinished, workspace_, &Workspace::finishInteraction);
        connect(one.form, &OptionsForm::changed, this,
                [this, n](const QString& name, const QString& text, bool live) { setOption(n, name, text, live); });
        options_.push_back(one);
    }
    area->setWidget(inner);
    area->hide();
    optionsArea_ = area;
    return area;
}

void CompareView::showOptions(bool on) {
    showOptions_->setChecked(on);
    refreshOptions();
    optionsArea_->setVisible(on);
}

void CompareView::refreshOptions() {
    if (!showOptions_->isChecked()) return;
    const relief::CompareSubject subject = workspace_->scenario().comparison.subject;
    const std::vector<relief::MethodChoice> all = relief::comparedOf(workspace_->scenario());
    for (std::size_t n = 0; n < options_.size(); ++n) {
        options_[n].whole->setVisible(n < all.size());
        if (n >= all.size()) continue;
        const relief::MethodDescription described = relief::describedVariation(subject, all[n]);
        options_[n].title->setText(QString::fromStdString(comparedName(n, subject, all[n])));
        options_[n].title->setToolTip(coreText(described.help));
        options_[n].form->show(described, all[n]);
    }
}

void CompareView::setOption(std::size_t number, const QString& name, const QString& text, bool live) {
    relief::Scenario scenario = workspace_->scenario();
    const relief::CompareSubject subject = scenario.comparison.subject;
    std::vector<relief::MethodChoice>& others = relief::othersOf(scenario.comparison);
    if (number > others.size()) return;
    relief::MethodChoice choice = number == 0 ? relief::ownVariation(scenario, subject) : others[number - 1];
    const std::string key = name.toStdString();
    const std::string value = text.toStdString();
    // Options of a nested method are replaced if another one is chosen.
    const auto before = choice.options.find(key);
    const bool same = before != choice.options.end() && before->second == value;
    if (!same) std::erase_if(choice.options, [&](const auto& option) { return option.first.starts_with(key + "."); });
    choice.options[key] = value;
    // Some pixel models need more samples.
    if (subject == relief::CompareSubject::Filters) {
        choice = relief::ownVariation(relief::varied(scenario, subject, choice), subject);
    }
    if (number == 0) {
        scenario = relief::varied(scenario, subject, choice);
    } else {
        others[number - 1] = choice;
    }
    const QChar letter(static_cast<char>('A' + number));
    workspace_->change(scenario, changeName([letter, key] { return tr("%1: %2").arg(letter).arg(optionTitle(key)); }),
                       QStringLiteral("compare-%1-%2").arg(letter).arg(name), live);
}

}  // namespace reliefui
