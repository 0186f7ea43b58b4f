#include "relief/maps/engine_map.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/parallel.h"
#include "images/picture_bands.h"
#include "images/picture_input.h"
#include "images/system_error.h"
#include "relief/maps/engine_json.h"
#include "relief/memory.h"

namespace relief {

namespace {

namespace fs = std::filesystem;

// Two channels would be grey and coverage to readers of PNG: a third, empty one makes them red and green.
std::size_t storedChannels(const EngineLevel& level) {
    return level.channels.size() == 2 ? 3 : level.channels.size();
}

// The codes of a picture, channels interleaved.
template <class Code>
std::vector<std::byte> interleaved(const EngineLevel& level, int bits) {
    const std::size_t count = storedChannels(level);
    const std::size_t pixels = level.channels.front().size();
    std::vector<std::byte> bytes(pixels * count * sizeof(Code));
    const double most = std::exp2(bits) - 1;
    for (std::size_t c = 0; c < level.channels.size(); ++c) {
        for (std::size_t i = 0; i < pixels; ++i) {
            const float x = level.channels[c].pixels()[i];
            Code code;
            if constexpr (std::is_same_v<Code, float>) {
                code = x;
            } else {
                code = static_cast<Code>(std::lround(static_cast<double>(x) * most));
            }
            std::memcpy(bytes.data() + (i * count + c) * sizeof code, &code, sizeof code);
        }
    }
    return bytes;
}

std::vector<std::string> channelNames(std::size_t count) {
    if (count == 1) return {"Y"};
    std::vector<std::string> names;
    for (std::size_t c = 0; c < count; ++c) names.emplace_back(1, kEngineLetters[c]);
    return names;
}

std::string fileName(const std::string& path) {
    return fs::path(path).filename().string();
}

// The number of bits of a channel that readers of this type of number see.
int bitsOf(const std::string& path, NumberType type) {
    switch (type) {
        case NumberType::UInt8:
            return 8;
        case NumberType::UInt16:
            return 16;
        case NumberType::Float:
            return 32;
        default:
            throw InputError(path, Message(MessageId::EngineNumbers));
    }
}

// Reads a picture by the conventions, and sets their bits to those of the file.
EngineLevel readLevel(const std::string& path, EngineConventions& conventions, Work& work) {
    PictureInput input(path, kDefaultMaxPixels);
    const ImageInfo& info = input.info();
    std::vector<int> indices;
    for (std::size_t c = 0; c < conventions.channels.size(); ++c) {
        if (conventions.channels[c] == EngineRole::Zero) continue;
        const int named = input.channelIndex(std::string(1, kEngineLetters[c]));
        const int index = named >= 0 ? named : static_cast<int>(c);
        if (index >= static_cast<int>(info.channels.size())) {
            throw InputError(path, Message(MessageId::EngineNoChannel,
                                           {{"channel", std::string(1, kEngineLetters[c])},
                                            {"role", std::string(engineRoleName(conventions.channels[c]))}}));
        }
        indices.push_back(index);
    }
    const RawPlanes raw = input.read(indices, work, indices.size() * sizeof(float));
    EngineLevel level;
    std::size_t next = 0;
    for (const EngineRole role : conventions.channels) {
        FloatImage picture(info.width, info.height);
        if (role != EngineRole::Zero) {
            const RawPlane& plane = raw.planes[next++];
            conventions.bits = bitsOf(path, plane.type);
            const double most = conventions.bits == 32 ? 1 : std::exp2(conventions.bits) - 1;
            withNumbers(plane, [&](const auto* first) {
                for (std::size_t i = 0; i < picture.size(); ++i) {
                    const float x = static_cast<float>(static_cast<double>(first[i * plane.stride]) / most);
                    if (!std::isfinite(x) || x < 0) throw InputError(path, Message(MessageId::EngineNotFinite));
                    picture.pixels()[i] = x;
                }
            });
        }
        level.channels.push_back(std::move(picture));
    }
    return level;
}

EngineConventions convention(const char* pack, ConeUnit unit, bool relaxed) {
    EngineConventions c;
    c.kind = relaxed ? "relaxed-cone" : "cone";
    c.channels = parseEnginePack(pack, "");
    c.cone.unit = unit;
    c.relaxed = relaxed;
    return c;
}

// The sidecar's text, or that of the picture's metadata; empty if there is neither.
std::string conventionsText(const std::string& path) {
    const std::string sidecar = engineSidecar(path);
    std::error_code none;
    if (fs::exists(sidecar, none)) return readTextFile(sidecar);
    if (!fs::exists(path, none)) return {};
    const std::string text = PictureInput(path, kDefaultMaxPixels).description();
    return text.find(kEngineFormat) == std::string::npos ? std::string() : text;
}

}  // namespace

const FloatImage* EngineMap::channel(EngineRole role, int level) const {
    for (std::size_t c = 0; c < conventions.channels.size(); ++c) {
        if (conventions.channels[c] == role) return &levels[static_cast<std::size_t>(level)].channels[c];
    }
    return nullptr;
}

std::optional<FloatImage> EngineMap::heights(int level) const {
    const FloatImage* high = channel(EngineRole::Height, level);
    const FloatImage* deep = channel(EngineRole::Depth, level);
    if (high == nullptr && deep == nullptr) return std::nullopt;
    FloatImage heights = high != nullptr ? *high : *deep;
    for (float& h : heights.pixels()) h = std::clamp(high != nullptr ? h : 1.0F - h, 0.0F, 1.0F);
    return heights;
}

void requireSize(const std::string& path, const FloatImage& picture, int width, int height) {
    if (picture.width() == width && picture.height() == height) return;
    const auto text = [](int w, int h) { return std::to_string(w) + "x" + std::to_string(h); };
    throw InputError(path, Message(MessageId::EngineSize, {{"size", text(picture.width(), picture.height())},
                                                           {"wanted", text(width, height)}}));
}

const std::vector<NamedConvention>& namedConventions() {
    static const std::vector<NamedConvention> all{
        {"dummer", "Dummer 2006: R height, G square root of the ratio, B and A the surface's slopes",
         convention("R=height,G=cone", ConeUnit::SqrtRatio, false)},
        {"policarpo",
         "Policarpo & Oliveira 2007: A depth (black is the top), B ratio of relaxed cones, R and G normals",
         convention("B=cone,A=depth", ConeUnit::Ratio, true)},
        {"robust", "Ban et al. 2024: R height, G ratio, conservative cones",
         convention("R=height,G=cone", ConeUnit::Ratio, false)},
        {"robust-relaxed", "Ban et al. 2024: R height, G ratio, corrected relaxed cones",
         convention("R=height,G=cone", ConeUnit::Ratio, true)},
        {"relaxed-cone-map", "RelaxedConeMap, the program: R height, G ratio, relaxed cones",
         convention("R=height,G=cone", ConeUnit::Ratio, true)},
    };
    return all;
}

const NamedConvention& namedConvention(const std::string& name, const std::string& option) {
    for (const NamedConvention& one : namedConventions()) {
        if (one.name == name) return one;
    }
    throw InputError(option, unknownName({"what", option}, name, namesOf(namedConventions())));
}

std::string engineSidecar(const std::string& path) {
    return path + ".json";
}

std::string engineLevelPath(const std::string& path, int level, int levels) {
    if (levels == 1) return path;
    const fs::path whole(path);
    return (whole.parent_path() / (whole.stem().string() + "." + std::to_string(level) + whole.extension().string()))
        .string();
}

bool isEngineMap(const std::string& path) {
    return !conventionsText(path).empty();
}

void writeEngineMap(const std::string& path, const EngineMap& map) {
    const EngineConventions& c = map.conventions;
    const int levels = static_cast<int>(map.levels.size());
    EngineSidecar sidecar{c, {}, {}};
    for (int l = 0; l < levels; ++l) {
        const FloatImage& picture = map.levels[static_cast<std::size_t>(l)].channels.front();
        sidecar.files.push_back(fileName(engineLevelPath(path, l, levels)));
        sidecar.sizes.emplace_back(picture.width(), picture.height());
    }
    const auto json = engineJson(sidecar);
    for (int l = 0; l < levels; ++l) {
        const EngineLevel& level = map.levels[static_cast<std::size_t>(l)];
        auto own = json;
        if (levels > 1) own["level"] = l;
        ImageInfo info;
        info.width = level.channels.front().width();
        info.height = level.channels.front().height();
        info.channels = channelNames(storedChannels(level));
        info.type = c.bits == 8 ? "uint8" : c.bits == 16 ? "uint16" : "float";
        const std::vector<std::byte> bytes = c.bits == 8    ? interleaved<std::uint8_t>(level, c.bits)
                                             : c.bits == 16 ? interleaved<std::uint16_t>(level, c.bits)
                                                            : interleaved<float>(level, c.bits);
        writeNumbers(engineLevelPath(path, l, levels), info, bytes.data(), own.dump());
    }
    writeTextFile(engineSidecar(path), json.dump(2) + "\n");
}

std::optional<EngineConventions> readEngineConventions(const std::string& path) {
    const std::string text = conventionsText(path);
    if (text.empty()) return std::nullopt;
    return parseEngineJson(text, path).conventions;
}

EngineMap readEngineMap(const std::string& path, EngineConventions conventions, Work& work) {
    std::vector<std::string> files{path};
    // The picture of one level, named itself, has no sidecar and is read alone.
    const std::string sidecarPath = engineSidecar(path);
    std::error_code none;
    if (fs::exists(sidecarPath, none)) {
        const EngineSidecar sidecar = parseEngineJson(readTextFile(sidecarPath), path);
        if (sidecar.files.size() > 1) {
            files.clear();
            for (const std::string& name : sidecar.files) {
                files.push_back((fs::path(path).parent_path() / fs::path(name).filename()).string());
            }
        }
    }
    EngineMap map;
    for (const std::string& file : files) map.levels.push_back(readLevel(file, conventions, work));
    map.conventions = std::move(conventions);
    return map;
}

}  // namespace relief
