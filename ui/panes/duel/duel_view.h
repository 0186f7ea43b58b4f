// Two to four methods on the chosen ray, in lock step: the position of each, which one departs from the exact answer
// first, and what went wrong there. The first one is the scenario's method; its step is the window's.
#pragma once

#include <memory>
#include <vector>

#include "panes/duel/duel_data.h"
#include "panes/figure_view.h"
#include "workspace/latest_job.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QSplitter;
class QTableView;
class QToolButton;

namespace reliefui {

class DrawingCanvas;
class DuelModel;

class DuelView : public FigureView {
    Q_OBJECT
  public:
    explicit DuelView(Workspace* workspace, QWidget* parent = nullptr);
    ~DuelView() override;

    DrawingCanvas* canvas() const { return canvas_; }
    const Duel* duel() const { return duel_.get(); }
    std::size_t moment() const { return moment_; }
    QString verdict() const;
    double shownUpTo() const { return source_.upTo; }
    // Returns true if no computation is pending.
    bool isUpToDate() const { return !stale() && !job_->busy(); }

  public slots:
    // Stepping moves all methods in lock step.
    void first();
    void back();
    void forward();
    void last();
    // Goes to the first moment at which a method departs from the exact answer.
    void toDivergence();
    // Sets the rival at this place, 0 to 2; empty: none.
    void setRival(int place, const QString& method);
    bool cancel() override;

    // Shows only the range of heights that the ray traverses.
    void showNearRay(bool on);

  protected:
    void showSnapshot() override;
    bool outdated() const override { return duel_ && duel_->snapshot != workspace_->snapshot(); }
    void resizeEvent(QResizeEvent* event) override;
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void releaseContents() override;
    void addToMenu(QMenu& menu) override;

  private:
    void makeBar(QHBoxLayout* bar);
    void makeButtons(QHBoxLayout* bar);
    void applyFont();
    void shareRoom();  // divides the room between drawing and table
    void showLegend();
    void adopt(std::shared_ptr<const Duel> duel);
    void redraw();       // draws again for another visible part
    void redrawMarks();  // draws the marks of another moment
    void goTo(std::size_t moment);
    void showUpTo(double lambda);  // shows the ray enlarged up to lambda; 0: the whole ray
    void goToDivergence();
    void selectMoment();  // selects the moment in the table
    void leaveCloseUp();  // shows the whole ray once a run has left the enlarged part
    void followStep(int step);
    void showChoosers();
    void showVerdict();
    void showEmpty(relief::MessageId why);
    std::size_t moments() const { return duel_ ? duel_->steps.moments.size() : 0; }

    DrawingCanvas* canvas_;
    DuelModel* model_;
    QTableView* table_;
    QLabel* verdict_;
    QSplitter* split_ = nullptr;
    QLabel* own_ = nullptr;
    QToolButton* near_ = nullptr;
    QToolButton* divergence_ = nullptr;
    std::vector<QComboBox*> choosers_;
    std::shared_ptr<const Duel> duel_;
    std::vector<relief::MethodChoice> rivals_;  // of the duel that is shown or being computed
    DuelSource source_;
    ProfileOptions options_;
    ProfileFrame frame_;
    std::shared_ptr<const Drawing> relief_;
    std::shared_ptr<const Drawing> axes_;
    std::shared_ptr<const Drawing> legend_;
    std::size_t moment_ = 0;
    bool following_ = false;
    bool jump_ = false;               // go to the first divergence as soon as the duel is ready
    std::unique_ptr<LatestJob> job_;  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
