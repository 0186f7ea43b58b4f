// The distance pane: slices through any map, the difference of two, and the chosen ray with the spheres and cones of
// its steps. Maps are built and slices computed on a thread of the pane's own; long work shows its progress and can be
// cancelled. A click on a step chooses it, Ctrl+click shows the distances of a point; wheel and drag zoom and move, R
// resets the view.
#pragma once

#include <memory>
#include <vector>

#include <QTimer>

#include "panes/distance/distance_maps.h"
#include "panes/figure_view.h"
#include "panes/point_finder.h"
#include "workspace/latest_job.h"

class QComboBox;
class QFrame;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QSlider;
class QToolButton;

namespace reliefui {

class AnnotationLayer;
class DrawingCanvas;
class RangeButton;

class DistanceView : public FigureView {
    Q_OBJECT
  public:
    explicit DistanceView(Workspace* workspace, QWidget* parent = nullptr);
    ~DistanceView() override;

    DrawingCanvas* canvas() const { return canvas_; }
    const DistanceOptions& options() const { return options_; }
    void setOptions(const DistanceOptions& options);
    // The drawing on the screen; null before the first.
    const DistancePicture* shown() const { return result_ ? &result_->picture : nullptr; }
    // Returns true if no computation is pending: the screen shows the requested slice, or a problem.
    bool isUpToDate() const;
    // The point whose distances are shown; null: none.
    const PointQuery* point() const { return result_ ? result_->point.get() : nullptr; }
    QString problem() const { return problem_; }

  public slots:
    bool cancel() override;
    void resetZoom();

  protected:
    void showSnapshot() override;
    bool outdated() const override { return snapshot_ != workspace_->snapshot(); }
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void resizeEvent(QResizeEvent* event) override;
    void releaseContents() override;
    void addToMenu(QMenu& menu) override;
    bool showsPoints() const override { return true; }
    std::optional<QueryPoint> pointAt(const QPointF& widget) const override;
    std::optional<QPointF> pointPlace() const override;

  private:
    // Identifies the maps: their names and the heights.
    struct MapNames {
        std::vector<std::string> names;
        std::shared_ptr<const relief::FloatImage> heights;
        bool operator==(const MapNames&) const = default;
    };
    struct Result {
        std::shared_ptr<const Snapshot> snapshot;
        DistanceMaps maps;
        DistancePicture picture;
        Drawing legend;
        std::shared_ptr<const PointQuery> point;
        int secondSector = 0;

        DistanceSource source() const;
    };

    void makeMapBar(QHBoxLayout* bar);
    void makeSliceBar(QHBoxLayout* bar);
    void makeWaiting();
    void placeWaiting();
    void refreshStep();  // draws the marks of another step
    void build(const MapNames& names);
    void draw();
    void take(std::shared_ptr<const Result> result);
    void showMarks();
    void showControls();
    void showEmpty(relief::MessageId why);
    void fail(const QString& problem);
    void showWaiting();
    void change(const DistanceOptions& options, const char* drag = nullptr);
    void adopt();  // takes over the scenario's state of this pane
    void choose(const ItemId& id);
    bool ready() const;
    MapNames namesNow() const;

    DrawingCanvas* canvas_;
    AnnotationLayer* annotations_ = nullptr;
    QComboBox* kind_ = nullptr;
    QComboBox* minus_ = nullptr;
    QComboBox* sector_ = nullptr;
    std::vector<QToolButton*> axes_;
    QSlider* slider_ = nullptr;
    QLabel* slice_ = nullptr;
    QToolButton* iso_ = nullptr;
    QToolButton* near_ = nullptr;
    QToolButton* follow_ = nullptr;
    RangeButton* range_ = nullptr;
    QFrame* waiting_ = nullptr;
    QLabel* what_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QToolButton* stop_ = nullptr;
    QToolButton* retry_ = nullptr;
    QTimer busyDelay_;

    DistanceOptions options_;
    QString problem_;
    std::shared_ptr<const Snapshot> snapshot_;
    DistanceMaps maps_;
    MapNames built_;     // identifies maps_
    MapNames building_;  // maps being built; empty: none
    MapNames failed_;    // maps that could not be built; not tried again until something changes
    std::shared_ptr<const Result> result_;
    std::shared_ptr<const Drawing> drawing_;
    std::shared_ptr<const Drawing> legend_;
    std::optional<QueryPoint> query_;
    PointFinder point_{this, [this] { refresh(); }};
    std::unique_ptr<LatestJob> job_;  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
