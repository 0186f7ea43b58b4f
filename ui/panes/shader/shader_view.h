// The picture of the exported shader of the scenario's method beside the CPU's, with their difference, the worst pixel
// and the time of a frame. All of it is made on a thread of the pane's own, where OpenGL runs as well.
#pragma once

#include <memory>

#include "panes/figure_view.h"
#include "panes/shader/shader_drawing.h"
#include "panes/shader/shader_state.h"
#include "workspace/latest_job.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace reliefui {

class DrawingCanvas;
class RangeButton;

class ShaderView : public FigureView {
    Q_OBJECT
  public:
    explicit ShaderView(Workspace* workspace, QWidget* parent = nullptr);
    ~ShaderView() override;

    DrawingCanvas* canvas() const { return canvas_; }
    // What is shown; null before it is drawn.
    const ShaderPreview* preview() const { return preview_.get(); }
    const ShaderPicture& picture() const { return picture_; }
    // Returns true if no computation is pending.
    bool isUpToDate() const { return !stale() && !job_->busy(); }
    // Sets how OpenGL is opened, and draws again.
    void setGlSource(ShaderGlSource source);

  public slots:
    void draw();
    bool cancel() override;
    void chooseWorst();
    void setMeasure(reliefui::ShaderMeasure measure);

  protected:
    void showSnapshot() override;
    bool outdated() const override;
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void releaseContents() override;

  private:
    void makeBar(QHBoxLayout* bar);
    void adopt();  // takes over the scenario's state of this pane
    void redraw();
    void showBusy();
    void showSummary();
    bool current() const;
    ShaderSource source() const;

    DrawingCanvas* canvas_;
    QToolButton* draw_ = nullptr;
    QToolButton* worst_ = nullptr;
    QComboBox* measure_ = nullptr;
    RangeButton* range_ = nullptr;
    QLabel* summary_ = nullptr;
    ShaderGlSource open_;
    std::shared_ptr<const Snapshot> snapshot_;  // to be drawn, or drawn
    std::shared_ptr<const ShaderPreview> preview_;
    ShaderPane pane_;
    ShaderPicture picture_;
    bool stopped_ = false;  // by the user, until the next change
    double fraction_ = 0;
    std::unique_ptr<LatestJob> job_;  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
