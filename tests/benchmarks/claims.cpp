// Measures the tables of distance and cone maps in RESULTS.md; the second form inserts all tables into a document, from
// the files in a folder (results_tables.h). measure.sh in this folder runs all measurements.
//  relief_claims [--rays N] [--size N] [--threads N] [steps] [wrong] [gain] [cost]
//  relief_claims tables RESULTS.md FOLDER
// Six procedural reliefs (seed 1), relief depth 0.2, bilinear, repeat; rays with uniform entry and azimuth, and uniform
// elevation in 10 to 90 degrees. Exit status 1 if a method with the exact guarantee gave another hit.
#include <ctime>
#include <iostream>
#include <map>
#include <set>

#include "measuring/bench/bench_tracers.h"
#include "measuring/bench/machine.h"
#include "measuring/bench/measured_method.h"
#include "relief/errors.h"
#include "relief/files.h"
#include "relief/reliefs.h"
#include "results_tables.h"

namespace relief {
namespace {

constexpr double kReliefDepth = 0.2;
constexpr double kLowest = 10;        // degrees
constexpr double kWrongTexels = 0.5;  // a hit further away is wrong
constexpr std::uint64_t kSeed = 1;

struct Settings {
    std::size_t rays = 1'000'000;
    int size = 256;
    int threads = 0;
    std::set<std::string> tables;
};

struct Measured {
    double steps = 0;
    double wrong = 0;    // share of the rays
    double beyond = 0;   // share of these that are behind the first hit
    double seconds = 0;  // processor time of all threads, which depends less on other load
    std::size_t bytes = 0;
};

struct Subject {
    std::string name;
    HeightField field;
    RayBlock rays;
    HitBlock truth;
};

class Claims {
  public:
    Claims(const Settings& settings, std::ostream& out) : out_(out), work_(settings.threads) {
        for (const char* name : {"bricks", "pits", "city", "columns", "fractal", "hills"}) {
            HeightField field(std::make_shared<FloatImage>(makeRelief(name, settings.size, settings.size, kSeed)),
                              Surface::Bilinear, Address::Repeat, kReliefDepth);
            RayBlock rays = benchRays(field, std::nullopt, settings.rays, kSeed, kLowest);
            HitBlock truth;
            MapCache cache;
            NullSink sink;
            makeTracer({"exact", {}}, field, cache, work_)->trace(rays, truth, sink, work_);
            subjects_.push_back({name, std::move(field), std::move(rays), std::move(truth)});
        }
    }

    void steps();
    void wrong();
    void gain();
    void cost();
    bool kept() const { return kept_; }

  private:
    Measured measure(const std::string& method, const Subject& subject);
    void heading(const std::string& first) const;
    double stepsOf(const std::string& method, const Subject& subject) { return measure(method, subject).steps; }

    std::ostream& out_;
    Work work_;
    std::vector<Subject> subjects_;
    std::map<std::pair<std::string, std::string>, Measured> known_;
    bool kept_ = true;
};

std::string fixed(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

Measured Claims::measure(const std::string& method, const Subject& subject) {
    const auto [place, isNew] = known_.try_emplace({method, subject.name});
    Measured& got = place->second;
    if (!isNew) return got;
    MapCache cache;
    const std::clock_t begin = std::clock();
    const auto tracer = makeTracer(parseMethodChoice(method, "--tracers"), subject.field, cache, work_);
    got.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    got.bytes = tracer->bytes();
    HitBlock hits;
    BlockCounts counts;
    tracer->trace(subject.rays, hits, counts, work_);
    const auto rays = static_cast<double>(subject.rays.size());
    got.steps = static_cast<double>(counts.steps) / rays;
    bool same = true;
    for (std::size_t i = 0; i < subject.rays.size(); ++i) {
        const double length = std::max(1.0, std::hypot(subject.rays.a[i], subject.rays.b[i]));
        const double late = (hits.lambda[i] - subject.truth.lambda[i]) * length;
        // NaN (no hit) is wrong, since under repeat every ray hits.
        if (!(std::abs(late) <= kWrongTexels)) got.wrong += 1 / rays;
        if (!(late <= kWrongTexels)) got.beyond += 1 / rays;
        same = same && hits.lambda[i] == subject.truth.lambda[i];
    }
    if (tracer->guarantee() == Guarantee::Exact && !same) {
        std::cerr << method << " is not exact on " << subject.name << "\n";
        kept_ = false;
    }
    return got;
}

void Claims::heading(const std::string& first) const {
    out_ << "\n| " << first << " |";
    for (const Subject& subject : subjects_) out_ << " " << subject.name << " |";
    out_ << "\n| --- |";
    for (std::size_t i = 0; i < subjects_.size(); ++i) out_ << " --: |";
    out_ << "\n";
}

void Claims::steps() {
    heading("steps a ray (share of every cell's)");
    for (const char* method : {"exact",
                               "max-pyramid",
                               "max-pyramid-paper",
                               "distance-conservative",
                               "distance-conservative:footprint=4:layers=16",
                               "distance-refined:footprint=1:layers=32",
                               "distance-refined",
                               "distance-refined:sectors=8",
                               "cone",
                               "cone:sectors=4",
                               "cone:sectors=8",
                               "hybrid",
                               "hybrid:inner=distance-refined",
                               "hybrid:inner=cone",
                               "cone-dummer",
                               "relaxed-cone",
                               "distance",
                               "distance-refined-sampled",
                               "distance:stop=never:to=voxel:iterations=32",
                               "layers",
                               "layers-secant",
                               "layers-bisection",
                               "offset"}) {
        out_ << "| " << method << " |";
        for (const Subject& subject : subjects_) {
            const double steps = stepsOf(method, subject);
            out_ << " " << fixed(steps, 2) << " (" << fixed(steps / stepsOf("exact", subject), 2) << ") |";
        }
        out_ << "\n" << std::flush;
    }
}

void Claims::wrong() {
    heading("% of rays wrong (of them beyond)");
    for (const std::string method :
         {"distance", "distance:to=voxel", "distance-refined-sampled", "distance:stop=never:to=voxel:iterations=32",
          "distance:stop=never:to=voxel", "cone-dummer", "cone-dummer:iterations=256", "relaxed-cone"}) {
        out_ << "| " << method << " |";
        for (const Subject& subject : subjects_) {
            const Measured got = measure(method, subject);
            out_ << " " << fixed(100 * got.wrong, 2) << " (" << fixed(100 * got.beyond, 2) << ") |";
        }
        out_ << "\n" << std::flush;
    }
}

void Claims::gain() {
    heading("% fewer steps than with the Euclidean map");
    out_ << "| the papers' form: sampled, until the surface, F = 1, L = 32 |";
    for (const Subject& subject : subjects_) {
        const double plain = stepsOf("distance", subject);
        out_ << " " << fixed(100 * (1 - stepsOf("distance-refined-sampled", subject) / plain), 1) << " |";
    }
    out_ << "\n";
    const std::pair<std::string, std::string> shapes[] = {{"F = 1, L = 32", ":footprint=1:layers=32"},
                                                          {"F = 4, L = 16", ":footprint=4:layers=16"}};
    for (const auto& [label, shape] : shapes) {
        for (const std::string rule : {"exit", "classic"}) {
            for (const std::string sectors : {"1", "8"}) {
                if (sectors != "1" && label != "F = 4, L = 16") continue;
                out_ << "| " << label << ", " << rule << (sectors == "1" ? "" : ", " + sectors + " sectors") << " |";
                for (const Subject& subject : subjects_) {
                    const std::string options = shape + ":rule=" + rule;
                    const double plain = stepsOf("distance-conservative" + options, subject);
                    const double refined = stepsOf("distance-refined" + options + ":sectors=" + sectors, subject);
                    out_ << " " << fixed(100 * (1 - refined / plain), 1) << " |";
                }
                out_ << "\n" << std::flush;
            }
        }
    }
}

void Claims::cost() {
    out_ << "\n| map (processor seconds of " << cpuText()
         << ") | float KB | u16 KB | u8 KB | float s | u16 s | u8 s |\n| --- | --: | --: | --: | --: | --: | --: |\n";
    for (const std::string method :
         {"distance", "distance-conservative", "distance-conservative:footprint=4:layers=16",
          "distance-refined:footprint=1:layers=32", "distance-refined", "distance-refined:sectors=8",
          "distance-refined-sampled", "cone", "cone:sectors=8", "cone-dummer", "relaxed-cone"}) {
        std::string bytes;
        std::string seconds;
        for (const std::string precision : {"float", "u16", "u8"}) {
            double sum = 0;
            std::size_t size = 0;
            for (const Subject& subject : subjects_) {
                const Measured got = measure(method + ":precision=" + precision, subject);
                sum += got.seconds;
                size = got.bytes;
            }
            bytes += " " + fixed(static_cast<double>(size) / 1024, 0) + " |";
            seconds += " " + fixed(sum / static_cast<double>(subjects_.size()), 3) + " |";
        }
        out_ << "| " << method << " |" << bytes << seconds << "\n" << std::flush;
    }
}

int run(int argc, char** argv) {
    Settings settings;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto number = [&] { return ++i < argc ? parseNumber(argv[i], word) : 0.0; };
        if (word == "--rays") {
            settings.rays = static_cast<std::size_t>(number());
        } else if (word == "--size") {
            settings.size = static_cast<int>(number());
        } else if (word == "--threads") {
            settings.threads = static_cast<int>(number());
        } else {
            settings.tables.insert(word);
        }
    }
    Claims claims(settings, std::cout);
    const std::pair<const char*, void (Claims::*)()> tables[] = {
        {"steps", &Claims::steps}, {"wrong", &Claims::wrong}, {"gain", &Claims::gain}, {"cost", &Claims::cost}};
    for (const auto& [name, print] : tables) {
        if (settings.tables.empty() || settings.tables.count(name) != 0) (claims.*print)();
    }
    return claims.kept() ? 0 : 1;
}

}  // namespace
}  // namespace relief

int main(int argc, char** argv) {
    try {
        if (argc == 4 && std::string(argv[1]) == "tables") {
            const std::string text = relief::readTextFile(argv[2]);
            const std::string made = relief::claims::withTables(text, argv[3]);
            if (made != text) relief::writeTextFile(argv[2], made);
            return 0;
        }
        return relief::run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
