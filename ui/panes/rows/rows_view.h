// Texture coordinates along the chosen pixel's scan line by several variants: values, errors, streams. Computed on a
// thread of the pane's own. The wheel zooms along the row, a drag moves it, a click chooses a pixel of the row, R
// resets the view.
#pragma once

#include <memory>
#include <vector>

#include <QPointF>

#include "panes/figure_view.h"
#include "panes/rows/rows_drawing.h"
#include "workspace/latest_job.h"

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QMouseEvent;
class QSpinBox;
class QToolButton;

namespace reliefui {

class DrawingCanvas;

class RowsView : public FigureView {
    Q_OBJECT
  public:
    explicit RowsView(Workspace* workspace, QWidget* parent = nullptr);
    ~RowsView() override;

    DrawingCanvas* canvas() const { return canvas_; }
    const RowsOptions& options() const { return options_; }
    // The options must be accepted by rowMethods().
    void setOptions(const RowsOptions& options);
    // The data on the screen; null: none, and the pane shows why.
    const RowsData* shown() const { return data_.get(); }
    const RowsFrame& frame() const { return frame_; }
    // Returns true if no computation is pending.
    bool isUpToDate() const;

  public slots:
    void resetZoom();

  protected:
    void showSnapshot() override;
    bool outdated() const override { return snapshot_ && snapshot_ != workspace_->snapshot(); }
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void releaseContents() override;
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    // Controls of one of the compared variants: its name and those of its options that apply.
    struct Slot {
        QComboBox* variant = nullptr;
        QSpinBox* streams = nullptr;
        QSpinBox* span = nullptr;
        QDoubleSpinBox* error = nullptr;
        QSpinBox* anchor = nullptr;
    };

    void makeBar();
    void makeVariants();
    void addSlot(QGridLayout* grid, int row);
    void change(const RowsOptions& options);
    void adopt();  // takes over the scenario's state of this pane
    void readSlots();
    static void setSettings(const Slot& slot, const relief::RowSettings& settings);
    void showControls();
    void draw();  // draws again for another visible part, size or style
    void showEmpty(relief::MessageId why);
    void setRange(double from, double to);
    void zoom(double factor, double x);
    bool mouse(QMouseEvent* event);
    void choosePixel(const QPointF& widget);

    DrawingCanvas* canvas_;
    QWidget* bar_ = nullptr;
    QWidget* variants_ = nullptr;
    QToolButton* open_ = nullptr;
    QToolButton* logarithmic_ = nullptr;
    QComboBox* pixels_ = nullptr;
    QComboBox* precision_ = nullptr;
    std::vector<Slot> slots_;

    RowsOptions options_;
    RowsRange range_;
    RowsFrame frame_;
    std::shared_ptr<const Snapshot> snapshot_;  // snapshot of data_
    std::shared_ptr<const RowsData> data_;
    std::shared_ptr<const Drawing> axes_;
    std::shared_ptr<const Drawing> plots_;
    std::shared_ptr<const Drawing> legend_;
    QPointF pressed_;
    QPointF last_;
    bool dragging_ = false;
    std::unique_ptr<LatestJob> job_;  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
