#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "measuring/verify/stress_part_checks.h"
#include "measuring/verify/stress_parts.h"

namespace relief {

namespace {

// Relative tolerance between two computations of a position in float.
constexpr double kPlaceRounding = 0x1p-20;

bool finite(const Color& color) {
    return std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z);
}
std::string pixelText(const Frame& frame, std::size_t i) {
    const auto width = static_cast<std::size_t>(frame.width);
    return "pixel " + std::to_string(i % width) + "," + std::to_string(i / width);
}
std::string colorText(const Color& color) {
    return numberText(double{color.x}) + "," + numberText(double{color.y}) + "," + numberText(double{color.z});
}
std::string hitText(const Hit& hit) {
    return "outcome " + std::to_string(static_cast<int>(hit.outcome)) + " at lambda " + numberText(hit.lambda);
}

}  // namespace

std::optional<StressFault> finiteFault(const Frame& frame) {
    for (std::size_t i = 0; i < frame.hits->hits.size(); ++i) {
        const Hit hit = frame.hits->hits[i];
        const bool known = hit.outcome != Outcome::Hit ||
                           (hit.lambda >= 0 && hit.lambda <= 1 && std::isfinite(hit.s) && std::isfinite(hit.t));
        if (!known) return StressFault{"not-finite", pixelText(frame, i) + ": " + hitText(hit)};
    }
    for (const ColorImage* picture : {&frame.color->color, &frame.light->color}) {
        for (std::size_t i = 0; i < picture->size(); ++i) {
            const Color color = picture->pixels()[i];
            if (!finite(color)) return StressFault{"not-finite", pixelText(frame, i) + ": " + colorText(color)};
        }
    }
    return std::nullopt;
}

std::optional<StressFault> differenceFault(const Frame& frame, const Frame& other, std::string_view check,
                                           std::string_view what) {
    const auto fault = [&](std::size_t i, const std::string& one, const std::string& two) {
        return StressFault{std::string(check),
                           pixelText(frame, i) + ": " + one + ", " + std::string(what) + ": " + two};
    };
    for (std::size_t i = 0; i < frame.hits->hits.size(); ++i) {
        if (frame.rays->polygon[i] != other.rays->polygon[i]) {
            return fault(i, "polygon " + std::to_string(frame.rays->polygon[i]),
                         std::to_string(other.rays->polygon[i]));
        }
        const Hit one = frame.hits->hits[i];
        const Hit two = other.hits->hits[i];
        if (!sameHit(one, two)) return fault(i, hitText(one), hitText(two));
        if (frame.rays->inverseDepth[i] != other.rays->inverseDepth[i]) {
            return fault(i, "1 / depth " + numberText(double{frame.rays->inverseDepth[i]}),
                         numberText(double{other.rays->inverseDepth[i]}));
        }
        const Color a = frame.color->color.pixels()[i];
        const Color b = other.color->color.pixels()[i];
        if (a != b) return fault(i, "colour " + colorText(a), colorText(b));
        const Color c = frame.light->color.pixels()[i];
        const Color d = other.light->color.pixels()[i];
        if (c != d) return fault(i, "lit colour " + colorText(c), colorText(d));
    }
    return std::nullopt;
}

std::optional<StressFault> boundFault(const Frame& frame, const Frame& whole, double bound) {
    for (std::size_t i = 0; i < frame.hits->hits.size(); ++i) {
        const Hit one = frame.hits->hits[i], two = whole.hits->hits[i];
        if (one.outcome != Outcome::Hit || two.outcome != Outcome::Hit) continue;
        const double off = std::hypot(one.s - two.s, one.t - two.t);
        const double rounding = kPlaceRounding * std::max(std::abs(two.s), std::abs(two.t));
        if (off <= bound + rounding) continue;
        return StressFault{"bounded", pixelText(frame, i) + ": " + hitText(one) + " is " + numberText(off) +
                                          " texels from " + hitText(two) + ", more than " + numberText(bound)};
    }
    return std::nullopt;
}

namespace stress_detail {

namespace {

constexpr int kFramesPerCase = 4;
constexpr int kWidth = 24;
constexpr int kHeight = 18;
constexpr int kManyThreads = 3;
// Limit on the texels that a frame's rays pass over in total; above it only the default method is used, which skips
// empty space.
constexpr double kFrameTexels = 2e6;
// Limit on the texels of level 0 below all pixels in total; above it no filter reads them all (levels=exhaustive).
constexpr double kFootprintTexels = 1e5;
// Error bounds of approximate skipping, texels (Scenario::bounded).
constexpr double kBounds[] = {0, 0, 0, 0.25, 4};
// The estimates use every n-th pixel across and down.
constexpr int kRunStep = 3;

// Returns the option's lower end, or a value a quarter up its range; at the upper ends, filters sum up millions of
// texels per pixel.
std::string optionValue(const OptionDescription& option, Random& random) {
    if (option.kind == OptionKind::Choice) {
        return option.choices[static_cast<std::size_t>(random.below(static_cast<int>(option.choices.size())))];
    }
    const double value = random.below(2) == 0 ? option.low : option.low + (option.high - option.low) / 4;
    return numberText(option.kind == OptionKind::Integer ? std::floor(value) : value);
}

// Sets two of the filter's options, its samples and the pixel model at random.
void turnOptions(FilterChoice& choice, Random& random) {
    choice.pixelModel = static_cast<PixelModel>(random.below(static_cast<int>(kPixelModelNames.size())));
    choice.samples = std::max(2, fewestSamples(choice.pixelModel));
    const auto& options = findFilter(choice.name).options;
    for (int n = 0; n < 2 && !options.empty(); ++n) {
        const OptionDescription& option =
            options[static_cast<std::size_t>(random.below(static_cast<int>(options.size())))];
        if (option.name != "form") choice.options[option.name] = optionValue(option, random);
    }
}

std::string kindText(const FilterChoice& choice) {
    const auto form = choice.options.find("form");
    return form == choice.options.end() ? choice.name : choice.name + ":form=" + form->second;
}

// Estimates the number of texels that all view rays pass over, from some of the rays.
double texelsRun(const FrameRequest& request) {
    double sum = 0;
    for (int y = 0; y < request.height; y += kRunStep) {
        for (int x = 0; x < request.width; x += kRunStep) {
            if (const auto ray = pixelRay(request, x, y)) sum += std::hypot(ray->a, ray->b);
        }
    }
    return sum * kRunStep * kRunStep;
}

// Estimates the number of texels of level 0 below all pixels, from parallelograms between neighbouring rays. Infinite
// if a neighbour has no ray, such as at a horizon.
double texelsUnder(const FrameRequest& request) {
    double sum = 0;
    for (int y = 0; y + 1 < request.height; y += kRunStep) {
        for (int x = 0; x + 1 < request.width; x += kRunStep) {
            const auto here = pixelRay(request, x, y), right = pixelRay(request, x + 1, y),
                       below = pixelRay(request, x, y + 1);
            if (!here) continue;
            if (!right || !below) return std::numeric_limits<double>::infinity();
            const double across = std::hypot(right->s0 - here->s0, right->t0 - here->t0);
            const double down = std::hypot(below->s0 - here->s0, below->t0 - here->t0);
            sum += across * down;
        }
    }
    return sum * kRunStep * kRunStep;
}

class FrameTry {
  public:
    FrameTry(const CaseRun& run, std::uint64_t number)
        : run_(run), random_(partRandom(run, StressPart::Frames, number)), number_(number) {}

    void operator()() {
        const auto& cameras = run_.subjects.cameras;
        const StressCameraFamily& camera = cameras[number_ % cameras.size()];
        family_ = camera.name;
        choose(camera);
        ++run_.result.parts["frames"].tried[std::string(family_)];
        ++run_.result.parts["filters"].tried[kindText(scenario_.filter)];
        try {
            if (texelsRun(request(true)) > kFrameTexels) scenario_.method = MethodChoice{};
            if (scenario_.filter.options.contains("levels") && texelsUnder(request(true)) > kFootprintTexels) {
                scenario_.filter.options.erase("levels");
            }
            run_.watched.begin({&run_.of, StressPart::Frames, &scenario_.method, family_, ViewRay{}, &scenario_});
            compare();
            if (camera.refused) report({"accepted", "a camera at its own target was accepted"});
        } catch (const WorkError& error) {
            report({"exception", error.what()});
        } catch (const InputError& error) {
            ++run_.result.parts["frames"].refused;
            if (!camera.refused) report({"refused", error.what()});
        } catch (const Cancelled&) {
            run_.watched.end();
            throw;
        } catch (const std::exception& error) {
            report({"exception", error.what()});
        }
        run_.watched.end();
    }

  private:
    void choose(const StressCameraFamily& camera) {
        static const std::vector<FilterChoice> kinds = filterForms();
        const HeightField& field = run_.of.field;
        scenario_.reliefDepth = field.reliefDepth();
        scenario_.address = field.address();
        scenario_.surface = field.surface();
        scenario_.width = kWidth;
        scenario_.height = kHeight;
        scenario_.scene = static_cast<SceneKind>(random_.below(3));
        scenario_.camera = camera.make(scenario_.scene, random_);
        scenario_.light.elevation = random_.between(-10, 90);
        scenario_.light.azimuth = random_.between(-180, 180);
        scenario_.shadows = random_.below(2) == 0;
        scenario_.bounded = kBounds[random_.below(static_cast<int>(std::size(kBounds)))];
        scenario_.filter = kinds[(number_ + number_ / kinds.size()) % kinds.size()];
        turnOptions(scenario_.filter, random_);
        const MethodGroup& group =
            run_.groups[static_cast<std::size_t>(random_.below(static_cast<int>(run_.groups.size())))];
        const MeasuredMethod& method =
            group.forms[static_cast<std::size_t>(random_.below(static_cast<int>(group.forms.size())))];
        const bool builds = method.buildsMaps && field.heights().size() > kStressBuildTexels;
        if (!builds && method.supports(field.surface(), field.address())) scenario_.method = method.choice;
    }

    FrameRequest request(bool skip, bool spare = true) const {
        Scenario scenario = scenario_;
        scenario.skip = skip;
        if (!spare) scenario.bounded = 0;
        Assets assets;
        assets.heights = run_.of.field.sharedHeights();
        return frameRequest(scenario, assets);
    }

    std::shared_ptr<const Frame> rendered(bool skip, int threads, bool spare = true) const {
        run_.work.throwIfStopped();
        Work work(threads);
        return run_.subjects.frame(request(skip, spare), run_.maps, work);
    }

    void compare() {
        const auto frame = rendered(true, 1);
        if (const auto fault = finiteFault(*frame)) return report(*fault);
        if (scenario_.bounded > 0) {
            if (frame->exactHits) {
                const auto fault = boundFault(*frame, *rendered(true, 1, false), scenario_.bounded);
                if (fault) return report(*fault);
            }
            // Rays over flat ground have little parallax, too; without skipping, they reach the same hit by another
            // computation whose last bit may differ. Only the numbers of threads are therefore compared.
            const auto fault = differenceFault(*frame, *rendered(true, kManyThreads), "threads", "by several threads");
            if (fault) report(*fault);
            return;
        }
        const auto plain = rendered(false, kManyThreads);
        if (!differenceFault(*frame, *plain, "", "")) return;
        // Finds out whether skipping or the number of threads caused the difference.
        const auto alone = rendered(false, 1);
        if (const auto fault = differenceFault(*frame, *alone, "no-skip", "with --no-skip")) return report(*fault);
        const auto fault = differenceFault(*alone, *plain, "threads", "by several threads");
        report(fault.value_or(StressFault{"threads", "the same frame differs between two renderings"}));
    }

    void report(const StressFault& fault) {
        run_.result.report({fault, StressPart::Frames, scenario_.method, family_, ViewRay{},
                            std::make_shared<const Scenario>(scenario_)});
    }

    const CaseRun& run_;
    Random random_;
    std::uint64_t number_;
    std::string_view family_;
    Scenario scenario_;
};

}  // namespace

void stressFrames(const CaseRun& run) {
    for (int n = 0; n < kFramesPerCase; ++n) {
        run.work.throwIfStopped();
        FrameTry(run, run.of.number * kFramesPerCase + static_cast<std::uint64_t>(n))();
    }
}

}  // namespace stress_detail

}  // namespace relief
