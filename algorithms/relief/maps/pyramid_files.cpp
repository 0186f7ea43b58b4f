#include "relief/maps/pyramid_files.h"

#include <nlohmann/json.hpp>

#include "images/described_tiff.h"
#include "images/tiled_pages.h"
#include "relief/maps/map_atlas.h"

namespace relief {

namespace {

std::string checksumText(const FloatImage& level) {
    Checksum sum;
    sum.add(static_cast<std::uint64_t>(level.width()));
    sum.add(static_cast<std::uint64_t>(level.height()));
    sum.add(level.data(), level.size());
    return sum.text();
}

TileKind tileKind(PyramidKind kind) {
    return kind == PyramidKind::Max ? TileKind::Max : kind == PyramidKind::Min ? TileKind::Min : TileKind::Mean;
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
    auto checksums = nlohmann::ordered_json::array();
    for (int l = 0; l < pyramid.levels(); ++l) {
        const FloatImage& level = pyramid.level(l);
        nlohmann::ordered_json header = pyramidPage(kPyramidFileVersion, tileKind(pyramid.kind()), l, pyramid.levels(),
                                                    {level.width(), level.height()}, {base.width(), base.height()});
        checksums.push_back(checksumText(level));
        if (l + 1 == pyramid.levels()) header["checksums"] = checksums;
        pages.push_back({&level, header.dump()});
    }
    writeMipTiff(path, pages);
}

}  // namespace relief
