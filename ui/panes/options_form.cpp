#include "panes/options_form.h"

#include <algorithm>
#include <charconv>

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPointer>
#include <QSignalBlocker>

#include "panes/core_texts.h"
#include "panes/number_control.h"
#include "relief/tracers.h"

namespace reliefui {

namespace {

bool isNumber(const relief::OptionDescription& option) {
    return option.kind == relief::OptionKind::Integer || option.kind == relief::OptionKind::Real;
}

}  // namespace

OptionsForm::OptionsForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
    form_->setContentsMargins(0, 0, 0, 0);
}

void OptionsForm::collect(const relief::MethodDescription& method, const relief::OptionValues& values,
                          const std::string& prefix, int depth, std::vector<Control>& out) {
    constexpr int kDeepest = 3;
    for (const relief::OptionDescription& option : method.options) {
        const auto preset = method.defaults.find(option.name);
        Control control{prefix + option.name, option, preset == method.defaults.end() ? "" : preset->second, depth};
        out.push_back(control);
        if (option.kind != relief::OptionKind::Method || depth >= kDeepest) continue;
        const auto given = values.find(control.key);
        const std::string& inner = given == values.end() ? control.preset : given->second;
        const bool known = std::find(option.choices.begin(), option.choices.end(), inner) != option.choices.end();
        if (known) collect(relief::findTracer(inner), values, control.key + ".", depth + 1, out);
    }
}

void OptionsForm::show(const relief::MethodDescription& method, const relief::MethodChoice& choice) {
    std::vector<Control> controls;
    collect(method, choice.options, {}, 0, controls);
    std::string shape = method.name;
    for (const Control& control : controls) shape += ' ' + control.key;
    if (shown_ != shape) {
        rebuild(controls);
        shown_ = shape;
    }
    for (const Control& control : controls) {
        const auto given = choice.options.find(control.key);
        setText(control, given != choice.options.end() ? given->second : control.preset);
    }
}

void OptionsForm::rebuild(const std::vector<Control>& controls) {
    while (form_->rowCount() > 0) form_->removeRow(0);
    for (const Control& control : controls) addControl(control);
    if (!controls.empty()) return;
    auto* const none = new QLabel(tr("This method has no options."), this);
    none->setEnabled(false);
    form_->addRow(none);
}

void OptionsForm::addControl(const Control& control) {
    const QString name = QString::fromStdString(control.key);
    const QString indent(3 * control.depth, QChar(0x00a0));
    auto* const label = new QLabel(indent + optionTitle(control.option.name), this);
    label->setToolTip(optionToolTip(control.option));
    if (isNumber(control.option)) {
        auto* const number = new NumberControl(control.option, this);
        number->setObjectName(name);
        label->setBuddy(number);
        form_->addRow(label, number);
        addWords(control, number);
        connect(number, &NumberControl::editFinished, this, &OptionsForm::editFinished);
        connect(number, &NumberControl::changed, this, [this, name](double value, bool live) {
            Q_EMIT changed(name, QString::fromStdString(relief::numberText(value)), live);
        });
        return;
    }
    auto* const choices = new QComboBox(this);
    choices->setObjectName(name);
    choices->setAccessibleName(optionTitle(control.option.name));
    choices->setToolTip(optionToolTip(control.option));
    for (const std::string& text : control.option.choices) choices->addItem(QString::fromStdString(text));
    label->setBuddy(choices);
    form_->addRow(label, choices);
    // Queued, because choosing another nested method recreates the controls while this one is still emitting its
    // signal. Until then the controls may have been recreated for another reason. QComboBox::activated is also
    // emitted for the current entry; it is ignored, because a change would reset the nested method's options.
    connect(
        choices, qOverload<int>(&QComboBox::activated), this,
        [this, name, box = QPointer<QComboBox>(choices)](int) {
            if (box && box->currentText() != choices_[name]) Q_EMIT changed(name, box->currentText(), false);
        },
        Qt::QueuedConnection);
}

// Adds a check box for each word that may replace the number; if none is checked, the number applies.
void OptionsForm::addWords(const Control& control, NumberControl* number) {
    const QString name = QString::fromStdString(control.key);
    for (const std::string& word : control.option.choices) {
        const QString text = QString::fromStdString(word);
        auto* const box = new QCheckBox(text, this);
        box->setObjectName(name + '=' + text);
        box->setToolTip(optionToolTip(control.option));
        box->setAccessibleName(optionTitle(control.option.name) + QStringLiteral(": ") + text);
        form_->addRow(QString(), box);
        connect(box, &QCheckBox::clicked, this, [this, name, number, text](bool on) {
            const QString value = QString::fromStdString(relief::numberText(number->value()));
            Q_EMIT changed(name, on ? text : value, false);
        });
    }
}

void OptionsForm::setText(const Control& control, const std::string& text) {
    const QString name = QString::fromStdString(control.key);
    if (isNumber(control.option)) {
        double value = 0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        auto* const number = findChild<NumberControl*>(name);
        if (number == nullptr) return;
        const auto& words = control.option.choices;
        const bool word = std::find(words.begin(), words.end(), text) != words.end();
        for (const std::string& one : words) {
            auto* const box = findChild<QCheckBox*>(name + '=' + QString::fromStdString(one));
            if (box == nullptr) continue;
            const QSignalBlocker quiet(box);
            box->setChecked(one == text);
        }
        number->setEnabled(!word);
        if (!word) number->setValue(value);
    } else if (auto* const choices = findChild<QComboBox*>(name)) {
        choices->setCurrentText(QString::fromStdString(text));
        choices_[name] = choices->currentText();
    }
}

}  // namespace reliefui
