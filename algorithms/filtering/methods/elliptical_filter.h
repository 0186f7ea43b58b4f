// elliptical: all texels in the pixel's ellipse, on a level of the mean pyramid. Heckbert 1989; [TEX]. Formulas, errors
// and cost: filtering/elliptical.h. Limits: texels that the relief hides contribute to the colour.
#pragma once

#include "base/borrowed.h"
#include "filtering/ellipse_rows.h"
#include "filtering/elliptical.h"
#include "filtering/elliptical_lanes.h"
#include "filtering/texture_filter.h"

namespace relief {

// Makes the kernel of these options, with SIMD where that supports them. tools.levels: not null. Throws Cancelled.
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

struct EllipticalFilterOptions : EllipticalOptions {
    std::string ellipse = "direct";

    static std::vector<OptionField<EllipticalFilterOptions>> fields() {
        auto all = EllipticalOptions::fieldsOf<EllipticalFilterOptions>();
        all.push_back({{"ellipse",
                        OptionKind::Choice,
                        "",
                        0,
                        1,
                        1,
                        {"direct", "iterative", "cached"},
                        "computation of footprints. direct: from the derivatives of each pixel, in double; iterative, "
                        "cached: along rows in float ([TEX]), by differences or by cached squares; slower"},
                       &EllipticalFilterOptions::ellipse});
        return all;
    }
    // Throws InputError for ellipse=cached with pixel-shaped weights, which need the pixel's orientation in its
    // ellipse.
    void check(const std::string& subject) const {
        if (ellipseForm(ellipse) != EllipseForm::Cached || !EllipticalSettings::of(*this).shaped()) return;
        const Message range(MessageId::RangeEllipse, {{"weights", weights}});
        throw InputError(subject,
                         Message(MessageId::OutOfRange, {{"what", "ellipse"}, {"value", ellipse}, {"range", range}}));
    }

    bool operator==(const EllipticalFilterOptions&) const = default;
};

class EllipticalFilter final : public TextureFilter {
  public:
    using Options = EllipticalFilterOptions;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = "elliptical";
        filter.title = "elliptical";
        filter.help = "all texels in the elliptical footprint of the pixel, weighted by the pixel model";
        filter.source = "Heckbert 1989; [TEX]";
        filter.footprint = filter.ellipse = true;
        return filter;
    }
    static std::vector<std::string> benched() {
        return {"weights=uniform", "weights=texel-distance", "", "source=table", "source=map",
                "weights=box",     "levels=exhaustive"};
    }
    static std::unique_ptr<const TextureFilter> make(const Options& options, const FilterTools& tools, MapCache&,
                                                     Work& work) {
        return std::make_unique<EllipticalFilter>(tools, ellipticalKernel(options, tools, work),
                                                  ellipseForm(options.ellipse));
    }
    EllipticalFilter(const FilterTools& tools, EllipticalKernel kernel, EllipseForm form)
        : kernel_(std::move(kernel)), scale_(tools.pictureScale()), form_(form) {}

    const FilterDescription& description() const override { return filterDescriptionOf<EllipticalFilter>(); }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work&, FootprintLog* log) const override {
        Jacobian seen = query.jacobian;
        if (form_ != EllipseForm::Direct) {
            FilterBlock block, own;
            block.push(query);
            seen = footprints(block, own)[0].jacobian;
        }
        return kernel_.filter(scaled(seen, scale_), query.place * scale_, counts, log);
    }
    void colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts, Work&) const override {
        Borrowed<FilterBlock> own;
        kernel_.filter(footprints(block, *own), scale_, colors, counts);
    }

  private:
    // Returns the block itself or, after filling it, `own` with the block's places and its footprints in this form.
    const FilterBlock& footprints(const FilterBlock& block, FilterBlock& own) const {
        if (form_ == EllipseForm::Direct) return block;
        ellipseRows(form_, block, own);
        return own;
    }

    EllipticalKernel kernel_;
    glm::dvec2 scale_;
    EllipseForm form_;
};

}  // namespace relief
