// Recommends a technique for a shader: which tracer, with how many steps, over which textures, comes closest to the
// exact picture within limits of steps and texture fetches per ray and of texture memory.
//
// All techniques that have a shader are measured with the numbers that the textures hold: heights, cones and distances
// are rounded to 8 or 16 bits as `relief map` writes them for engines, and the library's method of the same name traces
// them. The error is that of pictures: FLIP against the picture of `exact` over the unrounded heights.
//
// Steps are those of `relief trace --steps`, the start included; the shader's own count is at most as large, because it
// leaves out the start. Fetches are texture fetches of the tracing function: a fetch with a bilinear or trilinear
// filter counts as one, and so does a fetch of one texel or of two channels.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "measuring/advise/recommend.h"

namespace relief {

struct ShaderAdviceOptions {
    explicit ShaderAdviceOptions(HeightField heights);

    HeightField field;    // bilinear, not read by tiles
    std::string name;     // of the height map, for messages
    std::string heights;  // arguments of `relief map` that name it, each after a space
    std::vector<Elevation> views = parseViews("10,80", "--views");
    std::int64_t maxSteps = 0;                      // per ray; 0: no limit
    std::int64_t maxFetches = 0;                    // per ray; 0: no limit
    std::int64_t memory = std::int64_t{256} << 20;  // bytes of all textures that the tracing function reads
    std::optional<double> error;                    // largest mean FLIP; without it the error is to be the smallest
    double seconds;                                 // for everything
    std::uint64_t seed = 1;
    std::shared_ptr<const ColorImage> color = nullptr;  // null: a picture of coloured patches
    int width = 240, height = 180;                      // of the pictures
};

// What the tracing function reads, besides the picture's colours.
enum class ShaderMap : std::uint8_t {
    Heights,
    SurfaceCones,
    RelaxedCones,
    RobustRelaxedCones,
    CellCones,
    Maxima,
    Distances
};
// The filter of the tracing function's fetches. Bilinear: heights. HeightAndCone: both in one bilinear fetch. Volume:
// a bilinear fetch of the height and a trilinear one of the distance for each step. Texels: unfiltered.
enum class FetchKind : std::uint8_t { Bilinear, HeightAndCone, Volume, Texels };
std::string_view fetchKindName(FetchKind kind);

struct AdvisedTexture {
    std::string format;  // "R16": channels and bits, unsigned normalised
    MessageId holds{};   // in words
    int width = 0, height = 0, depth = 1, levels = 1;
    std::int64_t bytes() const;  // of all levels
};

// A technique with all its numbers; NaN: not measured.
struct ShaderForm {
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

    MethodChoice method;
    ShaderMap map = ShaderMap::Heights;
    int bits = 16;  // of each channel
    FetchKind fetchKind = FetchKind::Bilinear;
    Guarantee guarantee{};
    std::vector<AdvisedTexture> textures;
    Verdict verdict = Verdict::Kept;
    // The largest numbers per ray. bounded: no ray at all takes more, because the shader's loop ends there; otherwise
    // they are the largest over the measured rays.
    std::int64_t mostSteps = 0, mostFetches = 0;
    bool bounded = false;
    double stepsP99 = kUnknown, fetchesP99 = kUnknown, stepsMean = kUnknown, fetchesMean = kUnknown;
    double flip = kUnknown, flipWorst = kUnknown;  // mean over all pixels of the relief; of the worst view
    double shiftP99 = kUnknown;                    // how far the texture appears from its place, pixels
    double displaced = kUnknown;  // share of the pixels where that is more than 1, or hit and miss differ
    double buildSeconds = 0;
    std::vector<std::string> commands;  // that write the textures, and last the shader

    std::int64_t bytes() const;
    bool measured() const { return !std::isnan(flip); }
};

struct ShaderAdvice {
    std::vector<ShaderForm> forms;  // those within the limits first, by increasing error; then the others, likewise
    std::size_t chosen = 0;
    bool keepsLimits = true;  // otherwise the chosen form is the one that exceeds the limits least
    int pictures = 0;
    std::int64_t rays = 0;  // measured for each form

    const ShaderForm& best() const { return forms[chosen]; }
};

// Measures all techniques. Throws Cancelled, InputError for a field that has other than the bilinear surface.
ShaderAdvice recommendShader(const ShaderAdviceOptions& options, Work& work);

// Returns the forms to measure with textures of `bits`: of each technique those numbers of layers or iterations that
// the limits allow, and some smaller ones; at least one, which may exceed the limits.
std::vector<ShaderForm> shaderForms(const ShaderAdviceOptions& options, int bits);
// Orders the forms and chooses one. Forms of nearly equal error count as equal, and the one with the fewest fetches is
// chosen.
ShaderAdvice shaderAdviceOf(const ShaderAdviceOptions& options, std::vector<ShaderForm> forms);

// Returns the rows of a table: of each technique and texture the form that would be chosen if there were no others; in
// the order of advice.forms.
std::vector<std::size_t> shaderRows(const ShaderAdviceOptions& options, const ShaderAdvice& advice);

std::string shaderAdviceText(const ShaderAdviceOptions& options, const ShaderAdvice& advice,
                             Language language = Language::English);
std::string shaderAdviceJson(const ShaderAdviceOptions& options, const ShaderAdvice& advice);  // with "\n"

}  // namespace relief
