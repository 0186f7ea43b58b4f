#include <chrono>
#include <cmath>
#include <filesystem>
#include <ostream>

#include "embree_peer.h"
#include "measuring/bench/machine.h"
#include "measuring/quantiles.h"
#include "measuring/text_table.h"
#include "relief/errors.h"
#include "relief/files.h"
#include "relief/reliefs.h"
#include "tracer_peers.h"

namespace relief::peers {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kModelTexels = 0.05;              // a larger difference is another place: the models differ
constexpr double kMostDiffer = 0.6;                // share of the rays; a third is usual on maps with steep walls
constexpr double kLeastSeconds = 0.01;             // per timing; small blocks are traced repeatedly for that long
constexpr const char* kReference = "max-pyramid";  // held to `exact`, bit for bit, by the tests; `exact` takes hours

double secondsSince(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

// Returns the rays per second of body(), which traces `rays` rays.
template <class Body>
double rateOf(std::size_t rays, const Body& body) {
    const auto begun = Clock::now();
    double seconds = 0;
    double passes = 0;
    do {
        body();
        ++passes;
        seconds = secondsSince(begun);
    } while (seconds < kLeastSeconds);
    return passes * static_cast<double>(rays) / seconds;
}

struct OurMethod {
    MethodChoice choice;
    MapCache maps;
    std::unique_ptr<Tracer> tracer;
    double buildSeconds = 0;
    HitBlock hits;
    std::vector<double> rates;
};

struct Variant {
    EmbreeVariant what;
    std::vector<double> rates;
};

// A view of the map: its rays, and the exact hits.
struct Subject {
    Elevation view;
    RayBlock rays;
    HitBlock truth;
};

std::int64_t differing(const HitBlock& truth, const HitBlock& hits) {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const bool same = truth.outcome[i] == hits.outcome[i] &&
                          (truth.outcome[i] != Outcome::Hit || truth.lambda[i] == hits.lambda[i]);
        count += same ? 0 : 1;
    }
    return count;
}

HitBlock hitsOf(const RayBlock& rays, const std::vector<float>& lambda) {
    HitBlock hits(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits.set(i,
                 std::isnan(lambda[i]) ? Hit::none(Outcome::Miss) : Hit::at(rays[i], static_cast<double>(lambda[i])));
    }
    return hits;
}

double modelDifference(const RayBlock& rays, const HitBlock& truth, const HitBlock& hits) {
    double differs = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double run = std::max(1.0, std::hypot(rays.a[i], rays.b[i]));
        const bool same =
            truth.outcome[i] == hits.outcome[i] &&
            (truth.outcome[i] != Outcome::Hit || std::abs(truth.lambda[i] - hits.lambda[i]) * run <= kModelTexels);
        differs += same ? 0 : 1;
    }
    return differs / static_cast<double>(rays.size());
}

bool isPeer(const BenchRow& row) {
    return row.method.name.starts_with("embree");
}

// Embree does not report its steps.
BenchValue stepsValue(const BenchRow& row, std::int64_t steps) {
    return isPeer(row) ? BenchValue(std::nan("")) : BenchValue(steps);
}

// Returns the extent of the rays, from their entries to their hits.
MeshExtent reached(const std::vector<Subject>& subjects) {
    double low[2] = {1e300, 1e300};
    double high[2] = {-1e300, -1e300};
    const auto take = [&](double s, double t) {
        const double at[2] = {s, t};
        for (int k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], at[k]);
            high[k] = std::max(high[k], at[k]);
        }
    };
    for (const Subject& subject : subjects) {
        for (std::size_t i = 0; i < subject.rays.size(); ++i) {
            take(subject.rays.s0[i], subject.rays.t0[i]);
            if (subject.truth.outcome[i] == Outcome::Hit) take(subject.truth.s[i], subject.truth.t[i]);
        }
    }
    const auto before = [](double x) { return static_cast<int>(std::floor(x)) - 2; };
    const auto behind = [](double x) { return static_cast<int>(std::ceil(x)) + 2; };
    return {before(low[0]), before(low[1]), behind(high[0]), behind(high[1])};
}

class Comparison {
  public:
    Comparison(const PeerOptions& options, std::ostream& out) : options_(options), out_(out), work_(options.threads) {}

    bool run() {
        for (const std::string& map : options_.maps) {
            if (std::filesystem::is_regular_file(map)) {
                compare(map, std::make_shared<FloatImage>(readHeight(map, {}, work_).heights));
                continue;
            }
            const std::size_t colon = map.find(':');
            const std::uint64_t seed = colon == std::string::npos
                                           ? 1
                                           : static_cast<std::uint64_t>(parseNumber(map.substr(colon + 1), "--maps"));
            for (const int size : options_.sizes) {
                compare(map, std::make_shared<FloatImage>(makeRelief(map.substr(0, colon), size, size, seed)));
            }
        }
        printCells(cells_, out_);
        out_ << "\n"
             << cpuText() << ", " << options_.threads << " thread(s), "
             << (options_.lanes.empty() ? "" : "ours with " + options_.lanes + " only, ") << compilerText() << ", "
             << commitText() << ", " << embreeText() << (options_.embree.empty() ? "" : " (" + options_.embree + ")")
             << ", " << addressName(options_.address) << ", relief depth " << numberText(options_.reliefDepth)
             << ", camera " << numberText(options_.view.distance) << " texture widths off, azimuth "
             << numberText(options_.view.azimuth) << ", field of view " << numberText(options_.view.fov)
             << ", random rays from " << numberText(options_.view.lowest) << " degrees\n";
        if (!options_.output.empty()) writeRows();
        return kept_;
    }

  private:
    void compare(const std::string& name, std::shared_ptr<const FloatImage> heights) {
        const HeightField field(std::move(heights), Surface::Bilinear, options_.address, options_.reliefDepth);
        std::vector<Subject> subjects = makeSubjects(field);
        std::vector<std::unique_ptr<OurMethod>> ours;
        for (const std::string& text : options_.methods) {
            auto method = std::make_unique<OurMethod>();
            method->choice = parseMethodChoice(text, "--methods");
            const auto begun = Clock::now();
            method->tracer = makeTracer(method->choice, field, method->maps, work_);
            method->buildSeconds = secondsSince(begun);
            ours.push_back(std::move(method));
        }
        const MeshExtent extent = reached(subjects);
        std::vector<std::unique_ptr<EmbreeScene>> scenes;
        for (const EmbreeShape shape : options_.shapes) {
            scenes.push_back(std::make_unique<EmbreeScene>(field, shape, extent, options_.threads, options_.embree));
        }
        tellCosts(name, field, ours, scenes);
        for (const Subject& subject : subjects) measure(name, field, subject, ours, scenes);
    }

    std::vector<Subject> makeSubjects(const HeightField& field) {
        MapCache maps;
        const auto reference = makeTracer({kReference, {}}, field, maps, work_);
        std::vector<Subject> subjects;
        for (const Elevation& view : options_.views) {
            Subject subject{view, peerRays(field, view, options_.view), {}};
            BlockCounts counts;
            // The overload that counts is the reference implementation.
            reference->trace(subject.rays, subject.truth, counts, work_);
            subjects.push_back(std::move(subject));
        }
        return subjects;
    }

    void tellCosts(const std::string& name, const HeightField& field,
                   const std::vector<std::unique_ptr<OurMethod>>& ours,
                   const std::vector<std::unique_ptr<EmbreeScene>>& scenes) {
        const auto megabytes = [](double bytes) { return readable(bytes / 1e6, 3) + " MB"; };
        const double heights = 4.0 * field.width() * field.height();
        std::vector<TableRow> rows{
            {name + ", " + std::to_string(field.width()) + " x " + std::to_string(field.height()), "memory",
             "built in, s"}};
        for (const auto& method : ours) {
            rows.push_back({methodText(method->choice),
                            megabytes(heights + static_cast<double>(method->tracer->bytes())),
                            readable(method->buildSeconds, 3)});
        }
        for (const auto& scene : scenes) {
            rows.push_back({EmbreeVariant{scene->shape(), 1, false}.method(),
                            megabytes(static_cast<double>(scene->bytes())), readable(scene->buildSeconds(), 3)});
        }
        out_ << textTable(rows) << std::flush;
    }

    void measure(const std::string& name, const HeightField& field, const Subject& subject,
                 const std::vector<std::unique_ptr<OurMethod>>& ours,
                 const std::vector<std::unique_ptr<EmbreeScene>>& scenes) {
        const EmbreeRays floats = embreeRays(field, subject.rays);
        std::vector<float> lambda(subject.rays.size());
        std::vector<Variant> variants;
        for (const EmbreeVariant& what : embreeVariants(options_.shapes)) variants.push_back({what, {}});
        const auto sceneOf = [&](const Variant& variant) -> const EmbreeScene& {
            return variant.what.shape == scenes.front()->shape() ? *scenes.front() : *scenes.back();
        };
        for (const auto& method : ours) {
            method->hits = HitBlock(subject.rays.size());
            method->rates.clear();
        }
        // The first round is a warm-up.
        for (int round = -1; round < options_.rounds; ++round) {
            const auto note = [&](std::vector<double>& rates, double rate) {
                if (round >= 0) rates.push_back(rate);
            };
            for (const auto& method : ours) {
                NullSink none;
                note(method->rates, rateOf(subject.rays.size(),
                                           [&] { method->tracer->trace(subject.rays, method->hits, none, work_); }));
            }
            for (Variant& variant : variants) {
                note(variant.rates,
                     rateOf(subject.rays.size(), [&] { sceneOf(variant).trace(variant.what, floats, lambda, work_); }));
            }
        }
        const auto best = std::max_element(variants.begin(), variants.end(), [](const Variant& x, const Variant& y) {
            return quantile(x.rates, 0.5) < quantile(y.rates, 0.5);
        });
        std::vector<double> fastest;  // rate in each round
        for (std::size_t r = 0; r < best->rates.size(); ++r) {
            double most = 0;
            for (const Variant& variant : variants) most = std::max(most, variant.rates[r]);
            fastest.push_back(most);
        }
        double differs = 0;
        for (const Variant& variant : variants) {
            sceneOf(variant).trace(variant.what, floats, lambda, work_);
            const HitBlock hits = hitsOf(subject.rays, lambda);
            if (&variant == &*best) differs = modelDifference(subject.rays, subject.truth, hits);
            keepRow(name, field, subject, embreeRow(variant, sceneOf(variant)), variant.rates, hits);
        }
        for (const auto& method : ours) {
            PeerCell cell;
            cell.map = name;
            cell.size = field.width();
            cell.view = subject.view;
            cell.rays = subject.rays.size();
            cell.method = methodText(method->choice);
            cell.rate = quantile(method->rates, 0.5);
            cell.spread = relativeSpread(method->rates);
            cell.best = best->what.text();
            cell.bestRate = quantile(best->rates, 0.5);
            cell.bestSpread = relativeSpread(best->rates);
            std::vector<double> ratios;
            for (std::size_t r = 0; r < fastest.size(); ++r) ratios.push_back(method->rates[r] / fastest[r]);
            cell.ratio = quantile(ratios, 0.5);
            cell.ratioSpread = relativeSpread(ratios);
            cell.differs = differs;
            cell.wrong = differing(subject.truth, method->hits);
            if (method->tracer->guarantee() == Guarantee::Exact && cell.wrong > 0) kept_ = false;
            // This is no difference of the models: one of the two was given other data.
            if (differs > kMostDiffer) kept_ = false;
            const BenchRow row = ourRow(*method, subject);
            cell.bytes = sizeof(float) * row.readsMean;
            cells_.push_back(cell);
            keepRow(name, field, subject, row, method->rates, method->hits);
        }
    }

    BenchRow embreeRow(const Variant& variant, const EmbreeScene& scene) {
        BenchRow row;
        row.method = {
            variant.what.method(),
            {{"packet", std::to_string(variant.what.packet)}, {"coherent", variant.what.coherent ? "1" : "0"}}};
        row.memoryBytes = static_cast<std::int64_t>(scene.bytes());
        row.buildSeconds = scene.buildSeconds();
        row.stepsMean = row.readsMean = std::nan("");  // Embree does not tell
        return row;
    }

    BenchRow ourRow(const OurMethod& method, const Subject& subject) {
        BenchRow row;
        row.method = method.choice;
        row.memoryBytes = static_cast<std::int64_t>(method.tracer->bytes());
        row.buildSeconds = method.buildSeconds;
        HitBlock hits;
        BlockCounts counts;
        method.tracer->trace(subject.rays, hits, counts, work_);
        row.stepsMean = static_cast<double>(counts.steps) / static_cast<double>(hits.size());
        row.readsMean = static_cast<double>(counts.reads) / static_cast<double>(hits.size());
        std::sort(hits.steps.begin(), hits.steps.end());
        row.stepsP95 = hits.steps[static_cast<std::size_t>(0.95 * static_cast<double>(hits.size() - 1))];
        row.stepsMax = hits.steps.back();
        return row;
    }

    void keepRow(const std::string& name, const HeightField& field, const Subject& subject, BenchRow row,
                 const std::vector<double>& rates, const HitBlock& hits) {
        row.height = name;
        row.width = field.width();
        row.heightTexels = field.height();
        row.surface = field.surface();
        row.address = field.address();
        row.reliefDepth = field.reliefDepth();
        row.elevation = subject.view;
        row.seed = options_.view.seed;
        row.threads = options_.threads;
        row.rate = quantile(rates, 0.5);
        row.spread = relativeSpread(rates);
        row.errors = tracerErrors(subject.rays, subject.truth, hits);
        row.compiler = compilerText();
        row.cpu = cpuText();
        row.commit = commitText();
        rows_.push_back(std::move(row));
    }

    // Writes the columns of relief bench tracers; options are written literally, since Embree's methods are in no list
    // of ours.
    void writeRows() const {
        std::vector<BenchColumn> columns = benchColumns();
        for (BenchColumn& column : columns) {
            if (column.name == "options") {
                column.get = [](const BenchRow& row) -> BenchValue { return optionsText(row.method, !isPeer(row)); };
            } else if (column.name == "steps_p95") {
                column.get = [](const BenchRow& row) -> BenchValue { return stepsValue(row, row.stepsP95); };
            } else if (column.name == "steps_max") {
                column.get = [](const BenchRow& row) -> BenchValue { return stepsValue(row, row.stepsMax); };
            }
        }
        if (options_.output.ends_with(".json")) {
            writeTextFile(options_.output, columnsJson<BenchRow>(columns, rows_));
            return;
        }
        std::string text = columnsHeader(columns);
        for (const BenchRow& row : rows_) text += columnsLine(columns, row);
        writeTextFile(options_.output, text);
    }

    const PeerOptions& options_;
    std::ostream& out_;
    Work work_;
    std::vector<PeerCell> cells_;
    std::vector<BenchRow> rows_;
    bool kept_ = true;
};

}  // namespace

bool compareTracers(const PeerOptions& options, std::ostream& out) {
    return Comparison(options, out).run();
}

}  // namespace relief::peers
