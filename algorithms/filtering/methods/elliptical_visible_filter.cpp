#include "filtering/methods/elliptical_visible_filter.h"

#include "filtering/elliptical_grid.h"
#include "filtering/elliptical_rays.h"
#include "filtering/methods/elliptical_filter.h"

namespace relief {

namespace {

class VisibleFilter final : public TextureFilter {
  public:
    VisibleFilter(const FilterTools& tools, VisibleKernel kernel)
        : kernel_(std::move(kernel)), scale_(tools.pictureScale()) {}

    const FilterDescription& description() const override { return filterDescriptionOf<EllipticalVisible>(); }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work& work, FootprintLog* log) const override {
        return kernel_.filter(scaled(query.jacobian, scale_), query.place * scale_,
                              {query.ray, query.lambda, query.place}, counts, work, log);
    }
    void colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts, Work& work) const override {
        kernel_.filter(block, scale_, colors, counts, work);
    }
    bool tracesBack() const override { return true; }

  private:
    VisibleKernel kernel_;
    glm::dvec2 scale_;
};

template <class Kernel>
class RaysFilter final : public TextureFilter {
  public:
    RaysFilter(const FilterTools& tools, Kernel kernel) : kernel_(std::move(kernel)), scale_(tools.pictureScale()) {}

    const FilterDescription& description() const override { return filterDescriptionOf<EllipticalVisible>(); }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work& work, FootprintLog* log) const override {
        FilterBlock block;
        block.push(query);
        Color color(0);
        kernel_.filter(block, scale_, {&color, 1}, counts, work, log);
        return color;
    }
    void colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts, Work& work) const override {
        kernel_.filter(block, scale_, colors, counts, work);
    }
    bool readsNeighbours() const override { return std::is_same_v<Kernel, GridKernel>; }

  private:
    Kernel kernel_;
    glm::dvec2 scale_;
};

VisibleForm parsedForm(const std::string& text) {
    return text == "plane"      ? VisibleForm::Plane
           : text == "position" ? VisibleForm::Position
                                : VisibleForm::PositionArea;
}

}  // namespace

std::unique_ptr<const TextureFilter> EllipticalVisible::make(const Options& options, const FilterTools& tools,
                                                             MapCache& maps, Work& work) {
    const bool rays = RaysKernel::serves(EllipticalSettings::of(options));
    const auto raysKernel = [&] {
        return RaysKernel(ellipticalKernel(options, tools, work),
                          makeTracer({"max-pyramid", {}}, tools.field, maps, work), options.samples);
    };
    if (options.form == kRaysForm && rays) {
        return std::make_unique<RaysFilter<RaysKernel>>(tools, raysKernel());
    }
    if (options.form == kGridForm && rays) {
        std::shared_ptr<const PackedConeHits> coneHits;
        if (tools.field.tiles() == nullptr && tools.field.texels() <= PackedConeHits::kMostTexels) {
            coneHits = std::make_shared<const PackedConeHits>(tools.field, packedCones(tools.field, maps, work));
        }
        EllipticalKernel plain = ellipticalKernel(options, tools, work);
        PointReader reader(plain.sharedLevels(), tools.field.address(), plain.laneLevels());
        return std::make_unique<RaysFilter<GridKernel>>(
            tools,
            GridKernel(std::move(plain), std::move(reader), raysKernel(),
                       makeTracer({"max-pyramid", {}}, tools.field, maps, work), std::move(coneHits), options.points));
    }
    VisibleKernel kernel(ellipticalKernel(options, tools, work), parsedForm(options.form), tools.field,
                         makeAnyHit(visibilityChoice(tools.field), tools.field, maps, work),
                         heightBoundsMap(tools.field, maps, work));
    kernel.setSkip(tools.skip);
    return std::make_unique<VisibleFilter>(tools, std::move(kernel));
}

}  // namespace relief
