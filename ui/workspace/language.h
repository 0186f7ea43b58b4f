// Language of the window, from the locale or chosen by the user. It applies to the message catalogue; Qt's own texts
// are translated with tr().
#pragma once

#include <QLocale>

#include "relief/messages.h"

namespace reliefui {

inline relief::Language uiLanguage() {
    return QLocale().language() == QLocale::Ukrainian ? relief::Language::Ukrainian : relief::Language::English;
}

// The language chosen in the window, as Qt names it ("uk"); empty: the system's.
QString chosenLanguage();

}  // namespace reliefui
