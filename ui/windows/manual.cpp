#include "windows/manual.h"

#include <QDir>
#include <QFileInfo>

namespace reliefui {

QString manualPage(const QString& programFolder) {
    const QDir folder(programFolder);
    for (const char* const place : {"../share/doc/relief/html/index.html", "../manual/html/index.html"}) {
        const QFileInfo page(QDir::cleanPath(folder.filePath(QLatin1String(place))));
        if (page.isFile()) return page.filePath();
    }
    return {};
}

}  // namespace reliefui
