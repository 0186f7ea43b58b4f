// A pane that shows drawings, with the grammar of all panes: wheel zooms at the pointer, drag moves, R shows all again,
// click chooses, Ctrl+click asks about a point, hover reads values out.
#pragma once

#include <memory>
#include <vector>

#include <QWidget>

#include "painting/cell_pictures.h"

namespace reliefui {

class DrawingCanvas : public QWidget {
    Q_OBJECT
  public:
    explicit DrawingCanvas(QWidget* parent = nullptr);

    // From the lowest to the topmost. The legend stands at the lower edge, whatever the zoom.
    void setLayers(std::vector<std::shared_ptr<const Drawing>> layers, std::shared_ptr<const Drawing> legend);
    void setStyle(const Style& style);
    // Shows the legend alone, so that room() is what it leaves; an empty one where it would take more than this part of
    // the height.
    std::shared_ptr<const Drawing> showLegend(Drawing legend, double most);
    double legendWidth() const;  // at most, points
    // Nothing to show but what would fill the pane, and how.
    void showText(relief::MessageId why);
    // Holds nothing any more; where it was zoomed to stays.
    void letGo();

    // Room for the drawing at its home zoom, in points.
    QSizeF room() const;
    QPointF toWidget(Point drawing) const;
    Point toDrawing(QPointF widget) const;
    // The part of the drawing that is seen, and points of the screen a unit of it.
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
    void clickedAt(const QPointF& widget);     // before it, whatever is there
    void asked(const QPointF& widget);         // Ctrl+click, instead of both: about this point
    void hovered(const reliefui::ItemId& id);  // none: nothing is under the pointer
    void resized();
    void moved();                         // zoomed or moved: another part is seen
    void pointed(const QPointF& widget);  // the pointer is there
    void left();                          // and now it is gone

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
    Box screenRoom() const;  // physical pixels
    double legendHeight() const;
    ViewMap legendMap() const;
    Box bounds() const;
    void setMap(const ViewMap& map);
    Style deviceStyle() const;  // in physical pixels

    Style style_;
    std::vector<std::shared_ptr<const Drawing>> layers_;
    std::shared_ptr<const Drawing> legend_;
    ViewMap map_;  // to physical pixels
    bool home_ = true;
    bool dragging_ = false;
    QPointF pressed_;
    QPointF last_;
    CellPictures cells_;
};

}  // namespace reliefui
