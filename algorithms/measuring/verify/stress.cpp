#include "measuring/verify/stress.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <deque>
#include <exception>
#include <thread>

#include "measuring/verify/stress_case.h"
#include "measuring/verify/stress_record.h"
#include "relief/files.h"
#include "rendering/frame.h"
#include "scenario/scenario.h"

namespace relief {

namespace {

using namespace stress_detail;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kWatchInterval{100};

double secondsSince(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

std::vector<MethodGroup> grouped(const std::vector<MeasuredMethod>& methods) {
    std::vector<MethodGroup> groups;
    for (const MeasuredMethod& method : methods) {
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const MethodGroup& g) { return g.name == method.choice.name; });
        if (group == groups.end()) {
            groups.push_back({method.choice.name, {method}});
        } else {
            group->forms.push_back(method);
        }
    }
    return groups;
}

// Sets the heights in the scenario as a command names them; the map is written to a file if no recipe makes it.
void nameHeights(Scenario& scenario, const Case& of, const StressOptions& options) {
    Pictures& pictures = scenario.pictures;
    if (of.made.recipe.empty() || std::max(of.field.width(), of.field.height()) > kMaxReliefSide) {
        const std::string name = "stress_" + std::to_string(options.seed) + "_" + std::to_string(of.number) + ".exr";
        pictures.height = options.folder == "." ? name : options.folder + "/" + name;
        pictures.reading.range.kind = HeightRange::Kind::Full;
        writeHeight(pictures.height, of.field.heights(), true);
    } else {
        pictures.recipe = of.made.recipe;
        pictures.recipeWidth = of.field.width();
        pictures.recipeHeight = of.field.height();
        pictures.seed = of.made.recipeSeed;
    }
    scenario.reliefDepth = of.field.reliefDepth();
    scenario.address = of.field.address();
    scenario.surface = of.field.surface();
}

// Returns the command that reproduces the violation. Blocks of rays, any-hit queries, homographies and rows have no
// command of their own, so the case is run again.
std::string reproduction(const Running& what, const StressOptions& options) {
    if (what.part == StressPart::Frames) {
        Scenario scenario = *what.frame;
        nameHeights(scenario, *what.of, options);
        return renderCommand(scenario);
    }
    if (what.part == StressPart::Tracers && !what.block) {
        Scenario scenario;
        nameHeights(scenario, *what.of, options);
        scenario.method = *what.method;
        return traceCommand(scenario, what.ray);
    }
    return "relief stress --seed " + std::to_string(options.seed) + " --case " + std::to_string(what.of->number) +
           " --parts " + std::string(stressPartName(what.part)) +
           (what.block ? " --tracers " + methodText(*what.method) + " --more-rays " + std::to_string(options.moreRays)
                       : "");
}

std::string methodOf(const MethodChoice& method, const Scenario* frame) {
    return methodText(method) + (frame == nullptr ? "" : " with " + filterText(frame->filter));
}

class StressRun {
  public:
    StressRun(const StressOptions& options, Work& work)
        : options_(options),
          groups_(grouped(options.methods.empty() ? methodVariants() : options.methods)),
          watched_(static_cast<std::size_t>(std::max(1, work.threads().size()))),
          work_(work),
          progress_(work.progress(), "stress", total(options)),
          tally_(options.listed) {}

    StressReport run() {
        std::jthread watch([this](const std::stop_token& end) { watchOver(end); });
        {
            std::vector<std::jthread> workers;
            for (Watched& watched : watched_) workers.emplace_back([this, &watched] { workOn(watched); });
        }
        watch.request_stop();
        watch.join();
        if (failure_) std::rethrow_exception(failure_);
        // After an interruption, some of the preceding cases are missing.
        for (auto& [number, result] : waiting_) add(result);
        StressReport report = tally_.report();
        report.seconds = secondsSince(begun_);
        report.interrupted = work_.stopped();
        return report;
    }

  private:
    // Returns the total progress: cases, or milliseconds.
    static std::int64_t total(const StressOptions& options) {
        if (!options.cases) return static_cast<std::int64_t>(options.seconds * 1000);
        return static_cast<std::int64_t>((*options.cases - std::min(options.first, *options.cases)) / options.step);
    }

    void workOn(Watched& watched) {
        try {
            while (!work_.stopped() && !failed_) {
                const std::uint64_t number = next_.fetch_add(options_.step);
                if (over(number)) return;
                CaseResult result = runCase(makeCase(options_.seed, number), options_, groups_, watched, work_);
                keep(number, std::move(result));
            }
        } catch (const Cancelled&) {
            // The report states that it was interrupted.
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failed_.exchange(true)) failure_ = std::current_exception();
        }
    }

    bool over(std::uint64_t number) const {
        if (options_.only) return number != *options_.only;
        if (options_.cases) return number >= *options_.cases;
        return number >= kStressCasesAtLeast && secondsSince(begun_) >= options_.seconds;
    }

    // Adds a result once all results before it are added, so that the report does not depend on the order in which
    // cases finish.
    void keep(std::uint64_t number, CaseResult result) {
        const std::lock_guard lock(mutex_);
        waiting_[number] = std::move(result);
        while (!waiting_.empty() && waiting_.begin()->first == added_) {
            add(waiting_.begin()->second);
            waiting_.erase(waiting_.begin());
            added_ += options_.step;
            if (options_.cases) progress_.advance();
        }
    }

    void watchOver(const std::stop_token& end) {
        std::mutex mutex;
        std::condition_variable_any wake;
        std::unique_lock lock(mutex);
        bool reported = false;
        std::int64_t shown = 0;
        while (!wake.wait_for(lock, end, kWatchInterval, [&] { return end.stop_requested(); })) {
            const auto now = static_cast<std::int64_t>(std::min(secondsSince(begun_), options_.seconds) * 1000);
            if (!options_.cases) progress_.advance(now - std::exchange(shown, now));
            for (Watched& watched : watched_) {
                watched.examine([&](const Running& running) {
                    if (reported || !options_.onHang || secondsSince(running.since) < options_.hangSeconds) return;
                    reported = true;
                    reportHang(running);
                });
            }
        }
    }

    void reportHang(const Running& running) {
        StressViolation violation{{"hang", "no answer for " + numberText(options_.hangSeconds) + " s"},
                                  methodOf(*running.method, running.frame),
                                  std::string(running.rays),
                                  running.of->map,
                                  ""};
        try {
            violation.command = reproduction(running, options_);
        } catch (const WorkError& error) {
            // The map cannot be written; the violation still names the ray.
            violation.command = error.what();
        }
        options_.onHang(violation);
    }

    // Commands are made only for violations that may be listed, because some of them write a map.
    void add(CaseResult& result) {
        std::optional<Case> of;
        for (const Found& found : result.found) {
            std::string kind =
                std::string(stressPartName(found.part)) + " " + found.method.name + " " + found.fault.check;
            if (!tally_.lists(kind) || (tally_.full() && !options_.onCase)) continue;
            if (!of) of = makeCase(options_.seed, result.number);
            result.violations.push_back(
                {found.fault, methodOf(found.method, found.frame.get()), std::string(found.rays), result.map,
                 reproduction({&*of, found.part, &found.method, found.rays, found.ray, found.frame.get(), found.block},
                              options_),
                 std::move(kind)});
        }
        if (options_.onCase) options_.onCase(result);
        tally_.add(result);
    }

    const StressOptions& options_;
    std::vector<MethodGroup> groups_;
    std::deque<Watched> watched_;
    Work& work_;
    WholeProgress progress_;  // a case consists of many stages
    Clock::time_point begun_ = Clock::now();
    std::atomic<std::uint64_t> next_{options_.only.value_or(options_.first)};
    std::mutex mutex_;
    std::map<std::uint64_t, CaseResult> waiting_;
    std::uint64_t added_ = options_.only.value_or(options_.first);
    std::atomic<bool> failed_{false};
    std::exception_ptr failure_;
    StressTally tally_;
};

}  // namespace

std::uint64_t StressMethodCoverage::total() const {
    std::uint64_t sum = 0;
    for (const auto& [family, count] : rays) sum += count;
    return sum;
}

std::uint64_t StressPartCoverage::total() const {
    std::uint64_t sum = 0;
    for (const auto& [kind, count] : tried) sum += count;
    return sum;
}

std::string_view stressPartName(StressPart part) {
    constexpr std::array<std::string_view, kStressParts> kNames{"tracers", "any-hit", "frames", "homographies", "rows"};
    return kNames[static_cast<std::size_t>(part)];
}

StressPart parseStressPart(std::string_view text, const std::string& option) {
    std::string known;
    for (int p = 0; p < kStressParts; ++p) {
        const auto part = static_cast<StressPart>(p);
        if (stressPartName(part) == text) return part;
        known.append(known.empty() ? "" : ", ").append(stressPartName(part));
    }
    throw InputError(option, unknownName({"what", MessageId::WordPart}, std::string(text), known));
}

StressReport stress(const StressOptions& options, Work& work) {
    return StressRun(options, work).run();
}

}  // namespace relief
