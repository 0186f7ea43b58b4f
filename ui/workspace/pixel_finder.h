// Goes to the pixels that are worth looking at, one after the other: where the method is farthest from exact, takes the
// most steps, goes past the surface, or disagrees with another method. Found on a thread of its own.
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

    // The next pixel of this kind; the first one when picture or kind are others than before, and after the last.
    // rival: of the disagreement, a method beside the scenario's own.
    void next(relief::Worth worth, const relief::MethodChoice& rival);
    bool busy() const { return job_->busy(); }
    // Of the kind that was looked for last, best first.
    const std::vector<relief::PixelWorth>& found() const { return found_; }

  public slots:
    void cancel();

  signals:
    void said(const QString& oneLine);  // which pixel that is, or that there is none

  private:
    void choose();
    QString textOf(const relief::PixelWorth& pixel) const;

    Workspace* workspace_;
    std::shared_ptr<const relief::HitStage> hits_;  // that were looked through
    relief::Worth worth_ = relief::Worth::Error;
    relief::MethodChoice rival_;
    std::vector<relief::PixelWorth> found_;
    std::size_t next_ = 0;
    std::unique_ptr<LatestJob> job_;  // last: ends before the rest
};

}  // namespace reliefui
