// The slice along the chosen pixel's ray: surface, ray, maxima of the pyramid, layers, numbered steps. A click on a
// step chooses it, Ctrl+click shows the distances of a point; wheel and drag zoom and move, R resets the view.
#pragma once

#include <memory>
#include <type_traits>

#include "panes/figure_view.h"
#include "panes/point_finder.h"
#include "panes/profile/profile_drawing.h"
#include "panes/profile/profile_state.h"

class QToolButton;

namespace reliefui {

class AnnotationLayer;
class DrawingCanvas;

class ProfileView : public FigureView {
    Q_OBJECT
  public:
    explicit ProfileView(Workspace* workspace, QWidget* parent = nullptr);

    DrawingCanvas* canvas() const { return canvas_; }
    const ProfileFrame& frame() const { return frame_; }
    const ProfileOptions& options() const { return options_; }
    // The point whose distances are shown; null: none.
    const PointQuery* point() const { return point_.known().get(); }

  public slots:
    void showAllLevels(bool all);
    void showNearRay(bool on);
    void setTrueAspect(bool on);
    void resetZoom();
    // Lets the user guess the hit by a click on the profile; then the answer is shown next to the guess.
    void guessAt(double lambda);

  protected:
    void showSnapshot() override;
    bool outdated() const override { return shown_ != workspace_->snapshot(); }
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void releaseContents() override;
    void addToMenu(QMenu& menu) override;
    bool showsPoints() const override { return true; }
    std::optional<QueryPoint> pointAt(const QPointF& widget) const override;
    std::optional<QPointF> pointPlace() const override;

  private:
    void makeBar();
    void change(const ProfilePane& pane);
    template <class Value>
    void set(Value ProfilePane::*choice, const std::type_identity_t<Value>& value) {
        ProfilePane pane = pane_;
        pane.*choice = value;
        change(pane);
    }
    void adopt();        // takes over the scenario's state of this pane
    void redraw();       // draws again for another visible part
    void refreshStep();  // draws the marks of another step
    void showEmpty(relief::MessageId why);
    void choose(const ItemId& id);
    void showGuessing(bool on);
    bool ready() const;
    ProfileSource source() const;

    DrawingCanvas* canvas_;
    AnnotationLayer* annotations_ = nullptr;
    QToolButton* allLevels_ = nullptr;
    QToolButton* near_ = nullptr;
    QToolButton* aspect_ = nullptr;
    QToolButton* guess_ = nullptr;
    std::shared_ptr<const Snapshot> shown_;
    ProfileOptions options_;
    ProfilePane pane_;
    std::uint64_t guessed_ = 0;  // snapshot version to which the guess belongs
    ProfileFrame frame_;
    std::shared_ptr<const Drawing> relief_;
    std::shared_ptr<const Drawing> axes_;
    std::shared_ptr<const Drawing> legend_;
    std::optional<QueryPoint> query_;
    PointFinder point_{this, [this] { refresh(); }};  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
