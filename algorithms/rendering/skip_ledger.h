// Two ledgers of the work that a frame skipped, how much of it and why. Lossless: the picture has the same bits as
// without skipping (FrameRequest::skip). Bounded: an approximation that is off by default (FrameRequest::bounded), with
// its measured error.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "relief/messages.h"
#include "rendering/frame.h"

namespace relief {

enum class Ledger : std::uint8_t { Lossless, Bounded };

struct SkipRow {
    Ledger ledger = Ledger::Lossless;
    std::string name;  // a stable key, such as "flat-ground"
    double count = 0;  // number of items not computed
    double of = 0;     // total number of items
    Message what;
    Message why;
};

// Returns the rows for which this frame has counts, including zeros, in the order of the stages. Stages that were
// reused as a whole have no rows of their own.
std::vector<SkipRow> skipLedger(const Frame& frame, const FrameRequest& request);

// Errors caused by bounded skipping, over the pixels that it skipped.
struct BoundedError {
    std::int64_t rays = 0;
    double rayMean = 0;  // texels, as in the error layer
    double rayMax = 0;
    std::int64_t wrongOutcomes = 0;
    std::int64_t footprints = 0;
    double colorMean = 0;  // largest difference of a channel, linear light
    double colorMax = 0;
};

// Accumulates the errors over the parts of a picture (FrameRenderer::picture()).
class BoundedSums {
  public:
    // Traces and filters the skipped pixels again, in full; ray errors are relative to an exact tracer. Throws
    // Cancelled.
    void add(const Frame& part, const FrameRequest& request, MapCache& maps, Work& work);
    BoundedError error() const;

  private:
    void addRays(const Frame& part, const FrameRequest& request, MapCache& maps, Work& work);

    BoundedError error_;  // its means hold sums until they are divided
};

// Returns the errors of a whole frame. Throws Cancelled.
BoundedError measureBounded(const Frame& frame, const FrameRequest& request, MapCache& maps, Work& work);

}  // namespace relief
