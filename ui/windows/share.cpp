#include "windows/share.h"

#include <memory>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QWidget>

#include "panes/file_dialogs.h"
#include "workspace/layer_names.h"
#include "workspace/workspace.h"

namespace reliefui {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(reliefui::Share)
};

constexpr const char* kCancelled = "cancelled";  // property of a process

}  // namespace

QProcess* startWriting(QWidget* window, Workspace* workspace, const QStringList& what, const QString& file) {
    auto* const writer = new QProcess(window);
    const auto ended = [workspace, writer, file](bool done) {
        writer->deleteLater();
        const QString shown = QDir::toNativeSeparators(file);
        if (writer->property(kCancelled).toBool())
            return Q_EMIT workspace->notice(Texts::tr("Cancelled: %1 was not written.").arg(shown));
        if (done) return Q_EMIT workspace->notice(Texts::tr("Written: %1").arg(shown));
        const QString said = QString::fromUtf8(writer->readAllStandardError()).trimmed();
        Q_EMIT workspace->problem(said.isEmpty() ? writer->errorString() : said);
    };
    QObject::connect(
        writer, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), workspace,
        [ended](int status, QProcess::ExitStatus how) { ended(status == 0 && how == QProcess::NormalExit); });
    QObject::connect(writer, &QProcess::errorOccurred, workspace, [ended](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) ended(false);
    });
    const QString program = QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("reliefscope"));
    writer->start(program, what + QStringList{QStringLiteral("-o"), file});
    return writer;
}

bool cancelWriting(QWidget* window) {
    const auto writers = window->findChildren<QProcess*>(QString(), Qt::FindDirectChildrenOnly);
    for (QProcess* const writer : writers) {
        writer->setProperty(kCancelled, true);
        writer->terminate();
    }
    return !writers.isEmpty();
}

void writePane(QWidget* window, Workspace* workspace, const QString& figure, const QStringList& how,
               const QString& file) {
    // The scenario lives as long as the process that reads it.
    const auto folder = std::make_shared<QTemporaryDir>();
    const QString scenario = folder->filePath(QStringLiteral("scenario.json"));
    try {
        relief::saveScenario(scenario.toStdString(), workspace->scenario());
    } catch (const relief::InputError& error) {
        return Q_EMIT workspace->problem(QString::fromStdString(error.text(workspace->style().language)));
    }
    QStringList what{scenario, QStringLiteral("--export"), figure};
    if (figure == QLatin1String("result"))
        what << QStringLiteral("--layer")
             << QString::fromStdString(std::string(kLayerNames[static_cast<std::size_t>(workspace->layer())]));
    QProcess* const writer = startWriting(window, workspace, what + how, file);
    QObject::connect(writer, &QObject::destroyed, workspace, [folder] {});
}

QString askPageFile(QWidget* window, const QString& name) {
    return askSaveFile(window, QStringLiteral("pages"), Texts::tr("Page for browsers"), name + QStringLiteral(".html"),
                       Texts::tr("Pages (*.html)"));
}

void askPanePage(QWidget* window, Workspace* workspace, const QString& figure) {
    const QString file = askPageFile(window, figure);
    if (!file.isEmpty()) writePane(window, workspace, figure, {QStringLiteral("--html")}, file);
}

void askLessonPage(QWidget* window, Workspace* workspace, const QString& folder) {
    const QString file = askPageFile(window, QFileInfo(folder).fileName());
    const QStringList what{QStringLiteral("--lesson"), folder, QStringLiteral("--html")};
    if (!file.isEmpty()) startWriting(window, workspace, what, file);
}

}  // namespace reliefui
