// What a tracer did, step by step.
// Tracers take a sink as a template parameter; the null sink costs nothing: its records are never even made.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
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

// What a step looked at: a closed set, filled by the tracer. Sentences, drawings and files are keyed on it and never
// ask which method or map it was, so a new tracer adds none. (s, t): texels, in the period in which the ray meets the
// place; z in [0, 1]; distances: texels of the metric (x, y, D z), D the relief's depth in texels.
namespace subject {
// Coordinates of the ray on a level of a pyramid, in texels of that level, counted from its first.
struct LevelPoint {
    double x = 0;
    double y = 0;
    bool operator==(const LevelPoint&) const = default;
};
// A texel of a level of the max pyramid, or a cell of the surface (level 0), and the largest height in it.
// ray: where the ray is at the step's beginning, [MIP18]'s V(i), where the next level down is walked: V(i+1) = 2 V(i).
struct Texel {
    int level = 0;
    std::int64_t i = 0;
    std::int64_t j = 0;
    double maximum = 0;
    std::optional<LevelPoint> ray{};
    bool operator==(const Texel&) const = default;
};
// A quad of a displacement mesh, [s, s + width] x [t, t + height], and the height of its highest vertex.
struct Quad {
    double s = 0;
    double t = 0;
    double width = 0;
    double height = 0;
    double maximum = 0;
    bool operator==(const Quad&) const = default;
};
// A voxel of a distance map: `footprint` cells a side, one of `layers` in height. From all of its points the surface is
// said to be at least `distance` away; negative: the surface may pass through it, and its cells are tested.
struct Voxel {
    std::int64_t i = 0;
    std::int64_t j = 0;
    std::int64_t k = 0;
    int footprint = 1;
    int layers = 1;
    double distance = 0;
    bool operator==(const Voxel&) const = default;
};
// A distance looked up at a point of the ray: a sphere that is said to be empty.
struct Sphere {
    double s = 0;
    double t = 0;
    double z = 0;
    double radius = 0;
    bool operator==(const Sphere&) const = default;
};
// A cone that stands on (s, t, apex) and is said to be empty within its azimuth sector, one of `sectors`.
// slope: heights per texel; 0 where it was not read because the ray is not above the apex. ofCell: it holds for the
// whole cell (i, j); else it is interpolated at the point of the ray above the apex. square: distances from its axis
// are the larger of |x| and |y|.
struct Cone {
    double s = 0;
    double t = 0;
    double apex = 0;
    double slope = 0;
    int sector = 0;
    int sectors = 1;
    bool ofCell = true;
    bool square = false;
    bool operator==(const Cone&) const = default;
};
// The surface's height under the ray where it reaches layer n of `count` equal layers, 0 the top plane.
struct Layer {
    int n = 0;
    int count = 1;
    double height = 0;
    bool operator==(const Layer&) const = default;
};
// The surface's height under one point of the ray.
struct Point {
    double height = 0;
    bool operator==(const Point&) const = default;
};
}  // namespace subject

using Subject = std::variant<subject::Texel, subject::Quad, subject::Voxel, subject::Sphere, subject::Cone,
                             subject::Layer, subject::Point>;
// In files: the kinds of Subject, and last cones that are square.
inline constexpr std::array<std::string_view, 8> kSubjectNames{"texel", "quad",  "voxel", "sphere",
                                                               "cone",  "layer", "point", "square-cone"};
static_assert(kSubjectNames.size() == std::variant_size_v<Subject> + 1);
inline std::string_view subjectName(const Subject& subject) {
    const auto* const cone = std::get_if<subject::Cone>(&subject);
    return cone != nullptr && cone->square ? kSubjectNames.back() : kSubjectNames[subject.index()];
}

// One decision. [lambdaIn, lambdaOut]: the part of the ray that it is about; the ray's heights there are 1 - lambda.
// lambdaAfter: where the tracer went on. subject: what it looked at.
// level, i, j, k, value are the columns of step files. (i, j): texel of that level, or cell of the surface (level 0;
// those of clamp and border count from -1), or voxel with k its layer; of a test or hit the cell that was tested; of
// points, layers and spheres the texel under the ray. value: the stored value that decided (height, maximum, distance,
// slope).
struct Step {
    Phase phase = Phase::Search;
    Decision decision = Decision::Test;
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
    Subject subject;

    template <class T>
    const T* as() const {
        return std::get_if<T>(&subject);
    }
    // It looked at a single point of the ray.
    bool atPoint() const {
        const auto* const cone = as<subject::Cone>();
        return as<subject::Point>() || as<subject::Layer>() || as<subject::Sphere>() || (cone && !cone->ofCell);
    }
    // (i, j) is the texel under the ray, not a texel of a pyramid, cell or voxel.
    bool namesTexelUnderRay() const { return atPoint() || as<subject::Quad>() != nullptr; }
    bool tests() const { return decision == Decision::Test || decision == Decision::Hit; }
    // Whether it went on because a map of distances or cones says that nothing is there.
    bool trustsMap() const {
        const bool map = as<subject::Voxel>() || as<subject::Sphere>() || as<subject::Cone>();
        return map && decision == Decision::Advance;
    }
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
