#include "windows/share.h"

#include <memory>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QVariant>
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

// A process that is ended with the workspace: asked to first, so that it removes its temporary files.
class Writer : public QProcess {
  public:
    // folder: with the scenario that the process reads, which has to live as long; may be null.
    Writer(Workspace* workspace, std::unique_ptr<QTemporaryDir> folder)
        : QProcess(workspace), folder_(std::move(folder)) {}
    ~Writer() override {
        if (state() == NotRunning) return;
        terminate();
        constexpr int kPatienceMs = 1000;
        if (!waitForFinished(kPatienceMs)) kill();
        waitForFinished(kPatienceMs);
    }

  private:
    std::unique_ptr<QTemporaryDir> folder_;
};

QProcess* start(Workspace* workspace, const QStringList& what, const QString& file,
                std::unique_ptr<QTemporaryDir> folder = nullptr) {
    // Not of the window, which is replaced by another when the language changes.
    auto* const writer = new Writer(workspace, std::move(folder));
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

}  // namespace

QProcess* startWriting(Workspace* workspace, const QStringList& what, const QString& file) {
    return start(workspace, what, file);
}

bool cancelWriting(Workspace* workspace) {
    const auto writers = workspace->findChildren<QProcess*>(QString(), Qt::FindDirectChildrenOnly);
    for (QProcess* const writer : writers) {
        writer->setProperty(kCancelled, true);
        writer->terminate();
    }
    return !writers.isEmpty();
}

void writePane(Workspace* workspace, const QString& figure, const QStringList& how, const QString& file) {
    auto folder = std::make_unique<QTemporaryDir>();
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
    start(workspace, what + how, file, std::move(folder));
}

QString askPageFile(QWidget* window, const QString& name) {
    return askSaveFile(window, QStringLiteral("pages"), Texts::tr("Page for browsers"), name + QStringLiteral(".html"),
                       Texts::tr("Pages (*.html)"));
}

void askPanePage(QWidget* window, Workspace* workspace, const QString& figure) {
    const QString file = askPageFile(window, figure);
    if (!file.isEmpty()) writePane(workspace, figure, {QStringLiteral("--html")}, file);
}

void askLessonPage(QWidget* window, Workspace* workspace, const QString& folder) {
    const QString file = askPageFile(window, QFileInfo(folder).fileName());
    const QStringList what{QStringLiteral("--lesson"), folder, QStringLiteral("--html")};
    if (!file.isEmpty()) startWriting(workspace, what, file);
}

}  // namespace reliefui
