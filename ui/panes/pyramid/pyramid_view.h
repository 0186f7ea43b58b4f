// The pyramid of the height map: all levels side by side with the chosen ray's steps on each; maxima, means, minima or
// all three; optionally as slabs in space. A click on a visited texel chooses its step; repeated clicks go through
// several steps.
#pragma once

#include <memory>
#include <type_traits>

#include "panes/deferred_call.h"
#include "panes/figure_view.h"
#include "panes/pyramid/pyramid_drawing.h"
#include "panes/pyramid/pyramid_parts.h"

class QHBoxLayout;
class QStackedLayout;
class QToolButton;

namespace reliefui {

class AnnotationLayer;
class DrawingCanvas;
class PyramidStack;
class RangeButton;

class PyramidView : public FigureView {
    Q_OBJECT
  public:
    explicit PyramidView(Workspace* workspace, QWidget* parent = nullptr);

    DrawingCanvas* canvas() const { return canvas_; }
    PyramidStack* stack() const { return stack_; }
    // The pyramids shown; parts().front() for single values.
    const std::vector<PyramidPart>& parts() const { return parts_.parts; }
    const std::vector<LevelBlock>& blocks() const { return parts_.parts.front().picture.blocks; }
    const RangedValues& heights() const { return parts_.heights; }
    // Describes what is under a point of the flat drawing.
    QString reading(Point drawing) const;

  public slots:
    void showMeans(bool means);
    void showMinima();
    void showAllKinds();
    // Shows the levels as slabs in space.
    void setStacked(bool on);
    // Shows only the surroundings of the ray, the same on every level, or the whole texture.
    void showNearRay(bool on);
    void setFollowing(bool on);
    void resetZoom();

  protected:
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void showSnapshot() override;
    bool outdated() const override { return shown_ != workspace_->snapshot(); }
    void releaseContents() override;
    void addToMenu(QMenu& menu) override;

  private:
    void refreshStep();  // draws the marks of another step
    void change(const PyramidPane& pane);
    template <class Value>
    void set(Value PyramidPane::*choice, const std::type_identity_t<Value>& value) {
        PyramidPane pane = pane_;
        pane.*choice = value;
        change(pane);
    }
    void adopt();  // takes over the scenario's state of this pane
    void chooseAt(Point drawing);
    QHBoxLayout* makeBar();
    void showEmpty(relief::MessageId why);
    void showStackLegend();
    void follow();
    void choose(const ItemId& id);
    QString textOf(const PyramidPart& part, const ItemId& id) const;
    const relief::Step* stepOf(const ItemId& id) const;

    DrawingCanvas* canvas_;
    AnnotationLayer* annotations_ = nullptr;
    QToolButton* maxima_;
    QToolButton* means_;
    QToolButton* minima_;
    QToolButton* all_;
    QToolButton* stacked_;
    QToolButton* near_;
    QToolButton* follow_;
    RangeButton* range_ = nullptr;
    PyramidStack* stack_;
    QStackedLayout* faces_;
    PyramidPane pane_;
    PyramidOptions options_;
    std::shared_ptr<const Snapshot> shown_;
    PyramidParts parts_;
    bool cramped_ = false;     // there is no room for all levels
    bool wasCramped_ = false;  // value at the last drawing
    std::shared_ptr<const Drawing> levels_;
    std::shared_ptr<const Drawing> legend_;
    DrawingCanvas* stackLegend_ = nullptr;  // below the slabs
    DeferredCall deferredRefresh_{this, [this] { refresh(); }};
};

}  // namespace reliefui
