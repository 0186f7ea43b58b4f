// The manual in HTML, which Help opens in the browser.
#pragma once

#include <QString>

namespace reliefui {

// The first page of the manual that belongs to the program in that folder: as installed (../share/doc/relief/html) or
// as built (../manual/html). Empty if there is none.
QString manualPage(const QString& programFolder);

}  // namespace reliefui
