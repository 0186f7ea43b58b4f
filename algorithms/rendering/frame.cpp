#include "rendering/frame.h"

#include <array>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

#include "filtering/sampler.h"
#include "relief/look_up_point.h"
#include "rendering/error_layer.h"
#include "rendering/pixel_query.h"
#include "rendering/visible_polygons.h"

namespace relief {

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

struct Layer {
    const char* name;
    std::vector<const char*> planes;
};

const std::vector<Layer>& layerTable() {
    static const std::vector<Layer> table{{"color", {"R", "G", "B"}},
                                          {"depth", {"depth.Z"}},
                                          {"uv", {"uv.u", "uv.v"}},
                                          {"normal", {"normal.X", "normal.Y", "normal.Z"}},
                                          {"steps", {"steps.Y"}},
                                          {"outcome", {"outcome.Y"}},
                                          {"error", {"error.Y", "error.kind"}},
                                          {"footprint", {"footprint.major", "footprint.minor"}},
                                          {"hidden", {"hidden.Y"}}};
    return table;
}

// What a layer needs beyond the frame, made only for those that need it.
struct LayerTools {
    ErrorLayer error;
    VisiblePolygons visible;
    Work& work;
    // Tells which texels are hidden; null: the filter asks for none.
    std::shared_ptr<const TextureFilter> sight = nullptr;
};

std::shared_ptr<const TextureFilter> sightOf(const Frame& frame, const FrameRequest& request, MapCache& maps,
                                             Work& work) {
    if (!frame.filter || !frame.filter->description().visible) return nullptr;
    if (frame.filter->tracesBack()) return frame.filter;
    FilterChoice choice = request.filter;
    choice.options["form"] = "plane";
    // Only its size matters.
    std::shared_ptr<const ColorImage> picture = request.color;
    if (!picture) picture = std::make_shared<ColorImage>(request.field.width(), request.field.height());
    return makeFilter(choice, {picture, nullptr, request.field, request.skip}, maps, work);
}

// Semi-axes, and the share of hidden texels (NaN where the filter asks for none).
std::array<float, 3> footprintValues(const std::string& name, const Frame& frame, const FrameRequest& request,
                                     const LayerTools& tools, int x, int y) {
    const std::optional<FilterQuery> query = filterQuery(frame, request, tools.visible, x, y);
    if (!query) return {kNaN, kNaN, 0};
    if (name == "footprint") {
        const SemiAxes<double> axes = ellipseOf(query->jacobian).semiAxes();
        return {static_cast<float>(axes.major), static_cast<float>(axes.minor), 0};
    }
    if (!tools.sight) return {kNaN, 0, 0};
    FootprintCounts counts;
    tools.sight->color(*query, counts, tools.work);
    return {counts.texels > 0
                ? static_cast<float>(static_cast<double>(counts.hidden) / static_cast<double>(counts.texels))
                : 0,
            0, 0};
}

// The values of one pixel in the planes of a layer.
std::array<float, 3> layerValues(const std::string& name, const Frame& frame, const FrameRequest& request,
                                 const LayerTools& tools, int x, int y) {
    const std::size_t i = frame.index(x, y);
    const HitBlock& hits = frame.hits->hits;
    if (name == "color") {
        const Color c = frame.light->color(x, y);
        return {c.r, c.g, c.b};
    }
    if (name == "depth") return {static_cast<float>(frame.depth(x, y)), 0, 0};
    if (name == "uv") {
        if (hits.outcome[i] != Outcome::Hit) return {kNaN, kNaN, 0};
        return {static_cast<float>(hits.s[i] / request.field.width()),
                static_cast<float>(hits.t[i] / request.field.height()), 0};
    }
    if (name == "normal") {
        const glm::vec3 n = frame.normal(x, y, request);
        return {n.x, n.y, n.z};
    }
    if (name == "error") return {tools.error.texels[i], static_cast<float>(tools.error.kinds[i]), 0};
    if (name == "footprint" || name == "hidden") return footprintValues(name, frame, request, tools, x, y);
    if (name == "steps") return {static_cast<float>(hits.steps[i]), 0, 0};
    return {static_cast<float>(hits.outcome[i]), 0, 0};
}

}  // namespace

PinholeCamera requestCamera(const FrameRequest& request) {
    const int beyond = 2 * request.margin;
    PinholeCamera camera = pinholeCamera(request.camera, request.width - beyond, request.height - beyond);
    camera.principal += glm::dvec2(0.5 + request.margin) - request.sample;
    return camera;
}

std::optional<ViewRay> Frame::ray(int x, int y) const {
    const std::size_t i = index(x, y);
    if (rays->polygon[i] == kNoPolygon) return std::nullopt;
    return rays->rays[i];
}

double Frame::depth(int x, int y) const {
    const std::size_t i = index(x, y);
    const HitBlock& block = hits->hits;
    if (block.outcome[i] != Outcome::Hit) return std::numeric_limits<double>::quiet_NaN();
    // The hit lies lambda of the slab's thickness under the entry, along the view ray, whose depth grows with it.
    const TexturedQuad& quad = polygons[rays->polygon[i]];
    const double texel = glm::length(quad.plane.perS);
    const glm::dvec3 direction = camera.rayThrough(x + 0.5, y + 0.5);
    const double descent = -glm::dot(direction, quad.normal);
    return 1.0 / static_cast<double>(rays->inverseDepth[i]) + block.lambda[i] * slabTexels * texel / descent;
}

glm::vec3 Frame::normal(int x, int y, const FrameRequest& request) const {
    const std::size_t i = index(x, y);
    const Hit hit = hits->hits[i];
    if (hit.outcome != Outcome::Hit) return glm::vec3(0);
    const TexturedQuad& quad = polygons[rays->polygon[i]];
    if (shading == ShadingNormal::Plane) return glm::vec3(quad.normal);
    const glm::dvec2 place = lookUpPoint(request.field, rays->rays[i], hit);
    glm::vec3 mapped(0);
    if (shading == ShadingNormal::NormalMap && bakedNormals) {
        mapped = bakedNormals->at(place.x, place.y, request.field.address());
    } else if (request.normals && shading != ShadingNormal::Heights) {
        const auto& map = *request.normals;
        mapped = sampleBilinear(map, place.x * map.width() / request.field.width(),
                                place.y * map.height() / request.field.height(), request.field.address());
    } else {
        return glm::vec3(reliefNormal(quad, request.field.slope(place.x, place.y), slabTexels));
    }
    // Opposed vectors can cancel between texels.
    return glm::length(mapped) > 0 ? glm::vec3(mappedNormal(quad, mapped)) : glm::vec3(quad.normal);
}

bool Frame::shadedByRelief(const FrameRequest& request) const {
    if (shading == ShadingNormal::Plane || (shading == ShadingNormal::NormalMap && bakedNormals)) return false;
    return !request.normals || shading == ShadingNormal::Heights;
}

VisiblePolygons Frame::visible(const FrameRequest& request) const {
    return visiblePolygons(polygons, camera, width, height, request.field.reliefDepth());
}

std::optional<FilterQuery> filterQuery(const Frame& frame, const FrameRequest& request, const VisiblePolygons& visible,
                                       int x, int y) {
    const std::size_t i = frame.index(x, y);
    const Hit hit = frame.hits->hits[i];
    if (hit.outcome != Outcome::Hit) return std::nullopt;
    const VisiblePolygon* polygon = nullptr;
    for (const VisiblePolygon& candidate : visible.polygons) {
        if (candidate.number == frame.rays->polygon[i]) polygon = &candidate;
    }
    assert(polygon != nullptr);
    const bool exact = frame.exactHits && frame.hits->by[i] != HitBy::LittleParallax;
    return pixelQuery(*polygon, request.field, frame.rays->rays[i], hit, exact, x, y);
}

bool tinyFootprint(const FilterQuery& query, const Frame& frame, const FrameRequest& request) {
    const double perTexel = frame.colorPerTexel;
    return ellipseOf(query.jacobian).semiAxes().major * perTexel <= request.bounded;
}

std::optional<ViewRay> pixelRay(const FrameRequest& request, int x, int y) {
    if (x < 0 || y < 0 || x >= request.width || y >= request.height) {
        throw InputError("--pixel",
                         Message(MessageId::PixelOutside,
                                 {{"x", x}, {"y", y}, {"width", request.width}, {"height", request.height}}));
    }
    const VisiblePolygons visible =
        visiblePolygons(makeScene(request.scene, request.field.width(), request.field.height()), requestCamera(request),
                        request.width, request.height, request.field.reliefDepth());
    const VisiblePolygon* polygon = visible.at(x, y, request.width);
    if (polygon == nullptr) return std::nullopt;
    return polygon->entry(x, y).ray;
}

const std::vector<std::string>& layerNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Layer& layer : layerTable()) all.emplace_back(layer.name);
        return all;
    }();
    return names;
}

std::vector<NamedPlane> layerPlanes(const Frame& frame, const FrameRequest& request,
                                    const std::vector<std::string>& layers, MapCache& maps, Work& work) {
    std::vector<NamedPlane> planes;
    LayerTools tools{{}, {}, work};
    for (const std::string& name : layers) {
        const Layer* layer = nullptr;
        std::string known;
        for (const Layer& candidate : layerTable()) {
            if (candidate.name == name) layer = &candidate;
            known += (known.empty() ? "" : ", ") + std::string(candidate.name);
        }
        if (layer == nullptr) {
            throw InputError("--layers",
                             Message(MessageId::UnknownName, {{"what", "layer"}, {"name", name}, {"known", known}}));
        }
        if (name == "steps") assert(frame.hits->counted());
        if (name == "error") tools.error = errorAgainstExact(frame, request, maps, work);
        if (name == "footprint" || name == "hidden") tools.visible = frame.visible(request);
        if (name == "hidden") tools.sight = sightOf(frame, request, maps, work);
        const std::size_t first = planes.size();
        for (const char* plane : layer->planes) planes.push_back({plane, FloatImage(frame.width, frame.height)});
        for (int y = 0; y < frame.height; ++y) {
            work.throwIfStopped();
            for (int x = 0; x < frame.width; ++x) {
                const std::array<float, 3> values = layerValues(name, frame, request, tools, x, y);
                for (std::size_t k = 0; k < layer->planes.size(); ++k) planes[first + k].plane(x, y) = values[k];
            }
        }
    }
    return planes;
}

}  // namespace relief
