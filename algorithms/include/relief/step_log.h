// The record of what a tracer did, step by step. Tracers take a sink as a template parameter; with the null sink
// records cost nothing, because they are never made.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace relief {

// The decisions of all tracers: a closed set, so that sentences and drawings cover new tracers without additions.
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

// The subject of a step is what it examined: a closed set of types, filled in by the tracer. Sentences, drawings and
// files depend only on the subject and not on the method or map, so that new tracers need no additions. (s, t): texels,
// in the period in which the ray meets the subject; z in [0, 1]; distances: texels of the metric (x, y, D z), where D
// is the depth of the relief in texels.
namespace subject {
// Coordinates of the ray on a pyramid level, in texels of that level, counted from its first texel.
struct LevelPoint {
    double x = 0;
    double y = 0;
    bool operator==(const LevelPoint&) const = default;
};
// A texel of a level of the max pyramid, or a cell of the surface (level 0), with the largest height in it. ray:
// position of the ray at the beginning of the step, if the next finer level is traversed next: V(i) of [MIP18], with
// V(i+1) = 2 V(i).
struct Texel {
    int level = 0;
    std::int64_t i = 0;
    std::int64_t j = 0;
    double maximum = 0;
    std::optional<LevelPoint> ray{};
    bool operator==(const Texel&) const = default;
};
// A quad of a displacement mesh, [s, s + width] x [t, t + height], with the height of its highest vertex.
struct Quad {
    double s = 0;
    double t = 0;
    double width = 0;
    double height = 0;
    double maximum = 0;
    bool operator==(const Quad&) const = default;
};
// A voxel of a distance map: `footprint` cells along each side, one of `layers` in height. The map claims that the
// surface is at least `distance` away from all of its points; negative: the surface may pass through the voxel, and its
// cells are tested. refined: it claims only that no ray of its class that reaches the voxel without having hit anything
// hits the surface within `distance`.
struct Voxel {
    std::int64_t i = 0;
    std::int64_t j = 0;
    std::int64_t k = 0;
    int footprint = 1;
    int layers = 1;
    double distance = 0;
    bool refined = false;
    bool operator==(const Voxel&) const = default;
};
// A distance looked up at a point of the ray: a sphere that the map claims to be empty. refined: as of Voxel.
struct Sphere {
    double s = 0;
    double t = 0;
    double z = 0;
    double radius = 0;
    bool refined = false;
    bool operator==(const Sphere&) const = default;
};
// A cone with its apex at (s, t, apex) that the map claims to be empty within one azimuth sector of `sectors`. slope:
// heights per texel; 0 if it was not read because the ray is not above the apex. ofCell: it is valid for the whole cell
// (i, j); otherwise it is interpolated at the point of the ray above the apex. square: distances from its axis are the
// larger of |x| and |y|. relaxed: not claimed to be empty; the ray meets the surface in it at most once.
struct Cone {
    double s = 0;
    double t = 0;
    double apex = 0;
    double slope = 0;
    int sector = 0;
    int sectors = 1;
    bool ofCell = true;
    bool square = false;
    bool relaxed = false;
    bool operator==(const Cone&) const = default;
};
// The height of the surface below the ray where it reaches layer n of `count` equal layers; layer 0 is the top plane.
struct Layer {
    int n = 0;
    int count = 1;
    double height = 0;
    bool operator==(const Layer&) const = default;
};
// The height of the surface below one point of the ray.
struct Point {
    double height = 0;
    bool operator==(const Point&) const = default;
};
}  // namespace subject

using Subject = std::variant<subject::Texel, subject::Quad, subject::Voxel, subject::Sphere, subject::Cone,
                             subject::Layer, subject::Point>;
// Names in files: the types of Subject in order, then their variants.
inline constexpr std::array<std::string_view, 11> kSubjectNames{
    "texel", "quad",        "voxel",         "sphere",         "cone",        "layer",
    "point", "square-cone", "refined-voxel", "refined-sphere", "relaxed-cone"};
static_assert(kSubjectNames.size() == std::variant_size_v<Subject> + 4);
inline std::string_view subjectName(const Subject& subject) {
    if (const auto* const cone = std::get_if<subject::Cone>(&subject); cone != nullptr) {
        if (cone->square) return kSubjectNames[7];
        if (cone->relaxed) return kSubjectNames[10];
    }
    if (const auto* const voxel = std::get_if<subject::Voxel>(&subject); voxel != nullptr && voxel->refined) {
        return kSubjectNames[8];
    }
    if (const auto* const sphere = std::get_if<subject::Sphere>(&subject); sphere != nullptr && sphere->refined) {
        return kSubjectNames[9];
    }
    return kSubjectNames[subject.index()];
}

// One decision. [lambdaIn, lambdaOut]: the interval of the ray that it covers; the ray's heights there are 1 - lambda.
// lambdaAfter: where the tracer continued. subject: what was examined. level, i, j, k, value: the columns of step
// files. (i, j): a texel of that level; or a cell of the surface (level 0; under clamp and border, cells are numbered
// from -1); or a voxel with its layer k. For a test or hit it is the tested cell; for points, layers and spheres the
// texel below the ray. value: the stored value that determined the decision (height, maximum, distance, slope).
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
    std::int64_t periodX = 0;  // under repeat: offset of the texel, in whole textures
    std::int64_t periodY = 0;
    Subject subject;

    template <class T>
    const T* as() const {
        return std::get_if<T>(&subject);
    }
    // Returns true if the step examined a single point of the ray.
    bool atPoint() const {
        const auto* const cone = as<subject::Cone>();
        return as<subject::Point>() || as<subject::Layer>() || as<subject::Sphere>() || (cone && !cone->ofCell);
    }
    // Returns true if (i, j) is the texel below the ray and not a texel of a pyramid, a cell or a voxel.
    bool namesTexelUnderRay() const { return atPoint() || as<subject::Quad>() != nullptr; }
    bool tests() const { return decision == Decision::Test || decision == Decision::Hit; }
    // Returns true if the ray advanced because of the claim of a distance or cone map.
    bool trustsMap() const {
        const bool map = as<subject::Voxel>() || as<subject::Sphere>() || as<subject::Cone>();
        return map && decision == Decision::Advance;
    }
    double zIn() const { return 1 - lambdaIn; }
    double zOut() const { return 1 - lambdaOut; }
    bool operator==(const Step&) const = default;
};

// Records nothing. Sinks receive step(make), where make() makes the record, so that sinks that do not need records
// never make them.
struct NullSink {
    template <class Make>
    void step(const Make&) {}
    void read(std::uint32_t) {}
    void startIsHighest() {}
    bool operator==(const NullSink&) const = default;
};

// Counts decision records and fetched values.
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

// Keeps all records, for the teaching views and step files.
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
