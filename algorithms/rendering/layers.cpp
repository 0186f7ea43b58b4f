// Layers: per-pixel data of a frame as planes of numbers.
#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "relief/memory.h"
#include "rendering/error_layer.h"
#include "rendering/frame.h"

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

const Layer& findLayer(const std::string& name) {
    std::string known;
    for (const Layer& candidate : layerTable()) {
        if (candidate.name == name) return candidate;
        known += (known.empty() ? "" : ", ") + std::string(candidate.name);
    }
    throw InputError("--layers", unknownName({"what", MessageId::WordLayer}, name, known));
}

// Data that layers need beyond the frame, made only for the layers that need it.
struct LayerTools {
    ErrorLayer error{};
    VisiblePolygons visible{};
    // The filter that tells which texels are hidden; null: the frame's filter is not a visible-part filter, or it was
    // not made yet.
    std::shared_ptr<const TextureFilter> visibleFilter = nullptr;
    bool visibleFilterMade = false;
};

std::shared_ptr<const TextureFilter> visibleFilterOf(const Frame& frame, const FrameRequest& request, MapCache& maps,
                                                     Work& work) {
    if (!frame.filter || !frame.filter->description().visible) return nullptr;
    if (frame.filter->tracesBack()) return frame.filter;
    FilterChoice choice = request.filter;
    choice.options["form"] = "plane";
    // Only the picture's size matters.
    std::shared_ptr<const ColorImage> picture = request.color;
    if (!picture) picture = std::make_shared<ColorImage>(request.field.width(), request.field.height());
    return makeFilter(choice, {picture, nullptr, request.field, request.skip}, maps, work);
}

// Returns the semi-axes, or the share of hidden texels (NaN if the filter does not test visibility).
std::array<float, 3> footprintValues(const std::string& name, const Frame& frame, const FrameRequest& request,
                                     const LayerTools& tools, int x, int y, Work& work) {
    const std::optional<FilterQuery> query = filterQuery(frame, request, tools.visible, x, y);
    if (!query) return {kNaN, kNaN, 0};
    if (name == "footprint") {
        const SemiAxes<double> axes = ellipseOf(query->jacobian).semiAxes();
        return {static_cast<float>(axes.major), static_cast<float>(axes.minor), 0};
    }
    if (!tools.visibleFilter) return {kNaN, 0, 0};
    FootprintCounts counts;
    tools.visibleFilter->color(*query, counts, work);
    return {counts.texels > 0
                ? static_cast<float>(static_cast<double>(counts.hidden) / static_cast<double>(counts.texels))
                : 0,
            0, 0};
}

// Returns the values of one pixel in the planes of a layer.
std::array<float, 3> layerValues(const std::string& name, const Frame& frame, const FrameRequest& request,
                                 const LayerTools& tools, int x, int y, Work& work) {
    const std::size_t i = frame.index(x, y);
    const HitBlock& hits = frame.hits->hits;
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
    if (name == "footprint" || name == "hidden") return footprintValues(name, frame, request, tools, x, y, work);
    if (name == "steps") return {static_cast<float>(hits.steps[i]), 0, 0};
    return {static_cast<float>(hits.outcome[i]), 0, 0};
}

}  // namespace

struct LayerPlanes::Tools : LayerTools {};

LayerPlanes::LayerPlanes(const FrameRequest& request, const std::vector<std::string>& layers, MapCache& maps,
                         RowRange rows)
    : layers_(layers), maps_(maps), tools_(std::make_unique<Tools>()), rows_(rows.orAll(request.height)) {
    for (const std::string& plane : layerPlaneNames(layers_)) {
        planes_.push_back({plane, FloatImage(request.width, rows_.count())});
    }
}

LayerPlanes::~LayerPlanes() = default;

std::uint64_t LayerPlanes::bytes(const FrameRequest& request, const std::vector<std::string>& layers, int rows) {
    return byteProduct({static_cast<std::uint64_t>(request.width), static_cast<std::uint64_t>(rows),
                        layerPlaneNames(layers).size(), 2 * sizeof(float)});
}

void LayerPlanes::add(const Frame& part, const FrameRequest& request, Work& work) {
    Tools& tools = *tools_;
    const RowRange rows{std::max(part.rows.begin, rows_.begin), std::min(part.rows.end, rows_.end)};
    std::size_t first = 0;
    for (const std::string& name : layers_) {
        const std::size_t count = findLayer(name).planes.size();
        if (name == "steps") assert(part.hits->counted());
        if (name == "error") tools.error = errorAgainstExact(part, request, maps_, work);
        if (name == "footprint" || name == "hidden") tools.visible = part.visible(request);
        if (name == "hidden" && !std::exchange(tools.visibleFilterMade, true)) {
            tools.visibleFilter = visibleFilterOf(part, request, maps_, work);
        }
        for (int y = rows.begin; y < rows.end && name != "color"; ++y) {
            work.throwIfStopped();
            for (int x = 0; x < part.width; ++x) {
                const std::array<float, 3> values = layerValues(name, part, request, tools, x, y, work);
                for (std::size_t k = 0; k < count; ++k) planes_[first + k].plane(x, y - rows_.begin) = values[k];
            }
        }
        first += count;
    }
}

std::vector<NamedPlane> LayerPlanes::take(const Frame& frame) {
    std::size_t first = 0;
    for (const std::string& name : layers_) {
        for (std::size_t i = 0; name == "color" && i < frame.light->color.size(); ++i) {
            const Color c = frame.light->color.pixels()[i];
            for (int k = 0; k < 3; ++k) planes_[first + static_cast<std::size_t>(k)].plane.pixels()[i] = c[k];
        }
        first += findLayer(name).planes.size();
    }
    return std::move(planes_);
}

std::vector<std::string> layerPlaneNames(const std::vector<std::string>& layers) {
    std::vector<std::string> names;
    for (const std::string& layer : layers) {
        const auto& planes = findLayer(layer).planes;
        names.insert(names.end(), planes.begin(), planes.end());
    }
    return names;
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
    LayerPlanes planes(request, layers, maps);
    planes.add(frame, request, work);
    return planes.take(frame);
}

}  // namespace relief
