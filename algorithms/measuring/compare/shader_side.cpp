#include "measuring/compare/shader_side.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "relief/visibility/any_hit.h"

namespace relief {

namespace {

constexpr std::size_t kMostPolygons = 6;

// Distance of the near plane, world units; the depth buffer holds 1 - kNear / distance.
constexpr double kNear = 1e-3;

constexpr const char* kVertexText = R"(#version 450
// Polygons in world units, relative to the eye; w of alongS and alongT: texture coordinate at the far end.
struct Polygon { vec4 origin, alongS, alongT, normal; };
layout(std140, binding = 1) uniform View {
    mat4 clip;
    vec4 light;  // to the light; w: width of the texture, world units
    Polygon polygons[6];
} view;
layout(location = 0) out vec2 texcoord;
layout(location = 1) out vec3 fromEye;
layout(location = 2) out vec3 toLight;
void main() {
    Polygon one = view.polygons[gl_InstanceID];
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec3 point = one.origin.xyz + corner.x * one.alongS.xyz + corner.y * one.alongT.xyz;
    mat3 toTangent = transpose(mat3(normalize(one.alongS.xyz), normalize(one.alongT.xyz), one.normal.xyz));
    texcoord = corner * vec2(one.alongS.w, one.alongT.w);
    fromEye = toTangent * point / view.light.w;
    toLight = toTangent * view.light.xyz;
    gl_Position = view.clip * vec4(point, 1.0);
}
)";

// Columns of the matrix from a point relative to the eye to clip coordinates, with row 0 of the picture at -1.
void addClip(std::vector<float>& numbers, const Frame& frame) {
    for (int column = 0; column < 4; ++column) {
        glm::dvec3 axis(0);
        if (column < 3) axis[column] = 1;
        const glm::dvec3 p = frame.camera.projectDirection(axis);
        const double z = column < 3 ? p.z : -2 * kNear;
        for (const double number : {2 * p.x / frame.width - p.z, 2 * p.y / frame.height - p.z, z, p.z}) {
            numbers.push_back(static_cast<float>(number));
        }
    }
}

void addVector(std::vector<float>& numbers, const glm::dvec3& v, double w) {
    for (const double number : {v.x, v.y, v.z, w}) numbers.push_back(static_cast<float>(number));
}

// The slope of the heights as normalAt() of the shader takes it.
std::pair<double, double> wideSlope(const HeightField& field, double s, double t) {
    return {field.at(s + 0.5, t) - field.at(s - 0.5, t), field.at(s, t + 0.5) - field.at(s, t - 0.5)};
}

// The light's ray from `bias` above a hit to the top plane, as inShadow() of the shader counts blockers.
AnyRay lightRay(const Hit& hit, glm::dvec2 run, double bias) {
    const double share = std::min(hit.lambda, bias), left = hit.lambda - share;
    return {hit.s + share * run.x, hit.t + share * run.y, 1 - left, left * run.x, left * run.y, left};
}

// The light of a frame as main.glsl computes it.
class LightSide {
  public:
    LightSide(const Frame& frame, const FrameRequest& request, const Tracer& tracer, MapCache& maps, Work& work)
        : frame_(frame),
          request_(request),
          tracer_(tracer),
          toLight_(lightDirection(request.light)),
          bias_(shaderShadowBias(request.method)) {
        for (const TexturedQuad& quad : frame.polygons) {
            const bool faces = glm::dot(toLight_, quad.normal) > 0;
            runs_.push_back(faces ? lightRun(quad, toLight_, frame.slabTexels) : glm::dvec2(0));
            axes_.emplace_back(quad);
        }
        const HeightField& field = request.field;
        if (field.address() == Address::Border) query_ = makeAnyHit(visibilityChoice(field), field, maps, work);
    }

    void lightRow(int y, std::span<Color> out, Work& work) const {
        std::vector<int> columns, sideColumns;
        RayBlock rays;
        AnyRayBlock sideRays;
        for (int x = 0; x < frame_.width; ++x) {
            const std::size_t i = frame_.index(x, y);
            const Hit hit = frame_.hits->hits[i];
            out[static_cast<std::size_t>(x)] = frame_.light->color(x, y);
            if (hit.outcome != Outcome::Hit) continue;
            const std::uint8_t polygon = frame_.rays->polygon[i];
            const double facing = facingOf(hit, polygon);
            out[static_cast<std::size_t>(x)] = lit(frame_.color->color.pixels()[i], facing, request_.light);
            if (facing <= 0 || hit.lambda <= bias_) continue;
            const glm::dvec2 run = runs_[polygon];
            const glm::dvec2 top(hit.s + hit.lambda * run.x, hit.t + hit.lambda * run.y);
            if (query_ && !inMap(top)) {
                sideColumns.push_back(x);
                sideRays.push(lightRay(hit, run, bias_));
            } else {
                columns.push_back(x);
                rays.push({top.x, top.y, -run.x, -run.y});
            }
        }
        const auto darken = [&](int x) {
            out[static_cast<std::size_t>(x)] = lit(frame_.color->color.pixels()[frame_.index(x, y)], 0, request_.light);
        };
        NullSink sink;
        HitBlock blockers;
        if (rays.size() > 0) tracer_.trace(rays, blockers, sink, work);
        for (std::size_t n = 0; n < columns.size(); ++n) {
            const double lambda = frame_.hits->hits.lambda[frame_.index(columns[n], y)];
            if (blockers.outcome[n] == Outcome::Hit && blockers.lambda[n] < lambda - bias_) darken(columns[n]);
        }
        VisibilityBlock results;
        if (sideRays.size() > 0) query_->query(sideRays, results, sink, work);
        for (std::size_t n = 0; n < sideColumns.size(); ++n) {
            if (results.visibility[n] == Visibility::Blocked) darken(sideColumns[n]);
        }
    }

  private:
    double facingOf(const Hit& hit, std::uint8_t polygon) const {
        if (glm::dot(toLight_, frame_.polygons[polygon].normal) <= 0) return 0;
        const auto slope = wideSlope(request_.field, hit.s, hit.t);
        return glm::dot(axes_[polygon].normalOf(slope, frame_.slabTexels), toLight_);
    }
    bool inMap(glm::dvec2 place) const {
        return place.x >= 0 && place.y >= 0 && place.x <= request_.field.width() && place.y <= request_.field.height();
    }

    const Frame& frame_;
    const FrameRequest& request_;
    const Tracer& tracer_;
    glm::dvec3 toLight_;
    double bias_;
    std::vector<glm::dvec2> runs_;
    std::vector<ReliefAxes> axes_;
    std::unique_ptr<AnyHitQuery> query_;  // at the border only
};

}  // namespace

ShaderRequest shaderRequest(FrameRequest request) {
    std::vector<Message> notes;
    const auto note = [&](MessageId what, const std::string& value) {
        notes.push_back(Message(what, {{"name", value}}));
    };
    if (request.field.surface() != Surface::Bilinear) {
        note(MessageId::ShaderNoteSurface, std::string(surfaceName(request.field.surface())));
        request.field = HeightField(request.field.sharedHeights(), Surface::Bilinear, request.field.address(),
                                    request.field.reliefDepth());
    }
    const std::string filter = request.filter.name;
    if (filter != "nearest" && filter != "bilinear" && filter != "trilinear") {
        request.filter = {"trilinear", {}};
        note(MessageId::ShaderNoteFilter, filter);
    }
    if (request.normals) note(MessageId::ShaderNoteNormals, {});
    if (!request.shadows) note(MessageId::ShaderNoteShadows, {});
    request.normals.reset();
    request.shadows = false;  // shaderLight() casts them
    request.mapping = kDirectRows;
    request.bounded = 0;
    return {std::move(request), std::move(notes)};
}

ShaderChoice shaderChoice(const FrameRequest& request) {
    ShaderChoice choice;
    choice.method = request.method;
    choice.address = request.field.address();
    choice.texelSlopes = true;
    return choice;
}

ShaderView shaderView(const Frame& frame, const FrameRequest& request) {
    ShaderView view;
    view.vertexText = kVertexText;
    addClip(view.numbers, frame);
    const HeightField& field = request.field;
    // All polygons show texels of one size.
    const double texel = glm::length(frame.polygons.front().plane.perS);
    addVector(view.numbers, lightDirection(request.light), texel * field.width());
    for (std::size_t n = 0; n < kMostPolygons; ++n) {
        const TexturedQuad& quad = frame.polygons[std::min(n, frame.polygons.size() - 1)];
        addVector(view.numbers, quad.plane.origin - frame.camera.eye, 0);
        addVector(view.numbers, quad.plane.perS * double(quad.width), double(quad.width) / field.width());
        addVector(view.numbers, quad.plane.perT * double(quad.height), double(quad.height) / field.height());
        addVector(view.numbers, quad.normal, 0);
    }
    view.polygons = static_cast<int>(std::min(kMostPolygons, frame.polygons.size()));
    const Light& light = request.light;
    view.uniforms.ambient = static_cast<float>(light.intensity * light.ambient);
    view.uniforms.intensity = static_cast<float>(light.intensity * (1 - light.ambient));
    view.uniforms.depthConstant = 1;
    view.uniforms.depthPerDistance = static_cast<float>(-kNear);
    return view;
}

ColorImage shaderLight(const Frame& frame, const FrameRequest& request, const Tracer& tracer, MapCache& maps,
                       Work& work) {
    const LightSide side(frame, request, tracer, maps, work);
    ColorImage out(frame.width, frame.height);
    parallelFor(work, frame.height, [&](int y) { side.lightRow(y, out.row(y), work); });
    return out;
}

ShaderTexture colorTexture(const FrameRequest& request) {
    const HeightField& field = request.field;
    const ColorImage* const color = request.color.get();
    ShaderTexture data{color != nullptr ? color->width() : field.width(),
                       color != nullptr ? color->height() : field.height(),
                       1,
                       4,
                       {{}},
                       request.filter.name != "nearest" || color == nullptr};
    std::vector<float>& texels = data.levels[0];
    texels.reserve(4 * static_cast<std::size_t>(data.width) * static_cast<std::size_t>(data.height));
    for (int y = 0; y < data.height; ++y) {
        for (int x = 0; x < data.width; ++x) {
            const Color c = color != nullptr ? (*color)(x, y) : heightGrey(static_cast<double>(field.texel(x, y)));
            texels.insert(texels.end(), {c.x, c.y, c.z, 1});
        }
    }
    return data;
}

ShaderDifferences shaderDifferences(const Frame& frame, const std::vector<float>& answers, const ColorImage& shader,
                                    const ColorImage& cpu) {
    ShaderDifferences all;
    all.hits = FloatImage(frame.width, frame.height, std::nanf(""));
    all.colors = FloatImage(frame.width, frame.height);
    const HitBlock& hits = frame.hits->hits;
    const auto shown = [](float v) { return srgbFromLinear(std::clamp(v, 0.0F, 1.0F)); };
    double worst = 0, sum = 0;
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            float color = 0;
            for (int c = 0; c < 3; ++c) color += std::abs(shown(shader(x, y)[c]) - shown(cpu(x, y)[c])) / 3;
            all.colors(x, y) = color;
            sum += static_cast<double>(color);
            if (static_cast<double>(color) > all.largestColor) {
                all.largestColor = static_cast<double>(color);
                all.worstColor = PixelChoice{x, y};
            }
            const std::size_t i = frame.index(x, y);
            if (frame.rays->polygon[i] == kNoPolygon) continue;
            ++all.compared;
            const bool here = hits.outcome[i] == Outcome::Hit, there = answers[4 * i] > 0;
            if (!here && !there) continue;
            const ViewRay ray = frame.rays->rays[i];
            const double off = here && there ? (static_cast<double>(answers[4 * i + 1]) - hits.lambda[i]) *
                                                   std::max(1.0, std::hypot(ray.a, ray.b))
                                             : std::numeric_limits<double>::infinity();
            all.hits(x, y) = static_cast<float>(off);
            if (std::isinf(off)) {
                ++all.otherOutcome;
            } else {
                all.far += std::abs(off) > kSameAnswer ? 1 : 0;
                all.largestHit = std::max(all.largestHit, std::abs(off));
            }
            if (std::abs(off) > worst) {
                worst = std::abs(off);
                all.worstHit = PixelChoice{x, y};
            }
        }
    }
    all.meanColor = sum / static_cast<double>(std::max<std::size_t>(1, all.colors.size()));
    return all;
}

}  // namespace relief
