#include "relief/maps/map_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>

#include "images/described_tiff.h"
#include "images/picture_input.h"
#include "relief/maps/map_atlas.h"
#include "relief/maps/map_field.h"
#include "relief/maps/map_json.h"
#include "relief/memory.h"

namespace relief {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "reliefscope map";

Checksum checksumOf(const FloatImage& heights) {
    Checksum sum;
    sum.add(static_cast<std::uint64_t>(heights.width()));
    sum.add(static_cast<std::uint64_t>(heights.height()));
    sum.add(heights.data(), heights.size());
    return sum;
}

std::string checksumText(const std::string& text) {
    Checksum sum;
    sum.add(text);
    return sum.text();
}

std::string checksumText(const PictureCodes& codes) {
    Checksum sum;
    std::visit([&](const auto& all) { sum.add(all.data(), all.size()); }, codes);
    return sum.text();
}

// The stacks of values in a map, all of one size and precision.
std::vector<const StoredValues*> stacksOf(const StoredMap& map) {
    if (const auto* distances = std::get_if<std::shared_ptr<const DistanceMap>>(&map)) return {&(*distances)->values};
    const auto& cones = std::get<std::shared_ptr<const ConeMap>>(map);
    return {&cones->apex, &cones->slopes};
}

// --- the description

Json parametersJson(const DistanceParameters& p) {
    return {{"footprint", p.footprint},
            {"layers", p.layers},
            {"flattest", p.flattest},
            {"horizons", p.horizons},
            {"sectors", p.sectors},
            {"directions", p.directions},
            {"precision", precisionName(p.precision)},
            {"to", distanceToName(p.to)}};
}
Json parametersJson(const ConeParameters& p) {
    return {{"sectors", p.sectors},
            {"radius", p.radius},
            {"directions", p.directions},
            {"precision", precisionName(p.precision)}};
}

void readParameters(const Json& json, DistanceParameters& p) {
    json.at("footprint").get_to(p.footprint);
    json.at("layers").get_to(p.layers);
    json.at("flattest").get_to(p.flattest);
    json.at("horizons").get_to(p.horizons);
    json.at("sectors").get_to(p.sectors);
    json.at("directions").get_to(p.directions);
    p.precision = parsePrecision(json.at("precision").get<std::string>());
    if (json.contains("to")) p.to = parseDistanceTo(json.at("to").get<std::string>());
}
void readParameters(const Json& json, ConeParameters& p) {
    json.at("sectors").get_to(p.sectors);
    json.at("radius").get_to(p.radius);
    json.at("directions").get_to(p.directions);
    p.precision = parsePrecision(json.at("precision").get<std::string>());
}

Json metricJson(const DistanceMap& map) {
    return {{"slab texels", map.slabTexels}, {"max run", numberJson(map.maxRun)}, {"cap", numberJson(map.cap)}};
}

template <class Map>
Json headerOf(const Map& map, const std::vector<const StoredValues*>& stacks, const Atlas& atlas) {
    Json header{{"format", kFormat}, {"version", kMapVersion}};
    if constexpr (std::is_same_v<Map, DistanceMap>) {
        header["kind"] = distanceKindName(map.kind);
    } else {
        header["kind"] = coneKindName(map.kind);
    }
    header["surface"] = surfaceName(map.surface);
    header["address"] = addressName(map.address);
    header["field"] = {map.fieldWidth, map.fieldHeight};
    header["parameters"] = parametersJson(map.parameters);
    if constexpr (std::is_same_v<Map, DistanceMap>) header["metric"] = metricJson(map);
    Json layers = Json::array();
    Json units = Json::array();
    for (const StoredValues* stack : stacks) {
        layers.push_back(stack->layers());
        units.push_back(static_cast<double>(stack->unit()));
    }
    header["atlas"] = {{"tile", {atlas.nx, atlas.ny}}, {"columns", atlas.columns}, {"layers", layers}};
    header["units"] = units;
    return header;
}

Json parsedHeader(const std::string& path, const std::string& description) {
    Json header = Json::parse(description, nullptr, false);
    if (!header.is_object() || header.value("format", Json()) != Json(kFormat)) {
        // A file of this program that is cut or altered is reported as damaged, not as an unknown picture.
        if (description.find(kFormat) != std::string::npos) refuseDamaged(path, "description");
        throw InputError(path, Message(MessageId::MapNotAMap));
    }
    if (const Json version = header.value("version", Json()); version != Json(kMapVersion)) {
        throw InputError(path, Message(MessageId::MapVersion, {{"version", version.dump()}, {"known", kMapVersion}}));
    }
    // The checksum covers the text before it was appended.
    const std::string text = description.substr(0, description.rfind(",\"header checksum\"")) + "}";
    if (header.value("header checksum", Json()) != Json(checksumText(text))) refuseDamaged(path, "description");
    return header;
}

// --- what belongs to the field

void checkSame(const std::string& path, const std::string& what, const std::string& stored, const std::string& given) {
    if (stored == given) return;
    throw InputError(path,
                     Message(MessageId::MapNotOfThisField, {{"what", what}, {"stored", stored}, {"given", given}}));
}

void checkField(const std::string& path, const Json& header, const HeightField& field) {
    const auto sizeText = [](int w, int h) { return std::to_string(w) + "x" + std::to_string(h); };
    const auto size = header.at("field").get<std::array<int, 2>>();
    const std::string stored = header.at("heights checksum").get<std::string>();
    const std::string given = checksumOf(field.heights()).text();
    if (stored != given || size != std::array<int, 2>{field.width(), field.height()}) {
        throw InputError(path, Message(MessageId::MapNotOfThisHeights,
                                       {{"stored", sizeText(size[0], size[1]) + " " + stored},
                                        {"given", sizeText(field.width(), field.height()) + " " + given}}));
    }
    checkSame(path, "surface", header.at("surface").get<std::string>(), std::string(surfaceName(field.surface())));
    checkSame(path, "address", header.at("address").get<std::string>(), std::string(addressName(field.address())));
    if (!header.contains("metric")) return;
    const double slab = header.at("metric").at("slab texels").get<double>();
    if (slab == field.slabTexels()) return;
    checkSame(path, "relief-depth", numberText(slab / field.width()), numberText(field.reliefDepth()));
    const auto texels = [](double count) { return Message(MessageId::WordTexels, {{"count", count}}); };
    throw InputError(
        path, Message(MessageId::MapNotOfThisField,
                      {{"what", "relief-depth"}, {"stored", texels(slab)}, {"given", texels(field.slabTexels())}}));
}

// False if the codes contain values that no valid map has: NaN, negative values that are not marks, or marks where none
// are allowed.
bool hasValidCodes(const StoredValues& values, bool marks) {
    if (!(values.unit() >= 0 && std::isfinite(values.unit()))) return false;
    return std::visit(
        [&](const auto& codes) {
            return std::all_of(codes.begin(), codes.end(), [&](auto code) {
                if constexpr (std::is_same_v<decltype(code), float>) {
                    if (code >= 0) return std::isfinite(code);
                    return marks && (code == StoredValues::kSurface || code == StoredValues::kBuried);
                } else {
                    return marks || code > 1;
                }
            });
        },
        values.codes());
}

// --- reading

// A map without its values, and the shape that its values must have.
struct Shell {
    std::shared_ptr<DistanceMap> distances;
    std::shared_ptr<ConeMap> cones;
    Precision precision = Precision::Float;
    int nx = 0;
    int ny = 0;
    std::vector<int> layers;

    StoredMap map() const {
        if (distances) return std::shared_ptr<const DistanceMap>(distances);
        return std::shared_ptr<const ConeMap>(cones);
    }
};

template <class Map>
void fillCommon(Map& map, const Json& header, const HeightField& field) {
    readParameters(header.at("parameters"), map.parameters);
    setField(map, field);
}

Shell shellOf(const std::string& path, const Json& header, const HeightField& field, MapCheck buildable) {
    Shell shell;
    const std::string kind = header.at("kind").get<std::string>();
    const auto distance = kindOf<DistanceKind>(kind, 4, distanceKindName);
    const auto cone = kindOf<ConeKind>(kind, kConeKinds, coneKindName);
    if (distance) {
        DistanceMap map;
        map.kind = *distance;
        // Files from before the parameter existed.
        if (map.kind == DistanceKind::Euclidean) map.parameters.to = DistanceTo::Voxel;
        fillCommon(map, header, field);
        map.slabTexels = field.slabTexels();
        map.maxRun = numberOf(header.at("metric").at("max run"));
        map.cap = numberOf(header.at("metric").at("cap"));
        if (!(map.maxRun >= 0) || !(map.cap > 0)) refuseDamaged(path, "metric");
        shell.precision = map.parameters.precision;
        shell.distances = std::make_shared<DistanceMap>(std::move(map));
    } else if (cone) {
        ConeMap map;
        map.kind = *cone;
        fillCommon(map, header, field);
        shell.precision = map.parameters.precision;
        shell.cones = std::make_shared<ConeMap>(std::move(map));
    } else {
        refuseDamaged(path, "kind " + kind);
    }
    if (!buildable(shell.map())) refuseDamaged(path, "parameters");
    if (shell.distances) {
        const DistanceShape shape = distanceMapShape(*distance, shell.distances->parameters, field);
        shell.nx = shape.nx;
        shell.ny = shape.ny;
        shell.layers = {shape.planes};
    } else {
        const ConeShape shape = coneMapShape(*cone, shell.cones->parameters, field);
        shell.nx = shape.nx;
        shell.ny = shape.ny;
        shell.layers = {1, shape.sectors};
    }
    return shell;
}

PictureCodes readCodes(const std::string& path, PictureInput& input, Precision precision, Work& work) {
    constexpr std::array kTypes{NumberType::Float, NumberType::UInt16, NumberType::UInt8};
    const std::array<int, 1> channel{0};
    // Reads the atlas and extracts the layers.
    const RawPlanes raw = input.read(channel, work, 2 * bytesEach(precision));
    const RawPlane& plane = raw.planes.front();
    if (plane.type != kTypes[static_cast<std::size_t>(precision)] || plane.stride != 1) refuseDamaged(path, "codes");
    const auto count = static_cast<std::size_t>(input.info().width) * static_cast<std::size_t>(input.info().height);
    const auto copied = [&]<class Code>(std::vector<Code> codes) {
        std::memcpy(codes.data(), plane.first, count * sizeof(Code));
        return PictureCodes(std::move(codes));
    };
    switch (precision) {
        case Precision::Float:
            return copied(std::vector<float>(count));
        case Precision::U16:
            return copied(std::vector<std::uint16_t>(count));
        case Precision::U8:
            break;
    }
    return copied(std::vector<std::uint8_t>(count));
}

StoredMap readMap(const std::string& path, PictureInput& input, const Json& header, const HeightField& field,
                  MapCheck buildable, Work& work) {
    const Shell shell = shellOf(path, header, field, buildable);
    const int tiles = shell.layers.front() + (shell.layers.size() > 1 ? shell.layers.back() : 0);
    const Atlas atlas(shell.nx, shell.ny, tiles);
    const Json& stored = header.at("atlas");
    if (stored.at("tile") != Json({atlas.nx, atlas.ny}) || stored.at("columns") != Json(atlas.columns) ||
        stored.at("layers") != Json(shell.layers) || input.info().width != atlas.width() ||
        input.info().height != atlas.height() || input.info().channels.size() != 1) {
        refuseDamaged(path, "layout");
    }
    const auto units = header.at("units").get<std::vector<float>>();
    if (units.size() != shell.layers.size()) refuseDamaged(path, "units");
    const PictureCodes codes = readCodes(path, input, shell.precision, work);
    if (header.at("codes checksum") != Json(checksumText(codes))) refuseDamaged(path, "codes");
    int first = 0;
    for (std::size_t s = 0; s < units.size(); first += shell.layers[s], ++s) {
        StoredValues values = std::visit(
            [&](const auto& pixels) { return layersOfPicture(pixels, atlas, first, shell.layers[s], units[s]); },
            codes);
        const bool marks = shell.distances && ofBoxes(shell.distances->kind);
        if (!hasValidCodes(values, marks)) refuseDamaged(path, "values");
        (shell.distances ? shell.distances->values
         : s == 0        ? shell.cones->apex
                         : shell.cones->slopes) = std::move(values);
    }
    return shell.map();
}

}  // namespace

std::string mapKindName(const StoredMap& map) {
    if (const auto* distances = std::get_if<std::shared_ptr<const DistanceMap>>(&map)) {
        return std::string(distanceKindName((*distances)->kind));
    }
    return std::string(coneKindName(std::get<std::shared_ptr<const ConeMap>>(map)->kind));
}

std::size_t mapBytes(const StoredMap& map) {
    return std::visit([](const auto& m) { return m->bytes(); }, map);
}

std::string mapSizeText(const StoredMap& map) {
    const StoredValues& values = *stacksOf(map).back();
    return std::to_string(values.width()) + " x " + std::to_string(values.height()) + " x " +
           std::to_string(values.layers());
}

void saveMap(const std::string& path, const StoredMap& map, const FloatImage& heights) {
    const std::vector<const StoredValues*> stacks = stacksOf(map);
    int tiles = 0;
    for (const StoredValues* stack : stacks) tiles += stack->layers();
    const Atlas atlas(stacks.front()->width(), stacks.front()->height(), tiles);
    Json header = std::visit([&](const auto& m) { return headerOf(*m, stacks, atlas); }, map);
    requireMemory(mapBytes(map), path);
    const PictureCodes codes = std::visit(
        [&]<class Code>(const UnfilledVector<Code>&) { return PictureCodes(pictureOfLayers<Code>(stacks, atlas)); },
        stacks.front()->codes());
    header["heights checksum"] = checksumOf(heights).text();
    header["codes checksum"] = checksumText(codes);
    header["header checksum"] = checksumText(header.dump());
    writeDescribedTiff(path, atlas.width(), atlas.height(), codes, header.dump());
}

StoredMap readStoredMap(const std::string& path, const HeightField& field, std::size_t maxBytes, MapCheck buildable,
                        Work& work) {
    // No code is shorter than a byte.
    PictureInput input(path, static_cast<std::int64_t>(std::max<std::size_t>(maxBytes, 1)));
    const Json header = parsedHeader(path, input.description());
    try {
        checkField(path, header, field);
        return readMap(path, input, header, field, buildable, work);
    } catch (const nlohmann::json::exception& fault) {
        refuseDamaged(path, fault.what());
    }
}

}  // namespace relief
