// tent: the texels around the point, weighted by closeness, up to a distance of `reach` texels; reach 1: bilinear.
// An external filter, only in the lists of the tests' own programs.
// Cost: (2 reach)^2 texels. Failure mode: blurs near ground, aliases distant ground.
#pragma once

#include <cmath>

#include <glm/common.hpp>

#include "filtering/sampler.h"
#include "filtering/texture_filter.h"

namespace relief {

class TentFilter final : public TextureFilter {
  public:
    struct Options {
        int reach = 2;

        static std::vector<OptionField<Options>> fields() {
            return {{{"reach", OptionKind::Integer, "texels", 1, 8, 1, {}, "how far a texel counts"}, &Options::reach}};
        }
    };
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = "tent";
        filter.title = "tent";
        filter.help = "the texels round the point, weighted by closeness";
        filter.source = "a guest";
        return filter;
    }
    static std::unique_ptr<const TextureFilter> make(const Options& options, const FilterTools& tools, MapCache&,
                                                     Work&) {
        return std::make_unique<TentFilter>(tools, options.reach);
    }
    TentFilter(const FilterTools& tools, int reach) : tools_(tools), scale_(tools.pictureScale()), reach_(reach) {}

    const FilterDescription& description() const override { return filterDescriptionOf<TentFilter>(); }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work&, FootprintLog* log) const override {
        const glm::dvec2 place = query.place * scale_;
        const glm::dvec2 first = glm::floor(place - 0.5) - (reach_ - 1.0);
        Color sum(0);
        double weights = 0;
        for (int j = 0; j < 2 * reach_; ++j) {
            for (int i = 0; i < 2 * reach_; ++i) {
                const glm::dvec2 texel = first + glm::dvec2(i, j) + 0.5;
                const glm::dvec2 weight = 1.0 - glm::abs(texel - place) / static_cast<double>(reach_);
                if (weight.x <= 0 || weight.y <= 0) continue;
                const double product = weight.x * weight.y;
                const Address address = tools_.field.address();
                sum += static_cast<float>(product) * sampleNearest(*tools_.picture, texel.x, texel.y, address);
                weights += product;
                if (log != nullptr) {
                    const auto at = [&](double x, int size) {
                        return addressIndex(static_cast<std::int64_t>(std::floor(x)), size, address);
                    };
                    log->texels.push_back({at(texel.x, tools_.picture->width()), at(texel.y, tools_.picture->height()),
                                           0, texel.x, texel.y, Color(static_cast<float>(product))});
                }
                ++counts.texels;
            }
        }
        const Color color = sum / static_cast<float>(weights);
        if (log != nullptr) log->takePoint(place, color);
        return color;
    }

  private:
    FilterTools tools_;
    glm::dvec2 scale_;
    int reach_;
};

}  // namespace relief
