// The rendered picture, in which the pixel to be explained is chosen. The pointer reads out values.
#pragma once

#include "painting/annotation.h"
#include "panes/picture_view.h"
#include "panes/range_button.h"

class QMenu;

namespace reliefui {

class AnnotationLayer;

class ResultView : public PictureView {
    Q_OBJECT
  public:
    explicit ResultView(Workspace* workspace, QWidget* parent = nullptr);

    // Maps a point of the full-size picture (pixel (i, j) covers [i, i+1) x [j, j+1)) to this widget, and back.
    QPointF toWidget(QPointF picture) const { return inRoom(picture, room()); }
    QPointF toPicture(QPointF widget) const { return fromRoom(widget, room()); }

    // Placed in the bar of the window that contains the view.
    RangeButton* rangeButton() const { return range_; }

    QSize sizeHint() const override { return {800, 600}; }

    // Adds the entries for annotations to the context menu.
    void addToMenu(QMenu& menu);

  signals:
    void hovered(const QString& readout);      // one line; empty when the pointer has left the picture
    void menuRequested(const QPoint& global);  // the context menu belongs to the window

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;
    QRectF roomAt(QPointF) const override { return room(); }
    void readOutHover(QPointF at) override;

  private:
    std::optional<AnnotationFrame> annotationFrame() const;
    QRectF room() const;
    double scale() const { return scaleIn(room()); }
    void paintPicture(QPainter& painter) const;
    void paintOverlays(QPainter& painter) const;
    void paintEmpty(QPainter& painter) const;
    QRect legendBox() const;

    RangeButton* range_;
    AnnotationLayer* annotations_ = nullptr;
};

}  // namespace reliefui
