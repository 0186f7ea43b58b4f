#include "measuring/bench/base_level_measure.h"

#include <algorithm>
#include <cmath>

#include "measuring/bench/view_bench.h"
#include "measuring/text_table.h"
#include "relief/maps/mean_levels_map.h"
#include "rendering/visible_polygons.h"

namespace relief {

namespace {

constexpr int kSide = 64;  // maximum number of rays along each side of the picture
constexpr int kRounds = 5;
constexpr int kDigits = 3;

RayBlock raysOfView(const FrameRequest& request) {
    const VisiblePolygons visible =
        visiblePolygons(makeScene(request.scene, request.field.width(), request.field.height()), requestCamera(request),
                        request.width, request.height, request.field.reliefDepth());
    RayBlock rays;
    const int stepX = std::max((request.width + kSide - 1) / kSide, 1);
    const int stepY = std::max((request.height + kSide - 1) / kSide, 1);
    for (int y = stepY / 2; y < request.height; y += stepY) {
        for (int x = stepX / 2; x < request.width; x += stepX) {
            const VisiblePolygon* const polygon = visible.at(x, y, request.width);
            if (polygon != nullptr) rays.push(polygon->entry(x, y).ray);
        }
    }
    return rays;
}

}  // namespace

std::optional<BaseLevelMeasure> measureBaseLevel(const FrameRequest& request, const MethodChoice& method,
                                                 MapCache& maps, Work& work) {
    const auto given = method.options.find(std::string(kBaseOption));
    if (given == method.options.end() || given->second != kBaseAuto) return std::nullopt;
    const RayBlock rays = raysOfView(request);
    if (rays.size() == 0) return std::nullopt;
    MethodChoice whole = method;
    whole.options[std::string(kBaseOption)] = "0";
    const std::vector<BenchRow> rows =
        benchRaysOfView(request.field, rays, {methodOfView(request, method), whole}, kRounds, maps, work);
    if (rows.size() != 2) return std::nullopt;
    return BaseLevelMeasure{footprintLevel(request), rows[0], rows[1]};
}

Message baseLevelSentence(const BaseLevelMeasure& measure) {
    const auto number = [](double value) { return readable(value, kDigits); };
    return Message(MessageId::BaseAutoMeasured,
                   {{"level", measure.footprint.level},
                    {"mean", number(measure.based.errors.mean)},
                    {"most", number(measure.based.errors.max)},
                    {"steps", number(measure.based.stepsMean)},
                    {"steps0", number(measure.whole.stepsMean)},
                    {"rate", number(measure.based.rate / 1e6)},
                    {"rate0", number(measure.whole.rate / 1e6)},
                    {"form0", measure.whole.method.name == "max-pyramid" ? "SIMD" : "scalar"}});
}

}  // namespace relief
