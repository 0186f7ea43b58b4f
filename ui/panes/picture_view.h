// The grammar of panes that show the rendered picture, once or several times.
//
// Click chooses the pixel, drag turns the camera, wheel changes its distance; Ctrl with drag or wheel pans and zooms
// the picture, R shows all of it again; arrows move the pixel (Shift: by ten).
#pragma once

#include <optional>

#include <QTimer>
#include <QWidget>

#include "workspace/workspace.h"

namespace reliefui {

class PictureView : public QWidget {
    Q_OBJECT
  public:
    explicit PictureView(Workspace* workspace, QWidget* parent = nullptr);

    // The pixel under a point of this widget.
    std::optional<relief::PixelChoice> pixelAt(QPointF widget) const;

  public slots:
    // The whole picture again.
    void resetZoom();

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

    // The part of this widget that holds the picture under the point; empty: none does.
    virtual QRectF roomAt(QPointF widget) const = 0;
    virtual void tellHover(QPointF at) = 0;

    Workspace* workspace() const { return workspace_; }
    QSize pictureSize() const;
    // The point of the full-size picture (pixel (i, j) is [i, i+1) x [j, j+1)) in a room, and back.
    QPointF inRoom(QPointF picture, const QRectF& room) const;
    QPointF fromRoom(QPointF widget, const QRectF& room) const;
    double scaleIn(const QRectF& room) const;  // screen pixels a pixel of the picture
    // Where the whole picture lies, also what of it is outside the room.
    QRectF pictureIn(const QRectF& room) const;

  private:
    enum class Drag : std::uint8_t { None, Pressed, Orbit, Pan };

    void zoom(double factor, QPointF at);
    void turn(QPointF delta);
    bool movePixel(int key, bool far);

    Workspace* workspace_;
    double zoom_ = 1;
    QPointF center_{0.5, 0.5};  // of the view, in parts of the picture's size
    Drag drag_ = Drag::None;
    QPointF pressed_;
    QPointF last_;
    QTimer wheelRest_;
};

}  // namespace reliefui
