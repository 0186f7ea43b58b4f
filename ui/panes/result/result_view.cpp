#include "panes/result/result_view.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "painting/painter.h"
#include "panes/annotation_layer.h"
#include "panes/result/pixel_values.h"
#include "panes/result/result_figure.h"
#include "panes/result/result_painting.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr int kLegendMargin = 8;

}  // namespace

ResultView::ResultView(Workspace* workspace, QWidget* parent) : PictureView(workspace, parent) {
    setObjectName(QStringLiteral("result"));
    setAccessibleName(tr("Result: the rendered picture"));
    connect(workspace, &Workspace::snapshotChanged, this, qOverload<>(&QWidget::update));
    connect(workspace, &Workspace::snapshotChanged, this, &ResultView::readAgain);
    connect(workspace, &Workspace::styleChanged, this, qOverload<>(&QWidget::update));
    range_ = new RangeButton(
        workspace,
        [workspace]() -> std::optional<RangedValues> {
            const auto snapshot = workspace->snapshot();
            if (!snapshot || !snapshot->layer.values) return std::nullopt;
            return layerValues(snapshot->layer);
        },
        this);
    connect(workspace, &Workspace::snapshotChanged, range_, &RangeButton::refresh);
    range_->refresh();
    annotations_ = new AnnotationLayer(workspace, this, [this] { return annotationFrame(); });
}

// Annotations stand in the picture, in front of the legend and the magnifier.
std::optional<AnnotationFrame> ResultView::annotationFrame() const {
    if (!workspace()->snapshot()) return std::nullopt;
    const QRectF whole = pictureIn(room());
    const QRectF seen = whole & QRectF(rect());
    const auto box = [](const QRectF& r) { return Box{r.left(), r.top(), r.right(), r.bottom()}; };
    return resultAnnotations(box(whole), box(seen), pictureSize().width(), workspace()->style().pixelsPerPoint());
}

void ResultView::addToMenu(QMenu& menu) {
    annotations_->addToMenu(menu);
}

void ResultView::paintEvent(QPaintEvent*) {
    const PauseLog::Part part("result");
    QPainter painter(this);
    painter.fillRect(rect(), toColor(workspace()->style().background()));
    if (!workspace()->snapshot()) {
        paintEmpty(painter);
        return;
    }
    paintPicture(painter);
    paintOverlays(painter);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void ResultView::paintEmpty(QPainter& painter) const {
    painter.setPen(toColor(workspace()->style().text()));
    const QString text = workspace()->busy() ? tr("Drawing the first picture…")
                                             : tr("No picture yet: open a height map, or drop one here.");
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void ResultView::paintPicture(QPainter& painter) const {
    const auto snapshot = workspace()->snapshot();
    const QImage& image = snapshot->layer.image;
    // Enlarged pixels keep sharp edges; a coarse picture of a drag is interpolated.
    const bool smaller = image.width() < pictureSize().width();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale() < 1 || smaller);
    painter.drawImage(pictureIn(room()), image);
}

void ResultView::paintOverlays(QPainter& painter) const {
    const auto snapshot = workspace()->snapshot();
    const Style& style = workspace()->style();
    const int margin = kLegendMargin;
    paintPixelValues(painter, *snapshot, pictureIn(room()), rect(), style);
    paintLegend(&painter, snapshot->layer, QPoint(margin, height() - margin), style, width() - 2 * margin);
    if (!snapshot->scenario.pixel) return;
    const relief::PixelChoice pixel = *snapshot->scenario.pixel;
    const QPointF at = toWidget({pixel.x + 0.5, pixel.y + 0.5});
    paintChosenPixel(painter, at, scale(), style);

    // The magnifier is placed in the upper corner farther from the pixel.
    const QSize magnifier = magnifierSize(style, width());
    if (scale() * kMagnified > magnifier.width()) return;  // the picture is already that large
    if (magnifier.width() * 2 > width() || magnifier.height() * 2 > height()) return;
    const bool left = at.x() > width() / 2.0;
    const QPoint corner(left ? margin : width() - margin - magnifier.width(), margin);
    const QSize full = pictureSize();
    const QImage& image = snapshot->layer.image;
    const QPoint center(pixel.x * image.width() / full.width(), pixel.y * image.height() / full.height());
    paintMagnifier(painter, image, center, QRect(corner, magnifier), style);
}

// Room for the picture. In large type a colour scale would cover much of it, so the picture stands above.
QRectF ResultView::room() const {
    const QRect legend = workspace()->style().projector ? legendBox() : QRect();
    const int taken = legend.isEmpty() ? 0 : legend.height() + 2 * kLegendMargin;
    return taken < height() / 2 ? rect().adjusted(0, 0, 0, -taken) : rect();
}

// Rectangle of the colour scale, which is the lowest part of the legend.
QRect ResultView::legendBox() const {
    const auto snapshot = workspace()->snapshot();
    if (!snapshot || !snapshot->layer.values) return {};
    QSize size = scaleSize(snapshot->layer, workspace()->style(), width() - 2 * kLegendMargin);
    return {QPoint(kLegendMargin, height() - kLegendMargin - size.height()), size};
}

void ResultView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && legendBox().contains(event->pos())) {
        range_->open();
    } else {
        PictureView::mousePressEvent(event);
    }
}

void ResultView::readOutHover(QPointF at) {
    const auto snapshot = workspace()->snapshot();
    const auto pixel = pixelAt(at);
    Q_EMIT hovered(snapshot && pixel ? pixelReadout(*snapshot, *pixel, true).join(QStringLiteral("   ")) : QString());
}

void ResultView::leaveEvent(QEvent* event) {
    PictureView::leaveEvent(event);
    Q_EMIT hovered({});
}

void ResultView::contextMenuEvent(QContextMenuEvent* event) {
    Q_EMIT menuRequested(event->globalPos());
}

bool ResultView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* const help = static_cast<QHelpEvent*>(event);
    const auto snapshot = workspace()->snapshot();
    const auto pixel = pixelAt(help->pos());
    if (snapshot && pixel) {
        QToolTip::showText(help->globalPos(), pixelReadout(*snapshot, *pixel).join('\n'), this);
    } else {
        QToolTip::hideText();
    }
    return true;
}

}  // namespace reliefui
