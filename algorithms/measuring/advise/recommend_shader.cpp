#include "measuring/advise/recommend_shader.h"

#include <algorithm>
#include <new>

#include "measuring/advise/build_watch.h"
#include "measuring/advise/shader_pictures.h"
#include "relief/maps/engine_codes.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

// Time for everything, in multiples of that of the advice for processors: each form draws pictures.
constexpr double kPictureTimes = 10;
// Mean FLIPs that differ by less count as equal: by this share, or by so little that it is the noise of single pixels.
constexpr double kTieShare = 0.02, kTieFlip = 2e-4;

// Returns true if 8 bits hold every height.
bool holds8Bits(const HeightField& field) {
    return std::all_of(field.heights().pixels().begin(), field.heights().pixels().end(),
                       [](float h) { return nearestCode(static_cast<double>(h), 8) == h; });
}

bool sameStore(const ShaderForm& a, const ShaderForm& b) {
    const auto option = [](const ShaderForm& form, const char* name) {
        const auto given = form.method.options.find(name);
        return given == form.method.options.end() ? std::string() : given->second;
    };
    const bool volume = a.map == ShaderMap::Distances;
    return a.map == b.map && a.bits == b.bits && (!volume || option(a, "footprint") == option(b, "footprint"));
}

// The same technique and textures, but for the number of turns of its loop.
bool sameTechnique(const ShaderForm& a, const ShaderForm& b) {
    return a.method.name == b.method.name && sameStore(a, b);
}

class ShaderTrials {
  public:
    ShaderTrials(const ShaderAdviceOptions& options, Work& work)
        : options_(options), work_(work), pictures_(options, work) {}

    ShaderAdvice run() {
        const std::vector<ShaderForm> fine = shaderForms(options_, 16), coarse = shaderForms(options_, 8);
        const bool of8Bits = holds8Bits(options_.field);
        WholeProgress progress(work_.progress(), "recommend", static_cast<std::int64_t>(fine.size()));
        std::vector<ShaderForm> forms;
        for (std::size_t f = 0; f < fine.size(); ++f) {
            const bool heightsOnly = fine[f].map == ShaderMap::Heights || fine[f].map == ShaderMap::Maxima;
            const bool in8 = (of8Bits && heightsOnly) || fine[f].bytes() > options_.memory;
            forms.push_back(in8 ? coarse[f] : fine[f]);
            measure(forms.back());
            progress.advance();
        }
        // Of each technique the best number of turns, with 8 bits, too.
        const ShaderAdvice wide = shaderAdviceOf(options_, forms);
        for (const std::size_t row : shaderRows(options_, wide)) {
            const ShaderForm& best = wide.forms[row];
            if (best.bits == 8 || !best.measured()) continue;
            ShaderForm one = *std::find_if(coarse.begin(), coarse.end(),
                                           [&](const ShaderForm& form) { return form.method == best.method; });
            measure(one);
            forms.push_back(std::move(one));
        }
        ShaderAdvice advice = shaderAdviceOf(options_, std::move(forms));
        advice.pictures = pictures_.pictures();
        advice.rays = pictures_.rays();
        return advice;
    }

  private:
    double left() const { return options_.seconds - std::chrono::duration<double>(Clock::now() - begun_).count(); }

    void measure(ShaderForm& form) {
        if (form.bytes() > options_.memory) {
            form.verdict = Verdict::Memory;
            return;
        }
        if (form.bounded) form.verdict = verdictOf(form);
        // A form without an alternative within the limits is measured, so that the table shows its error.
        if (!store_ || !sameStore(stored_, form)) build(form);
        if (!store_ || left() <= 0) {
            form.verdict = Verdict::BuildTime;
            return;
        }
        setCommands(form, options_, store_->coneScale);
        form.buildSeconds = store_->seconds;
        pictures_.measure(form, *store_, work_);
        form.verdict = verdictOf(form);
    }

    Verdict verdictOf(const ShaderForm& form) const {
        if (options_.maxSteps > 0 && form.mostSteps > options_.maxSteps) return Verdict::Steps;
        if (options_.maxFetches > 0 && form.mostFetches > options_.maxFetches) return Verdict::Fetches;
        return Verdict::Kept;
    }

    void build(const ShaderForm& form) {
        store_.reset();
        stored_ = form;
        try {
            const BuildWatch watch(work_, std::max(left(), 0.0));
            Work work(work_.threads().size(), watch.token());
            store_.emplace(shaderStore(form, options_.field, work));
        } catch (const Cancelled&) {
            work_.throwIfStopped();
        } catch (const MemoryError&) {
        } catch (const std::bad_alloc&) {
        }
    }

    const ShaderAdviceOptions& options_;
    Work& work_;
    Clock::time_point begun_ = Clock::now();
    ShaderPictures pictures_;
    std::optional<ShaderStore> store_;  // of stored_, if it could be built
    ShaderForm stored_;
};

int rankOf(const ShaderForm& form) {
    return form.verdict == Verdict::Kept ? 0 : form.measured() ? 1 : 2;
}

// By how much a form exceeds the limits of steps and fetches, as a factor.
double excess(const ShaderAdviceOptions& options, const ShaderForm& form) {
    const auto over = [](std::int64_t most, std::int64_t limit) {
        return limit > 0 ? std::max(1.0, static_cast<double>(most) / static_cast<double>(limit)) : 1.0;
    };
    return over(form.mostSteps, options.maxSteps) * over(form.mostFetches, options.maxFetches);
}

}  // namespace

ShaderAdviceOptions::ShaderAdviceOptions(HeightField heights)
    : field(std::move(heights)), seconds(kPictureTimes * adviceSeconds(field)) {}

std::int64_t AdvisedTexture::bytes() const {
    const std::int64_t channels = format.starts_with("RG") ? 2 : 1;
    const std::int64_t each = format.ends_with("16") ? 2 : 1;
    std::int64_t texels = 0;
    for (int l = 0; l < levels; ++l) {
        const auto side = [&](int whole) { return std::max<std::int64_t>(whole >> l, 1); };
        texels += side(width) * side(height) * depth;
    }
    return texels * channels * each;
}

std::int64_t ShaderForm::bytes() const {
    std::int64_t all = 0;
    for (const AdvisedTexture& one : textures) all += one.bytes();
    return all;
}

std::string_view fetchKindName(FetchKind kind) {
    switch (kind) {
        case FetchKind::Bilinear:
            return "bilinear";
        case FetchKind::HeightAndCone:
            return "bilinear, 2 channels";
        case FetchKind::Volume:
            return "bilinear and trilinear";
        case FetchKind::Texels:
            break;
    }
    return "single texels";
}

ShaderAdvice shaderAdviceOf(const ShaderAdviceOptions& options, std::vector<ShaderForm> forms) {
    ShaderAdvice advice;
    advice.forms = std::move(forms);
    std::vector<ShaderForm>& all = advice.forms;
    std::stable_sort(all.begin(), all.end(), [](const ShaderForm& a, const ShaderForm& b) {
        if (rankOf(a) != rankOf(b)) return rankOf(a) < rankOf(b);
        if (rankOf(a) == 2) return false;
        if (a.flip != b.flip) return a.flip < b.flip;
        return a.fetchesMean < b.fetchesMean;
    });
    const auto kept = std::count_if(all.begin(), all.end(), [](const ShaderForm& f) { return rankOf(f) == 0; });
    if (kept == 0) {
        // Of those that were measured, the one that exceeds the limits least.
        advice.keepsLimits = false;
        for (std::size_t f = 1; f < all.size() && all[f].measured(); ++f) {
            if (excess(options, all[f]) < excess(options, all[advice.chosen])) advice.chosen = f;
        }
        return advice;
    }
    const double most = options.error.value_or(all[0].flip * (1 + kTieShare) + kTieFlip);
    advice.keepsLimits = all[0].flip <= most;
    for (std::size_t f = 1; f < static_cast<std::size_t>(kept) && all[f].flip <= most; ++f) {
        const ShaderForm& best = all[advice.chosen];
        if (all[f].fetchesMean < best.fetchesMean ||
            (all[f].fetchesMean == best.fetchesMean && all[f].bytes() < best.bytes())) {
            advice.chosen = f;
        }
    }
    return advice;
}

std::vector<std::size_t> shaderRows(const ShaderAdviceOptions& options, const ShaderAdvice& advice) {
    std::vector<std::size_t> rows;
    const std::vector<ShaderForm>& all = advice.forms;
    for (std::size_t f = 0; f < all.size(); ++f) {
        const bool seen = std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(f),
                                      [&](const ShaderForm& one) { return sameTechnique(one, all[f]); });
        if (seen) continue;
        std::vector<ShaderForm> own;
        for (const ShaderForm& one : all) {
            if (sameTechnique(one, all[f])) own.push_back(one);
        }
        const MethodChoice best = shaderAdviceOf(options, std::move(own)).best().method;
        rows.push_back(static_cast<std::size_t>(
            std::find_if(all.begin(), all.end(),
                         [&](const ShaderForm& one) { return sameTechnique(one, all[f]) && one.method == best; }) -
            all.begin()));
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

ShaderAdvice recommendShader(const ShaderAdviceOptions& options, Work& work) {
    if (options.field.surface() != Surface::Bilinear) {
        throw InputError("--surface", Message(MessageId::ShaderAdviceBilinear));
    }
    return ShaderTrials(options, work).run();
}

}  // namespace relief
