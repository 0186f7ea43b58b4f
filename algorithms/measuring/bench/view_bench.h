// Run time against error on the rays of a picture that is there: what `relief bench tracers` measures, of this view.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "measuring/bench/bench_tracers.h"
#include "rendering/frame.h"

namespace relief {

// Rays of the frame's pixels that a polygon covers, at most so many of them, as evenly spread over the picture as every
// n-th pixel of every n-th row is.
RayBlock sampledRays(const Frame& frame, std::size_t most);

// A row for each method that knows the field's surface: rates as medians of rounds over all methods in turn, after one
// to warm up; counts and errors in a pass of their own. Maps come from the cache; those of `elevation` and `seed` are
// not set, buildSeconds is 0. Throws Cancelled, InputError for unknown methods.
std::vector<BenchRow> benchRaysOfView(const HeightField& field, const RayBlock& rays,
                                      const std::vector<MethodChoice>& methods, int rounds, MapCache& maps, Work& work);

struct PixelPlace {
    int x = 0;
    int y = 0;
};
// The pixel of the frame's view where this method is farthest from `exact`; a wrong outcome is farther than any error,
// of several the one nearest to the picture's centre. Nothing where it has no error at all. Throws Cancelled.
std::optional<PixelPlace> worstPixel(const Frame& frame, const FrameRequest& request, const MethodChoice& method,
                                     MapCache& maps, Work& work);

// How many steps the rays of a frame took, and how far they are off.
struct FrameHistograms {
    static constexpr int kErrorBins = 4;  // a decade

    std::int64_t rays = 0;
    int stepWidth = 1;                // of a bin of steps, which begins at a multiple of it
    std::vector<std::int64_t> steps;  // rays in each bin, from 0 steps on
    double stepsMean = 0;
    std::int64_t stepsP95 = 0, stepsMost = 0;

    // Bins of error, texels: bin b from 10^(lowDecade + b / kErrorBins); smaller errors lie in the first.
    int lowDecade = -3;
    std::vector<std::int64_t> before, behind;  // rays that end before the exact hit, and behind it
    std::int64_t exact = 0;                    // rays
    std::int64_t wrong = 0;                    // of another outcome
    double largest = 0;                        // of the finite ones

    // Of a ray that ends before or behind the exact hit.
    std::size_t errorBin(double texels) const;
};
// tracer: the frame's; rays are traced again for their steps where the frame has not counted them. Throws Cancelled.
FrameHistograms frameHistograms(const Frame& frame, const FrameRequest& request, const Tracer& tracer, MapCache& maps,
                                Work& work);

// A bin of such histograms; `bin` is of steps or errors, and means nothing for the others.
enum class HistogramPart : std::uint8_t { Steps, Exact, Before, Behind, Wrong };
struct HistogramBin {
    HistogramPart part = HistogramPart::Steps;
    std::size_t bin = 0;
};
// The pixels whose rays are in the bin, those first that take most steps or are farthest off, of equal ones those near
// the picture's centre. data: of the very frame and tracer. Throws Cancelled.
std::vector<PixelPlace> pixelsOfBin(const Frame& frame, const FrameRequest& request, const Tracer& tracer,
                                    const FrameHistograms& data, HistogramBin bin, MapCache& maps, Work& work);

}  // namespace relief
