#include "engine_options.h"

#include <algorithm>
#include <array>
#include <utility>

#include "relief/maps/engine_builders.h"

namespace relief::app {

namespace {

constexpr const char* kGroup = "Maps of engines";
constexpr int kMostMips = 32;

// Parses the direction of the green channel: true for up.
bool isUp(const std::string& text, const std::string& option) {
    if (text != "up" && text != "down") throw InputError(option, unknownName({"what", option}, text, "up, down"));
    return text == "up";
}

}  // namespace

void EngineOptions::addCommon(CLI::App& parser) {
    std::string conventions;
    for (const NamedConvention& one : namedConventions()) {
        conventions += (conventions.empty() ? "" : "; ") + one.name + " (" + one.summary + ")";
    }
    addText(parser, "--convention", convention_, "NAME",
            "channels and units of another program: " + conventions + ". Other options override parts of it", kGroup);
    addText(parser, "--pack", pack_, "R=ROLE,G=ROLE...",
            "what the channels hold: height, depth (0 is the top), cone, apex, distance, normal-x, normal-y, normal-z, "
            "zero",
            kGroup);
    addText(parser, "--unit", unit_, "ratio|sqrt-ratio|slope",
            "numbers that stand for cones. ratio: by how much a cone widens per height of the slab (default); "
            "sqrt-ratio: its square root, which 8 bits hold better; slope: 1 / ratio",
            kGroup);
    addText(parser, "--cone-scale", scale_, "S",
            "ratio (or slope) for which 1 is stored; default 1. When slopes are written as integers, it is the "
            "steepest, and cannot be given",
            kGroup);
    addText(parser, "--length", length_, "uv|width",
            "unit of length of a ratio: texture coordinates (default), or texture widths on both axes", kGroup);
    addText(parser, "--white", white_, "high|deep",
            "whether 1 is stored for the top of the slab (high, default) or the bottom", kGroup);
}

void EngineOptions::addForWriting(CLI::App& parser) {
    addCommon(parser);
    addText(parser, "--bits", bits_, "8|16|float",
            "bits per channel: .png 8 or 16 (default), .exr float, .tif any of them (default 16)", kGroup);
    addText(
        parser, "--rounding", rounding_, "outward|nearest",
        "outward: cones become narrower, distances smaller, maxima higher, so that a safe map stays safe (default); "
        "nearest: as most tools round, which is not safe",
        kGroup);
    addText(
        parser, "--mips", mips_, "N|all",
        "cones and normals in N levels, each a file: FILE.0.png, FILE.1.png, ... A level's heights are the maxima of "
        "2 x 2, and its cones are built for them",
        kGroup);
    addText(
        parser, "--zero-level", zeroLevel_, "H",
        "height that lies in the polygon's plane, for the description: 1 (default) if the relief is carved into it, "
        "0 if it stands on it",
        kGroup);
    addText(parser, "--green", green_, "up|down",
            "normals: y against the rows of the picture, as in OpenGL (up, default), or with them, as in Direct3D",
            kGroup);
}

void EngineOptions::addForReading(CLI::App& parser) {
    addCommon(parser);
    addText(parser, "--fetch", fetch_, "bilinear|nearest", "how the shader fetches cones; default bilinear", kGroup);
    addFlag(parser, "--relaxed", relaxed_,
            "within a cone a ray may cross the surface once; the shader bisects the last step", kGroup);
}

std::string EngineOptions::given() const {
    const std::array<std::pair<const OptionText*, const char*>, 12> all{{{&convention_, "--convention"},
                                                                         {&pack_, "--pack"},
                                                                         {&unit_, "--unit"},
                                                                         {&scale_, "--cone-scale"},
                                                                         {&length_, "--length"},
                                                                         {&white_, "--white"},
                                                                         {&bits_, "--bits"},
                                                                         {&rounding_, "--rounding"},
                                                                         {&mips_, "--mips"},
                                                                         {&zeroLevel_, "--zero-level"},
                                                                         {&green_, "--green"},
                                                                         {&fetch_, "--fetch"}}};
    for (const auto& [option, name] : all) {
        if (*option) return name;
    }
    return relaxed_ ? "--relaxed" : "";
}

void EngineOptions::apply(EngineConventions& c) const {
    if (convention_) {
        const EngineConventions& named = namedConvention(*convention_, "--convention").conventions;
        c.channels = named.channels;
        c.cone = named.cone;
        c.relaxed = named.relaxed;
    }
    if (pack_) c.channels = parseEnginePack(*pack_, "--pack");
    if (unit_) c.cone.unit = parseConeUnit(*unit_, "--unit");
    if (length_) c.cone.length = parseConeLength(*length_, "--length");
    if (scale_) {
        c.cone.scale = parseNumber(*scale_, "--cone-scale");
        checkOption({"--cone-scale", OptionKind::Real, "", 1e-6, 1e6, 1, {}, ""}, *scale_, "--cone-scale");
    }
    if (white_) {
        const bool high = parseHeightWhite(*white_, "--white") == HeightWhite::High;
        std::replace(c.channels.begin(), c.channels.end(), high ? EngineRole::Depth : EngineRole::Height,
                     high ? EngineRole::Height : EngineRole::Depth);
    }
    if (bits_) {
        if (*bits_ != "8" && *bits_ != "16" && *bits_ != "float") {
            throw InputError("--bits", unknownName({"what", "--bits"}, *bits_, "8, 16, float"));
        }
        c.bits = *bits_ == "float" ? 32 : *bits_ == "8" ? 8 : 16;
    }
    if (rounding_) c.rounding = parseEngineRounding(*rounding_, "--rounding");
    if (zeroLevel_) {
        checkOption({"--zero-level", OptionKind::Real, "", 0, 1, 0.1, {}, ""}, *zeroLevel_, "--zero-level");
        c.zeroLevel = parseNumber(*zeroLevel_, "--zero-level");
    }
    if (green_) c.greenUp = isUp(*green_, "--green");
    if (relaxed_) c.relaxed = true;
}

ConeFetch EngineOptions::fetch() const {
    return fetch_ ? parseConeFetch(*fetch_, "--fetch") : ConeFetch::Bilinear;
}

int EngineOptions::mips(int width, int height) const {
    if (!mips_) return 1;
    const int most = mostMipLevels(width, height);
    if (*mips_ == "all") return most;
    const auto levels = static_cast<int>(parseWhole(*mips_, "--mips", 1, kMostMips));
    if (levels > most) {
        throw InputError("--mips",
                         Message(MessageId::EngineMips,
                                 {{"size", std::to_string(width) + "x" + std::to_string(height)}, {"levels", most}}));
    }
    return levels;
}

}  // namespace relief::app
