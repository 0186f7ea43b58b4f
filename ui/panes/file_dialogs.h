// File dialogs that open in the folder of the last file of the same kind, also across sessions.
#pragma once

#include <QString>

class QWidget;

namespace reliefui {

// kind: what is opened, used as a key of the settings ("pictures"). folder: where the first such dialog opens. Returns
// an empty string if the user cancelled.
QString askOpenFile(QWidget* parent, const QString& kind, const QString& title, const QString& filter,
                    const QString& folder = {});
// name: proposed file name. Its extension is appended to a name typed without one; the user is asked before a file is
// replaced.
QString askSaveFile(QWidget* parent, const QString& kind, const QString& title, const QString& name,
                    const QString& filter);
// Last folder used for a kind; `otherwise` if there is none or it no longer exists.
QString lastFolder(const QString& kind, const QString& otherwise = {});
void keepFolder(const QString& kind, const QString& file);

}  // namespace reliefui
