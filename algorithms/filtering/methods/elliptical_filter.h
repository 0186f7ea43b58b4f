// elliptical: all texels in the pixel's ellipse, of a level of the mean pyramid. Heckbert 1989; [TEX].
// Formulas, errors and cost: filtering/elliptical.h. Failure mode: colours of texels that the relief hides shine
// through.
#pragma once

#include "filtering/elliptical.h"
#include "filtering/elliptical_lanes.h"
#include "filtering/texture_filter.h"

namespace relief {

// The kernel of these options, in SIMD where that serves them.
inline EllipticalKernel ellipticalKernel(const EllipticalOptions& options, const FilterTools& tools, Work& work) {
    const EllipticalSettings settings = EllipticalSettings::of(options);
    EllipticalKernel kernel(tools.levels, tools.field.address(), settings);
    if (settings.implementation == Implementation::Lanes && EllipticalLanes::serves(settings)) {
        if (const auto lanes = laneLevels(*tools.levels, tools.field.address(), work)) {
            kernel.setLanes(std::make_shared<const EllipticalLanes>(lanes, settings));
        }
    }
    return kernel;
}

class EllipticalFilter final : public TextureFilter {
  public:
    using Options = EllipticalOptions;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = "elliptical";
        filter.help = "all texels in the ellipse of the pixel, weighted by the pixel's own shape";
        filter.source = "Heckbert 1989; [TEX]";
        filter.footprint = filter.ellipse = true;
        return filter;
    }
    static std::unique_ptr<const TextureFilter> make(const Options& options, const FilterTools& tools, MapCache&,
                                                     Work& work) {
        return std::make_unique<EllipticalFilter>(tools, ellipticalKernel(options, tools, work));
    }
    EllipticalFilter(const FilterTools& tools, EllipticalKernel kernel)
        : kernel_(std::move(kernel)), scale_(tools.pictureScale()) {}

    const FilterDescription& description() const override { return filterDescriptionOf<EllipticalFilter>(); }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work&, FootprintLog* log) const override {
        return kernel_.filter(scaled(query.jacobian, scale_), query.place * scale_, counts, log);
    }
    void colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts, Work&) const override {
        kernel_.filter(block, scale_, colors, counts);
    }

  private:
    EllipticalKernel kernel_;
    glm::dvec2 scale_;
};

}  // namespace relief
