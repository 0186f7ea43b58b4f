#include "workspace/pixel_finder.h"

#include <algorithm>
#include <cmath>

#include "rendering/base_level.h"
#include "scenario/variation.h"

namespace reliefui {

namespace {

constexpr std::size_t kMost = 24;  // largest number of pixels found
constexpr int kApart = 40;         // minimum distance of two pixels is the picture's width divided by this,
constexpr int kLeastApart = 4;     // but at least this, in pixels

QString nameOf(const relief::MethodChoice& method) {
    return QString::fromStdString(relief::variationText(relief::CompareSubject::Methods, method));
}

std::vector<float> valuesOf(const Snapshot& snapshot, relief::Worth worth, const relief::MethodChoice& rival,
                            relief::Work& work) {
    using relief::Worth;
    const relief::Frame& frame = *snapshot.frame;
    switch (worth) {
        case Worth::Steps:
            return relief::stepWorth(frame, *snapshot.tracer, work);
        case Worth::Disagreement: {
            const auto method = relief::methodOfView(*snapshot.request, rival);
            const auto tracer = relief::makeTracer(method, snapshot.request->field, *snapshot.maps, work);
            return relief::disagreement(frame, *tracer, work);
        }
        default:
            break;
    }
    const relief::ErrorLayer errors = relief::errorAgainstExact(frame, *snapshot.request, *snapshot.maps, work);
    return relief::errorWorth(worth, frame, errors);
}

}  // namespace

PixelFinder::PixelFinder(Workspace* workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
    LatestJob::Listener listener;
    listener.failed = [this](const QString& problem) {
        if (!problem.isEmpty()) return Q_EMIT workspace_->problem(problem);
        Q_EMIT reported(tr("The search was cancelled"));
    };
    listener.progress = [](const QString&, double) {};
    job_ = std::make_unique<LatestJob>(this, std::move(listener));
}

PixelFinder::~PixelFinder() = default;

bool PixelFinder::cancel() {
    return job_->cancel();
}

void PixelFinder::next(relief::Worth worth, const relief::MethodChoice& rival) {
    const auto snapshot = workspace_->snapshot();
    if (!snapshot || !snapshot->frame || snapshot->coarse) {
        Q_EMIT reported(tr("The picture is not complete yet"));
        return;
    }
    const bool same =
        hits_ == snapshot->frame->hits && worth_ == worth && (worth != relief::Worth::Disagreement || rival_ == rival);
    if (same) return choose();
    auto made = std::make_shared<std::vector<relief::PixelWorth>>();
    const int apart = std::max(kLeastApart, snapshot->frame->width / kApart);
    const auto work = [=](relief::Work& w) {
        *made = relief::largestApart(valuesOf(*snapshot, worth, rival, w), snapshot->frame->width, apart, kMost);
    };
    const auto done = [=, this] {
        hits_ = snapshot->frame->hits;
        worth_ = worth;
        rival_ = rival;
        found_ = *made;
        next_ = 0;
        choose();
    };
    Q_EMIT reported(tr("Searching for pixels …"));
    job_->start({work, done});
}

void PixelFinder::choose() {
    if (found_.empty()) {
        const QString none[] = {
            tr("Every hit is the exact one"), tr("No ray takes a step"), tr("No ray goes past the surface"),
            tr("%1 and %2 agree everywhere").arg(nameOf(workspace_->scenario().method), nameOf(rival_))};
        Q_EMIT reported(none[static_cast<std::size_t>(worth_)]);
        return;
    }
    const relief::PixelWorth& pixel = found_[next_ % found_.size()];
    workspace_->finishInteraction();
    workspace_->choosePixel(pixel.x, pixel.y);
    workspace_->finishInteraction();
    Q_EMIT reported(tr("%1 of %2: pixel (%3, %4), %5")
                        .arg(next_ % found_.size() + 1)
                        .arg(found_.size())
                        .arg(pixel.x)
                        .arg(pixel.y)
                        .arg(textOf(pixel)));
    ++next_;
}

QString PixelFinder::textOf(const relief::PixelWorth& pixel) const {
    if (worth_ == relief::Worth::Steps) return tr("steps: %1").arg(pixel.value);
    if (std::isinf(pixel.value)) {
        return worth_ == relief::Worth::Disagreement ? tr("outcome differs from that of %1").arg(nameOf(rival_))
                                                     : tr("another outcome");
    }
    const QString texels = QString::fromStdString(relief::numberText(pixel.value, 3));
    if (worth_ == relief::Worth::Disagreement) {
        return tr("%1 texels from %2").arg(texels, nameOf(rival_));
    }
    return worth_ == relief::Worth::Overshoot ? tr("%1 texels past the surface").arg(texels)
                                              : tr("%1 texels from the exact hit").arg(texels);
}

}  // namespace reliefui
