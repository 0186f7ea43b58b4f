// trilinear: interpolation between two levels of the mean pyramid. Williams 1983. The level is chosen by the longer
// side of the pixel's parallelogram, as graphics APIs define it. Cost: eight texels per pixel. Limits: blurs where the
// pixel's projection is long and narrow.
#pragma once

#include <algorithm>
#include <cmath>

#include "filtering/texture_filter.h"

namespace relief {

class TrilinearFilter final : public TextureFilter {
  public:
    using Options = NoFilterOptions;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = "trilinear";
        filter.title = "trilinear";
        filter.help = "two levels of the mean pyramid, chosen by the longer side of the pixel's projection";
        filter.source = "Williams 1983";
        filter.footprint = true;
        return filter;
    }
    static std::unique_ptr<const TextureFilter> make(const Options&, const FilterTools& tools, MapCache&, Work&) {
        return std::make_unique<TrilinearFilter>(tools);
    }
    explicit TrilinearFilter(const FilterTools& tools) : tools_(tools), scale_(tools.pictureScale()) {}

    const FilterDescription& description() const override { return filterDescriptionOf<TrilinearFilter>(); }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work&, FootprintLog* log) const override {
        const Jacobian j = scaled(query.jacobian, scale_);
        const double side = std::max(std::hypot(j.ux, j.vx), std::hypot(j.uy, j.vy));
        const double level = side > 1 ? std::log2(side) : 0;
        const Color color = tools_.levels->trilinear(level, query.place * scale_, tools_.field.address());
        counts.texels += level > 0 && level < tools_.levels->top() ? 8 : 4;
        if (log != nullptr) {
            log->footprint.kind = FootprintKind::Bilinear;
            log->footprint.level = static_cast<int>(std::min<double>(level, tools_.levels->top()));
            log->footprint.centre = query.place * scale_ * std::ldexp(1.0, -log->footprint.level);
            log->color = color;
        }
        return color;
    }

  private:
    FilterTools tools_;
    glm::dvec2 scale_;
};

}  // namespace relief
