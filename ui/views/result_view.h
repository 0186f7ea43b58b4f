// The rendered picture, where the question arises: why does this pixel look like that?
//
// Click chooses the pixel, drag turns the camera, wheel changes its distance; Ctrl with drag or wheel pans and zooms
// the picture, R shows all of it again; arrows move the pixel (Shift: by ten). The pointer reads values out.
#pragma once

#include <optional>

#include <QTimer>
#include <QWidget>

#include "workspace/workspace.h"

namespace reliefui {

class ResultView : public QWidget {
    Q_OBJECT
  public:
    explicit ResultView(Workspace* workspace, QWidget* parent = nullptr);

    // The point of the full-size picture (pixel (i, j) is [i, i+1) x [j, j+1)) on this widget, and back.
    QPointF toWidget(QPointF picture) const;
    QPointF toPicture(QPointF widget) const;
    // The pixel under a point of this widget.
    std::optional<relief::PixelChoice> pixelAt(QPointF widget) const;

    QSize sizeHint() const override { return {800, 600}; }

  public slots:
    // The whole picture again.
    void resetZoom();

  signals:
    void hovered(const QString& readout);      // one line; empty when the pointer has left the picture
    void menuRequested(const QPoint& global);  // the context menu is the window's

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;

  private:
    enum class Drag : std::uint8_t { None, Pressed, Orbit, Pan };

    double scale() const;  // screen pixels a pixel of the picture
    QSize pictureSize() const;
    void zoom(double factor, QPointF at);
    void turn(QPointF delta);
    void paintPicture(QPainter& painter) const;
    void paintOverlays(QPainter& painter) const;
    void paintEmpty(QPainter& painter) const;
    bool movePixel(int key, bool far);
    void tellHover(QPointF at);

    Workspace* workspace_;
    double zoom_ = 1;
    QPointF center_{0.5, 0.5};  // of the view, in parts of the picture's size
    Drag drag_ = Drag::None;
    QPointF pressed_;
    QPointF last_;
    QTimer wheelRest_;
};

}  // namespace reliefui
