// Which method, filter and map suit a height map, a range of views, an error bound and a memory: measured on it.
//
// Successive elimination (Even-Dar, Mannor, Mansour 2006): short rounds over all forms of all methods in turn, all on
// the same rays; out goes what breaks the error bound or the memory, what takes too long to build, and in each round
// what is slower than the best by more than the rounds so far can mistake.
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

// "10,80" into kAdviceViews elevations evenly from the one to the other (one number: that alone), "random" into the
// random one. InputError naming the option.
inline constexpr int kAdviceViews = 4;
std::vector<Elevation> parseViews(const std::string& text, const std::string& option);
std::string viewsText(const std::vector<Elevation>& views);

struct AdviceOptions {
    explicit AdviceOptions(HeightField heights) : field(std::move(heights)) {}

    HeightField field;
    std::string name;  // of the height map, for texts
    std::vector<Elevation> views = parseViews("10,80", "--views");
    double error = 0.5;                             // texels
    double outliers = 1e-4;                         // share of the rays that may be further off, or wrong
    std::int64_t memory = std::int64_t{256} << 20;  // bytes, of maps beside the heights
    double seconds = 20;                            // for all; a filter's reference may take a little longer
    // Simd: processor time of this library's fastest code, on one thread. Scalar: what a writer of shaders would port,
    // and the maps of that alone; there the look-ups decide: cost = reads + stepCost x steps, counted, so the same on
    // every machine.
    Form form = Form::Simd;
    std::int64_t maxSteps = 0;  // a ray may take, but for the share of outliers; 0: any number
    double stepCost = 2;        // reads that a step's arithmetic is worth, Scalar
    std::uint64_t seed = 1;
    bool filters = true;
    std::shared_ptr<const ColorImage> color = nullptr;  // for the filters; none: coloured patches
    std::vector<MethodChoice> forms;                    // empty: adviceForms()
};

// Every tracer of the list as it is by default and with those values of its options that are worth a trial. lowest: of
// the views, degrees.
// maxSteps: of a ray, 0: any number; numbers of layers and iterations that it allows are then tried, too.
std::vector<MethodChoice> adviceForms(const HeightField& field, double lowest, std::int64_t maxSteps = 0);

enum class Verdict : std::uint8_t { Kept, Error, Steps, Memory, BuildTime, Refused, Slow };
std::string_view verdictName(Verdict verdict);

// What is known of a form; NaN: not measured, because it was out before.
struct AdvisedForm {
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

    MethodChoice method;
    Verdict verdict = Verdict::Kept;
    Guarantee guarantee{};
    double secondsARay = kUnknown;  // of one thread's processor, median of the rounds; Form::Simd only
    double steps = kUnknown, reads = kUnknown;
    std::int64_t mostSteps = 0;   // of a ray
    double overSteps = kUnknown;  // share of the rays that take more than AdviceOptions::maxSteps
    double cost = kUnknown;       // what decides: seconds a ray, or reads + stepCost x steps
    double beyond = kUnknown;     // share of the rays past the bound
    double largest = kUnknown;    // error, texels
    std::int64_t bytes = 0;       // beside the heights
    double buildSeconds = 0;
    int rounds = 0;
};

struct ReliefFigures {
    static constexpr int kTile = 8;  // texels
    double roughness = 0;            // mean of |height difference| of neighbours over their distance
    double flatTiles = 0;            // share of tiles that rise by less than half a texel
    double steep = 0;                // share of neighbours with more than 45 degrees between them
    bool flat = false;               // all heights are equal
};
ReliefFigures reliefFigures(const HeightField& field);

struct FilterFigures {
    FilterChoice filter;
    double rmse = 0;    // linear light, against a Gaussian pixel, worst of the elevations
    double texels = 0;  // a pixel, mean of the elevations
    double rate = 0;    // pixels a second, least of the elevations
};
struct FilterAdvice {
    std::vector<FilterFigures> filters;
    std::size_t live = 0;   // least error of those that take at most kLiveTimes of trilinear's time
    std::size_t still = 0;  // least error of all
    double elevation = 0;   // the flattest measured, degrees
    double anisotropy = 1;  // length over width of a footprint there, on the plane
};
inline constexpr double kLiveTimes = 25;
inline constexpr int kClosePercent = 10;  // what is closer when the time is up was not told apart

struct Advice {
    std::vector<AdvisedForm> forms;  // kept ones first, the cheapest first
    std::size_t chosen = 0;
    // The cheapest that was kept; not chosen where another is as cheap within what can be measured and is leaner.
    std::size_t cheapest = 0;
    std::size_t next = 0;   // the second of forms, if the first is chosen and that keeps the bounds; else the chosen
    std::size_t exact = 0;  // the plain walk
    std::optional<std::size_t> withoutMap;  // the cheapest form without a map that keeps the bound
    std::optional<std::size_t> rebuilt;     // better than the chosen where heights change; see pays()
    double paysAfterRays = 0;               // when the chosen one's map has paid for itself against that
    bool keepsBounds = true;                // the chosen form does; else it is the one that comes nearest
    std::size_t stillClose = 0;             // forms that the time was too short to tell apart; 0: told apart
    ReliefFigures relief;
    std::optional<FilterAdvice> filter;

    const AdvisedForm& best() const { return forms[chosen]; }
};

// Throws Cancelled.
Advice recommend(const AdviceOptions& options, Work& work);

FilterAdvice recommendFilter(const AdviceOptions& options, double seconds, Work& work);

std::string adviceText(const AdviceOptions& options, const Advice& advice, Language language = Language::English);
std::string adviceJson(const AdviceOptions& options, const Advice& advice);  // with "\n"
// Notes for standard error: the time was up, the map's building dominates.
std::vector<Message> adviceNotes(const AdviceOptions& options, const Advice& advice);

// How good the advice is: the chosen form's cost over that of the best valid one in the full table, every form measured
// to the end on other rays, less 1. Valid: within the error bound and AdviceOptions::maxSteps there.
struct AdviceRegret {
    MethodChoice chosen, best;
    double chosenCost = 0, bestCost = 0;
    double chosenBeyond = 0;  // share of the other rays past the bound
    bool keepsBound = true;   // the chosen form is valid there, or the advice said that none is
    double adviceSeconds = 0, tableSeconds = 0;
    std::size_t measured = 0;  // forms of the full table
    bool anyIsValid() const { return std::isfinite(bestCost); }
    double regret() const { return chosenCost / bestCost - 1; }  // where any is valid
};
AdviceRegret adviceRegret(const AdviceOptions& options, Work& work);

// The advice for several reliefs.
struct CheckedRelief {
    std::string name;
    AdviceRegret advice;
};
// Whether it keeps its bound on every one of them.
bool keepsBounds(std::span<const CheckedRelief> reliefs);
// A table of the reliefs, and a line about all of them.
std::string regretText(std::span<const CheckedRelief> reliefs);

}  // namespace relief
