// Names and helps that the algorithms describe themselves with, for people: in the language of the window where it
// knows them, as they are where it does not (a method added later).
#pragma once

#include <string>

#include <QString>

namespace reliefui {

// "relief-depth": "Relief depth".
QString controlTitle(const std::string& name);
// Of a method's or filter's option, where the word means something else than elsewhere ("floor"); of an inner method's
// ("inner.layers") without what stands before its name.
QString optionTitle(const std::string& key);
// A help text or a unit.
QString coreText(const std::string& english);
// "degrees": "°"; others with a space before them.
QString unitSuffix(const std::string& unit);

}  // namespace reliefui
