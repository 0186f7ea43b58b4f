// Run time against error of the methods on the rays of this view, and histograms of its steps and errors. All of it is
// computed on a thread of the pane's own, while nothing is dragged. A click on a method chooses it and the pixel where
// it is farthest from the exact hit.
#pragma once

#include <memory>
#include <optional>
#include <type_traits>

#include <QPointF>

#include "panes/charts/charts_data.h"
#include "panes/charts/charts_state.h"
#include "panes/figure_view.h"
#include "workspace/latest_job.h"

class QComboBox;
class QToolButton;

namespace reliefui {

class DrawingCanvas;

class ChartsView : public FigureView {
    Q_OBJECT
  public:
    explicit ChartsView(Workspace* workspace, QWidget* parent = nullptr);
    ~ChartsView() override;

    DrawingCanvas* canvas() const { return canvas_; }
    const ChartsPicture& picture() const { return picture_; }
    // What was measured last; null: nothing yet.
    const MeasuredView* measured() const { return measured_.get(); }
    const relief::FrameHistograms* histograms() const { return histograms_.get(); }
    // Nothing is waited for.
    bool settled() const;

  public slots:
    void measure();
    void cancel() override;
    // Measures again by itself when the view changes.
    void setLive(bool on);
    void setWithMaps(bool on);
    void setShown(reliefui::ChartsShown shown);
    void setMeasure(relief::ErrorMeasure measure);
    // The method of a mark, and its worst pixel.
    void choose(std::size_t point);
    // A pixel of a bar: the one with most steps or farthest off; again: the next.
    void chooseOf(const reliefui::HistogramBar& bar);

  protected:
    void showSnapshot() override;
    bool outdated() const override;
    std::shared_ptr<const Figure> figure() const override;
    void tell(const QPointF& widget) override;
    bool eventFilter(QObject* object, QEvent* event) override;
    void letGo() override;

  private:
    void makeBar();
    void change(const ChartsPane& pane);
    template <class Value>
    void set(Value ChartsPane::*choice, const std::type_identity_t<Value>& value) {
        ChartsPane pane = pane_;
        pane.*choice = value;
        change(pane);
    }
    void adopt();  // what the scenario says
    void startMeasuring();
    void draw();  // another pixel, room or style
    void showEmpty();
    void showBusy();
    QString textOf(const relief::ParetoPoint& point) const;
    QString textOf(const HistogramBar& bar) const;
    static QString rangeOf(const HistogramBar& bar);
    ChartsSource source() const;

    DrawingCanvas* canvas_;
    QWidget* bar_ = nullptr;
    QToolButton* measureButton_ = nullptr;
    QToolButton* live_ = nullptr;
    QToolButton* maps_ = nullptr;
    QComboBox* shown_ = nullptr;
    QComboBox* error_ = nullptr;

    std::shared_ptr<const Snapshot> snapshot_;
    std::shared_ptr<const relief::Frame> counted_;  // that the histograms are of
    std::shared_ptr<const relief::FrameHistograms> histograms_;
    std::shared_ptr<const MeasuredView> measured_;
    ChartsPane pane_;
    ChartsPicture picture_;
    QPointF released_;
    bool measuring_ = false;
    std::shared_ptr<const Snapshot> measuredNow_;  // while it is
    double fraction_ = 0;                          // of what is being measured
    std::unique_ptr<LatestJob> job_;               // last: ends before the rest
};

}  // namespace reliefui
