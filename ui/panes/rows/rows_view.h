// Texture coordinates along the chosen pixel's scan line by several variants: values, errors, streams. Computed on a
// thread of the pane's own. Wheel zooms along the row, drag moves it, a click chooses a pixel of the row, R shows all.
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
    // Of options that rowMethods() takes.
    void setOptions(const RowsOptions& options);
    // What is on the screen; null: nothing, and the pane says why.
    const RowsData* shown() const { return data_.get(); }
    const RowsFrame& frame() const { return frame_; }
    // Nothing is waited for.
    bool settled() const;

  public slots:
    void resetZoom();

  protected:
    void showSnapshot() override;
    bool outdated() const override { return snapshot_ && snapshot_ != workspace_->snapshot(); }
    std::shared_ptr<const Figure> figure() const override;
    void tell(const QPointF& widget) override;
    void letGo() override;
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    // One of the variants compared: its name and those of its options that it has.
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
    void adopt();  // what the scenario says
    void readSlots();
    static void setSettings(const Slot& slot, const relief::RowSettings& settings);
    void showControls();
    void draw();  // another part is seen, another room or style
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
    std::shared_ptr<const Snapshot> snapshot_;  // that data_ are of
    std::shared_ptr<const RowsData> data_;
    std::shared_ptr<const Drawing> axes_;
    std::shared_ptr<const Drawing> plots_;
    std::shared_ptr<const Drawing> legend_;
    QPointF pressed_;
    QPointF last_;
    bool dragging_ = false;
    std::unique_ptr<LatestJob> job_;  // last: ends before the rest
};

}  // namespace reliefui
