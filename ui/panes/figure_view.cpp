#include "panes/figure_view.h"

#include <algorithm>
#include <utility>

#include <QVTKOpenGLNativeWidget.h>
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QTimer>

#include "panes/gl_release.h"
#include "panes/space_figure.h"
#include "workspace/change_name.h"
#include "workspace/language.h"
#include "workspace/pane_store.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr int kCopiedWidth = 1600;  // in pixels

// Figures rendered with VTK are drawn on the window's thread.
bool isRendered(const Figure& figure) {
    return dynamic_cast<const SpaceFigure*>(&figure) != nullptr;
}
bool isRendered(const Figure& figure, const QString& path) {
    const bool pixels = !figure.vectors() || path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive);
    return pixels && isRendered(figure);
}

void drawNow(const BackgroundTasks::Task& draw) {
    const DrawingTime drawing("figure");
    relief::Work work;
    draw(work)();
}

}  // namespace

FigureView::FigureView(Workspace* workspace, const QString& title, const QString& name, const QString& dialog,
                       QWidget* parent)
    : QWidget(parent), workspace_(workspace), name_(name), dialog_(dialog) {
    setAccessibleName(title);
    connect(workspace_, &Workspace::snapshotChanged, this, &FigureView::refresh);
}

void FigureView::setFace(QWidget* face) {
    face_ = face;
    setFocusProxy(face);
    if (face->accessibleName().isEmpty()) face->setAccessibleName(accessibleName());
    face->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(face, &QWidget::customContextMenuRequested, this, &FigureView::openMenu);
}

void FigureView::setReadout(const QString& text) {
    readout_ = text;
    Q_EMIT hovered(text);
}

void FigureView::refresh() {
    becameVisible_ = std::exchange(stale_, !isOnScreen());
    if (stale_) {
        if (outdated()) releaseContents();
        return;
    }
    try {
        showSnapshot();
    } catch (const relief::InputError& error) {  // a damaged tile of a map that is read by tiles
        Q_EMIT workspace_->problem(QString::fromStdString(error.text(uiLanguage())));
    }
}

bool FigureView::markStaleIfHidden() {
    if (!isOnScreen()) stale_ = true;
    return !isOnScreen();
}

void FigureView::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    if (stale_) QTimer::singleShot(0, this, &FigureView::refresh);
}

void FigureView::releaseClosed() {
    if (isVisible()) return;
    releaseContents();
    stale_ = true;
    for (QVTKOpenGLNativeWidget* const widget : findChildren<QVTKOpenGLNativeWidget*>()) releaseGl(*widget);
}

FigurePage FigureView::page() const {
    FigurePage page;
    page.title = name_.toStdString();
    page.style = workspace_->style();
    return page;
}

QImage FigureView::image(int width) const {
    const auto shown = figure();
    relief::Work work;
    return shown ? figureImage(*shown, page(), width, work) : QImage();
}

void FigureView::openMenu(const QPoint& at) {
    QMenu menu(this);
    readOut(at);
    const QString value = readout_;
    addToMenu(menu);
    if (showsPoints()) addPointToMenu(menu, at);
    QAction* const copy =
        menu.addAction(tr("Copy value"), this, [value] { QApplication::clipboard()->setText(value); });
    copy->setEnabled(!value.isEmpty());
    QAction* const picture = menu.addAction(tr("Copy picture"), this, &FigureView::copyPicture);
    QAction* const save = menu.addAction(tr("Export figure…"), this, &FigureView::askFigure);
    const bool any = figure() != nullptr;
    picture->setEnabled(any);
    save->setEnabled(any);
    menu.exec(face_->mapToGlobal(at));
}

void FigureView::addPointToMenu(QMenu& menu, const QPoint& at) {
    const std::optional<QueryPoint> point = pointAt(at);
    QAction* const ask = menu.addAction(tr("Distances at this point"), this, [this, point] { setPoint(point); });
    ask->setEnabled(point.has_value());
    QAction* const forget = menu.addAction(tr("Remove the point"), this, [this] { setPoint(std::nullopt); });
    forget->setEnabled(stateOf<PointState>(workspace_->scenario()).point.has_value());
    menu.addSeparator();
}

void FigureView::setPoint(const std::optional<QueryPoint>& point) {
    workspace_->change(withState(workspace_->scenario(), PointState{point}), changeName([hasPoint = point.has_value()] {
                           return hasPoint ? tr("Distances at a point") : tr("Remove the point");
                       }));
}

void FigureView::askPoint(const QPointF& widget) {
    constexpr double kSame = 5;  // in pixels
    const std::optional<QPointF> mark = pointPlace();
    const bool same = mark && std::abs(mark->x() - widget.x()) <= kSame && std::abs(mark->y() - widget.y()) <= kSame;
    const std::optional<QueryPoint> point = pointAt(widget);
    if (same || point) setPoint(same ? std::nullopt : point);
}

void FigureView::askFigure() {
    const auto shown = figure();
    if (!shown) return Q_EMIT workspace_->problem(tr("This pane shows nothing yet that can be exported."));
    if (const auto file = askFigureFile(this, dialog_, name_, shown->vectors())) saveFigure(*file);
}

void FigureView::saveFigure(const FigureFile& file) {
    const auto shown = figure();
    if (!shown) return;
    const auto draw = [this, shown, page = page(), file, workspace = workspace_](relief::Work& work) {
        return saveFigureFile(
            *shown, page, file, workspace, [this, path = file.path] { Q_EMIT saved(path); }, work);
    };
    isRendered(*shown, file.path) ? drawNow(draw) : drawInBackground(*shown, draw);
}

void FigureView::copyPicture() {
    const auto shown = figure();
    if (!shown) return;
    const auto draw = [this, shown, page = page()](relief::Work& work) -> std::function<void()> {
        QImage picture;
        try {
            picture = figureImage(*shown, page, kCopiedWidth, work);
        } catch (const relief::Cancelled&) {
            return [] {};
        } catch (const std::exception& error) {
            return [this, problem = QString::fromUtf8(error.what())] { Q_EMIT workspace_->problem(problem); };
        }
        return [picture] { QApplication::clipboard()->setImage(picture); };
    };
    isRendered(*shown) ? drawNow(draw) : drawInBackground(*shown, draw);
}

// Runs `draw` on another thread; the function it returns is called on the window's thread if the pane still exists.
void FigureView::drawInBackground(const Figure&, BackgroundTasks::Task draw) {
    ++saving_;
    workspace_->tasks().start(this, [this, draw = std::move(draw)](relief::Work& work) {
        return [this, finish = draw(work)] {
            --saving_;
            finish();
        };
    });
}

}  // namespace reliefui
