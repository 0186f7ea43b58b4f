// The HTML manual, which the Help menu opens in the browser.
#pragma once

#include <QString>

namespace reliefui {

// Path of the manual's first page, relative to the program's folder: as installed (../share/doc/relief/html) or as
// built (../manual/html). Empty if there is none.
QString manualPage(const QString& programFolder);

}  // namespace reliefui
