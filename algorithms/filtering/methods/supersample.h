// supersample: many rays per pixel, traced and lit one by one. The renderer makes the rays (rendering/supersample.h);
// each samples the texture bilinearly. This is the ground truth for the other filters. Cost: the number of samples
// times that of a picture.
#pragma once

#include "filtering/methods/bilinear.h"

namespace relief {

struct SupersampleFilter {
    using Options = NoFilterOptions;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = kSupersample;
        filter.title = "supersampling";
        filter.help = "many rays per pixel, each traced and lit by itself; the reference for pictures, slow";
        return filter;
    }
    // Not measured, because the other filters are compared with it.
    static std::vector<std::string> benched() { return {}; }
    static std::vector<std::string> advised() { return {}; }
    static std::unique_ptr<const TextureFilter> make(const Options& options, const FilterTools& tools, MapCache& maps,
                                                     Work& work) {
        return BilinearFilter::make(options, tools, maps, work);
    }
};

}  // namespace relief
