#include "relief/maps/pyramid_files.h"

#include <nlohmann/json.hpp>

#include "images/described_tiff.h"
#include "relief/maps/map_atlas.h"

namespace relief {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "reliefscope pyramid";

std::string checksumText(const FloatImage& level) {
    Checksum sum;
    sum.add(static_cast<std::uint64_t>(level.width()));
    sum.add(static_cast<std::uint64_t>(level.height()));
    sum.add(level.data(), level.size());
    return sum.text();
}

const char* kindName(PyramidKind kind) {
    switch (kind) {
        case PyramidKind::Max:
            return "max";
        case PyramidKind::Min:
            return "min";
        case PyramidKind::Mean:
            break;
    }
    return "mean";
}

// The meaning of a texel of level l.
std::string meaning(PyramidKind kind, int l) {
    const std::string side = std::to_string(std::int64_t{1} << l);
    const std::string what = kind == PyramidKind::Mean ? "mean" : std::string(kindName(kind)) + "imum";
    if (l == 0) return "texel (i, j) is the height at its centre (i + 1/2, j + 1/2); rows top-down";
    return "texel (i, j) is the " + what + " of the " + side + " x " + side + " heights of level 0 that begin at (" +
           side + " i, " + side + " j), or of those that exist in the last column and row; rows top-down";
}

}  // namespace

const std::vector<std::string>& pyramidMapKinds() {
    static const std::vector<std::string> kinds{"max-pyramid", "mean-pyramid"};
    return kinds;
}

PyramidKind pyramidKindOf(const std::string& name) {
    return name == pyramidMapKinds().front() ? PyramidKind::Max : PyramidKind::Mean;
}

void savePyramid(const std::string& path, const Pyramid& pyramid) {
    const FloatImage& base = pyramid.level(0);
    std::vector<DescribedPage> pages;
    Json checksums = Json::array();
    for (int l = 0; l < pyramid.levels(); ++l) {
        const FloatImage& level = pyramid.level(l);
        Json header{{"format", kFormat},
                    {"version", kPyramidFileVersion},
                    {"kind", kindName(pyramid.kind())},
                    {"level", l},
                    {"levels", pyramid.levels()},
                    {"size", {level.width(), level.height()}},
                    {"field", {base.width(), base.height()}},
                    {"unit", "height, share of the slab: 0 its bottom, 1 the polygon"},
                    {"texels", meaning(pyramid.kind(), l)}};
        checksums.push_back(checksumText(level));
        if (l + 1 == pyramid.levels()) header["checksums"] = checksums;
        pages.push_back({&level, header.dump()});
    }
    writeMipTiff(path, pages);
}

}  // namespace relief
