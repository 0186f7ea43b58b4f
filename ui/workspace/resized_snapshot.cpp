#include "workspace/resized_snapshot.h"

#include <algorithm>
#include <cmath>

#include "relief/memory.h"

namespace reliefui {

relief::Scenario inSize(relief::Scenario scenario, int width, int height) {
    const auto scaled = [](int at, int from, int to) {
        return std::clamp(static_cast<int>(std::floor((at + 0.5) * to / from)), 0, to - 1);
    };
    if (scenario.pixel) {
        scenario.pixel->x = scaled(scenario.pixel->x, scenario.width, width);
        scenario.pixel->y = scaled(scenario.pixel->y, scenario.height, height);
    }
    scenario.width = width;
    scenario.height = height;
    return scenario;
}

std::shared_ptr<const Snapshot> resized(const std::shared_ptr<const Snapshot>& snapshot, int width,
                                        relief::Work& work) {
    const relief::Scenario& own = snapshot->scenario;
    if (width == own.width && !snapshot->coarse) return snapshot;
    const double scale = static_cast<double>(width) / own.width;
    relief::Scenario scenario = inSize(own, width, std::max(1, static_cast<int>(std::lround(own.height * scale))));
    relief::FrameRequest request = relief::frameRequest(scenario, snapshot->assets);
    request.counts = snapshot->layer.layer == Layer::Steps;
    // Memory of a frame with all its stages, measured for `relief render` of large pictures.
    constexpr std::uint64_t kBytesPerPixel = 96;
    relief::requireMemory(relief::byteProduct({kBytesPerPixel, static_cast<std::uint64_t>(scenario.width),
                                               static_cast<std::uint64_t>(scenario.height)}),
                          std::to_string(scenario.width) + "x" + std::to_string(scenario.height),
                          relief::MemoryHint::SmallerPicture);
    auto other = std::make_shared<Snapshot>(*snapshot);
    other->scenario = std::move(scenario);
    other->coarse = false;
    relief::FrameRenderer renderer(snapshot->maps);
    other->frame = renderer.render(request, work);
    other->layer = makeLayer(snapshot->layer.layer, *other->frame, request, *snapshot->maps, work, scale);
    other->picture = snapshot->layer.layer == Layer::Color
                         ? other->layer.image
                         : makeLayer(Layer::Color, *other->frame, request, *snapshot->maps, work).image;
    other->tracer = renderer.tracer();
    other->request = std::make_shared<const relief::FrameRequest>(std::move(request));
    return other;
}

}  // namespace reliefui
