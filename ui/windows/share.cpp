#include "windows/share.h"

#include <memory>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QWidget>

#include "panes/file_dialogs.h"
#include "workspace/workspace.h"

namespace reliefui {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(reliefui::Share)
};

QString askFile(QWidget* window, const QString& name) {
    return askSaveFile(window, QStringLiteral("pages"), Texts::tr("Page for browsers"), name + QStringLiteral(".html"),
                       Texts::tr("Pages (*.html)"));
}

}  // namespace

QProcess* writePage(QWidget* window, Workspace* workspace, const QStringList& what, const QString& file) {
    auto* const writer = new QProcess(window);
    const auto ended = [workspace, writer, file](bool done) {
        writer->deleteLater();
        if (done) return Q_EMIT workspace->notice(Texts::tr("Written: %1").arg(QDir::toNativeSeparators(file)));
        const QString said = QString::fromUtf8(writer->readAllStandardError()).trimmed();
        Q_EMIT workspace->problem(said.isEmpty() ? writer->errorString() : said);
    };
    QObject::connect(writer, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), workspace,
                     [ended](int status, QProcess::ExitStatus) { ended(status == 0); });
    QObject::connect(writer, &QProcess::errorOccurred, workspace, [ended](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) ended(false);
    });
    const QString program = QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("reliefscope"));
    writer->start(program, what + QStringList{QStringLiteral("--html"), QStringLiteral("-o"), file});
    return writer;
}

void askPanePage(QWidget* window, Workspace* workspace, const QString& figure) {
    const QString file = askFile(window, figure);
    if (file.isEmpty()) return;
    // The scenario lives as long as the process that reads it.
    const auto folder = std::make_shared<QTemporaryDir>();
    const QString scenario = folder->filePath(QStringLiteral("scenario.json"));
    try {
        relief::saveScenario(scenario.toStdString(), workspace->scenario());
    } catch (const relief::InputError& error) {
        return Q_EMIT workspace->problem(QString::fromStdString(error.text(workspace->style().language)));
    }
    QProcess* const writer = writePage(window, workspace, {scenario, QStringLiteral("--export"), figure}, file);
    QObject::connect(writer, &QObject::destroyed, workspace, [folder] {});
}

void askLessonPage(QWidget* window, Workspace* workspace, const QString& folder) {
    const QString file = askFile(window, QFileInfo(folder).fileName());
    if (!file.isEmpty()) writePage(window, workspace, {QStringLiteral("--lesson"), folder}, file);
}

}  // namespace reliefui
