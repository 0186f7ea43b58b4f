// Pages for browsers, from the window: another process of this program writes them, because their texts are in both
// languages and the window's in one.
#pragma once

#include <QString>
#include <QStringList>

class QProcess;
class QWidget;

namespace reliefui {

class Workspace;

// Starts `reliefscope WHAT --html -o FILE`, and reports its end through the workspace. The process deletes itself then.
QProcess* writePage(QWidget* window, Workspace* workspace, const QStringList& what, const QString& file);
// Asks for a file, and writes the pane's figure of the open scenario, with a slider over the steps.
void askPanePage(QWidget* window, Workspace* workspace, const QString& figure);
// Asks for a file, and writes the lesson in this folder.
void askLessonPage(QWidget* window, Workspace* workspace, const QString& folder);

}  // namespace reliefui
