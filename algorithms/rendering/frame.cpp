#include "rendering/frame.h"

#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

#include "filtering/sampler.h"
#include "relief/methods/look_up_point.h"
#include "rendering/pinhole.h"
#include "rendering/pixel_query.h"
#include "rendering/visible_polygons.h"

namespace relief {

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
    // The hit lies lambda slab thicknesses below the entry, along the view ray, and camera depth grows in proportion.
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
    // Opposite normals of neighbouring texels can cancel when they are interpolated.
    return glm::length(mapped) > 0 ? glm::vec3(mappedNormal(quad, mapped)) : glm::vec3(quad.normal);
}

bool Frame::shadedByRelief(const FrameRequest& request) const {
    if (shading == ShadingNormal::Plane || (shading == ShadingNormal::NormalMap && bakedNormals)) return false;
    return !request.normals || shading == ShadingNormal::Heights;
}

VisiblePolygons Frame::visible(const FrameRequest& request) const {
    return visiblePolygons(polygons, camera, width, height, request.field.reliefDepth(), request.mapping);
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
                        request.width, request.height, request.field.reliefDepth(), request.mapping);
    const VisiblePolygon* polygon = visible.at(x, y, request.width);
    if (polygon == nullptr) return std::nullopt;
    return polygon->entry(x, y).ray;
}

std::optional<ViewRay> floorRay(const HeightField& field, const Camera& camera, int width, int height, int x, int y) {
    FrameRequest request{field};
    request.camera = camera;
    request.width = width;
    request.height = height;
    return pixelRay(request, x, y);
}

}  // namespace relief
