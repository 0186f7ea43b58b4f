// The measurements behind the table of claims.
#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "measuring/bench/bench_filters.h"
#include "measuring/bench/bench_rows.h"
#include "measuring/bench/bench_tracers.h"
#include "measuring/bench/claims.h"
#include "measuring/bench/machine.h"
#include "relief/methods/distance.h"
#include "relief/reliefs.h"

namespace relief {

namespace {

constexpr double kReliefDepth = 0.2;
constexpr double kLowest = 10;        // lowest elevation of random rays, degrees
constexpr double kWrongTexels = 0.5;  // a hit with a larger error counts as wrong
constexpr std::uint64_t kSeed = 1;
constexpr int kDigits = 3;
constexpr std::array<const char*, 6> kReliefs{"bricks", "pits", "city", "columns", "fractal", "hills"};

std::string number(double value) {
    return numberText(value, kDigits);
}

// A method's answers for the rays of one relief, compared with those of exact.
struct Counted {
    double steps = 0, reads = 0;  // mean per ray
    // share of the rays with an error above kWrongTexels, and of those behind the surface by as much
    double wrong = 0, beyond = 0;
    double error = 0;            // mean, texels, of rays that hit
    std::int64_t different = 0;  // number of rays whose answer differs in any bit
};

struct Views {
    RayBlock rays;
    HitBlock truth;
};

struct Subject {
    std::string name;
    HeightField field;
    std::map<std::string, Views> views;  // "random", "80", "8", "1"
};

// The minimum and maximum of a value over the reliefs, with the reliefs' names.
struct Range {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
    std::string leastOn, mostOn;

    void add(const std::string& name, double value) {
        if (value < least) least = value, leastOn = name;
        if (value > most) most = value, mostOn = name;
    }
    std::vector<MessageValue> values(double scale = 1) const {
        return {
            {"least", number(least * scale)}, {"leastOn", leastOn}, {"most", number(most * scale)}, {"mostOn", mostOn}};
    }
};

class Measuring {
  public:
    Measuring(const ClaimsOptions& options, Work& work) : options_(options), work_(work) {
        for (const char* name : kReliefs) subjects_.push_back(subject(name));
    }

    std::vector<MeasuredClaim> all() {
        using Part = void (Measuring::*)();
        for (const Part part : {&Measuring::pyramids, &Measuring::approximations, &Measuring::distances,
                                &Measuring::refined, &Measuring::rows, &Measuring::filters}) {
            (this->*part)();
            work_.throwIfStopped();
        }
        return std::move(claims_);
    }

  private:
    Subject subject(const std::string& name) {
        const auto heights = std::make_shared<FloatImage>(makeRelief(name, options_.size, options_.size, kSeed));
        Subject made{name, HeightField(heights, Surface::Bilinear, Address::Repeat, kReliefDepth), {}};
        const auto count = static_cast<std::size_t>(options_.rays);
        made.views["random"].rays = benchRays(made.field, std::nullopt, count, kSeed, kLowest);
        for (const double degrees : {80.0, 8.0, 1.0}) {
            made.views[numberText(degrees)].rays = benchRays(made.field, degrees, count, kSeed);
        }
        MapCache none;
        const auto exact = makeTracer({"exact", {}}, made.field, none, work_);
        for (auto& [view, both] : made.views) {
            BlockCounts counts;
            exact->trace(both.rays, both.truth, counts, work_);
        }
        return made;
    }

    const Subject& on(const std::string& name) const {
        return *std::find_if(subjects_.begin(), subjects_.end(), [&](const Subject& s) { return s.name == name; });
    }

    Counted count(const std::string& method, const Subject& subject, const std::string& view = "random") {
        const auto [place, isNew] = known_.try_emplace({method, subject.name, view});
        Counted& got = place->second;
        if (!isNew) return got;
        const Views& views = subject.views.at(view);
        MapCache cache;
        const auto tracer = makeTracer(parseMethodChoice(method, "claims"), subject.field, cache, work_, Form::Scalar);
        HitBlock hits;
        BlockCounts counts;
        tracer->trace(views.rays, hits, counts, work_);
        const auto each = 1 / static_cast<double>(views.rays.size());
        got.steps = static_cast<double>(counts.steps) * each;
        got.reads = static_cast<double>(counts.reads) * each;
        for (std::size_t i = 0; i < views.rays.size(); ++i) {
            const double length = std::max(1.0, std::hypot(views.rays.a[i], views.rays.b[i]));
            const double late = (hits.lambda[i] - views.truth.lambda[i]) * length;
            // NaN (no hit) counts as wrong, since every ray hits under repeat addressing.
            if (!(std::abs(late) <= kWrongTexels)) got.wrong += each;
            if (!(late <= kWrongTexels)) got.beyond += each;
            if (std::isfinite(late)) got.error += std::abs(late) * each;
            const bool same = hits.outcome[i] == views.truth.outcome[i] && hits.lambda[i] == views.truth.lambda[i] &&
                              hits.s[i] == views.truth.s[i] && hits.t[i] == views.truth.t[i];
            got.different += same ? 0 : 1;
        }
        return got;
    }

    // Returns the mean over the reliefs.
    template <class Get>
    double mean(const std::string& method, const Get& get, const std::string& view = "random") {
        double sum = 0;
        for (const Subject& subject : subjects_) sum += get(count(method, subject, view));
        return sum / static_cast<double>(subjects_.size());
    }
    double wrong(const std::string& method) {
        return 100 * mean(method, [](const Counted& c) { return c.wrong; });
    }
    // Returns the range of the number of steps relative to another method.
    Range stepShares(const std::string& method, const std::string& of) {
        Range range;
        for (const Subject& s : subjects_) range.add(s.name, count(method, s).steps / count(of, s).steps);
        return range;
    }

    void say(const std::string& id, ClaimVerdict verdict, std::vector<MessageValue> values) {
        claims_.push_back({id, verdict, std::move(values)});
    }
    static ClaimVerdict confirmedIf(bool holds) { return holds ? ClaimVerdict::Confirmed : ClaimVerdict::Refuted; }

    void pyramids();
    void diagonal();
    void highest();
    void twoPerLevel();
    void excludes();
    void rates();
    void approximations();
    void distances();
    void manyNear();
    void example();
    void refined();
    void rows();
    void streams();
    void derivatives();
    void filters();

    const ClaimsOptions& options_;
    Work& work_;
    std::vector<Subject> subjects_;
    std::map<std::tuple<std::string, std::string, std::string>, Counted> known_;
    std::vector<MeasuredClaim> claims_;
};

void Measuring::pyramids() {
    const std::string paper = "max-pyramid-paper";
    int fewer = 0;
    int fewerReads = 0;
    std::int64_t different = 0;
    std::vector<MessageValue> shares;
    Range range;
    for (const Subject& s : subjects_) {
        const Counted own = count(paper, s);
        const Counted exact = count("exact", s);
        fewer += own.steps < exact.steps ? 1 : 0;
        fewerReads += own.reads < exact.reads ? 1 : 0;
        different += own.different;
        range.add(s.name, own.steps / exact.steps);
        shares.emplace_back(s.name, number(own.steps / exact.steps));
    }
    const auto all = static_cast<int>(subjects_.size());
    const auto some = [&](int count) {
        return count == all ? ClaimVerdict::Confirmed : (count == 0 ? ClaimVerdict::Refuted : ClaimVerdict::Depends);
    };
    say("many-cases", some(fewer), {{"fewer", fewer}, {"all", all}, {"fewerReads", fewerReads}});
    say("no-loss", confirmedIf(different == 0), {{"different", different}, {"rays", all * options_.rays}});
    say("bricks-best", confirmedIf(range.leastOn == "bricks"), shares);
    const Range cone = stepShares("cone", "exact");
    // "Strongly" is taken as a factor of two between two reliefs.
    say("gain-by-relief", confirmedIf(cone.most > 2 * cone.least), cone.values());
    const Range hybrid = stepShares("hybrid:inner=distance-conservative", "distance-conservative");
    int pays = 0;
    for (const Subject& s : subjects_) {
        pays += count("hybrid:inner=distance-conservative", s).steps < count("distance-conservative", s).steps ? 1 : 0;
    }
    auto values = hybrid.values();
    values.emplace_back("fewer", pays);
    values.emplace_back("all", all);
    say("hybrid", some(pays), values);
    diagonal();
    highest();
    twoPerLevel();
    excludes();
    rates();
}

void Measuring::diagonal() {
    std::int64_t most = 0;
    std::int64_t above = 0;
    for (const Subject& s : subjects_) {
        const Views& views = s.views.at("1");
        for (std::size_t i = 0; i < views.rays.size(); ++i) {
            const std::int64_t cells = static_cast<std::int64_t>(views.truth.steps[i]) - 1;  // without the start step
            most = std::max(most, cells);
            const double bound = std::abs(views.rays.a[i]) + std::abs(views.rays.b[i]) + 2;
            above += static_cast<double>(cells) > bound ? 1 : 0;
        }
    }
    const double diagonal = std::numbers::sqrt2 * options_.size;
    say("diagonal", confirmedIf(static_cast<double>(most) <= diagonal),
        {{"most", most},
         {"diagonal", number(diagonal)},
         {"above", above},
         {"rays", static_cast<std::int64_t>(subjects_.size()) * options_.rays}});
}

void Measuring::highest() {
    const auto heights = std::make_shared<FloatImage>(makeRelief("checker", options_.size, options_.size, kSeed));
    const HeightField field(heights, Surface::Columns, Address::Repeat, kReliefDepth);
    const RayBlock rays = benchRays(field, std::nullopt, static_cast<std::size_t>(options_.rays), kSeed, kLowest);
    MapCache cache;
    const auto paper = makeTracer({"max-pyramid-paper", {}}, field, cache, work_, Form::Scalar);
    const auto exact = makeTracer({"exact", {}}, field, cache, work_);
    HitBlock truth;
    NullSink null;
    exact->trace(rays, truth, null, work_);
    std::int64_t highest = 0;
    std::int64_t hidden = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RayBlock one;
        one.push(rays[i]);
        HitBlock hits;
        BlockCounts counts;
        paper->trace(one, hits, counts, work_);
        if (counts.startHighest == 0) continue;
        ++highest;
        hidden += hits.lambda[0] == truth.lambda[i] ? 0 : 1;
    }
    say("highest", confirmedIf(highest > 0 && hidden == 0),
        {{"highest", highest}, {"rays", options_.rays}, {"hidden", hidden}});
}

// Counts, for recursions that end with the return to the level above, how many of the four texels each visited.
void Measuring::twoPerLevel() {
    constexpr std::size_t kMost = 3;
    std::array<std::int64_t, kMost + 1> taken{};
    for (const Subject& s : subjects_) {
        MapCache cache;
        const auto paper = makeTracer({"max-pyramid-paper", {}}, s.field, cache, work_, Form::Scalar);
        HitBlock hits;
        StepLog log;
        paper->trace(s.views.at("random").rays, hits, log, work_);
        std::vector<std::size_t> visited;  // of each open recursion
        for (const Step& step : log.steps) {
            if (step.decision == Decision::Start) {
                visited.clear();
                continue;
            }
            if (step.decision == Decision::Ascend) {
                if (visited.empty()) continue;
                ++taken[std::min(visited.back(), kMost)];
                visited.pop_back();
                continue;
            }
            if (!visited.empty()) ++visited.back();
            if (step.decision == Decision::Descend) visited.push_back(0);
        }
    }
    const std::int64_t all = taken[1] + taken[2] + taken[3];
    const auto share = [&](std::size_t n) {
        return number(100 * static_cast<double>(taken[n]) / static_cast<double>(std::max<std::int64_t>(all, 1)));
    };
    say("two-a-level", confirmedIf(taken[kMost] == 0),
        {{"all", all}, {"one", share(1)}, {"two", share(2)}, {"three", share(kMost)}});
}

// Counts texels of the base level in which the intersection with the surface is computed.
void Measuring::excludes() {
    Range range;
    for (const Subject& s : subjects_) {
        std::array<double, 2> tested{};
        for (const bool paper : {false, true}) {
            MapCache cache;
            const auto tracer =
                makeTracer({paper ? "max-pyramid-paper" : "exact", {}}, s.field, cache, work_, Form::Scalar);
            HitBlock hits;
            StepLog log;
            tracer->trace(s.views.at("random").rays, hits, log, work_);
            tested[paper ? 1 : 0] =
                static_cast<double>(std::count_if(log.steps.begin(), log.steps.end(), [](const Step& step) {
                    return step.level == 0 && (step.decision == Decision::Test || step.decision == Decision::Hit ||
                                               step.decision == Decision::Skip);
                }));
        }
        range.add(s.name, tested[1] / tested[0]);
    }
    const bool some = range.least < 0.5;
    say("excludes", range.most < 0.5 ? ClaimVerdict::Confirmed : (some ? ClaimVerdict::Depends : ClaimVerdict::Refuted),
        range.values(100));
}

void Measuring::rates() {
    BenchOptions bench;
    for (const Subject& s : subjects_) bench.maps.push_back({s.name, s.field.sharedHeights()});
    for (const char* name : {"exact", "max-pyramid-paper"}) {
        bench.methods.push_back(measuredMethod({name, {}}, Form::Scalar));
    }
    bench.elevations = {8.0};
    bench.rays = static_cast<std::size_t>(options_.rays);
    bench.rounds = options_.rounds;
    bench.reliefDepth = kReliefDepth;
    const std::vector<BenchRow> rows = benchTracers(bench, work_);
    Range range;
    double spread = 0;
    for (std::size_t r = 0; r + 1 < rows.size(); r += 2) {
        range.add(rows[r].height, rows[r + 1].rate / rows[r].rate);
        spread = std::max({spread, rows[r].spread, rows[r + 1].spread});
    }
    auto values = range.values();
    values.emplace_back("spread", number(100 * spread));
    // Experiments are necessary if the best method is not the same everywhere.
    say("experiment", confirmedIf(range.most > 1.5 * range.least), values);
}

void Measuring::approximations() {
    const double wrong16 = wrong("layers:layers=16");
    const double wrong256 = wrong("layers:layers=256");
    const auto steps = [&](const std::string& method) {
        return number(mean(method, [](const Counted& c) { return c.steps; }));
    };
    say("no-refinement", confirmedIf(wrong16 > 1),
        {{"steps16", steps("layers:layers=16")},
         {"wrong16", number(wrong16)},
         {"steps256", steps("layers:layers=256")},
         {"wrong256", number(wrong256)},
         {"exact", steps("exact")}});
    const auto error = [](const Counted& c) { return c.error; };
    const double steep = mean("offset", error, "80");
    const double flat = mean("offset", error, "8");
    say("offset", confirmedIf(flat > 5 * steep), {{"steep", number(steep)}, {"flat", number(flat)}});
    const double wrong8 = wrong("layers:layers=8");
    const double wrong512 = wrong("layers:layers=512");
    say("few-layers", confirmedIf(wrong8 > 1 && wrong8 > wrong512),
        {{"wrong8", number(wrong8)}, {"wrong64", number(wrong("layers:layers=64"))}, {"wrong512", number(wrong512)}});
    const auto layers = [&](const char* name, const char* view) { return count("layers", on(name), view).error; };
    const double bricks8 = layers("bricks", "8");
    const double hills80 = layers("hills", "80");
    say("layers-grazing",
        confirmedIf(bricks8 > layers("bricks", "80") && layers("hills", "8") > hills80 &&
                    layers("bricks", "80") > hills80),
        {{"bricks80", number(layers("bricks", "80"))},
         {"bricks8", number(bricks8)},
         {"hills80", number(hills80)},
         {"hills8", number(layers("hills", "8"))}});
}

void Measuring::distances() {
    Range beyond;
    Range wrongs;
    double safe = 0;
    for (const Subject& s : subjects_) {
        beyond.add(s.name, count("distance", s).beyond);
        wrongs.add(s.name, count("distance", s).wrong);
        safe = std::max(safe, count("distance-conservative", s).beyond);
    }
    say("never-crosses",
        safe > 0 ? ClaimVerdict::Refuted : (beyond.most > 0 ? ClaimVerdict::Depends : ClaimVerdict::Confirmed),
        {{"beyond", number(100 * beyond.most)}, {"on", beyond.mostOn}, {"safe", number(100 * safe)}});
    constexpr double kFew = 0.01;  // share of the rays
    say("donnelly-exact",
        wrongs.most < kFew ? ClaimVerdict::Confirmed
                           : (wrongs.least < kFew ? ClaimVerdict::Depends : ClaimVerdict::Refuted),
        wrongs.values(100));
    std::vector<MessageValue> values;
    double smooth = 0;
    double rough = std::numeric_limits<double>::infinity();
    for (const char* name : {"hills", "fractal", "bricks", "city", "columns"}) {
        const double steps = count("distance", on(name)).steps;
        values.emplace_back(name, number(steps));
        const bool complex = on(name).name == "city" || on(name).name == "columns";
        if (complex) rough = std::min(rough, steps);
        if (on(name).name == "hills") smooth = steps;
    }
    say("donnelly-complex", confirmedIf(rough > smooth), values);
    manyNear();
    example();
}

void Measuring::manyNear() {
    constexpr double kNear = 2;  // texels
    std::vector<MessageValue> values;
    std::map<std::string, double> shares;
    for (const char* name : {"hills", "fractal", "city", "columns"}) {
        const HeightField& field = on(name).field;
        MapCache cache;
        const auto map = DistanceTracer::make(field, {}, cache, work_).distanceMap();
        std::int64_t free = 0;
        std::int64_t near = 0;
        for (int k = 0; k < map->layers(); ++k) {
            for (int y = 0; y < map->ny(); ++y) {
                for (int x = 0; x < map->nx(); ++x) {
                    if (!(map->centreZ(k) > field.at(map->centreS(x), map->centreT(y)))) continue;
                    ++free;
                    near += static_cast<double>(map->at(x, y, k, 0)) < kNear ? 1 : 0;
                }
            }
        }
        shares[name] = static_cast<double>(near) / static_cast<double>(std::max<std::int64_t>(free, 1));
        values.emplace_back(name, number(100 * shares[name]));
    }
    const bool complex = shares["city"] > shares["hills"] && shares["columns"] > shares["hills"];
    const bool one = shares["city"] > shares["hills"] || shares["columns"] > shares["hills"];
    say("many-near", complex ? ClaimVerdict::Confirmed : (one ? ClaimVerdict::Depends : ClaimVerdict::Refuted), values);
}

// The walls of the paper's figure, in the plane, tested with rays through C in many directions.
void Measuring::example() {
    constexpr std::array<double, 9> kWalls{7, 2, 2, 2, 2, 2, 2, 2, 10};
    constexpr double kX = 4, kY = 6;
    constexpr int kDirections = 100000;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    // Returns the distance along (dx, dy) to the first wall.
    const auto toWall = [&](double dx, double dy) {
        double first = kInfinity;
        for (std::size_t column = 0; column < kWalls.size(); ++column) {
            double in = 0;
            double out = kInfinity;
            const auto cut = [&](double at, double step, double low, double high) {
                if (step == 0) {
                    if (at < low || at > high) out = -1;
                    return;
                }
                const double a = (low - at) / step;
                const double b = (high - at) / step;
                in = std::max(in, std::min(a, b));
                out = std::min(out, std::max(a, b));
            };
            cut(kX, dx, static_cast<double>(column), static_cast<double>(column + 1));
            cut(kY, dy, 0, kWalls[column]);
            if (in <= out) first = std::min(first, in);
        }
        return first;
    };
    double near = kInfinity;
    double refined = kInfinity;
    for (int n = 0; n < kDirections; ++n) {
        const double angle = 2 * std::numbers::pi * n / kDirections;
        const double dx = std::cos(angle);
        const double dy = std::sin(angle);
        const double distance = toWall(dx, dy);
        near = std::min(near, distance);
        // View rays come from above and have met nothing before C.
        if (dy < 0 && toWall(-dx, -dy) == kInfinity) refined = std::min(refined, distance);
    }
    constexpr double kTolerance = 1e-3;
    say("example", confirmedIf(std::abs(near - 3) < kTolerance && std::abs(refined - 4) < kTolerance),
        {{"directions", kDirections}, {"near", number(near)}, {"refined", number(refined)}});
}

void Measuring::refined() {
    const std::string shape = ":footprint=4:layers=16";
    Range gain;
    Range safe;
    std::int64_t different = 0;
    for (const Subject& s : subjects_) {
        gain.add(s.name, 1 - count("distance:map=refined-sampled", s).steps / count("distance", s).steps);
        safe.add(s.name,
                 1 - count("distance-refined" + shape, s).steps / count("distance-conservative" + shape, s).steps);
        MapCache cache;
        HitBlock one;
        HitBlock other;
        NullSink null;
        const RayBlock& rays = s.views.at("random").rays;
        makeTracer(parseMethodChoice("distance:map=refined-sampled", "claims"), s.field, cache, work_)
            ->trace(rays, one, null, work_);
        makeTracer({"distance-refined-sampled", {}}, s.field, cache, work_)->trace(rays, other, null, work_);
        for (std::size_t i = 0; i < rays.size(); ++i) different += one.lambda[i] == other.lambda[i] ? 0 : 1;
    }
    auto values = gain.values(100);
    values.emplace_back("safeLeast", number(100 * safe.least));
    values.emplace_back("safeMost", number(100 * safe.most));
    constexpr double kWorthIt = 0.01;
    say("refined-fewer",
        gain.least > kWorthIt ? ClaimVerdict::Confirmed
                              : (gain.most > kWorthIt ? ClaimVerdict::Depends : ClaimVerdict::Refuted),
        values);
    const double plain = wrong("distance");
    const double refinedWrong = wrong("distance:map=refined-sampled");
    constexpr double kSame = 0.1;  // percent of the rays
    const double safeWrong = wrong("distance-refined" + shape);
    say("refined-exact",
        safeWrong > 0 ? ClaimVerdict::Refuted
                      : (refinedWrong <= plain + kSame ? ClaimVerdict::Confirmed : ClaimVerdict::Depends),
        {{"plain", number(plain)}, {"refined", number(refinedWrong)}, {"safe", number(safeWrong)}});
    say("unchanged", confirmedIf(different == 0),
        {{"different", different}, {"rays", static_cast<std::int64_t>(subjects_.size()) * options_.rays}});
}

RowBenchOptions rowOptions(const std::vector<std::string>& methods, std::int64_t width, int rounds) {
    RowBenchOptions options;
    options.methods.clear();
    for (const std::string& method : methods) options.methods.push_back(parseRowMethod(method, "claims"));
    options.widths = {width};
    options.elevations = {25};
    options.precisions = {RowPrecision::Float};
    options.pixels = 1 << 20;
    options.rounds = rounds;
    return options;
}

void Measuring::rows() {
    const auto rows =
        benchRows(rowOptions({"affine", "direct", "row-constant", "incremental:anchor=0"}, 3840, 1), work_);
    say("affine", confirmedIf(rows[0].errorMax > 1),
        {{"affine", number(rows[0].errorMax)}, {"direct", number(rows[1].errorMax)}});
    const auto counts = [](const RowBenchRow& row) -> std::vector<MessageValue> {
        return {{"div", number(row.counts.div)},
                {"add", number(row.counts.add)},
                {"mul", number(row.counts.mul)},
                {"error", number(row.errorMax)}};
    };
    const auto are = [](const PixelCounts& c, double div, double add, double mul) {
        constexpr double kNearly = 0.01;  // tolerance for the operations of the row's first pixel
        return std::abs(c.div - div) < kNearly && std::abs(c.add - add) < kNearly && std::abs(c.mul - mul) < kNearly;
    };
    say("direct-counts", confirmedIf(are(rows[1].counts, 2, 8, 8)), counts(rows[1]));
    say("row-constant", confirmedIf(are(rows[2].counts, 2, 4, 4)), counts(rows[2]));
    say("incremental",
        rows[3].counts.add < 4 && rows[3].counts.mul < 4
            ? ClaimVerdict::Confirmed
            : (rows[3].counts.mul < 4 && rows[3].counts.add < 4.01 ? ClaimVerdict::Depends : ClaimVerdict::Refuted),
        counts(rows[3]));
    streams();
    derivatives();
}

void Measuring::streams() {
    const auto rows = benchRows(
        rowOptions({"incremental:anchor=0", "streams:streams=2:anchor=0", "streams:streams=16:anchor=0"}, 16384, 1),
        work_);
    const double most = std::max(rows[1].errorMax, rows[2].errorMax);
    say("streams", confirmedIf(most <= rows[0].errorMax),
        {{"error1", number(rows[0].errorMax)},
         {"error2", number(rows[1].errorMax)},
         {"error16", number(rows[2].errorMax)},
         {"add", number(rows[2].counts.add)}});
}

void Measuring::derivatives() {
    // Computing A, B, C, F from the four derivatives takes 10 multiplications and 4 additions (mapping/footprint.h),
    // which all counts include.
    constexpr double kEllipseMul = 10, kEllipseAdd = 4;
    const auto rows = benchRows(
        rowOptions({"derivatives-direct", "derivatives-iterative", "derivatives-cached"}, 3840, options_.rounds),
        work_);
    const double mul = rows[0].counts.mul - kEllipseMul;
    const double add = rows[0].counts.add - kEllipseAdd;
    const bool asMany = std::abs(mul - 10) < 0.01 && std::abs(add - 11) < 0.01;
    say("derivative-counts", asMany ? ClaimVerdict::Confirmed : ClaimVerdict::Depends,
        {{"mul", number(mul)}, {"add", number(add)}, {"div", number(rows[0].counts.div)}});
    const PixelCounts saved{rows[0].counts.mul - rows[1].counts.mul, rows[0].counts.add - rows[1].counts.add,
                            rows[0].counts.div - rows[1].counts.div};
    say("iterative",
        saved.mul > 7.9 && saved.add > 4.9
            ? ClaimVerdict::Confirmed
            : (saved.mul > 0 && saved.add > 0 ? ClaimVerdict::Depends : ClaimVerdict::Refuted),
        {{"mul", number(saved.mul)},
         {"add", number(saved.add)},
         {"div", number(saved.div)},
         {"error", number(rows[1].errorMax)}});
    const double percent = 100 * (rows[2].rate / rows[0].rate - 1);
    constexpr double kPaper = 70;
    const double spread = 100 * std::max(rows[0].spread, rows[2].spread);
    say("cached",
        percent >= kPaper ? ClaimVerdict::Confirmed : (percent > 0 ? ClaimVerdict::Depends : ClaimVerdict::Refuted),
        {{"percent", number(percent)},
         {"spread", number(spread)},
         {"error", number(rows[2].errorMax)},
         {"direct", number(rows[0].errorMax)}});
}

void Measuring::filters() {
    FilterBenchOptions options;
    options.pixelModels = {PixelModel::Gaussian};
    options.elevations = {8};
    options.width = 160;
    options.height = 120;
    options.rounds = options_.rounds;
    constexpr int kSide = 256;
    const auto measured = [&](const char* scene, const std::vector<std::string>& filters) {
        options.scenes = {filterScene(scene, kSide, kSeed)};
        options.filters.clear();
        for (const std::string& filter : filters) options.filters.push_back(parseFilter(filter, "claims"));
        return benchFilters(options, work_);
    };
    const auto plane =
        measured("checker", {"bilinear", "trilinear", "elliptical:implementation=scalar", "elliptical:weights=uniform",
                             "elliptical:weights=texel-distance", "elliptical:source=map:implementation=scalar"});
    const auto thousandths = [](const FilterBenchRow& row) { return number(1000 * row.rmse); };
    say("trilinear", confirmedIf(plane[0].rmse > plane[2].rmse && plane[1].rmse > plane[2].rmse),
        {{"list", "bilinear " + thousandths(plane[0]) + ", trilinear " + thousandths(plane[1]) + ", elliptical " +
                      thousandths(plane[2])}});
    say("gaussian", confirmedIf(plane[2].rmse < plane[3].rmse && plane[2].rmse < plane[4].rmse),
        {{"list", "uniform " + thousandths(plane[3]) + ", texel-distance " + thousandths(plane[4]) + ", gaussian " +
                      thousandths(plane[2])}});
    const double times = plane[5].rate / plane[2].rate;
    constexpr double kConsiderably = 1.5;
    say("weight-maps",
        times >= kConsiderably ? ClaimVerdict::Confirmed : (times > 1 ? ClaimVerdict::Depends : ClaimVerdict::Refuted),
        {{"times", number(times)},
         {"spread", number(100 * std::max(plane[2].spread, plane[5].spread))},
         {"map", thousandths(plane[5])},
         {"direct", thousandths(plane[2])}});
    const auto bricks =
        measured("bricks", {"elliptical:implementation=scalar", "elliptical-visible:form=plane:implementation=scalar"});
    say("hidden",
        bricks[1].rmse < 0.5 * bricks[0].rmse
            ? ClaimVerdict::Confirmed
            : (bricks[1].rmse < bricks[0].rmse ? ClaimVerdict::Depends : ClaimVerdict::Refuted),
        {{"all", thousandths(bricks[0])},
         {"back", thousandths(bricks[1])},
         {"times", number(bricks[0].rate / bricks[1].rate)}});
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm day{};
    gmtime_r(&now, &day);
    std::array<char, 16> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &day);
    return text.data();
}

}  // namespace

ClaimsTable measureClaims(const ClaimsOptions& options, Work& work) {
    ClaimsTable table{today(), cpuText(), compilerText(), commitText(), options.size, options.rays, {}};
    table.claims = Measuring(options, work).all();
    return table;
}

}  // namespace relief
