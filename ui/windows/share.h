// Pages for browsers and moving pictures, from the window: another process of this program writes them, because the
// texts of pages are in both languages and the window's in one, and because it may take long.
#pragma once

#include <QString>
#include <QStringList>

class QProcess;
class QWidget;

namespace reliefui {

class Workspace;

// Starts `reliefscope WHAT -o FILE`, and reports its end through the workspace. The process deletes itself then. It
// belongs to the workspace: it goes on while a window is replaced by another, and is ended with the workspace.
QProcess* startWriting(Workspace* workspace, const QStringList& what, const QString& file);
// Ends all such processes of the workspace. Returns whether there were any.
bool cancelWriting(Workspace* workspace);
// Writes the pane's figure of the open scenario; how: further arguments.
void writePane(Workspace* workspace, const QString& figure, const QStringList& how, const QString& file);
// Asks for the file of a page; empty if the user cancelled. name: proposed, without ending.
QString askPageFile(QWidget* window, const QString& name);
// Asks for a file, and writes the pane's figure of the open scenario, with a slider over the steps.
void askPanePage(QWidget* window, Workspace* workspace, const QString& figure);
// Asks for a file, and writes the lesson in this folder.
void askLessonPage(QWidget* window, Workspace* workspace, const QString& folder);

}  // namespace reliefui
