// Names and help texts from the algorithms' descriptions, translated if the window has a translation, otherwise
// unchanged (methods added later).
#pragma once

#include <string>

#include <QString>

namespace reliefui {

// Title of a control: "relief-depth" gives "Relief depth".
QString controlTitle(const std::string& name);
// Title of an option of a method or filter, with a translation of its own where the word has a special meaning
// ("floor"). Prefixes of inner methods ("inner.layers") are removed.
QString optionTitle(const std::string& key);
// Translates a help text or a unit.
QString coreText(const std::string& english);
// Translates the title of a method, filter or relief, with a capital letter; as a title, a word may be another than as
// a unit ("layers").
QString titleText(const std::string& title);
// Unit as a suffix: "degrees" gives "°"; other units are preceded by a space.
QString unitSuffix(const std::string& unit);

}  // namespace reliefui
