// What is wrong with the tracer whose files are open: the faults that its answers show, with their likely cause and
// cure, and a picture of the errors. A click on a fault or on the picture chooses the ray. All of it is computed on a
// thread of the pane's own.
#pragma once

#include <memory>
#include <optional>

#include "panes/doctor/doctor_data.h"
#include "panes/figure_view.h"
#include "workspace/latest_job.h"

class QListWidget;
class QToolButton;

namespace reliefui {

class DrawingCanvas;

class DoctorView : public FigureView {
    Q_OBJECT
  public:
    explicit DoctorView(Workspace* workspace, QWidget* parent = nullptr);
    ~DoctorView() override;

    DrawingCanvas* canvas() const { return canvas_; }
    QListWidget* list() const { return list_; }
    // Null before it is computed.
    const DoctorReport* report() const { return report_.get(); }
    // Returns true if no computation is pending.
    bool isUpToDate() const { return !stale() && !job_->busy(); }

  public slots:
    void diagnose();
    bool cancel() override;
    // Chooses a ray of the files, and the pixel that it belongs to if the files name it.
    void chooseRay(std::size_t ray);

  protected:
    void showSnapshot() override;
    bool outdated() const override;
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void releaseContents() override;

  private:
    void readAgain();
    void noteCancelled(bool busy);
    void forget();  // the report, and what was asked
    void redraw();
    void fillList();
    void showBusy();

    DrawingCanvas* canvas_;
    QListWidget* list_;
    QToolButton* run_ = nullptr;
    std::shared_ptr<const DoctorReport> report_;
    std::optional<DoctorSubject> asked_;      // what is, or was last, diagnosed
    std::optional<relief::Message> problem_;  // why there is no report of the open files
    double fraction_ = 0;
    std::unique_ptr<LatestJob> job_;  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
