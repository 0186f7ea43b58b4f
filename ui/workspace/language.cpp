#include "workspace/language.h"

#include <QSettings>

namespace reliefui {

QString chosenLanguage() {
    return QSettings().value(QStringLiteral("language")).toString();
}

}  // namespace reliefui
