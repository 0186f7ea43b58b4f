// Run time against error on the rays of an existing picture: the measurements of `relief bench tracers` for this view.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "measuring/bench/bench_tracers.h"
#include "rendering/frame.h"

namespace relief {

// Returns at most `most` rays of the frame's pixels that a polygon covers: every n-th pixel of every n-th row.
RayBlock sampledRays(const Frame& frame, std::size_t most);

// Returns a row for each method that supports the field's surface: rates as medians of rounds over all methods in turn,
// after a warm-up round; counts and errors from a separate pass. Maps come from the cache; elevation and seed are not
// set, and buildSeconds is 0. Throws Cancelled, InputError for unknown methods.
std::vector<BenchRow> benchRaysOfView(const HeightField& field, const RayBlock& rays,
                                      const std::vector<MethodChoice>& methods, int rounds, MapCache& maps, Work& work);

struct PixelPlace {
    int x = 0;
    int y = 0;
};
// Returns the pixel of the frame's view with the method's largest error relative to `exact`. A wrong outcome counts as
// larger than any error; of equal errors the one nearest to the picture's centre is taken. std::nullopt if no pixel has
// an error. Throws Cancelled.
std::optional<PixelPlace> worstPixel(const Frame& frame, const FrameRequest& request, const MethodChoice& method,
                                     MapCache& maps, Work& work);

// Histograms of the steps and errors of the rays of a frame.
struct FrameHistograms {
    static constexpr int kErrorBins = 4;  // per decade

    std::int64_t rays = 0;
    int stepWidth = 1;                // width of a bin of steps; bins begin at multiples of it
    std::vector<std::int64_t> steps;  // rays in each bin, starting at 0 steps
    double stepsMean = 0;
    std::int64_t stepsP95 = 0, stepsMost = 0;

    // Bins of error, texels: bin b begins at 10^(lowDecade + b / kErrorBins); smaller errors are counted in the first.
    int lowDecade = -3;
    std::vector<std::int64_t> before, behind;  // rays that end before or behind the exact hit
    std::int64_t exact = 0;                    // rays with the exact hit, or miss
    std::int64_t wrong = 0;                    // rays with another outcome
    double largest = 0;                        // largest finite error, texels

    // Returns the bin of a ray that ends before or behind the exact hit by this error.
    std::size_t errorBin(double texels) const;
};
// tracer: the frame's tracer. Rays are traced again to count their steps if the frame has not counted them. Throws
// Cancelled.
FrameHistograms frameHistograms(const Frame& frame, const FrameRequest& request, const Tracer& tracer, MapCache& maps,
                                Work& work);

// A bin of such histograms; `bin` is used only for parts that have bins of steps or errors.
enum class HistogramPart : std::uint8_t { Steps, Exact, Before, Behind, Wrong };
struct HistogramBin {
    HistogramPart part = HistogramPart::Steps;
    std::size_t bin = 0;
};
// Returns the pixels whose rays are in the bin, those with the most steps or largest errors first, and of equal ones
// those nearest to the picture's centre. data: must come from the same frame and tracer. Throws Cancelled.
std::vector<PixelPlace> pixelsOfBin(const Frame& frame, const FrameRequest& request, const Tracer& tracer,
                                    const FrameHistograms& data, HistogramBin bin, MapCache& maps, Work& work);

}  // namespace relief
