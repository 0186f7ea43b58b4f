// The pane that explains the colour of the chosen pixel. The history is computed in the background, because
// supersampling draws the pixel's row once for every sample.
#pragma once

#include <memory>

#include "panes/figure_view.h"
#include "rendering/pixel_history.h"
#include "workspace/latest_job.h"

namespace reliefui {

class FormulaFace;

class WhyView : public FigureView {
    Q_OBJECT
  public:
    explicit WhyView(Workspace* workspace, QWidget* parent = nullptr);
    ~WhyView() override;

    const FormulaFace* face() const { return face_; }
    const relief::PixelHistory* history() const { return history_.get(); }
    // Returns true if no computation is pending.
    bool isUpToDate() const { return !stale() && !job_->busy(); }

  public slots:
    bool cancel() override { return job_->cancel(); }

  protected:
    void showSnapshot() override;
    bool outdated() const override { return shown_ && shown_ != workspace_->snapshot(); }
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& at) override;
    void releaseContents() override;

  private:
    void draw();
    void showEmpty(relief::Message why);
    void showEmpty(relief::MessageId why) { showEmpty(relief::Message(why)); }

    FormulaFace* face_;
    std::shared_ptr<const Snapshot> shown_;  // of the history
    std::shared_ptr<const relief::PixelHistory> history_;
    std::unique_ptr<LatestJob> job_;  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
