// The frames of a moving picture: each differs from the scenario in one value.
#include "scenario/sequence.h"

#include <map>

#include <gtest/gtest.h>

#include "relief/errors.h"

namespace relief {

namespace {

std::vector<SequenceFrame> frames(const std::string& text, const Scenario& scenario, std::optional<int> count = {}) {
    return framesOf(parseSequence(text, count, "--sequence"), scenario, "--sequence");
}

// Returns the scenario of a frame with the option as in `scenario`.
template <class Member>
Scenario undone(Scenario frame, const Scenario& scenario, Member member) {
    member(frame) = member(scenario);
    return frame;
}

TEST(Sequence, ASweepChangesOneValueFromOneEndToTheOther) {
    const Scenario scenario;
    const auto depths = frames("sweep:relief-depth=0.1..0.3", scenario, 5);
    ASSERT_EQ(depths.size(), 5U);
    const auto depth = [](auto& s) -> auto& {
        return s.reliefDepth;
    };
    for (std::size_t n = 0; n < depths.size(); ++n) {
        EXPECT_DOUBLE_EQ(depths[n].scenario.reliefDepth, 0.1 + 0.05 * static_cast<double>(n));
        EXPECT_EQ(undone(depths[n].scenario, scenario, depth), scenario) << n;
    }
    EXPECT_EQ(depths[1].changed(), "relief-depth = 0.15");
    EXPECT_EQ(frames("sweep:light-azimuth=-90..90", scenario, 3)[1].changed(), "light-azimuth = 0°");
    EXPECT_EQ(frames("sweep:light-azimuth=0..90", scenario).size(), static_cast<std::size_t>(kSequenceFrames));
    // A third is shown with all digits of the value that is used.
    const auto thirds = frames("sweep:ambient=0..1", scenario, 4);
    EXPECT_EQ(thirds[1].changed(), "ambient = 0.333333");
    EXPECT_EQ(thirds[1].scenario.light.ambient, 0.333333);
}

TEST(Sequence, ASweepOfAnOptionOfMethodFilterOrCoordinates) {
    Scenario scenario;
    scenario.method = {"layers", {{"layers", "8"}}};
    scenario.filter.name = "elliptical";
    const auto layers = frames("sweep:layers=4,16,64", scenario);
    ASSERT_EQ(layers.size(), 3U);
    EXPECT_EQ(layers[2].scenario.method.options.at("layers"), "64");
    EXPECT_EQ(layers[2].changed(), "layers = 64");
    // Whole numbers, each once.
    const auto few = frames("sweep:layers=2..6", scenario, 30);
    ASSERT_EQ(few.size(), 5U);
    for (std::size_t n = 0; n < few.size(); ++n)
        EXPECT_EQ(few[n].scenario.method.options.at("layers"), std::to_string(n + 2));
    const auto radii = frames("sweep:radius=0.5..1", scenario, 2);
    EXPECT_EQ(radii[0].scenario.filter.options.at("radius"), "0.5");
    EXPECT_EQ(radii[0].scenario.method, scenario.method);
}

// Whatever the window proposes is a sequence of different frames.
TEST(Sequence, ProposedSweepsAreSweeps) {
    for (const char* const method : {"layers", "max-pyramid", "cone", "hybrid", "displacement", "relaxed-cone"}) {
        Scenario scenario;
        scenario.method = {method, {}};
        scenario.filter.name = "elliptical-visible";
        const std::vector<SweptOption> options = sweptOptions(scenario);
        EXPECT_GT(options.size(), 10U);
        for (const SweptOption& option : options) {
            EXPECT_FALSE(option.help.empty()) << option.name;
            const auto all =
                framesOf(parseSweep(option.name + "=" + option.values, {}, "--sweep"), scenario, "--sweep");
            ASSERT_GE(all.size(), 2U) << method << " " << option.name << "=" << option.values;
            EXPECT_NE(all.front().value, all.back().value) << method << " " << option.name << "=" << option.values;
        }
    }
}

TEST(Sequence, ProposedSweepsLieAroundThePresentValue) {
    Scenario scenario;
    scenario.camera.azimuth = 25;
    scenario.light.ambient = 0.2;
    std::map<std::string, std::string> proposed;
    for (const SweptOption& option : sweptOptions(scenario)) proposed[option.name] = option.values;
    EXPECT_EQ(proposed["azimuth"], "-5..55");
    EXPECT_EQ(proposed["ambient"], "0.1..0.4");
}

TEST(Sequence, AnOrbitLeadsAroundOnce) {
    Scenario scenario;
    scenario.camera.azimuth = 30;
    scenario.scene = SceneKind::Floor;
    const auto all = frames("orbit", scenario, 4);
    ASSERT_EQ(all.size(), 4U);
    const std::vector<double> angles{30, 120, 210, 300};
    for (std::size_t n = 0; n < all.size(); ++n) {
        EXPECT_DOUBLE_EQ(all[n].scenario.camera.azimuth, angles[n]);
        EXPECT_EQ(all[n].scenario.camera.elevation, scenario.camera.elevation);
    }
    EXPECT_EQ(all[1].changed(), "azimuth = 120°");
    // Behind a wall there is nothing to see.
    scenario.scene = SceneKind::Wall;
    for (const SequenceFrame& frame : frames("orbit", scenario, 24)) {
        EXPECT_LE(std::abs(frame.scenario.camera.azimuth), 60);
    }
}

TEST(Sequence, WhatIsNoSequenceIsRefused) {
    Scenario scenario;
    for (const char* const text :
         {"", "step", "sweep", "sweep:", "sweep:layers", "sweep:=1..2", "sweep:fov=", "sweep:fov=1..", "sweep:fov=a..b",
          "sweep:fov=10,,20", "sweep:fov=1..2..3", "sweep:fov=0..20", "sweep:width=10..20", "sweep:nothing=1..2",
          "sweep:elevation=0..91", "sweep:fov=nan..20"}) {
        EXPECT_THROW(frames(text, scenario), InputError) << text;
    }
    EXPECT_THROW(frames("sweep:fov=10,20", scenario, 3), InputError) << "the values say how many";
    EXPECT_THROW(parseSequence("steps", 3, "--sequence"), InputError);
    // A camera that is given by its eye has no azimuth.
    scenario.camera.kind = Camera::Kind::Free;
    EXPECT_THROW(frames("orbit", scenario), InputError);
    try {
        frames("sweep:fob=1..2", scenario);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_NE(error.text(Language::English).find("did you mean \"fov\"?"), std::string::npos)
            << error.text(Language::English);
    }
}

}  // namespace

}  // namespace relief
