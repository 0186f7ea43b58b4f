#include "scenario/rays_view.h"

#include <filesystem>
#include <fstream>

#include "relief/files.h"
#include "scenario/json_reader.h"

namespace relief {

namespace {

constexpr const char* kFormat = "reliefscope rays";
constexpr int kVersion = 1;
constexpr std::size_t kFormatWithin = 64;  // first bytes of the file that name its format

Json vectorJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json cameraJson(const PinholeCamera& camera) {
    const auto row = [&](const glm::dvec3& axis) {
        return Json{axis.x, axis.y, axis.z, -(axis.x * camera.eye.x + axis.y * camera.eye.y + axis.z * camera.eye.z)};
    };
    Json json{{"eye", vectorJson(camera.eye)},
              {"right", vectorJson(camera.right)},
              {"up", vectorJson(camera.up)},
              {"forward", vectorJson(camera.forward)},
              {"focal_pixels", {camera.focal.x, camera.focal.y}},
              {"principal_pixel", {camera.principal.x, camera.principal.y}}};
    // From the world to a camera that looks along -z, as OpenGL has it.
    json["view_matrix"] = {row(camera.right), row(camera.up), row(-camera.forward), {0, 0, 0, 1}};
    return json;
}

Json polygonJson(const VisiblePolygon& polygon, double slabTexels) {
    const TexturedPlane& plane = polygon.quad.plane;
    const glm::dvec3 down = -polygon.quad.normal * slabTexels * glm::length(plane.perS);
    const auto row = [&](int k) { return Json{plane.perS[k], plane.perT[k], down[k], plane.origin[k]}; };
    Json json{{"origin", vectorJson(plane.origin)},
              {"per_s", vectorJson(plane.perS)},
              {"per_t", vectorJson(plane.perT)},
              {"normal", vectorJson(polygon.quad.normal)}};
    // From (s, t, lambda) to the world.
    json["world_matrix"] = {row(0), row(1), row(2), {0, 0, 0, 1}};
    return json;
}

}  // namespace

std::string raysViewPath(const std::string& raysPath) {
    return std::filesystem::path(raysPath).replace_extension(".json").string();
}

std::string raysViewText(const Scenario& scenario, const FrameRequest& request, const ViewRays& view,
                         const std::string& path) {
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    Json json{{"format", kFormat},
              {"version", kVersion},
              {"scenario", Json::parse(scenarioText(scenario, folder.string()))},
              {"size", {request.width, request.height}},
              {"field", {request.field.width(), request.field.height()}},
              {"slab_texels", request.field.slabTexels()},
              {"camera", cameraJson(requestCamera(request))}};
    json["polygons"] = Json::array();
    for (const VisiblePolygon& polygon : view.polygons) {
        json["polygons"].push_back(polygonJson(polygon, request.field.slabTexels()));
    }
    std::string text = json.dump(2);
    // The pixels, a line each: there are too many for an indented array.
    text.resize(text.rfind('\n'));
    text += ",\n  \"rays\": [";
    for (std::size_t r = 0; r < view.rays.size(); ++r) {
        text += (r > 0 ? ",\n    [" : "\n    [") + std::to_string(view.x[r]) + ", " + std::to_string(view.y[r]) + ", " +
                std::to_string(view.polygon[r]) + "]";
    }
    return text + "\n  ]\n}\n";
}

bool isRaysView(const std::string& path) {
    // Opening a named pipe would wait for its writer.
    std::error_code none;
    if (!std::filesystem::is_regular_file(path, none)) return false;
    // The format is the first member; a file of a large view has hundreds of megabytes.
    std::string begin(kFormatWithin, '\0');
    std::ifstream(path, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
    return begin.find("\"" + std::string(kFormat) + "\"") != std::string::npos;
}

std::optional<RaysView> readRaysView(const std::string& raysPath, std::size_t rays) {
    const std::string path = raysViewPath(raysPath);
    std::error_code error;
    if (path == raysPath || !std::filesystem::exists(path, error)) return std::nullopt;
    const std::string text = readTextFile(path);
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || !json.contains("format") || json["format"] != kFormat) return std::nullopt;
    const auto list = json.find("rays");
    RaysView view{parseScenario(text, path), {}};
    const auto refuse = [&](std::size_t count) {
        throw InputError(path,
                         Message(MessageId::RaysViewCount, {{"count", count}, {"file", raysPath}, {"rays", rays}}));
    };
    const bool any = list != json.end() && list->is_array();
    if (!any || list->size() != rays) refuse(any ? list->size() : 0);
    for (const Json& pixel : *list) {
        const bool good =
            pixel.is_array() && pixel.size() == 3 && pixel[0].is_number_integer() && pixel[1].is_number_integer();
        if (!good) refuse(view.pixels.size());
        const PixelChoice place{pixel[0].get<int>(), pixel[1].get<int>()};
        if (place.x < 0 || place.x >= view.scenario.width || place.y < 0 || place.y >= view.scenario.height) {
            refuse(view.pixels.size());
        }
        view.pixels.push_back(place);
    }
    return view;
}

}  // namespace relief
