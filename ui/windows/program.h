// What the program and the window tests set up in the same way before a window can be made.
#pragma once

#include <QApplication>
#include <QString>

namespace reliefui {

class MainWindow;
class Workspace;

// Before the QApplication: the surfaces of VTK, and what Qt would complain about on the standard error.
void prepareWindows();
// The same where only figures are drawn: no display is asked for.
void prepareFigures();
// After it: texts in the language of the locale, type, colours; numbers stay those of the C locale.
void dressApplication(QApplication& application);
// Texts of windows that are made from now on: in that language, as Qt names it ("uk"); empty: that of the system.
void speak(const QString& language);

// Grabs the window, OpenGL panes included, when its first full picture is there, and ends the application: exit status
// 0, or 1 if the file cannot be written.
void screenshotThenQuit(MainWindow& window, Workspace& workspace, const QString& path);

}  // namespace reliefui
