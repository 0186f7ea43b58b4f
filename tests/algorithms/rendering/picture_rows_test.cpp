// Some rows of a picture alone, as they are made for pictures larger than memory and for parts: the bits of the whole
// frame wherever the rows begin and end, with every filter, coordinates along rows, pixel model and method.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "algorithms/filtering/filter_cases.h"
#include "algorithms/relief/fields.h"
#include "relief/tracers.h"
#include "rendering/frame_buffers.h"
#include "scenario/row_methods.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 72;
// Ends of the rows made one after another: on and next to the ends of tiles, and single rows.
const std::vector<int> kEnds{1, 31, 33, 64, 96, 97, 99};

// Two tiles wide and four high, neither whole; the view slants, so that rows of coordinates differ.
FrameRequest bricks() {
    FrameRequest request(HeightField(share(makeRelief("bricks", 48, 32, 1))));
    request.width = 67;
    request.height = kEnds.back();
    request.scene = SceneKind::Cube;
    request.camera.elevation = 30;
    request.camera.azimuth = 25;
    request.camera.distance = 1.2;
    request.color = randomPicture(48, 32, kSeed);
    request.shadows = true;
    request.light.elevation = 25;
    return request;
}

void expectSameRows(const FloatImage& whole, const FloatImage& part, int begin) {
    const auto rows =
        whole.pixels().subspan(static_cast<std::size_t>(begin) * static_cast<std::size_t>(whole.width()), part.size());
    EXPECT_EQ(std::memcmp(rows.data(), part.data(), part.bytes()), 0);
}

void expectSameBits(const std::string& name, const FrameRequest& request, const std::vector<std::string>& layers = {}) {
    SCOPED_TRACE(name);
    Work work(2);
    const auto maps = std::make_shared<MapCache>();
    FrameRenderer wholeRenderer(maps), renderer(maps, true);
    const auto whole = wholeRenderer.render(request, work);
    std::vector<NamedPlane> planes;
    if (!layers.empty()) planes = layerPlanes(*wholeRenderer.counted(work), request, layers, *maps, work);
    int begin = 0;
    for (const int end : kEnds) {
        if (begin == request.height) break;
        SCOPED_TRACE(end);
        const RowRange rows{begin, end};
        std::optional<LayerPlanes> made;
        if (!layers.empty()) made.emplace(request, layers, *maps, rows);
        PictureParts parts;
        parts.onlyRows = rows;
        parts.counts = !layers.empty();
        parts.done = [&](const Frame& part) {
            if (made) made->add(part, request, work);
        };
        const auto frame = renderer.picture(request, work, parts);
        const ColorImage& color = frame->light->color;
        ASSERT_EQ(color.height(), end - begin);
        for (int y = begin; y < end; ++y) {
            const auto a = color.row(y - begin), b = whole->light->color.row(y);
            ASSERT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0) << "row " << y;
        }
        if (made) {
            const auto some = made->take(*frame);
            ASSERT_EQ(some.size(), planes.size());
            for (std::size_t n = 0; n < some.size(); ++n) {
                SCOPED_TRACE(some[n].name);
                expectSameRows(planes[n].plane, some[n].plane, begin);
            }
        }
        begin = end;
    }
}

TEST(PictureRows, everyFilter) {
    FrameRequest request = bricks();
    for (const FilterChoice& filter : allFilters()) {
        std::string name = filter.name;
        for (const auto& [option, value] : filter.options) name.append(" ").append(option).append("=").append(value);
        // These take a hundred times as long per pixel; a smaller picture will do.
        const bool slow =
            name.find("position") != std::string::npos || name.find("texel-distance") != std::string::npos;
        request.filter = filter;
        request.width = slow ? 9 : 67;
        request.height = slow ? 33 : kEnds.back();
        for (const double bounded : {0.0, kMaxBounded}) {
            if (slow && bounded > 0) continue;
            request.bounded = bounded;
            expectSameBits(name + " bounded " + std::to_string(bounded), request);
        }
    }
}

TEST(PictureRows, everyMapping) {
    FrameRequest request = bricks();
    request.filter = {"elliptical", {}};
    for (const std::string& name : mappingNames()) {
        request.mapping = parseMapping(name, "--mapping");
        expectSameBits(name, request);
    }
}

TEST(PictureRows, samplesOfEveryPixelModel) {
    FrameRequest request = bricks();
    for (const PixelModel model : {PixelModel::Box, PixelModel::Gaussian, PixelModel::Lcd, PixelModel::Crt}) {
        request.filter = {std::string(kSupersample), {}, fewestSamples(model) > 2 ? fewestSamples(model) : 2, model};
        expectSameBits(std::string(pixelModelName(model)), request);
    }
}

TEST(PictureRows, everyMethodAndLayer) {
    FrameRequest request = bricks();
    for (const MethodDescription& method : tracerList()) {
        request.method = {method.name, {}};
        expectSameBits(method.name, request);
    }
    request.method = {"max-pyramid", {}};
    request.filter = {"elliptical-visible", {{"form", "grid"}}};
    expectSameBits("layers", request, layerNames());
}

// Memory grows with the rows that are made, not with the picture.
TEST(PictureRows, bytes) {
    FrameRequest request = bricks();
    const RowRange rows{128, 256};
    request.width = kMaxPictureSide;
    for (const int samples : {1, 4}) {
        request.filter = samples > 1 ? FilterChoice{std::string(kSupersample), {}, samples, PixelModel::Gaussian}
                                     : FilterChoice{"elliptical-visible", {{"form", "grid"}}};
        request.height = 1024;
        const std::uint64_t some = pictureBytes(request, 2, rows);
        request.height = kMaxPictureSide;
        EXPECT_EQ(pictureBytes(request, 2, rows), some);
        EXPECT_LT(static_cast<double>(some), 0.8e9);
    }
}

}  // namespace
}  // namespace relief::test
