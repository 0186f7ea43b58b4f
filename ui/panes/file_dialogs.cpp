#include "panes/file_dialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>

namespace reliefui {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(reliefui::FileDialogs)
};

QString folderKey(const QString& kind) {
    return QStringLiteral("folders/") + kind;
}

bool mayReplace(QWidget* parent, const QString& title, const QString& file) {
    const QString question = Texts::tr("%1 already exists. Replace it?").arg(QDir::toNativeSeparators(file));
    return QMessageBox::question(parent, title, question, QMessageBox::Yes | QMessageBox::No, QMessageBox::No) ==
           QMessageBox::Yes;
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
    const QString ending = QFileInfo(name).suffix();
    QString file = QDir(lastFolder(kind)).filePath(name);
    for (;;) {
        file = QFileDialog::getSaveFileName(parent, title, file, filter);
        keepFolder(kind, file);
        if (file.isEmpty() || ending.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
        file += QLatin1Char('.') + ending;
        // The dialog has asked about the name without the ending.
        if (!QFileInfo::exists(file) || mayReplace(parent, title, file)) return file;
    }
}

}  // namespace reliefui
