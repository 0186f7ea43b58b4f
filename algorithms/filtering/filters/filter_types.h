// The explicit list of filters, one per line. A filter is a type with describe(), Options and make(), such as
// TrilinearFilter. The footprint pane draws a filter that logs no texels (FootprintLog) as one that samples the four
// texels at the point, so a filter that samples other texels must log them.
#pragma once

#include <tuple>

#include "filtering/methods/bilinear.h"
#include "filtering/methods/elliptical_filter.h"
#include "filtering/methods/elliptical_visible_filter.h"
#include "filtering/methods/nearest.h"
#include "filtering/methods/supersample.h"
#include "filtering/methods/trilinear.h"

namespace relief {

using FilterTypes = std::tuple<  //
    NearestFilter,               //
    BilinearFilter,              //
    TrilinearFilter,             //
    EllipticalFilter,            //
    EllipticalVisible,           //
    SupersampleFilter>;

}  // namespace relief
