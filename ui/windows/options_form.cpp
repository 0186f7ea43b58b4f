#include "windows/options_form.h"

#include <charconv>

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "windows/core_texts.h"
#include "windows/number_control.h"

namespace reliefui {

namespace {

bool isNumber(const relief::OptionDescription& option) {
    return option.kind == relief::OptionKind::Integer || option.kind == relief::OptionKind::Real;
}

}  // namespace

OptionsForm::OptionsForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
    form_->setContentsMargins(0, 0, 0, 0);
}

void OptionsForm::show(const relief::MethodDescription& method, const relief::MethodChoice& choice) {
    if (shown_ != method.name) rebuild(method);
    for (const relief::OptionDescription& option : method.options) {
        const auto given = choice.options.find(option.name);
        const auto preset = method.defaults.find(option.name);
        if (given != choice.options.end()) {
            setText(option, given->second);
        } else if (preset != method.defaults.end()) {
            setText(option, preset->second);
        }
    }
}

void OptionsForm::rebuild(const relief::MethodDescription& method) {
    while (form_->rowCount() > 0) form_->removeRow(0);
    for (const relief::OptionDescription& option : method.options) addControl(option);
    if (method.options.empty()) {
        auto* const none = new QLabel(tr("This method has no options."), this);
        none->setEnabled(false);
        form_->addRow(none);
    }
    shown_ = method.name;
}

void OptionsForm::addControl(const relief::OptionDescription& option) {
    const QString name = QString::fromStdString(option.name);
    if (isNumber(option)) {
        auto* const number = new NumberControl(option, this);
        form_->addRow(controlTitle(option.name), number);
        connect(number, &NumberControl::settled, this, &OptionsForm::settled);
        connect(number, &NumberControl::changed, this, [this, name](double value, bool live) {
            Q_EMIT changed(name, QString::fromStdString(relief::numberText(value)), live);
        });
        return;
    }
    auto* const choices = new QComboBox(this);
    choices->setObjectName(name);
    choices->setAccessibleName(controlTitle(option.name));
    choices->setToolTip(optionToolTip(option));
    for (const std::string& text : option.choices) choices->addItem(QString::fromStdString(text));
    form_->addRow(controlTitle(option.name), choices);
    connect(choices, qOverload<int>(&QComboBox::activated), this,
            [this, name, choices](int) { Q_EMIT changed(name, choices->currentText(), false); });
}

void OptionsForm::setText(const relief::OptionDescription& option, const std::string& text) {
    const QString name = QString::fromStdString(option.name);
    if (isNumber(option)) {
        double value = 0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        if (auto* const number = findChild<NumberControl*>(name)) number->setValue(value);
    } else if (auto* const choices = findChild<QComboBox*>(name)) {
        choices->setCurrentText(QString::fromStdString(text));
    }
}

}  // namespace reliefui
