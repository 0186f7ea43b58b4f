// What a tracer did, step by step.
// Tracers take a sink as a template parameter; the null sink costs nothing: its records are never even made.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace relief {

// The closed set that sentences and drawings are keyed on: a new tracer adds none.
enum class Decision : std::uint8_t { Start, Skip, Descend, Ascend, Advance, Test, Refine, Hit, Miss, Limit };
inline constexpr std::array<std::string_view, 10> kDecisionNames{"start", "skip",   "descend", "ascend", "advance",
                                                                 "test",  "refine", "hit",     "miss",   "limit"};
constexpr std::string_view decisionName(Decision decision) {
    return kDecisionNames[static_cast<std::size_t>(decision)];
}

enum class Phase : std::uint8_t { Start, Search, Refine };
inline constexpr std::array<std::string_view, 3> kPhaseNames{"start", "search", "refine"};
constexpr std::string_view phaseName(Phase phase) {
    return kPhaseNames[static_cast<std::size_t>(phase)];
}

// What a step looked at, which drawings and sentences show as such: the stored value of a texel (or the surface within
// a cell), or the surface at one point of the ray.
enum class Primitive : std::uint8_t { Texel, Point };

// One decision. Level and texel (i, j) of a pyramid, or voxel (i, j, k); level 0 cells of clamp and border run from -1.
// [lambdaIn, lambdaOut]: the stretch of the ray that the decision is about; the ray's heights there are 1 - lambda.
// value: the stored value that decided (height, maximum, distance). lambdaAfter: where the tracer went on.
struct Step {
    Phase phase = Phase::Search;
    Decision decision = Decision::Test;
    Primitive primitive = Primitive::Texel;
    int level = 0;
    std::int64_t i = 0;
    std::int64_t j = 0;
    std::int64_t k = 0;
    double lambdaIn = 0;
    double lambdaOut = 0;
    double value = 0;
    double lambdaAfter = 0;
    std::int64_t periodX = 0;  // under repeat: by how many whole textures the texel is moved
    std::int64_t periodY = 0;

    double zIn() const { return 1 - lambdaIn; }
    double zOut() const { return 1 - lambdaOut; }
    bool operator==(const Step&) const = default;
};

// A sink: step(make) is given a function that makes the record, so that sinks which do not look never make one.
struct NullSink {
    template <class Make>
    void step(const Make&) {}
    void read(std::uint32_t) {}
    void startIsHighest() {}
    bool operator==(const NullSink&) const = default;
};

// Counts decision records and stored values fetched.
struct CountSink {
    std::uint32_t steps = 0;
    std::uint32_t reads = 0;
    bool highest = false;

    template <class Make>
    void step(const Make&) {
        ++steps;
    }
    void read(std::uint32_t values) { reads += values; }
    void startIsHighest() { highest = true; }
};

// Keeps everything, for the teaching views and step files.
struct LogSink {
    std::vector<Step> steps;
    std::uint32_t reads = 0;

    template <class Make>
    void step(const Make& make) {
        steps.push_back(make());
    }
    void read(std::uint32_t values) { reads += values; }
    void startIsHighest() {}
};

}  // namespace relief
