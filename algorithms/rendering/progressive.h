// Renders frames within a time budget while the view moves, and the full picture when it rests.
//
// Frames that would take longer are simplified level by level. The first levels simplify the visibility tests of the
// filter, which take most of the time of a frame with such a filter:
// - the requested filter;
// - elliptical-visible:form=grid with 2 points per pixel instead of more;
// - elliptical, without visibility tests (in place of supersample: the default filter);
// - further levels reduce the resolution: a picture 2, 3, 4, 6, 8 times smaller.
// Hits, light and shadows are never approximated: on every level they are exactly those of a picture of that size.
// FramePace chooses the finest level that keeps within the budget by the measured frame times. All frames of the full
// size are made by one renderer, so that no ray is traced again when the camera comes to rest.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "rendering/frame.h"
#include "rendering/frame_pace.h"

namespace relief {

inline constexpr int kCoarsestFilter = 2;

// Returns the filter on a level of simplification, [0, kCoarsestFilter]; the same as on the finer level if there is
// nothing to simplify.
FilterChoice coarserFilter(const FilterChoice& choice, int level);

struct MovingLevel {
    int number = 0;  // 0: the full request
    FilterChoice filter;
    int factor = 1;  // the picture is this many times smaller
    // Estimated seconds of a frame, used until times are measured.
    double seconds = 0;
};
// Returns the wall seconds of the frame's stages on the work's threads, without the maps, which are built only once.
double pixelSeconds(const Frame& frame, Work& work);
// Returns the request with the filter and the size of a level.
FrameRequest coarserRequest(const FrameRequest& request, const MovingLevel& level);

class ProgressiveRenderer {
  public:
    // budget: seconds that a frame may take; if it is not positive, no level keeps within it and the coarsest is taken.
    ProgressiveRenderer(std::shared_ptr<MapCache> maps, double budget);

    struct Picture {
        std::shared_ptr<const FrameRequest> request;  // the request as it was drawn
        std::shared_ptr<const Frame> frame;
        std::shared_ptr<const Tracer> tracer;  // the frame's tracer
        MovingLevel level;
    };
    // Renders a frame on the level that the budget allows, with the same bits as FrameRenderer gives for
    // coarserRequest(). Throws what FrameRenderer::render throws.
    Picture moving(const FrameRequest& request, Work& work);
    // Renders the full request, with the same bits as FrameRenderer. Throws what FrameRenderer::render throws.
    Picture atRest(const FrameRequest& request, Work& work);
    // Returns the picture's frame with steps and reads.
    std::shared_ptr<const Frame> counted(const Picture& picture, Work& work);

    // The parts of moving(), for callers that do more with a frame than draw it and report the total time.
    MovingLevel levelFor(const FrameRequest& request);
    Picture draw(const FrameRequest& request, const MovingLevel& level, Work& work);
    void took(double seconds) { pace_->took(seconds); }
    // Records that a frame on this level was cancelled after this many seconds. Returns true if a coarser level comes
    // next.
    bool gaveUp(const MovingLevel& level, double seconds);
    // Returns the expected seconds of a full frame, from the measured frame times; call after levelFor().
    double fullSeconds() const { return pace_->expected(0); }
    // keep: the filter is never simplified, because its effect is what the user examines.
    void keepFilter(bool keep) { keepFilter_ = keep; }

  private:
    std::vector<MovingLevel> levels(const FrameRequest& request, bool lit) const;
    FrameRenderer& rendererOf(const MovingLevel& level) { return level.factor == 1 ? full_ : small_; }

    void forgetSmall(const FrameRequest& shown);

    std::shared_ptr<MapCache> maps_;
    FrameRenderer full_, small_;
    std::shared_ptr<const Frame> fullFrame_, smallFrame_;  // the last frames of full_ and small_
    std::optional<FrameRequest> drawn_, drawnSmall_;       // the requests last drawn by full_ and by small_
    FramePace traced_, lit_;  // for frames that trace rays; for frames that change only later stages
    FramePace* pace_;         // the one that levelFor() used last
    bool keepFilter_ = false;
};

}  // namespace relief
