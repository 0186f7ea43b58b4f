// A widget that shows drawings, with the controls common to all panes: the wheel zooms at the pointer, a drag moves, R
// resets the view, a click chooses, Ctrl+click queries a point, hovering reads out values.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QWidget>

#include "painting/cell_pictures.h"
#include "panes/deferred_call.h"

namespace reliefui {

class DrawingCanvas : public QWidget {
    Q_OBJECT
  public:
    explicit DrawingCanvas(QWidget* parent = nullptr);

    // Layers from the lowest to the topmost. The legend stands at the lower edge, whatever the zoom.
    void setLayers(std::vector<std::shared_ptr<const Drawing>> layers, std::shared_ptr<const Drawing> legend);
    void setStyle(const Style& style);
    // Shows only the legend, so that room() returns what it leaves. Returns the legend, or an empty drawing if it would
    // take more than this share of the height.
    std::shared_ptr<const Drawing> showLegend(Drawing legend, double most);
    double legendWidth() const;  // largest width, in points
    // Shows only a message that explains how to fill the pane.
    void showText(const relief::Message& text);
    void showText(relief::MessageId text) { showText(relief::Message(text)); }
    // Releases the drawings; the zoom is kept.
    void releaseContents();

    // Room for the drawing at its home zoom, in points.
    QSizeF room() const;
    QPointF toWidget(Point drawing) const;
    Point toDrawing(QPointF widget) const;
    // The visible part of the drawing; the scale is in points of the screen per unit.
    Box visible() const;
    double zoom() const;
    ItemId itemAt(QPointF widget) const;
    bool atHome() const { return home_; }

  public slots:
    void resetZoom();
    // Zooms so that the box fills most of the pane.
    void zoomTo(const Box& drawing);

  signals:
    void clicked(const reliefui::ItemId& id);
    void clickedAt(const QPointF& widget);     // emitted before the item's signal, whatever is at this point
    void pointQueried(const QPointF& widget);  // Ctrl+click, emitted instead of the two others: query this point
    void hovered(const reliefui::ItemId& id);  // id of the item under the pointer; ItemKind::None: no item
    void resized();
    void moved();  // zoomed or moved, so that another part is visible
    // The pointer moved to this point, or rests there while the drawing has changed.
    void pointed(const QPointF& widget);
    void left();  // the pointer left the widget

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    Box screenRoom() const;  // in physical pixels
    double legendHeight() const;
    ViewMap legendMap() const;
    Box bounds() const;
    void setMap(const ViewMap& map);
    void readAgain();
    Style deviceStyle() const;  // scaled to physical pixels

    Style style_;
    std::vector<std::shared_ptr<const Drawing>> layers_;
    std::shared_ptr<const Drawing> legend_;
    ViewMap map_;  // from drawing units to physical pixels
    bool home_ = true;
    bool dragging_ = false;
    QPointF pressed_;
    QPointF last_;
    std::optional<QPointF> pointer_;  // where the pointer rests; none while it is elsewhere
    CellPictures cells_;
    // Delayed until the pane has set all that its readout depends on.
    DeferredCall deferredReading_{this, [this] { readAgain(); }};
};

}  // namespace reliefui
