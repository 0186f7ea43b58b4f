// The language of the window, that of the locale or one that was chosen: of the catalogue's sentences; Qt's own texts
// go through tr().
#pragma once

#include <QLocale>

#include "relief/messages.h"

namespace reliefui {

inline relief::Language uiLanguage() {
    return QLocale().language() == QLocale::Ukrainian ? relief::Language::Ukrainian : relief::Language::English;
}

// As it was chosen in the window, as Qt names it ("uk"); empty: the system's.
QString chosenLanguage();

}  // namespace reliefui
