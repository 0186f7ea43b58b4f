// What a frame did not compute, how much of it, and why: two ledgers. Lossless: the picture has the same bits as
// without skipping (FrameRequest::skip). Bounded: off unless asked for (FrameRequest::bounded), with the error
// measured.
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
    double count = 0;  // not computed ...
    double of = 0;     // ... of so many
    Message what;
    Message why;
};

// The rows that this frame has counts of, zeros among them; in the order of the stages. Stages that were kept whole
// have none of their own.
std::vector<SkipRow> skipLedger(const Frame& frame, const FrameRequest& request);

// What the bounded ledger cost, over the pixels that it skipped.
struct BoundedError {
    std::int64_t rays = 0;
    double rayMean = 0;  // texels, as the error layer measures
    double rayMax = 0;
    std::int64_t wrongOutcomes = 0;
    std::int64_t footprints = 0;
    double colorMean = 0;  // largest difference of a channel, linear light
    double colorMax = 0;
};

// Sums the errors over the parts of a picture (FrameRenderer::picture()).
class BoundedSums {
  public:
    // Traces and filters the skipped pixels once more, in full; ray errors are against an exact tracer. Throws
    // Cancelled.
    void add(const Frame& part, const FrameRequest& request, MapCache& maps, Work& work);
    BoundedError error() const;

  private:
    void addRays(const Frame& part, const FrameRequest& request, MapCache& maps, Work& work);

    BoundedError error_;  // its means: sums
};

// The same of a whole frame.
BoundedError measureBounded(const Frame& frame, const FrameRequest& request, MapCache& maps, Work& work);

}  // namespace relief
