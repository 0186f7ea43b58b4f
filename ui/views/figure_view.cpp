#include "views/figure_view.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>

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
    QAction* const picture =
        menu.addAction(tr("Copy picture"), this, [this] { QApplication::clipboard()->setImage(image(kCopiedWidth)); });
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
    try {
        writeFigure(figureState(), request, path.toStdString());
        Q_EMIT saved(path);
    } catch (const relief::InputError& error) {
        Q_EMIT workspace_->problem(QString::fromStdString(error.text(request.style.language)));
    }
}

}  // namespace reliefui
