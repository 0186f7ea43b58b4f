// Kinds of changes that a person makes in the window, each with the stages of the picture that depend on it. The test
// asserts the stages and the counts; the benchmark relief_changes prints them with times.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rendering/frame_buffers.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

inline constexpr std::uint32_t kNoStage = 0;
inline constexpr std::uint32_t kLightStage = bit(relief::Stage::Light);
inline constexpr std::uint32_t kShadowStages = bit(relief::Stage::Shadows) | kLightStage;
inline constexpr std::uint32_t kColorStages = bit(relief::Stage::Color) | kLightStage;
inline constexpr std::uint32_t kHitStages = bit(relief::Stage::Hits) | bit(relief::Stage::Color) | kShadowStages;
inline constexpr std::uint32_t kAllOfIt = bit(relief::Stage::Rays) | kHitStages;

struct Change {
    const char* name;
    std::uint32_t stages;  // bits of Stage: those that are made again
    std::function<void(SnapshotOrder&)> apply;
    bool edit = false;  // of a relief by hand: only some tiles of the stages are made again
};

// A relief by hand of side x side texels with smooth hills, on the floor.
inline relief::Scenario drawnScenario(int side) {
    relief::Scenario scenario;
    scenario.pictures.drawn = {side, side, {}};
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const double x = 6.2832 * i / side, y = 6.2832 * j / side;
            scenario.pictures.drawn.heights.push_back(0.4 + 0.3 * std::sin(x) * std::cos(2 * y));
        }
    }
    scenario.shadows = true;
    return scenario;
}

// The changes, one after the other. The first follow each other on any picture with a pixel, colours, shadows and the
// filter `elliptical`; the edits need drawnScenario().
inline std::vector<Change> sceneChanges() {
    using Order = SnapshotOrder;
    const auto scene = [](std::function<void(relief::Scenario&)> change) {
        return [change = std::move(change)](Order& order) { change(order.scenario); };
    };
    return {
        {"nothing", kNoStage, [](Order&) {}},
        {"chosen step", kNoStage, scene([](auto& s) { s.step = 1; })},
        {"chosen pixel", kNoStage, scene([](auto& s) { s.pixel->x += s.width / 10; })},
        {"bookmark", kNoStage, scene([](auto& s) {
             s.bookmarks.push_back({"here", *s.pixel, s.camera, 0});
         })},
        {"method to compare with", kNoStage, scene([](auto& s) {
             s.comparison.others = {{"offset", {}}};
         })},
        {"layer shown: depth", kNoStage, [](Order& order) { order.layer = Layer::Depth; }},
        {"layer shown: steps", kNoStage, [](Order& order) { order.layer = Layer::Steps; }},
        {"layer shown before", kNoStage, [](Order& order) { order.layer = Layer::Color; }},
        {"strength of the light", kLightStage, scene([](auto& s) { s.light.intensity *= 0.8; })},
        {"colour of the sky", kLightStage, scene([](auto& s) { s.sky[0] *= 0.5; })},
        {"direction of the light", kShadowStages, scene([](auto& s) { s.light.azimuth += 5; })},
        {"shadows off", kShadowStages, scene([](auto& s) { s.shadows = false; })},
        {"shadows on", kShadowStages, scene([](auto& s) { s.shadows = true; })},
        {"option of the filter", kColorStages, scene([](auto& s) { s.filter.options["sigma"] = "0.6"; })},
        {"another filter", kColorStages, scene([](auto& s) { s.filter = {}; })},
        {"no colour picture", kColorStages, scene([](auto& s) { s.pictures.color.clear(); })},
        {"option of the method", kHitStages, scene([](auto& s) { s.method.options["base"] = "1"; })},
        {"another method", kHitStages, scene([](auto& s) {
             s.method = {"exact", {}};
         })},
        {"undo of that", kHitStages, scene([](auto& s) { s.method = {}; })},
        {"camera turned", kAllOfIt, scene([](auto& s) { s.camera.azimuth += 2; })},
        {"camera nearer", kAllOfIt, scene([](auto& s) { s.camera.distance *= 0.9; })},
        {"camera moved sideways", kAllOfIt, scene([](auto& s) { s.camera.target.x += 0.02; })},
        {"depth of the relief", kAllOfIt, scene([](auto& s) { s.reliefDepth *= 1.1; })},
        {"size of the picture", kAllOfIt, scene([](auto& s) { s.width -= 32; })},
    };
}

inline std::vector<Change> editChanges() {
    const auto raise = [](int i, int j, int count) {
        return [=](SnapshotOrder& order) {
            relief::DrawnRelief& drawn = order.scenario.pictures.drawn;
            for (int n = 0; n < count; ++n) drawn.heights[static_cast<std::size_t>(j * drawn.width + i + n)] += 0.05;
        };
    };
    return {
        {"one texel by hand", kHitStages, raise(5, 9, 1), true},
        {"the same texel, dragged on", kHitStages, raise(5, 9, 1), true},
        {"four texels by hand", kHitStages, raise(8, 3, 4), true},
    };
}

// Returns the stages that were made for `now` after `before`.
inline std::uint32_t stagesMade(const Snapshot& before, const Snapshot& now) {
    std::uint32_t made = 0;
    const relief::Frame &a = *before.frame, &b = *now.frame;
    const auto note = [&](relief::Stage stage, bool same) { made |= same ? 0U : bit(stage); };
    note(relief::Stage::Rays, a.rays == b.rays);
    note(relief::Stage::Hits, a.hits == b.hits);
    note(relief::Stage::Color, a.color == b.color);
    note(relief::Stage::Shadows, a.shadows == b.shadows);
    note(relief::Stage::Light, a.light == b.light);
    return made;
}

}  // namespace reliefui
