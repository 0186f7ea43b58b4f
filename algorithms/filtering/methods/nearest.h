// nearest: the texel that holds the point. Cost: one texel a pixel. Failure mode: aliases wherever texels are smaller
// than pixels.
#pragma once

#include "filtering/sampler.h"
#include "filtering/texture_filter.h"

namespace relief {

class NearestFilter final : public TextureFilter {
  public:
    using Options = NoFilterOptions;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = "nearest";
        filter.help = "the texel that holds the point";
        return filter;
    }
    static std::unique_ptr<const TextureFilter> make(const Options&, const FilterTools& tools, MapCache&, Work&) {
        return std::make_unique<NearestFilter>(tools);
    }
    explicit NearestFilter(const FilterTools& tools) : tools_(tools), scale_(tools.pictureScale()) {}

    const FilterDescription& description() const override { return filterDescriptionOf<NearestFilter>(); }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work&, FootprintLog* log) const override {
        const glm::dvec2 place = query.place * scale_;
        counts.texels += 1;
        const Color color = sampleNearest(*tools_.picture, place.x, place.y, tools_.field.address());
        if (log != nullptr) log->takePoint(place, color);
        return color;
    }

  private:
    FilterTools tools_;
    glm::dvec2 scale_;
};

}  // namespace relief
