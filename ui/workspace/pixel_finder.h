// Goes through notable pixels, one after the other: those where the method has the largest error, takes the most steps,
// passes the surface, or disagrees with another method. The search runs on a thread of its own.
#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QString>

#include "measuring/advise/worth_seeing.h"
#include "workspace/latest_job.h"
#include "workspace/workspace.h"

namespace reliefui {

class PixelFinder : public QObject {
    Q_OBJECT
  public:
    explicit PixelFinder(Workspace* workspace, QObject* parent = nullptr);
    ~PixelFinder() override;

    // Goes to the next pixel of this kind. Starts with the first one if the picture or the kind has changed, and again
    // after the last. rival: the other method, for Worth::Disagreement.
    void next(relief::Worth worth, const relief::MethodChoice& rival);
    bool busy() const { return job_->busy(); }
    // Results of the last search, best first.
    const std::vector<relief::PixelWorth>& found() const { return found_; }

  public slots:
    // Returns false if there is no search.
    bool cancel();

  signals:
    void reported(const QString& oneLine);  // describes the chosen pixel, or gives the reason why there is none

  private:
    void choose();
    QString textOf(const relief::PixelWorth& pixel) const;

    Workspace* workspace_;
    std::shared_ptr<const relief::HitStage> hits_;  // the frame's hits that were searched
    relief::Worth worth_ = relief::Worth::Error;
    relief::MethodChoice rival_;
    std::vector<relief::PixelWorth> found_;
    std::size_t next_ = 0;
    std::unique_ptr<LatestJob> job_;  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
