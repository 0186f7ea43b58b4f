// Common controls of panes that show the rendered picture, once or several times.
//
// A click chooses the pixel, a drag rotates the camera, the wheel changes its distance; Ctrl with drag or wheel pans
// and zooms the picture, R shows all of it; arrow keys move the pixel (Shift: by ten).
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

    // The pixel at a point of this widget.
    std::optional<relief::PixelChoice> pixelAt(QPointF widget) const;

  public slots:
    // Shows the whole picture.
    void resetZoom();

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

    // The rectangle of this widget with the picture at this point; empty if there is none.
    virtual QRectF roomAt(QPointF widget) const = 0;
    virtual void readOutHover(QPointF at) = 0;
    // Call this after another picture has come under the pointer, which may rest.
    void readAgain();

    Workspace* workspace() const { return workspace_; }
    QSize pictureSize() const;
    // Maps a point of the full-size picture (pixel (i, j) covers [i, i+1) x [j, j+1)) to a room's widget coordinates,
    // and back.
    QPointF inRoom(QPointF picture, const QRectF& room) const;
    QPointF fromRoom(QPointF widget, const QRectF& room) const;
    double scaleIn(const QRectF& room) const;  // screen pixels per pixel of the picture
    // Rectangle of the whole picture, including the part outside the room.
    QRectF pictureIn(const QRectF& room) const;

  private:
    enum class Drag : std::uint8_t { None, Pressed, Orbit, Pan };

    void zoom(double factor, QPointF at);
    void turn(QPointF delta);
    bool movePixel(int key, bool far);

    Workspace* workspace_;
    double zoom_ = 1;
    QPointF center_{0.5, 0.5};  // centre of the view, as a share of the picture's size
    Drag drag_ = Drag::None;
    QPointF pressed_;
    QPointF last_;
    std::optional<QPointF> pointer_;  // where the pointer is; none while it is elsewhere
    QTimer wheelRest_;
};

}  // namespace reliefui
