// The pyramid of the height map: every level side by side, and where the chosen ray went on each. A click on a visited
// texel chooses that step; where there are several, one after the other.
#pragma once

#include <memory>

#include <QWidget>

#include "drawings/pyramid_drawing.h"
#include "workspace/workspace.h"

class QLabel;
class QToolButton;

namespace reliefui {

class DrawingCanvas;

class PyramidView : public QWidget {
    Q_OBJECT
  public:
    explicit PyramidView(Workspace* workspace, QWidget* parent = nullptr);

    DrawingCanvas* canvas() const { return canvas_; }
    const std::vector<LevelBlock>& blocks() const { return picture_.blocks; }
    QString readout() const;

  public slots:
    void showMeans(bool means);
    void showMinima();
    // Only the surroundings of the ray, the same on every level, or all of the texture.
    void showNearRay(bool on);
    void setFollowing(bool on);
    void resetZoom();

  private:
    void refresh();      // another map, ray or room
    void refreshStep();  // another step
    void showEmpty(relief::MessageId why);
    void follow();
    void choose(const ItemId& id);
    void tell(const ItemId& id);
    relief::PyramidKind levels() const;
    PyramidSource source() const;

    Workspace* workspace_;
    DrawingCanvas* canvas_;
    QToolButton* maxima_;
    QToolButton* means_;
    QToolButton* minima_;
    QToolButton* near_;
    QToolButton* follow_;
    QLabel* readout_;
    std::shared_ptr<const Snapshot> shown_;
    PyramidPicture picture_;
    bool cramped_ = false;     // no room for all levels
    bool wasCramped_ = false;  // when it was last drawn
    std::shared_ptr<const Drawing> levels_;
    std::shared_ptr<const Drawing> legend_;
};

}  // namespace reliefui
