#include "why.h"

#include "json_line.h"
#include "rendering/lighting.h"
#include "scenario/ray_files.h"

namespace relief::app {

namespace {

template <class Vector>
Json threeNumbers(const Vector& v) {
    return {v.x, v.y, v.z};
}

std::string_view foundBy(HitBy by) {
    return by == HitBy::Traced ? "traced" : by == HitBy::FlatGround ? "flat-ground" : "little-parallax";
}

Json hitJson(const HistoryRay& ray) {
    Json json{{"outcome", outcomeName(ray.hit.outcome)}};
    if (ray.hit.outcome != Outcome::Hit) return json;
    json["lambda"] = ray.hit.lambda;
    json["s"] = ray.hit.s;
    json["t"] = ray.hit.t;
    json["found"] = foundBy(ray.by);
    return json;
}

Json filterJson(const HistoryRay& ray) {
    Json json{{"color", threeNumbers(ray.sum)}};
    if (ray.height) {
        json["height"] = *ray.height;
        return json;
    }
    json["texels"] = Json::array();
    for (const HistoryTexel& texel : ray.texels) {
        json["texels"].push_back({{"level", texel.level},
                                  {"i", texel.i},
                                  {"j", texel.j},
                                  {"weight", threeNumbers(texel.weight)},
                                  {"color", threeNumbers(texel.color)}});
    }
    json["hidden"] = ray.hidden;
    if (ray.allHidden) json["all_hidden"] = true;
    return json;
}

Json rayJson(const HistoryRay& ray) {
    Json json{{"pixel", {ray.pixel.x, ray.pixel.y}},
              {"sample", {ray.sample.x, ray.sample.y}},
              {"share", threeNumbers(ray.share)},
              {"product", threeNumbers(ray.product)}};
    if (!ray.polygon) {
        json["coverage"] = nullptr;
        return json;
    }
    json["coverage"] = {{"polygon", *ray.polygon}, {"depth", ray.entryDepth}};
    json["ray"] = {{"s0", ray.ray.s0}, {"t0", ray.ray.t0}, {"a", ray.ray.a}, {"b", ray.ray.b}};
    json["hit"] = hitJson(ray);
    if (ray.hit.outcome != Outcome::Hit) return json;
    json["filter"] = filterJson(ray);
    json["light"] = {{"normal", threeNumbers(ray.normal)},
                     {"cosine", ray.cosine},
                     {"shadowed", ray.shadowed},
                     {"amount", ray.amount}};
    return json;
}

}  // namespace

std::string historiesJson(const std::vector<PixelHistory>& histories, const FrameRequest& request) {
    Json list = Json::array();
    for (const PixelHistory& history : histories) {
        Json json{{"pixel", {history.x, history.y}},
                  {"drawn", threeNumbers(history.drawn)},
                  {"srgb", history.srgb},
                  {"product", threeNumbers(history.product)},
                  {"difference", history.difference()},
                  {"bound", history.bound},
                  {"method", history.method},
                  {"filter", request.filter.name},
                  {"light",
                   {{"direction", threeNumbers(lightDirection(request.light))},
                    {"ambient", request.light.ambient},
                    {"intensity", request.light.intensity}}}};
        json["rays"] = Json::array();
        for (const HistoryRay& ray : history.rays) json["rays"].push_back(rayJson(ray));
        list.push_back(std::move(json));
    }
    return list.dump(2) + "\n";
}

}  // namespace relief::app
