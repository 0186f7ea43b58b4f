// Recommends a method, filter and map for a height map, a range of views, an error bound and a memory limit, by
// measuring on that height map.
//
// Successive elimination (Even-Dar, Mannor, Mansour 2006): all forms of all methods are measured in turn in short
// rounds, on the same rays. Dropped are forms that break the error bound or the memory limit, those that take too long
// to build, and after each round those that are slower than the best by more than the measurement error of the rounds
// so far.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "filtering/filters/filter_choice.h"
#include "measuring/bench/bench_tracers.h"
#include "relief/image.h"

namespace relief {

// Parses a range of views: "10,80" gives kAdviceViews elevations spaced uniformly from the first to the last, in
// degrees; one number gives that elevation alone, "random" the random view. Throws InputError naming the option.
inline constexpr int kAdviceViews = 4;
std::vector<Elevation> parseViews(const std::string& text, const std::string& option);
std::string viewsText(const std::vector<Elevation>& views);

// Returns the time, seconds, that suffices to build the promising maps of these heights on two threads: 4 up to 1024 x
// 1024 texels, then growing with the side, to 16 from 4096 x 4096 on.
double adviceSeconds(const HeightField& field);

struct AdviceOptions {
    explicit AdviceOptions(HeightField heights) : field(std::move(heights)), seconds(adviceSeconds(field)) {}

    HeightField field;
    std::string name;  // of the height map, for messages
    std::vector<Elevation> views = parseViews("10,80", "--views");
    double error = 0.5;                             // texels
    double outliers = 1e-4;                         // share of the rays that may have a larger error or another outcome
    std::int64_t memory = std::int64_t{256} << 20;  // bytes, of maps without the heights
    double seconds;  // total time; verifying forms and a filter's reference may exceed it a little
    // Simd: the cost is processor time of this library's fastest code on one thread. Scalar: the cost of a port to a
    // shader, with only the maps that the port needs; it is dominated by memory look-ups and is therefore counted,
    // reads + stepCost x steps, equal on every machine.
    Form form = Form::Simd;
    std::int64_t maxSteps = 0;  // per ray, except for the share of outliers; 0: no limit
    double stepCost = 2;        // cost of a step's arithmetic, in reads; Scalar only
    std::uint64_t seed = 1;
    bool filters = true;
    std::shared_ptr<const ColorImage> color = nullptr;  // for the filters; null: a picture of coloured patches
    std::vector<MethodChoice> forms;                    // empty: adviceForms()
};

// Returns every tracer with its default options and with the option values that are worth measuring. lowest: lowest
// elevation of the views, degrees. maxSteps: step limit per ray, 0: none; numbers of layers and iterations that just
// keep this limit are included. form: Scalar leaves out maps that cannot be stored in a file.
std::vector<MethodChoice> adviceForms(const HeightField& field, double lowest, std::int64_t maxSteps = 0,
                                      Form form = Form::Simd);

// Fetches: of recommend_shader.h only.
enum class Verdict : std::uint8_t { Kept, Error, Steps, Memory, BuildTime, Refused, Slow, Fetches };
std::string_view verdictName(Verdict verdict);

// Measurements of a form; NaN: not measured, because it was dropped before.
struct AdvisedForm {
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

    MethodChoice method;
    Verdict verdict = Verdict::Kept;
    Guarantee guarantee{};
    double secondsPerRay = kUnknown;  // processor seconds per ray on one thread, median of the rounds; Form::Simd only
    double steps = kUnknown, reads = kUnknown;
    std::int64_t mostSteps = 0;   // maximum over all rays
    double overSteps = kUnknown;  // share of the rays that take more than AdviceOptions::maxSteps
    double cost = kUnknown;       // the criterion: seconds per ray, or reads + stepCost x steps
    double beyond = kUnknown;     // share of the rays past the error bound
    double largest = kUnknown;    // largest error, texels
    std::int64_t bytes = 0;       // of its maps, without the heights
    double buildSeconds = 0;
    int rounds = 0;
};

struct ReliefFigures {
    static constexpr int kTile = 8;  // texels
    double roughness = 0;            // mean slope between neighbours: |height difference| / distance
    double flatTiles = 0;            // share of tiles whose heights differ by less than half a texel
    double steep = 0;                // share of neighbouring texels with a slope above 45 degrees between them
    bool flat = false;               // all heights are equal
};
// Computes these statistics over the whole height map, or over a sample of a map that is read by tiles.
ReliefFigures reliefFigures(const HeightField& field);

struct FilterFigures {
    FilterChoice filter;
    double rmse = 0;    // linear light, compared with a Gaussian pixel; maximum over the elevations
    double texels = 0;  // per pixel, mean over the elevations
    double rate = 0;    // pixels per second, minimum over the elevations
};
struct FilterAdvice {
    std::vector<FilterFigures> filters;
    // index of the filter of smallest error among those that take at most kLiveTimes of trilinear's time
    std::size_t live = 0;
    std::size_t still = 0;  // index of the filter of smallest error
    double elevation = 0;   // lowest elevation measured, degrees
    double anisotropy = 1;  // length over width of a footprint at that elevation, on the plane
};
inline constexpr double kLiveTimes = 25;
inline constexpr int kClosePercent = 10;  // forms whose costs differ by less when the time is up count as undecided

struct Advice {
    std::vector<AdvisedForm> forms;  // kept forms first, by increasing cost
    std::size_t chosen = 0;
    // The cheapest kept form; it is not chosen if another one's cost is equal within the measurement error and its map
    // is smaller.
    std::size_t cheapest = 0;
    // the second form, if the first is chosen and the second keeps the bounds; otherwise the chosen one
    std::size_t next = 0;
    std::size_t exact = 0;                  // the form `exact` without a map
    std::optional<std::size_t> withoutMap;  // the cheapest form without a map that keeps the bounds
    std::optional<std::size_t> rebuilt;     // better than the chosen form if the heights change after each picture
    // number of rays after which the chosen form's map has paid for itself compared with `rebuilt`
    double paysAfterRays = 0;
    bool keepsBounds = true;     // whether the chosen form keeps the bounds; otherwise it is the one that comes nearest
    std::size_t stillClose = 0;  // number of forms whose order is undecided because the time was up; 0: decided
    ReliefFigures relief;
    std::optional<FilterAdvice> filter;  // empty without options.filters, and for maps too narrow to compare filters

    const AdvisedForm& best() const { return forms[chosen]; }
};

// Measures all forms within about options.seconds and returns the advice. Throws Cancelled.
Advice recommend(const AdviceOptions& options, Work& work);

// Measures the library's filters on small pictures of the map; with more than 10 seconds the pictures are larger.
// Returns std::nullopt if the map is so narrow that no pixel of them can be compared. Throws Cancelled.
std::optional<FilterAdvice> recommendFilter(const AdviceOptions& options, double seconds, Work& work);

// Returns the advice as text with reasons, and as JSON.
std::string adviceText(const AdviceOptions& options, const Advice& advice, Language language = Language::English);
std::string adviceJson(const AdviceOptions& options, const Advice& advice);  // with "\n"
// Returns notes for standard error: the time was too short, no filter could be compared, or building the map dominates.
std::vector<Message> adviceNotes(const AdviceOptions& options, const Advice& advice);

// Quality of the advice. The regret is the chosen form's cost divided by that of the best valid form, minus 1, where
// every form is measured completely on other rays. Valid: keeps the error bound and AdviceOptions::maxSteps on those
// rays.
struct AdviceRegret {
    MethodChoice chosen, best;
    double chosenCost = 0, bestCost = 0;
    double chosenBeyond = 0;  // share of the other rays past the error bound
    bool keepsBound = true;   // the chosen form is valid on the other rays, or the advice stated that no form is
    double adviceSeconds = 0, tableSeconds = 0;
    std::size_t measured = 0;  // number of forms measured
    bool anyIsValid() const { return std::isfinite(bestCost); }
    double regret() const { return chosenCost / bestCost - 1; }  // requires anyIsValid()
};
// Runs the advice, and then measures all forms completely. Throws Cancelled.
AdviceRegret adviceRegret(const AdviceOptions& options, Work& work);

// The advice for one of several reliefs.
struct CheckedRelief {
    std::string name;
    AdviceRegret advice;
};
// Returns true if the advice keeps its bound on all reliefs.
bool keepsBounds(std::span<const CheckedRelief> reliefs);
// Returns a table of the reliefs, followed by a summary line.
std::string regretText(std::span<const CheckedRelief> reliefs);

}  // namespace relief
