#include "filtering/texture_filter.h"

#include <algorithm>
#include <cmath>

#include "filtering/elliptical_grid.h"
#include "filtering/elliptical_rays.h"
#include "filtering/sampler.h"

namespace relief {

namespace {

// From texels of the height map to texels of the picture.
glm::dvec2 pictureScale(const ColorImage& picture, const HeightField& field) {
    return {static_cast<double>(picture.width()) / field.width(),
            static_cast<double>(picture.height()) / field.height()};
}

class PointFilter final : public TextureFilter {
  public:
    PointFilter(const FilterDescription& description, const FilterTools& tools)
        : description_(description), tools_(tools), scale_(pictureScale(*tools.picture, tools.field)) {}

    const FilterDescription& description() const override { return description_; }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work&, FootprintLog* log) const override {
        const glm::dvec2 place = query.place * scale_;
        const Address address = tools_.field.address();
        const bool nearest = description_.name == "nearest";
        counts.texels += nearest ? 1 : 4;
        const Color color = nearest ? sampleNearest(*tools_.picture, place.x, place.y, address)
                                    : sampleBilinear(*tools_.picture, place.x, place.y, address);
        if (log != nullptr) {
            log->footprint.kind = FootprintKind::Bilinear;
            log->footprint.centre = place;
            log->color = color;
        }
        return color;
    }

  private:
    const FilterDescription& description_;
    FilterTools tools_;
    glm::dvec2 scale_;
};

// The level by the longer side of the pixel's parallelogram, as graphics interfaces define it.
class TrilinearFilter final : public TextureFilter {
  public:
    TrilinearFilter(const FilterDescription& description, const FilterTools& tools)
        : description_(description), tools_(tools), scale_(pictureScale(*tools.picture, tools.field)) {}

    const FilterDescription& description() const override { return description_; }
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
    const FilterDescription& description_;
    FilterTools tools_;
    glm::dvec2 scale_;
};

class EllipticalFilter final : public TextureFilter {
  public:
    EllipticalFilter(const FilterDescription& description, const FilterTools& tools, EllipticalKernel kernel)
        : description_(description), kernel_(std::move(kernel)), scale_(pictureScale(*tools.picture, tools.field)) {}

    const FilterDescription& description() const override { return description_; }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work&, FootprintLog* log) const override {
        return kernel_.filter(scaled(query.jacobian, scale_), query.place * scale_, counts, log);
    }
    void colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts, Work&) const override {
        kernel_.filter(block, scale_, colors, counts);
    }

  private:
    const FilterDescription& description_;
    EllipticalKernel kernel_;
    glm::dvec2 scale_;
};

class VisibleFilter final : public TextureFilter {
  public:
    VisibleFilter(const FilterDescription& description, const FilterTools& tools, VisibleKernel kernel)
        : description_(description), kernel_(std::move(kernel)), scale_(pictureScale(*tools.picture, tools.field)) {}

    const FilterDescription& description() const override { return description_; }
    Color color(const FilterQuery& query, FootprintCounts& counts, Work& work, FootprintLog* log) const override {
        return kernel_.filter(scaled(query.jacobian, scale_), query.place * scale_,
                              {query.ray, query.lambda, query.place}, counts, work, log);
    }
    void colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts, Work& work) const override {
        kernel_.filter(block, scale_, colors, counts, work);
    }
    bool tracesBack() const override { return true; }

  private:
    const FilterDescription& description_;
    VisibleKernel kernel_;
    glm::dvec2 scale_;
};

template <class Kernel>
class RaysFilter final : public TextureFilter {
  public:
    RaysFilter(const FilterDescription& description, const FilterTools& tools, Kernel kernel)
        : description_(description), kernel_(std::move(kernel)), scale_(pictureScale(*tools.picture, tools.field)) {}

    const FilterDescription& description() const override { return description_; }
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
    bool asksNeighbours() const override { return std::is_same_v<Kernel, GridKernel>; }

  private:
    const FilterDescription& description_;
    Kernel kernel_;
    glm::dvec2 scale_;
};

template <class Options>
FilterDescription described(std::string name, std::string help, std::string source, bool visible) {
    FilterDescription filter{std::move(name), std::move(help), std::move(source), {}, {}, true, visible};
    MethodDescription options;
    describeOptions<Options>(options);
    filter.options = std::move(options.options);
    filter.defaults = std::move(options.defaults);
    return filter;
}

constexpr const char* kFilterSet = "--filter-set";

VisibleForm parsedForm(const std::string& text) {
    return text == "plane"      ? VisibleForm::Plane
           : text == "position" ? VisibleForm::Position
                                : VisibleForm::PositionArea;
}

}  // namespace

void TextureFilter::colors(const FilterBlock& block, std::span<Color> colors, FootprintCounts& counts,
                           Work& work) const {
    assert(colors.size() == block.size());
    for (std::size_t i = 0; i < block.size() && !work.stopped(); ++i) colors[i] = color(block[i], counts, work);
}

const std::vector<FilterDescription>& filterList() {
    static const std::vector<FilterDescription> list{
        {"nearest", "the texel that holds the point", "", {}, {}},
        {"bilinear", "the four texels around the point, weighted by closeness", "", {}, {}},
        {"trilinear",
         "two levels of the mean pyramid, by the longer side of the pixel's projection",
         "Williams 1983",
         {},
         {},
         true},
        described<EllipticalOptions>("elliptical",
                                     "all texels in the ellipse of the pixel, weighted by the pixel's own shape",
                                     "Heckbert 1989; [TEX]", false),
        described<VisibleOptions>("elliptical-visible",
                                  "the same without the texels that the relief hides from the viewer",
                                  "[ANISO17] (form=plane)", true),
        {std::string(kSupersample),
         "many rays a pixel, traced and lit one by one: the picture's truth, slow",
         "",
         {},
         {}},
    };
    return list;
}

std::vector<FilterChoice> filterForms() {
    std::vector<FilterChoice> forms;
    for (const FilterDescription& filter : filterList()) {
        FilterChoice choice;
        choice.name = filter.name;
        forms.push_back(choice);
        if (!filter.visible) continue;
        for (const OptionDescription& option : filter.options) {
            if (option.name != "form") continue;
            for (const std::string& form : option.choices) {
                if (form == filter.defaults.at(option.name)) continue;
                forms.push_back(choice);
                forms.back().options["form"] = form;
            }
        }
    }
    return forms;
}

const FilterDescription& findFilter(std::string_view name) {
    std::string known;
    for (const FilterDescription& filter : filterList()) {
        if (filter.name == name) return filter;
        known += (known.empty() ? "" : ", ") + filter.name;
    }
    throw InputError("--filter", Message(MessageId::UnknownName,
                                         {{"what", "filter"}, {"name", std::string(name)}, {"known", known}}));
}

bool needsLevels(const FilterChoice& choice) {
    return findFilter(choice.name).footprint;
}

void checkFilter(const FilterChoice& choice, const std::string& subject) {
    const FilterDescription& filter = findFilter(choice.name);
    if (filter.visible) {
        parseOptions<VisibleOptions>(filter.name, choice.options, subject);
    } else if (!filter.options.empty()) {
        parseOptions<EllipticalOptions>(filter.name, choice.options, subject);
    } else if (!choice.options.empty()) {
        throw InputError(subject, Message(MessageId::UnknownName, {{"what", "option of " + filter.name},
                                                                   {"name", choice.options.begin()->first},
                                                                   {"known", "none"}}));
    }
}

FilterChoice parseFilter(std::string_view text, const std::string& subject) {
    FilterChoice choice;
    std::size_t colon = text.find(':');
    choice.name = findFilter(text.substr(0, colon)).name;
    while (colon != std::string_view::npos) {
        text.remove_prefix(colon + 1);
        colon = text.find(':');
        const std::string_view part = text.substr(0, colon);
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos || equals == 0) {
            throw InputError(subject, Message(MessageId::NotASetting,
                                              {{"text", std::string(part)}, {"example", "elliptical:sigma=0.5"}}));
        }
        choice.options[std::string(part.substr(0, equals))] = part.substr(equals + 1);
    }
    checkFilter(choice, subject);
    return choice;
}

std::string filterText(const FilterChoice& choice) {
    std::string text = choice.name;
    for (const auto& [name, value] : choice.options) text.append(":").append(name).append("=").append(value);
    return text;
}

std::unique_ptr<const TextureFilter> makeFilter(const FilterChoice& choice, const FilterTools& tools, MapCache& maps,
                                                Work& work) {
    assert(tools.picture && !tools.picture->empty());
    const FilterDescription& filter = findFilter(choice.name == kSupersample ? "bilinear" : choice.name);
    if (!filter.footprint) return std::make_unique<PointFilter>(filter, tools);
    FilterTools ready = tools;
    if (!ready.levels) ready.levels = std::make_shared<const ColorLevels>(tools.picture, work);
    if (filter.options.empty()) return std::make_unique<TrilinearFilter>(filter, ready);
    const Address address = tools.field.address();
    const auto kernelOf = [&](const EllipticalOptions& options) {
        const EllipticalSettings settings = EllipticalSettings::of(options);
        EllipticalKernel kernel(ready.levels, address, settings);
        if (settings.implementation == Implementation::Lanes && EllipticalLanes::serves(settings)) {
            if (const auto lanes = laneLevels(*ready.levels, address, work)) {
                kernel.setLanes(std::make_shared<const EllipticalLanes>(lanes, settings));
            }
        }
        return kernel;
    };
    if (!filter.visible) {
        const auto options = parseOptions<EllipticalOptions>(filter.name, choice.options, kFilterSet);
        return std::make_unique<EllipticalFilter>(filter, ready, kernelOf(options));
    }
    const auto options = parseOptions<VisibleOptions>(filter.name, choice.options, kFilterSet);
    const bool rays = RaysKernel::serves(EllipticalSettings::of(options));
    const auto raysKernel = [&] {
        return RaysKernel(kernelOf(options), makeTracer({"max-pyramid", {}}, tools.field, maps, work), options.samples);
    };
    if (options.form == kRaysForm && rays) {
        return std::make_unique<RaysFilter<RaysKernel>>(filter, ready, raysKernel());
    }
    if (options.form == kGridForm && rays) {
        std::shared_ptr<const PackedConeHits> coneHits;
        if (tools.field.heights().size() <= PackedConeHits::kMostTexels) {
            coneHits = std::make_shared<const PackedConeHits>(tools.field, packedCones(tools.field, maps, work));
        }
        EllipticalKernel plain = kernelOf(options);
        PointReader reader(plain.sharedLevels(), address, plain.laneLevels());
        return std::make_unique<RaysFilter<GridKernel>>(
            filter, ready,
            GridKernel(std::move(plain), std::move(reader), raysKernel(),
                       makeTracer({"max-pyramid", {}}, tools.field, maps, work), std::move(coneHits), options.points));
    }
    VisibleKernel kernel(kernelOf(options), parsedForm(options.form), tools.field,
                         makeAnyHit(sightChoice(tools.field), tools.field, maps, work),
                         heightBoundsMap(tools.field, maps, work));
    kernel.setSkip(tools.skip);
    return std::make_unique<VisibleFilter>(filter, ready, std::move(kernel));
}

}  // namespace relief
