// Base of filters that sample the texture at one point, regardless of the pixel's size.
#pragma once

#include "filtering/sampler.h"
#include "filtering/texture_filter.h"

namespace relief {

// Filter: the derived class, which must have describe(), kTexels (number of texels read) and read(picture, s, t,
// address).
template <class Filter>
class PointFilter : public TextureFilter {
  public:
    using Options = NoFilterOptions;
    static std::unique_ptr<const TextureFilter> make(const Options&, const FilterTools& tools, MapCache&, Work&) {
        return std::make_unique<Filter>(tools);
    }
    explicit PointFilter(const FilterTools& tools) : tools_(tools), scale_(tools.pictureScale()) {}

    const FilterDescription& description() const override { return filterDescriptionOf<Filter>(); }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work&, FootprintLog* log) const override {
        const glm::dvec2 place = query.place * scale_;
        counts.texels += Filter::kTexels;
        const Color color = Filter::read(*tools_.picture, place.x, place.y, tools_.field.address());
        if (log != nullptr) log->takePoint(place, color);
        return color;
    }

  private:
    FilterTools tools_;
    glm::dvec2 scale_;
};

}  // namespace relief
