// nearest: the texel that contains the point. Cost: one texel per pixel. Limits: aliases wherever texels are smaller
// than pixels.
#pragma once

#include "filtering/methods/point_filter.h"

namespace relief {

class NearestFilter final : public PointFilter<NearestFilter> {
  public:
    using PointFilter::PointFilter;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = "nearest";
        filter.title = "nearest texel";
        filter.help = "the texel that holds the point";
        return filter;
    }
    static constexpr int kTexels = 1;
    static constexpr auto read = &sampleNearest;
};

}  // namespace relief
