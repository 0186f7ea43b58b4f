// bilinear: the four texels around the point. Cost: four texels a pixel. Failure mode: aliases where texels are smaller
// than half a pixel.
#pragma once

#include "filtering/sampler.h"
#include "filtering/texture_filter.h"

namespace relief {

class BilinearFilter final : public TextureFilter {
  public:
    using Options = NoFilterOptions;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = "bilinear";
        filter.help = "the four texels around the point, weighted by closeness";
        return filter;
    }
    static std::unique_ptr<const TextureFilter> make(const Options&, const FilterTools& tools, MapCache&, Work&) {
        return std::make_unique<BilinearFilter>(tools);
    }
    explicit BilinearFilter(const FilterTools& tools) : tools_(tools), scale_(tools.pictureScale()) {}

    const FilterDescription& description() const override { return filterDescriptionOf<BilinearFilter>(); }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work&, FootprintLog* log) const override {
        const glm::dvec2 place = query.place * scale_;
        counts.texels += 4;
        const Color color = sampleBilinear(*tools_.picture, place.x, place.y, tools_.field.address());
        if (log != nullptr) log->takePoint(place, color);
        return color;
    }

  private:
    FilterTools tools_;
    glm::dvec2 scale_;
};

}  // namespace relief
