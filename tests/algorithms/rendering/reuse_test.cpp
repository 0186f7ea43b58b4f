// Data reused between pictures never affect them: after a change of any single input, with any filter and any method
// that reuses data, the frame has the bits of a newly rendered one.
#include <functional>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "rendering/frame.h"

namespace relief::test {
namespace {

using Change = std::function<void(FrameRequest&)>;

std::shared_ptr<const ColorImage> colors(std::uint64_t seed) {
    Random random(seed);
    ColorImage image(24, 20);
    for (Color& color : image.pixels()) {
        color = Color(static_cast<float>(random.unit()), static_cast<float>(random.unit()), 0.5F);
    }
    return std::make_shared<ColorImage>(std::move(image));
}

Heights relief(const std::string& name, int width = 24, int height = 20) {
    return share(makeRelief(name, width, height, 1));
}

Heights oneTexelHigher(const Heights& heights) {
    FloatImage image = *heights;
    image(12, 10) = 1 - 0.5F * image(12, 10);
    return share(std::move(image));
}

FrameRequest request() {
    FrameRequest request(HeightField(relief("bricks"), Surface::Bilinear, Address::Repeat, 0.3));
    request.width = 32;
    request.height = 24;
    request.camera.elevation = 25;
    request.color = colors(1);
    request.shadows = true;
    return request;
}

// A change of one property of the height field.
Change fieldWith(const std::function<HeightField(const HeightField&)>& changed) {
    return [changed](FrameRequest& r) { r.field = changed(r.field); };
}
Change heightsOf(const Heights& heights) {
    return fieldWith(
        [heights](const HeightField& f) { return HeightField(heights, f.surface(), f.address(), f.reliefDepth()); });
}

// Other values for every field of a request, one field at a time.
std::multimap<std::string, Change> changes() {
    // If a field is added to the request, this fails to compile: add other values for it below.
    [[maybe_unused]] const auto& [width, height, field, method, color, normals, filter, scene, camera, light, shadows,
                                  counts, mapping, skip, bounded, sky, sample, margin] = request();
    const std::set<std::string> names{"width",   "height", "field",   "method", "color",   "normals",
                                      "filter",  "scene",  "camera",  "light",  "shadows", "counts",
                                      "mapping", "skip",   "bounded", "sky",    "sample",  "margin"};
    std::multimap<std::string, Change> all{
        {"width", [](FrameRequest& r) { r.width = 29; }},
        {"height", [](FrameRequest& r) { r.height = 27; }},
        {"field", fieldWith([](const HeightField& f) {
             return HeightField(f.sharedHeights(), Surface::Columns, f.address(), f.reliefDepth());
         })},
        {"field", fieldWith([](const HeightField& f) {
             return HeightField(f.sharedHeights(), f.surface(), Address::Clamp, f.reliefDepth());
         })},
        {"field", fieldWith([](const HeightField& f) {
             return HeightField(f.sharedHeights(), f.surface(), Address::Border, f.reliefDepth());
         })},
        {"field", fieldWith([](const HeightField& f) {
             return HeightField(f.sharedHeights(), f.surface(), f.address(), 0.11);
         })},
        {"field", heightsOf(relief("spikes"))},
        {"field", heightsOf(constantHeights(24, 20, 1))},
        {"field", heightsOf(constantHeights(24, 20, 0.25F))},
        {"field", heightsOf(relief("bricks", 20, 24))},
        {"field", heightsOf(oneTexelHigher(relief("bricks")))},
        {"method", [](FrameRequest& r) { r.method.name = "layers"; }},
        {"method", [](FrameRequest& r) { r.method.options["base"] = "2"; }},
        {"color", [](FrameRequest& r) { r.color = colors(2); }},
        {"color", [](FrameRequest& r) { r.color = nullptr; }},
        {"normals",
         [](FrameRequest& r) { r.normals = std::make_shared<Image<glm::vec3>>(4, 4, glm::vec3(0.6F, 0, 0.8F)); }},
        {"filter",
         [](FrameRequest& r) {
             r.filter.name = r.filter.name == "nearest" ? "trilinear" : "nearest";
             r.filter.options.clear();
         }},
        {"filter", [](FrameRequest& r) { r.filter.samples = 3; }},
        {"filter",
         [](FrameRequest& r) {
             r.filter = {"elliptical", {{"ellipse", "cached"}}};
         }},
        {"filter",
         [](FrameRequest& r) {
             r.filter = {"elliptical", {{"ellipse", "iterative"}}};
         }},
        {"scene", [](FrameRequest& r) { r.scene = SceneKind::Wall; }},
        {"scene", [](FrameRequest& r) { r.scene = SceneKind::Cube; }},
        {"camera", [](FrameRequest& r) { r.camera.azimuth += 40; }},
        {"camera", [](FrameRequest& r) { r.camera.elevation = 70; }},
        {"light", [](FrameRequest& r) { r.light.elevation = 12; }},
        {"light", [](FrameRequest& r) { r.light.azimuth += 90; }},
        {"light", [](FrameRequest& r) { r.light.ambient = 0.5; }},
        {"light", [](FrameRequest& r) { r.light.intensity = 0.5; }},
        {"shadows", [](FrameRequest& r) { r.shadows = false; }},
        {"counts", [](FrameRequest& r) { r.counts = true; }},
        {"mapping", [](FrameRequest& r) { r.mapping.variant = RowVariant::Affine; }},
        {"mapping",
         [](FrameRequest& r) {
             r.mapping = {RowVariant::Subspan, 16, 5};
         }},
        {"skip", [](FrameRequest& r) { r.skip = false; }},
        {"bounded", [](FrameRequest& r) { r.bounded = kMaxBounded; }},
        {"sky", [](FrameRequest& r) { r.sky = Color(1, 0, 1); }},
        {"sample",
         [](FrameRequest& r) {
             r.sample = {0.1, 0.8};
         }},
        {"margin", [](FrameRequest& r) { r.margin = 2; }},
    };
    for (const std::string& name : names) EXPECT_GT(all.count(name), 0U) << name;
    for (const auto& [name, change] : all) EXPECT_EQ(names.count(name), 1U) << name;
    return all;
}

bool sameFrame(const Frame& a, const Frame& b) {
    if (!(a.light->color == b.light->color) || !(a.color->color == b.color->color)) return false;
    for (std::size_t i = 0; i < a.hits->hits.size(); ++i) {
        if (!sameBits(a.hits->hits[i], b.hits->hits[i])) return false;
    }
    // Counts made earlier may be kept.
    const bool counted = a.hits->counted() && b.hits->counted();
    return a.hits->hits.size() == b.hits->hits.size() && (!counted || a.hits->hits.steps == b.hits->hits.steps);
}

// In both directions: data left by either frame must not affect the other.
void expectFresh(const FrameRequest& one, const FrameRequest& other) {
    Work work(1);
    FrameRenderer kept(std::make_shared<MapCache>());
    kept.render(one, work);
    for (const FrameRequest* now : {&other, &one}) {
        FrameRenderer fresh(std::make_shared<MapCache>());
        EXPECT_TRUE(sameFrame(*kept.render(*now, work), *fresh.render(*now, work)));
    }
}

TEST(Reuse, OfEachInputByItselfWithEveryFilter) {
    const auto all = changes();
    std::set<std::string> unseen;
    for (const auto& [name, change] : all) unseen.insert(name);
    for (const FilterChoice& filter : filterForms()) {
        for (const auto& [name, change] : all) {
            SCOPED_TRACE(filterText(filter) + ", " + name);
            FrameRequest one = request();
            one.filter = filter;
            one.filter.samples = 2;
            // Filters that sum over the surface are slow and reuse the same data as the others.
            const auto form = filter.options.find("form");
            if (form != filter.options.end() && form->second.starts_with("position")) one.width = one.height = 12;
            FrameRequest other = one;
            change(other);
            expectFresh(one, other);
            Work work(1);
            if (!sameFrame(*FrameRenderer(std::make_shared<MapCache>()).render(one, work),
                           *FrameRenderer(std::make_shared<MapCache>()).render(other, work))) {
                unseen.erase(name);
            }
        }
    }
    // A change that affects no picture would test nothing. Only skipping and counting must not affect it.
    EXPECT_EQ(unseen, (std::set<std::string>{"counts", "skip"}));
}

// Covers the options of filters and methods as well.
TEST(Reuse, OfEveryOptionOfFiltersAndMethods) {
    for (const FilterDescription& filter : filterList()) {
        for (const OptionDescription& option : filter.options) {
            if (option.name == "levels") continue;  // reads all texels to the horizon
            FrameRequest one = request();
            one.filter.name = filter.name;
            one.filter.samples = 2;
            one.width = one.height = 12;
            FrameRequest other = one;
            const bool choice = option.kind == OptionKind::Choice;
            other.filter.options[option.name] = choice ? option.choices.back() : numberText(option.low);
            SCOPED_TRACE(filterText(other.filter));
            expectFresh(one, other);
        }
    }
    for (const MethodDescription& method : tracerList()) {
        SCOPED_TRACE(method.name);
        FrameRequest one = request();
        FrameRequest other = one;
        other.method = {method.name, {}};
        expectFresh(one, other);
        // The same method with another relief, starting with flat ground.
        one.method = other.method;
        heightsOf(constantHeights(24, 20, 0.5F))(one);
        expectFresh(one, other);
    }
}

}  // namespace
}  // namespace relief::test
