// Frames within a budget while something moves, and the picture itself when it rests.
//
// Frames that would take longer are given with less, level by level. First of what each pixel sees of the relief, which
// is what a frame of a filter with regard to it takes most of its time for:
//   the filter that was asked for;
//   elliptical-visible:form=grid with 2 points a pixel instead of more;
//   elliptical, as if nothing were hidden (the plain filter in the place of supersample);
// then of the pixels: a picture 2, 3, 4, 6, 8 times smaller. Hits, light and shadows are the picture's own on every
// level. Which one, FramePace decides: the finest that keeps within the budget by what frames took so far. Frames of
// the picture's size are made by one renderer: to settle where the camera has come to rest, no ray is traced again.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "rendering/frame.h"
#include "rendering/frame_pace.h"

namespace relief {

inline constexpr int kCoarsestFilter = 2;

// The choice on a level of the filter, [0, kCoarsestFilter]; the same as on a finer one where there is nothing to leave
// out.
FilterChoice coarserFilter(const FilterChoice& choice, int level);

struct MovingLevel {
    int number = 0;  // 0: what was asked for
    FilterChoice filter;
    int factor = 1;  // times smaller is the picture
    // Of a frame, where nothing has been measured.
    double seconds = 0;
};
// Of a frame's stages, on so many threads: without the maps, which are made once.
double pixelSeconds(const Frame& frame, Work& work);
FrameRequest coarserRequest(const FrameRequest& request, const MovingLevel& level);

class ProgressiveRenderer {
  public:
    // budget: seconds a frame may take; not positive: none does, and the coarsest level is taken.
    ProgressiveRenderer(std::shared_ptr<MapCache> maps, double budget);

    struct Picture {
        std::shared_ptr<const FrameRequest> request;  // as it was drawn
        std::shared_ptr<const Frame> frame;
        std::shared_ptr<const Tracer> tracer;  // of the frame
        MovingLevel level;
    };
    // A frame on the level that the budget allows. The same bits as FrameRenderer's of coarserRequest().
    // Throws what FrameRenderer::render throws.
    Picture moving(const FrameRequest& request, Work& work);
    // The frame that was asked for. The same bits as FrameRenderer's.
    Picture settled(const FrameRequest& request, Work& work);
    // The picture's frame with steps and reads.
    std::shared_ptr<const Frame> counted(const Picture& picture, Work& work);

    // What moving() is made of, for who does more with a frame than draw it and says what all that took.
    MovingLevel levelFor(const FrameRequest& request);
    Picture draw(const FrameRequest& request, const MovingLevel& level, Work& work);
    void took(double seconds) { pace_->took(seconds); }
    // A frame on this level was given up after so long. Whether a coarser one comes next.
    bool gaveUp(const MovingLevel& level, double seconds);
    // What the frame itself takes, by what frames took so far; after levelFor().
    double fullSeconds() const { return pace_->expected(0); }
    // What is looked at is what the filter does: it is not left out.
    void keepFilter(bool keep) { keepFilter_ = keep; }

  private:
    std::vector<MovingLevel> levels(const FrameRequest& request, bool lit) const;
    FrameRenderer& rendererOf(const MovingLevel& level) { return level.factor == 1 ? full_ : small_; }

    void forgetSmall(const FrameRequest& shown);

    std::shared_ptr<MapCache> maps_;
    FrameRenderer full_, small_;
    std::shared_ptr<const Frame> fullFrame_, smallFrame_;  // that they made last
    std::optional<FrameRequest> drawn_, drawnSmall_;       // by full_, by small_
    FramePace traced_, lit_;                               // where rays are traced; where only what follows changes
    FramePace* pace_;                                      // that was asked last
    bool keepFilter_ = false;
};

}  // namespace relief
