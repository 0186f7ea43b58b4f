// What a change is called in the menu of undo. The history outlives a change of language: a name is kept with the
// function that says it, and said again when it is shown.
#pragma once

#include <functional>

#include <QString>

namespace reliefui {

// The name in the language of now. said: holds values alone, nothing of a window. For the window's thread.
QString changeName(std::function<QString()> said);
// A name that changeName() gave, in the language of now; any other text as it is.
QString saidAgain(const QString& name);

}  // namespace reliefui
