// A rendered frame with its inputs.
#pragma once

#include <memory>

#include "relief/tracers.h"
#include "rendering/frame.h"

namespace relief::test {

struct RenderedView {
    FrameRequest request;
    std::shared_ptr<MapCache> maps = std::make_shared<MapCache>();
    Work work{2};
    std::shared_ptr<const Frame> frame;
    std::shared_ptr<const Tracer> tracer;

    RenderedView(HeightField field, const MethodChoice& method, int width, int height) : request(std::move(field)) {
        request.width = width;
        request.height = height;
        request.method = method;
        FrameRenderer renderer(maps);
        frame = renderer.render(request, work);
        tracer = renderer.tracer();
    }
};

}  // namespace relief::test
