// The pyramid of the height map: every level side by side, and where the chosen ray went on each. A click on a visited
// texel chooses that step; where there are several, one after the other.
#pragma once

#include <memory>

#include "drawings/pyramid_drawing.h"
#include "views/figure_view.h"

class QToolButton;

namespace reliefui {

class DrawingCanvas;

class PyramidView : public FigureView {
    Q_OBJECT
  public:
    explicit PyramidView(Workspace* workspace, QWidget* parent = nullptr);

    DrawingCanvas* canvas() const { return canvas_; }
    const std::vector<LevelBlock>& blocks() const { return picture_.blocks; }

  public slots:
    void showMeans(bool means);
    void showMinima();
    // Only the surroundings of the ray, the same on every level, or all of the texture.
    void showNearRay(bool on);
    void setFollowing(bool on);
    void resetZoom();

  protected:
    std::shared_ptr<const Snapshot> figureSnapshot() const override { return levels_ ? shown_ : nullptr; }
    void fillFigure(FigureRequest& request) const override;
    void tell(const QPointF& widget) override;

  private:
    void refresh();      // another map, ray or room
    void refreshStep();  // another step
    void showEmpty(relief::MessageId why);
    void follow();
    void choose(const ItemId& id);
    void tellItem(const ItemId& id);
    relief::PyramidKind levels() const;
    PyramidOptions options() const;
    PyramidSource source() const;

    DrawingCanvas* canvas_;
    QToolButton* maxima_;
    QToolButton* means_;
    QToolButton* minima_;
    QToolButton* near_;
    QToolButton* follow_;
    std::shared_ptr<const Snapshot> shown_;
    PyramidPicture picture_;
    bool cramped_ = false;     // no room for all levels
    bool wasCramped_ = false;  // when it was last drawn
    std::shared_ptr<const Drawing> levels_;
    std::shared_ptr<const Drawing> legend_;
};

}  // namespace reliefui
