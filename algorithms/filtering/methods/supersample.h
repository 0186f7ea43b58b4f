// supersample: many rays a pixel, traced and lit one by one. The renderer makes the rays (rendering/supersample.h);
// each reads the texture bilinearly. The picture's truth; cost: its samples times a picture's.
#pragma once

#include "filtering/methods/bilinear.h"

namespace relief {

struct SupersampleFilter {
    using Options = NoFilterOptions;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = kSupersample;
        filter.help = "many rays a pixel, traced and lit one by one: the picture's truth, slow";
        return filter;
    }
    // It is what the others are held against.
    static std::vector<std::string> benched() { return {}; }
    static std::vector<std::string> advised() { return {}; }
    static std::unique_ptr<const TextureFilter> make(const Options& options, const FilterTools& tools, MapCache& maps,
                                                     Work& work) {
        return BilinearFilter::make(options, tools, maps, work);
    }
};

}  // namespace relief
