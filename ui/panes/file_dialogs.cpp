#include "panes/file_dialogs.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

namespace reliefui {

namespace {

QString folderKey(const QString& kind) {
    return QStringLiteral("folders/") + kind;
}

}  // namespace

QString lastFolder(const QString& kind, const QString& otherwise) {
    const QString folder = QSettings().value(folderKey(kind)).toString();
    return !folder.isEmpty() && QFileInfo(folder).isDir() ? folder : otherwise;
}

void keepFolder(const QString& kind, const QString& file) {
    if (!file.isEmpty()) QSettings().setValue(folderKey(kind), QFileInfo(file).absolutePath());
}

QString askOpenFile(QWidget* parent, const QString& kind, const QString& title, const QString& filter,
                    const QString& folder) {
    const QString file = QFileDialog::getOpenFileName(parent, title, lastFolder(kind, folder), filter);
    keepFolder(kind, file);
    return file;
}

QString askSaveFile(QWidget* parent, const QString& kind, const QString& title, const QString& name,
                    const QString& filter) {
    const QString file = QFileDialog::getSaveFileName(parent, title, QDir(lastFolder(kind)).filePath(name), filter);
    keepFolder(kind, file);
    return file;
}

}  // namespace reliefui
