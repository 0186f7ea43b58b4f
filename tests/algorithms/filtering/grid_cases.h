// Shared by the tests of form=grid: rendered frames with the filter queries of their pixels.
#pragma once

#include "algorithms/every_target.h"
#include "filter_cases.h"
#include "relief/reliefs.h"
#include "rendering/frame.h"

namespace relief::test {

inline constexpr std::uint64_t kSeed = 43;

inline FilterChoice grid(const char* points = "3") {
    return {"elliptical-visible", {{"form", "grid"}, {"points", points}}};
}

inline HeightField reliefOf(const char* name, Address address = Address::Repeat, Surface surface = Surface::Bilinear) {
    return HeightField(std::make_shared<const FloatImage>(makeRelief(name, 64, 48, kSeed)), surface, address, 0.1);
}

inline FrameRequest requestOf(const HeightField& field, const Picture& picture, const FilterChoice& filter) {
    FrameRequest request(field);
    request.width = 150;
    request.height = 70;
    request.color = picture;
    request.filter = filter;
    request.camera.elevation = 30;
    return request;
}

// Returns the random picture with its contrast scaled by `contrast` about 0.5.
inline Picture faintPicture(int width, int height, float contrast) {
    auto picture = std::make_shared<ColorImage>(*randomPicture(width, height, kSeed));
    for (Color& color : picture->pixels()) color = Color(0.5F) + contrast * (color - Color(0.5F));
    return picture;
}

// A rendered frame and the filter queries of its pixels, in scan order.
struct FrameQueries {
    Work work{1};
    FrameRequest request;
    std::shared_ptr<const Frame> frame;
    VisiblePolygons visible;
    FilterBlock block;

    explicit FrameQueries(const FrameRequest& frameRequest, int threads = 1) : work(threads), request(frameRequest) {
        FrameRenderer renderer(std::make_shared<MapCache>());
        frame = renderer.render(request, work);
        visible = frame->visible(request);
        for (int y = 0; y < request.height; ++y) {
            for (int x = 0; x < request.width; ++x) {
                if (const auto query = filterQuery(*frame, request, visible, x, y)) block.push(*query);
            }
        }
    }
    Color color(std::size_t i) const { return frame->color->color(block.x[i], block.y[i]); }
};

}  // namespace relief::test
