#include "relief/maps/engine_json.h"

#include <cmath>

#include "relief/maps/map_json.h"

namespace relief {

namespace {

using Json = nlohmann::ordered_json;

Json channelsJson(const std::vector<EngineRole>& channels) {
    Json json = Json::object();
    for (std::size_t c = 0; c < channels.size(); ++c) {
        json[std::string(1, kEngineLetters[c])] = engineRoleName(channels[c]);
    }
    return json;
}

Json volumeJson(const EngineVolume& volume) {
    const DistanceParameters& p = volume.parameters;
    return {{"unit", "texture widths"},
            {"scale", volume.scale},
            {"interpolate", !ofBoxes(volume.kind)},
            {"tile", {volume.nx, volume.ny}},
            {"columns", volume.columns},
            {"layers", p.layers},
            {"sectors", p.sectors},
            {"footprint", p.footprint},
            {"slab-texels", volume.slabTexels},
            {"max-run", numberJson(volume.maxRun)},
            {"cap", numberJson(volume.cap)},
            {"flattest", p.flattest},
            {"horizons", p.horizons},
            {"directions", p.directions},
            {"to", distanceToName(p.to)}};
}

EngineVolume volumeOf(const Json& json, const std::string& kind, const std::string& path) {
    EngineVolume volume;
    const auto known = kindOf<DistanceKind>(kind, 4, distanceKindName);
    if (!known) refuseDamaged(path, "kind " + kind);
    volume.kind = *known;
    DistanceParameters& p = volume.parameters;
    json.at("scale").get_to(volume.scale);
    volume.nx = json.at("tile").at(0).get<int>();
    volume.ny = json.at("tile").at(1).get<int>();
    json.at("columns").get_to(volume.columns);
    json.at("layers").get_to(p.layers);
    json.at("sectors").get_to(p.sectors);
    json.at("footprint").get_to(p.footprint);
    json.at("slab-texels").get_to(volume.slabTexels);
    volume.maxRun = numberOf(json.at("max-run"));
    volume.cap = numberOf(json.at("cap"));
    json.at("flattest").get_to(p.flattest);
    json.at("horizons").get_to(p.horizons);
    json.at("directions").get_to(p.directions);
    p.to = parseDistanceTo(json.at("to").get<std::string>());
    // Far more than any tracer uses; the picture's size limits the product.
    constexpr int kMost = 4096;
    const auto within = [](int number, int most) { return number >= 1 && number <= most; };
    const bool valid = volume.scale > 0 && within(p.layers, kMost) && within(p.sectors, kMost) &&
                       within(p.footprint, kMost) && within(volume.columns, p.layers * p.sectors) && volume.nx > 0 &&
                       volume.ny > 0 && volume.slabTexels >= 0 && volume.maxRun >= 0 && volume.cap > 0;
    if (!valid) refuseDamaged(path, "distance");
    return volume;
}

Json coneJson(const EngineConventions& c) {
    return {{"unit", coneUnitName(c.cone.unit)},
            {"scale", c.cone.scale},
            {"length", coneLengthName(c.cone.length)},
            {"apex", packs(c.channels, EngineRole::Apex) ? "channel" : "surface"},
            {"relaxed", c.relaxed}};
}

void readCone(const Json& json, EngineConventions& c, const std::string& path) {
    c.cone.unit = parseConeUnit(json.at("unit").get<std::string>(), path);
    json.at("scale").get_to(c.cone.scale);
    if (!(c.cone.scale > 0) || !std::isfinite(c.cone.scale)) refuseDamaged(path, "scale");
    c.cone.length = parseConeLength(json.at("length").get<std::string>(), path);
    json.at("relaxed").get_to(c.relaxed);
}

EngineSidecar sidecarOf(const Json& json, const std::string& path) {
    EngineSidecar sidecar;
    EngineConventions& c = sidecar.conventions;
    json.at("kind").get_to(c.kind);
    for (const Json& file : json.at("files")) {
        sidecar.files.push_back(file.at("name").get<std::string>());
        sidecar.sizes.emplace_back(file.at("size").at(0).get<int>(), file.at("size").at(1).get<int>());
    }
    if (sidecar.files.empty()) refuseDamaged(path, "files");
    c.fieldWidth = json.at("field").at(0).get<int>();
    c.fieldHeight = json.at("field").at(1).get<int>();
    json.at("bits").get_to(c.bits);
    std::string pack;
    for (const auto& [letter, role] : json.at("channels").items()) {
        pack += (pack.empty() ? "" : ",") + letter + "=" + role.get<std::string>();
    }
    c.channels = parseEnginePack(pack, path);
    c.surface = parseSurface(json.at("surface").get<std::string>());
    c.wrap = parseAddress(json.at("wrap").get<std::string>());
    json.at("relief-depth").get_to(c.reliefDepth);
    json.at("zero-level").get_to(c.zeroLevel);
    c.rounding = parseEngineRounding(json.at("rounding").get<std::string>(), path);
    if (json.contains("cone")) readCone(json.at("cone"), c, path);
    if (json.contains("distance")) c.volume = volumeOf(json.at("distance"), c.kind, path);
    if (json.contains("normal")) c.greenUp = json.at("normal").at("green") == Json("up");
    if (c.fieldWidth < 1 || c.fieldHeight < 1 || !(c.reliefDepth >= 0)) refuseDamaged(path, "field");
    return sidecar;
}

}  // namespace

Json engineJson(const EngineSidecar& sidecar) {
    const EngineConventions& c = sidecar.conventions;
    Json files = Json::array();
    for (std::size_t l = 0; l < sidecar.files.size(); ++l) {
        files.push_back({{"name", sidecar.files[l]}, {"size", {sidecar.sizes[l].first, sidecar.sizes[l].second}}});
    }
    Json json{{"format", kEngineFormat},
              {"version", kEngineMapVersion},
              {"kind", c.kind},
              {"files", files},
              {"field", {c.fieldWidth, c.fieldHeight}},
              {"bits", c.bits},
              {"channels", channelsJson(c.channels)},
              {"color-space", "linear"},
              {"first-row", "v = 0"},
              {"surface", surfaceName(c.surface)},
              {"wrap", addressName(c.wrap)},
              {"relief-depth", c.reliefDepth},
              {"zero-level", c.zeroLevel},
              {"rounding", engineRoundingName(c.rounding)}};
    if (packs(c.channels, EngineRole::Cone)) json["cone"] = coneJson(c);
    if (c.volume) json["distance"] = volumeJson(*c.volume);
    if (packs(c.channels, EngineRole::NormalX) || packs(c.channels, EngineRole::NormalY)) {
        json["normal"] = {{"green", c.greenUp ? "up" : "down"}};
    }
    return json;
}

EngineSidecar parseEngineJson(const std::string& text, const std::string& path) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || json.value("format", Json()) != Json(kEngineFormat)) {
        refuseDamaged(path, std::string("no \"") + kEngineFormat + "\"");
    }
    if (const Json version = json.value("version", Json()); version != Json(kEngineMapVersion)) {
        throw InputError(path,
                         Message(MessageId::MapVersion, {{"version", version.dump()}, {"known", kEngineMapVersion}}));
    }
    try {
        return sidecarOf(json, path);
    } catch (const nlohmann::json::exception& fault) {
        refuseDamaged(path, fault.what());
    } catch (const InputError& fault) {
        if (fault.subject() == path) throw;
        throw InputError(path, fault.message());
    }
}

}  // namespace relief
