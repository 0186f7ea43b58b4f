// Dialogs for files that open in the folder in which the last file of that kind was chosen, also in another session.
#pragma once

#include <QString>

class QWidget;

namespace reliefui {

// kind: what is opened, as a word of the settings ("pictures"). folder: where the first such dialog opens. Empty:
// nothing was chosen.
QString askOpenFile(QWidget* parent, const QString& kind, const QString& title, const QString& filter,
                    const QString& folder = {});
// name: the file name that is offered.
QString askSaveFile(QWidget* parent, const QString& kind, const QString& title, const QString& name,
                    const QString& filter);
// The folder of a kind; `otherwise` where no file of it was chosen or the folder is gone.
QString lastFolder(const QString& kind, const QString& otherwise = {});
void keepFolder(const QString& kind, const QString& file);

}  // namespace reliefui
