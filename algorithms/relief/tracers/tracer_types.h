// The explicit list of methods, one per line. A method is a type with
//     describe(), Options with fields(), make(field, options, maps, work),
//     trace(ray, sink), field(), bytes() of its maps, stepBound(ray);
// and optional members, which tracers.cpp detects: traceSegment() with segmentRecords(), to work inside `hybrid`;
// traceSimd(), the SIMD version, with simdWith() and hasSimdMap() where that depends on options and maps;
// traceSegmentsSimd(), that of traceSegment(), with segmentsInSimd(); formNote(), a sentence on what has no SIMD
// version and why; guarantee(), mesh(), pyramidWalk(). trace() returns Miss for a ray that is not finite, and otherwise
// only under border. Its log ends with the decision that is the outcome, has at most stepBound(ray) records, and all
// its numbers are finite.
#pragma once

#include <tuple>

#include "relief/methods/bump.h"
#include "relief/methods/cone.h"
#include "relief/methods/cone_dummer.h"
#include "relief/methods/cone_robust.h"
#include "relief/methods/displacement.h"
#include "relief/methods/distance.h"
#include "relief/methods/distance_conservative.h"
#include "relief/methods/distance_refined.h"
#include "relief/methods/distance_refined_sampled.h"
#include "relief/methods/exact.h"
#include "relief/methods/flat.h"
#include "relief/methods/layers.h"
#include "relief/methods/max_pyramid.h"
#include "relief/methods/max_pyramid_paper.h"
#include "relief/methods/normal_map.h"
#include "relief/methods/offset.h"
#include "relief/methods/offset_limited.h"
#include "relief/methods/relaxed_cone.h"
#include "relief/methods/relaxed_cone_robust.h"
#include "relief/tracers/hybrid.h"

namespace relief {

using TracerTypes = std::tuple<    //
    ExactTracer,                   //
    MaxPyramidTracer,              //
    MaxPyramidPaperTracer,         //
    OffsetTracer,                  //
    OffsetLimitedTracer,           //
    LayersTracer,                  //
    LayersSecantTracer,            //
    LayersBisectionTracer,         //
    ConeTracer,                    //
    ConeDummerTracer,              //
    ConeRobustTracer,              //
    RelaxedConeTracer,             //
    RelaxedConeRobustTracer,       //
    DistanceTracer,                //
    DistanceConservativeTracer,    //
    DistanceRefinedSampledTracer,  //
    DistanceRefinedTracer,         //
    HybridTracer,                  //
    FlatTracer,                    //
    BumpTracer,                    //
    NormalMapTracer,               //
    DisplacementTracer>;

}  // namespace relief
