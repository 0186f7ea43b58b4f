// Run time against error of the methods on the rays of this view, and histograms of the frame's steps and errors. All
// of it is computed on a thread of the pane's own, except during drags. A click on a method chooses it and the pixel
// where its error is largest.
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
    // The last measurements; null if there are none yet.
    const MeasuredView* measured() const { return measured_.get(); }
    const relief::FrameHistograms* histograms() const { return histograms_.get(); }
    // Returns true if no computation is pending.
    bool isUpToDate() const;

  public slots:
    void measure();
    bool cancel() override;
    // Measures automatically when the view changes.
    void setLive(bool on);
    void setWithMaps(bool on);
    void setShown(reliefui::ChartsShown shown);
    void setMeasure(relief::ErrorMeasure measure);
    // Chooses the method of a mark, and its worst pixel.
    void choose(std::size_t point);
    // Chooses a pixel of a bar: first the one with the most steps or the largest error, then the next one.
    void chooseOf(const reliefui::HistogramBar& bar);

  protected:
    void showSnapshot() override;
    bool outdated() const override;
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    bool eventFilter(QObject* object, QEvent* event) override;
    void releaseContents() override;

  private:
    void makeBar();
    void change(const ChartsPane& pane);
    template <class Value>
    void set(Value ChartsPane::*choice, const std::type_identity_t<Value>& value) {
        ChartsPane pane = pane_;
        pane.*choice = value;
        change(pane);
    }
    void adopt();  // takes over the scenario's state of this pane
    // Returns true if the histograms are those of the snapshot's frame.
    bool counted() const { return snapshot_ && histograms_ && counted_ == snapshot_->frame; }
    void startMeasuring();
    void draw();  // draws again for another pixel, size or style
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
    std::shared_ptr<const relief::Frame> counted_;  // the frame of the histograms
    std::shared_ptr<const relief::FrameHistograms> histograms_;
    relief::Message uncounted_{relief::MessageId::DrawComparePending};  // shown until they are counted
    std::shared_ptr<const MeasuredView> measured_;
    ChartsPane pane_;
    ChartsPicture picture_;
    QPointF released_;
    bool measuring_ = false;
    std::shared_ptr<const Snapshot> measuredNow_;  // snapshot of the measurement in progress
    double fraction_ = 0;                          // progress of the measurement, 0 to 1
    std::unique_ptr<LatestJob> job_;               // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
