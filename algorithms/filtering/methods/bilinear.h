// bilinear: the four texels around the point. Cost: four texels per pixel. Limits: aliases where texels are smaller
// than half a pixel.
#pragma once

#include "filtering/methods/point_filter.h"

namespace relief {

class BilinearFilter final : public PointFilter<BilinearFilter> {
  public:
    using PointFilter::PointFilter;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = "bilinear";
        filter.title = "bilinear";
        filter.help = "the four texels around the point, interpolated bilinearly";
        return filter;
    }
    static constexpr int kTexels = 4;
    static constexpr auto read = &sampleBilinear;
};

}  // namespace relief
