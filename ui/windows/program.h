// Set-up shared by the program and the window tests, needed before a window can be created.
#pragma once

#include <QApplication>
#include <QString>

namespace reliefui {

class MainWindow;
class Workspace;

// Call before creating the QApplication: sets VTK's surface format and avoids Qt's warnings on standard error.
void prepareWindows();
// The same for programs that only draw figures; needs no display.
void prepareFigures();
// Call after creating it: sets translation (the locale's language), fonts and colours. Numbers keep the C locale.
void setUpApplication(QApplication& application);
// Language of windows created from now on, as Qt names it ("uk"); empty: the system's.
void installTranslations(const QString& language);

// Grabs the window, including OpenGL panes, when its first full picture is shown, and ends the application with exit
// status 0, or 1 if the file cannot be written.
void screenshotThenQuit(MainWindow& window, Workspace& workspace, const QString& path);

}  // namespace reliefui
