#include "panes/core_texts.h"

#include <QCoreApplication>

namespace reliefui {

QString coreText(const std::string& english) {
    return QCoreApplication::translate("core", english.c_str());
}

namespace {

std::string capitalised(const std::string& name) {
    std::string title = name;
    for (char& c : title) {
        if (c == '-' || c == '_') c = ' ';
    }
    if (!title.empty() && title.front() >= 'a' && title.front() <= 'z') title.front() -= 'a' - 'A';
    return title;
}

}  // namespace

QString controlTitle(const std::string& name) {
    return coreText(capitalised(name));
}

QString titleText(const std::string& title) {
    // Without a translation as a title, the general translation of the word is used.
    QString text = QCoreApplication::translate("core", title.c_str(), "title");
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

QString optionTitle(const std::string& key) {
    const std::string name = key.substr(key.rfind('.') + 1);
    // Without a translation as an option, the general translation of the word is used.
    return QCoreApplication::translate("core", capitalised(name).c_str(), "option");
}

QString unitSuffix(const std::string& unit) {
    if (unit.empty()) return {};
    if (unit == "degrees") return QStringLiteral("°");
    if (unit == "pixels") return coreText(" px");
    return {};  // shown in the tool tip only, because it would make the box as wide as the panel
}

}  // namespace reliefui
