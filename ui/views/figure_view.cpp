#include "views/figure_view.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QPointer>
#include <QThreadPool>

namespace reliefui {

namespace {

constexpr int kCopiedWidth = 1600;  // pixels
constexpr int kLeastWidth = 160;
constexpr int kMostWidth = 15000;
constexpr double kMmPerInch = 25.4;

}  // namespace

FigureView::FigureView(Workspace* workspace, const QString& title, const QString& name, const QString& dialog,
                       QWidget* parent)
    : QWidget(parent), workspace_(workspace), name_(name), dialog_(dialog) {
    setAccessibleName(title);
}

void FigureView::setFace(QWidget* face) {
    face_ = face;
    setFocusProxy(face);
    face->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(face, &QWidget::customContextMenuRequested, this, &FigureView::openMenu);
}

void FigureView::setReadout(const QString& text) {
    readout_ = text;
    Q_EMIT hovered(text);
}

FigureRequest FigureView::figure() const {
    FigureRequest request;
    request.view = name_.toStdString();
    request.style = workspace_->style();
    fillFigure(request);
    return request;
}

Snapshot FigureView::figureState() const {
    Snapshot now = *figureSnapshot();
    now.scenario.step = workspace_->scenario().step;
    return now;
}

QImage FigureView::image(int width) const {
    return figureSnapshot() ? figureImage(figureState(), figure(), width) : QImage();
}

void FigureView::openMenu(const QPoint& at) {
    QMenu menu(this);
    tell(at);
    const QString value = readout_;
    addToMenu(menu);
    QAction* const copy =
        menu.addAction(tr("Copy value"), this, [value] { QApplication::clipboard()->setText(value); });
    copy->setEnabled(!value.isEmpty());
    QAction* const picture = menu.addAction(tr("Copy picture"), this, &FigureView::copyPicture);
    QAction* const save = menu.addAction(tr("Export figure…"), this, &FigureView::askFigure);
    picture->setEnabled(figureSnapshot() != nullptr);
    save->setEnabled(figureSnapshot() != nullptr);
    menu.exec(face_->mapToGlobal(at));
}

void FigureView::askFigure() {
    QString path = QFileDialog::getSaveFileName(this, dialog_, name_ + QStringLiteral(".svg"),
                                                tr("Figures") + QStringLiteral(" (*.svg *.pdf *.png)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".svg");
    int pixels = 0;
    if (QFileInfo(path).suffix().compare(QLatin1String("png"), Qt::CaseInsensitive) == 0) {
        bool accepted = false;
        pixels = QInputDialog::getInt(this, dialog_, tr("Width, pixels:"), kCopiedWidth, kLeastWidth, kMostWidth, 100,
                                      &accepted);
        if (!accepted) return;
    }
    saveFigure(path, pixels);
}

void FigureView::saveFigure(const QString& path, int pixels) {
    if (!figureSnapshot()) return;
    FigureRequest request = figure();
    // In print, dark lines on white.
    request.style.theme = Theme::Light;
    // So many pixels of the same page: text grows with the picture.
    if (pixels > 0) request.dpi = pixels / request.widthMm * kMmPerInch;
    drawAside([this, state = figureState(), request, path]() -> std::function<void()> {
        try {
            writeFigure(state, request, path.toStdString());
            return [this, path] { Q_EMIT saved(path); };
        } catch (const relief::InputError& error) {
            const QString problem = QString::fromStdString(error.text(request.style.language));
            return [this, problem] { Q_EMIT workspace_->problem(problem); };
        } catch (const std::exception& error) {
            return [this, problem = QString::fromUtf8(error.what())] { Q_EMIT workspace_->problem(problem); };
        }
    });
}

void FigureView::copyPicture() {
    if (!figureSnapshot()) return;
    drawAside([state = figureState(), request = figure()]() -> std::function<void()> {
        QImage picture;
        try {
            picture = figureImage(state, request, kCopiedWidth);
        } catch (const std::exception&) {
            return [] {};  // a map that there is none of
        }
        return [picture] { QApplication::clipboard()->setImage(picture); };
    });
}

// draw: on another thread; what it returns is called on the window's, if the pane is still there.
void FigureView::drawAside(std::function<std::function<void()>()> draw) {
    ++saving_;
    QThreadPool::globalInstance()->start([draw = std::move(draw), view = QPointer(this)] {
        const std::function<void()> told = draw();
        if (QCoreApplication::instance() == nullptr) return;  // the program ends
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [view, told] {
                if (!view) return;
                --view->saving_;
                told();
            },
            Qt::QueuedConnection);
    });
}

}  // namespace reliefui
