// Frames within a budget while the camera moves, and the picture itself when it rests.
//
// What a frame of a filter with regard to the relief takes most of its time for is what each pixel sees of it. Frames
// that would take longer than the budget are given with less of that: levels, each coarser than the one before:
//   0  the filter that was asked for
//   1  elliptical-visible:form=grid with 2 points a pixel instead of more
//   2  elliptical: as if nothing were hidden
// Hits, light and shadows are the picture's own on every level. The finest level is taken that, by what frames took so
// far, keeps within the budget; a finer level that was too slow is left alone for longer each time. One renderer makes
// them all: to settle where the camera has come to rest, no ray of a pixel is traced again.
#pragma once

#include <array>
#include <memory>

#include "rendering/frame.h"

namespace relief {

inline constexpr int kCoarsestFilter = 2;

// The choice on a level, [0, kCoarsestFilter]; the same as on a finer one where there is nothing to leave out.
FilterChoice coarserFilter(const FilterChoice& choice, int level);

class ProgressiveRenderer {
  public:
    // budget: seconds a frame may take; not positive: none does, and the coarsest level is taken once all are known.
    ProgressiveRenderer(std::shared_ptr<MapCache> maps, double budget) : renderer_(std::move(maps)), budget_(budget) {}

    struct Picture {
        std::shared_ptr<const Frame> frame;
        int level = 0;
        // Whether settled() would give another picture.
        bool coarse = false;
    };
    // A frame on the level that the budget allows. The same bits as FrameRenderer's with coarserFilter.
    // Throws what FrameRenderer::render throws.
    Picture moving(const FrameRequest& request, Work& work);
    // The frame that was asked for. The same bits as FrameRenderer's.
    std::shared_ptr<const Frame> settled(const FrameRequest& request, Work& work);

  private:
    // The finest level within the budget.
    int levelFor(const FilterChoice& filter, double pixels) const;
    void learn(int level, double perPixel);

    FrameRenderer renderer_;
    double budget_;
    FilterChoice filter_;
    int last_ = 0;
    int since_ = 0, wait_ = 0;  // frames since the level became coarser, and before it may become finer
    bool first_ = true;         // no frame that tells what the level takes has been made on it
    // Seconds a pixel on each level while the camera moves; 0: not known.
    std::array<double, kCoarsestFilter + 1> perPixel_{};
};

}  // namespace relief
