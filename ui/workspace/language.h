// The language of the window, chosen by the locale: of the catalogue's sentences; Qt's own texts go through tr().
#pragma once

#include <QLocale>

#include "relief/messages.h"

namespace reliefui {

inline relief::Language uiLanguage() {
    return QLocale().language() == QLocale::Ukrainian ? relief::Language::Ukrainian : relief::Language::English;
}

}  // namespace reliefui
