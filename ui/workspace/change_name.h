// Names of changes in the undo menu. The history survives a change of language, so each name is stored with the
// function that translates it, which is called again when the name is shown.
#pragma once

#include <functional>

#include <QString>

namespace reliefui {

// Returns the name in the current language and registers the function. `said` must capture only values, no part of a
// window. Window's thread only.
QString changeName(std::function<QString()> translate);
// Translates a name returned by changeName() into the current language; returns any other text unchanged.
QString translatedChangeName(const QString& name);

}  // namespace reliefui
