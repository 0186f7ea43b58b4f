// The explicit list of filters: one line each. A filter is a type with describe(), Options and make()
// (filtering/methods/nearest.h is short). One
// that logs no texels (FootprintLog) is drawn as four texels at the point: log them where others are read.
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
