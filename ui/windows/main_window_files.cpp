#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QImageWriter>
#include <QMenu>
#include <QMimeData>
#include <QSaveFile>
#include <QSettings>
#include <QStatusBar>
#include <QUrl>

#include "panes/figure_export.h"
#include "panes/figure_view.h"
#include "panes/file_dialogs.h"
#include "panes/result/result_painting.h"
#include "windows/main_window.h"
#include "windows/manual.h"
#include "windows/pane_list.h"
#include "windows/pictures_box.h"
#include "windows/status_line.h"
#include "workspace/background_call.h"
#include "workspace/change_name.h"
#include "workspace/language.h"
#include "workspace/start_scenario.h"

namespace reliefui {

namespace {

constexpr int kMostRecent = 10;

QString recentKey() {
    return QStringLiteral("recentFiles");
}

QStringList droppedFiles(const QMimeData* data) {
    QStringList files;
    for (const QUrl& url : data->urls()) {
        if (url.isLocalFile()) files << url.toLocalFile();
    }
    return files;
}

// Explains an export failure. Errors that name command line options are expressed in the window's terms.
QString whyNoFigure(const relief::InputError& error) {
    using relief::MessageId;
    if (dynamic_cast<const EmptyFigure*>(&error) != nullptr) {
        switch (error.message().id) {
            case MessageId::ExportNoPixel:
                return MainWindow::tr("Nothing to export: no pixel is chosen. Click one in the result.");
            case MessageId::ExportNoRelief:
                return MainWindow::tr("Nothing to export: the chosen pixel shows no relief. Click on the relief.");
            case MessageId::ExportNoHit:
                return MainWindow::tr(
                    "Nothing to export: the ray of the chosen pixel meets no relief. Click another pixel.");
            case MessageId::ExportNoMethods:
            case MessageId::ExportNoOthers:
                return MainWindow::tr("Nothing to export: there is only one picture. Press + in the compare pane.");
            default:
                return QString::fromStdString(relief::sentence(error.message(), uiLanguage()));
        }
    }
    return QString::fromStdString(error.text(uiLanguage()));
}

}  // namespace

void MainWindow::askOpen() {
    const QString filter = tr("Height maps and scenarios") +
                           QStringLiteral(" (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.bmp *.tga *.pgm *.json);;") +
                           tr("All files") + QStringLiteral(" (*)");
    const QString path =
        askOpenFile(this, QStringLiteral("heights"), tr("Open a height map or a scenario"), filter, datasets_);
    if (!path.isEmpty()) workspace_->open(path);
}

void MainWindow::askColor() {
    const std::string& now = workspace_->scenario().pictures.color;
    const QString path = askForPicture(this, tr("Open the colour picture of the relief"), QString::fromStdString(now));
    if (path.isEmpty()) return;
    relief::Scenario scenario = workspace_->scenario();
    scenario.pictures.color = path.toStdString();
    workspace_->change(scenario, changeName([] { return tr("Colour"); }));
}

void MainWindow::askSaveScenario() {
    const QString path = askSaveFile(this, QStringLiteral("scenarios"), tr("Save scenario"),
                                     QStringLiteral("scenario.json"), tr("Scenarios") + QStringLiteral(" (*.json)"));
    if (path.isEmpty()) return;
    workspace_->save(path);
    if (QFileInfo::exists(path)) remember(path);
}

void MainWindow::askSavePicture(bool legend) {
    const QString path =
        askSaveFile(this, QStringLiteral("saved-pictures"), tr("Save picture"), QStringLiteral("result.png"),
                    tr("Pictures") + QStringLiteral(" (*.png *.jpg *.bmp)"));
    if (!path.isEmpty()) savePicture(path, legend);
}

// Compressing a large picture takes long, so it runs in the background.
void MainWindow::savePicture(const QString& path, bool legend) {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot) return;
    const auto report = [this, path](const QString& problem) {
        if (problem.isEmpty()) {
            status_->say(tr("Saved: %1").arg(path));
        } else {
            Q_EMIT workspace_->problem(tr("%1: cannot be written: %2").arg(path, problem));
        }
    };
    const QImage image =
        legend ? withLegend(snapshot->layer.image, snapshot->layer, workspace_->style()) : snapshot->layer.image;
    runInBackground([image, path, report, back = mailbox_.address()] {
        QSaveFile file(path);
        QImageWriter writer(&file, QFileInfo(path).suffix().toLatin1());
        const bool done = file.open(QIODevice::WriteOnly) && writer.write(image) && file.commit();
        const QString fault = file.error() != QFileDevice::NoError ? file.errorString() : writer.errorString();
        const QString problem = done ? QString() : fault;
        back.post([report, problem] { report(problem); });
    });
}

void MainWindow::askView(const QString& view) {
    if (const auto file = askFigureFile(this, tr("Export figure"), view, true)) saveView(view, *file);
}

void MainWindow::saveView(const QString& view, const FigureFile& file) {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot) return;
    const relief::Scenario& now = workspace_->scenario();
    std::shared_ptr<const Figure> figure;
    try {
        figure = figureKind(view.toStdString()).make(snapshot, now);
    } catch (const relief::InputError& error) {
        return Q_EMIT workspace_->problem(whyNoFigure(error));
    }
    FigurePage page;
    page.title = view.toStdString();
    page.style = workspace_->style();
    const auto saved = [this, path = file.path] { status_->say(tr("Saved: %1").arg(path)); };
    workspace_->tasks().start(this, [figure, page, file, saved, workspace = workspace_](relief::Work& work) {
        return saveFigureFile(*figure, page, file, workspace, saved, work);
    });
}

// Exports the pane that fills the window, otherwise the one with the keyboard focus, otherwise the result.
void MainWindow::exportFocused() {
    const auto exportPane = [this](const Pane& pane) {
        auto* const figure = pane.dock != nullptr ? qobject_cast<FigureView*>(pane.dock->widget()) : nullptr;
        if (figure != nullptr) {
            figure->askFigure();
        } else if (!pane.kind.figures.empty()) {
            askView(pane.kind.name);
        }
        return figure != nullptr || !pane.kind.figures.empty();
    };
    for (const Pane& pane : panes_) {
        if (filled_ != nullptr && pane.whole == filled_ && exportPane(pane)) return;
    }
    for (QWidget* at = QApplication::focusWidget(); at != nullptr; at = at->parentWidget()) {
        for (const Pane& pane : panes_) {
            if (pane.dock != nullptr && pane.dock == at && exportPane(pane)) return;
        }
    }
    askView(QStringLiteral("result"));
}

void MainWindow::remember(const QString& path) {
    QSettings settings;
    QStringList files = settings.value(recentKey()).toStringList();
    files.removeAll(path);
    files.prepend(path);
    settings.setValue(recentKey(), QStringList(files.mid(0, kMostRecent)));
}

void MainWindow::startAnew() {
    workspace_->show(startScenario(datasets_.toStdString()), changeName([] { return tr("Start anew"); }));
}

void MainWindow::fillRecent() {
    recent_->clear();
    const QStringList files = QSettings().value(recentKey()).toStringList();
    for (const QString& path : files) {
        const QFileInfo file(path);
        QAction* const action = recent_->addAction(file.dir().dirName() + '/' + file.fileName());
        action->setToolTip(path);
        connect(action, &QAction::triggered, this, [this, path] { workspace_->open(path); });
    }
    if (files.isEmpty()) recent_->addAction(tr("none yet"))->setEnabled(false);
}

void MainWindow::fillExamples(QMenu* menu) {
    const QDir folder(datasets_);
    const QStringList names = datasets_.isEmpty() ? QStringList() : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    for (const QString& name : names) {
        const relief::Pictures pictures = picturesIn(folder.filePath(name).toStdString());
        if (pictures.height.empty()) continue;
        QAction* const action = menu->addAction(name);
        action->setToolTip(tr("Open these pictures, shipped with Reliefscope"));
        connect(action, &QAction::triggered, this, [this, name, pictures] {
            relief::Scenario scenario = workspace_->scenario();
            scenario.pictures = pictures;
            workspace_->change(scenario, changeName([name] { return tr("Open %1").arg(name); }));
        });
    }
    menu->setEnabled(!menu->isEmpty());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFiles(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList files = droppedFiles(event->mimeData());
    if (files.isEmpty()) return;
    event->acceptProposedAction();
    if (files.size() > 1) {
        Q_EMIT workspace_->problem(tr("One file at a time, please: a height map or a scenario"));
        return;
    }
    workspace_->open(files.front());
}

void MainWindow::showManual() {
    const QString page = manualPage(QApplication::applicationDirPath());
    if (!page.isEmpty() && QDesktopServices::openUrl(QUrl::fromLocalFile(page))) return;
    report(page.isEmpty() ? tr("The manual is not here: it is built by %1, before the programs are installed.")
                                .arg(QStringLiteral("cmake --build build --target manual"))
                          : tr("The browser could not be started; the manual is %1").arg(page),
           false);
}

}  // namespace reliefui
