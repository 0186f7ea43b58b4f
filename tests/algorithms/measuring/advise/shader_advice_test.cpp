// The advice for shaders: its laws on small reliefs, and its choice on made tables.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "algorithms/relief/fields.h"
#include "measuring/advise/shader_forms.h"
#include "measuring/advise/shader_pictures.h"
#include "measuring/random_rays.h"
#include "relief/maps/engine_codes.h"

namespace relief::test {
namespace {

constexpr double kAmpleSeconds = 600;

// Pictures and reliefs are small, so that the tests are quick.
ShaderAdviceOptions optionsFor(const std::string& relief, int side = 32, Address address = Address::Repeat) {
    ShaderAdviceOptions options(
        HeightField(share(makeRelief(relief, side, side, 1)), Surface::Bilinear, address, 0.15));
    options.name = relief;
    options.heights = " --relief " + relief + ":32x32:1";
    options.views = parseViews("30", "--views");
    options.seconds = kAmpleSeconds;
    options.width = 48;
    options.height = 36;
    return options;
}

// Rays other than those of the pictures.
RayBlock otherRays(const ShaderAdviceOptions& options) {
    return randomRays(91, options.field, 300, 8);
}

void expectEachFormOnce(const ShaderAdvice& advice) {
    std::set<std::pair<std::string, int>> seen;
    for (const ShaderForm& form : advice.forms) {
        EXPECT_TRUE(seen.emplace(methodText(form.method), form.bits).second) << methodText(form.method);
    }
}

struct Limits {
    Address address;
    int steps, fetches;
};

TEST(ShaderAdvice, NoRayTakesMoreThanTheLimits) {
    for (const auto& [address, steps, fetches] :
         {Limits{Address::Repeat, 16, 0}, Limits{Address::Border, 0, 14}, Limits{Address::Clamp, 40, 25}}) {
        ShaderAdviceOptions options = optionsFor("city", 32, address);
        options.maxSteps = steps;
        options.maxFetches = fetches;
        Work work;
        const ShaderAdvice advice = recommendShader(options, work);
        ASSERT_TRUE(advice.keepsLimits);
        EXPECT_EQ(advice.best().verdict, Verdict::Kept);
        for (const ShaderForm& form : advice.forms) {
            const bool over = (steps > 0 && form.mostSteps > steps) || (fetches > 0 && form.mostFetches > fetches);
            EXPECT_EQ(form.verdict == Verdict::Kept, !over) << methodText(form.method);
            if (!form.bounded || over) continue;
            // The bounds hold for rays that were not measured.
            const ShaderStore store = shaderStore(form, options.field, work);
            HitBlock hits;
            BlockCounts counts;
            makeTracer(form.method, store.field, *store.maps, work, Form::Scalar)
                ->trace(otherRays(options), hits, counts, work);
            for (std::size_t i = 0; i < hits.size(); ++i) {
                ASSERT_LE(hits.steps[i], form.mostSteps) << methodText(form.method);
                ASSERT_LE(fetchesOf(form, hits.steps[i], hits.reads[i], hits.outcome[i]), form.mostFetches)
                    << methodText(form.method);
            }
        }
    }
}

// What the shader of this step's tracer fetches for it, from the shaders' text.
std::int64_t fetchesOfStep(const ShaderForm& form, const Step& step) {
    const bool refines = step.decision == Decision::Refine;
    const bool tests = step.decision == Decision::Test || step.decision == Decision::Hit;
    if (step.decision == Decision::Start || step.decision == Decision::Miss) return 0;
    switch (form.map) {
        case ShaderMap::CellCones:
            return tests ? 5 : 1;
        case ShaderMap::Distances:
            return step.decision == Decision::Hit ? 1 : 2;
        case ShaderMap::RelaxedCones:
        case ShaderMap::RobustRelaxedCones:
            return step.decision == Decision::Hit ? 2 : 1;
        default:
            return refines && form.method.name == "layers-secant" ? 0 : 1;
    }
}

TEST(ShaderAdvice, FetchesAreThoseOfTheStepsThatTheShaderTakes) {
    const ShaderAdviceOptions options = optionsFor("spikes");
    Work work;
    for (const ShaderForm& form : shaderForms(options, 16)) {
        if (form.map == ShaderMap::Maxima) continue;  // counted from the steps
        const ShaderStore store = shaderStore(form, options.field, work);
        const auto tracer = makeTracer(form.method, store.field, *store.maps, work, Form::Scalar);
        const RayBlock rays = otherRays(options);
        HitBlock hits;
        StepLog log;
        tracer->trace(rays, hits, log, work);
        for (std::size_t n = 0; n < rays.size(); ++n) {
            const auto steps = static_cast<std::int64_t>(log.begin[n + 1] - log.begin[n]);
            std::int64_t expected = 0;
            for (std::size_t s = log.begin[n]; s < log.begin[n + 1]; ++s) expected += fetchesOfStep(form, log.steps[s]);
            // Where the loop has ended before the surface or at the floor, the last height is not fetched.
            ASSERT_NEAR(static_cast<double>(fetchesOf(form, steps, log.reads[n], hits.outcome[n])),
                        static_cast<double>(expected), form.bounded ? 1 : 0)
                << methodText(form.method) << " ray " << n;
        }
    }
}

TEST(ShaderAdvice, ErrorFallsAsTheLimitsRise) {
    for (const char* const relief : {"bricks", "hills"}) {
        double before = 1;
        for (const int limit : {6, 24, 96}) {
            ShaderAdviceOptions options = optionsFor(relief);
            options.maxFetches = limit;
            Work work;
            const ShaderForm best = recommendShader(options, work).best();
            EXPECT_LT(best.flip, before) << relief << " " << limit;
            before = best.flip;
        }
    }
}

TEST(ShaderAdvice, KeepsTheMemoryOfTheTextures) {
    ShaderAdviceOptions options = optionsFor("fractal");
    options.maxSteps = 24;
    Work work;
    for (const std::int64_t memory : {32 * 32, 32 * 32 * 2, 32 * 32 * 4, 1 << 20}) {
        options.memory = memory;
        const ShaderAdvice advice = recommendShader(options, work);
        EXPECT_TRUE(advice.keepsLimits);
        EXPECT_LE(advice.best().bytes(), memory);
        expectEachFormOnce(advice);
        for (const ShaderForm& form : advice.forms) {
            EXPECT_EQ(form.verdict == Verdict::Memory, form.bytes() > memory) << methodText(form.method);
        }
    }
    options.memory = 32 * 32 - 1;
    const ShaderAdvice none = recommendShader(options, work);
    EXPECT_FALSE(none.keepsLimits);
    EXPECT_NE(shaderAdviceText(options, none).find("No technique was measured"), std::string::npos);
}

TEST(ShaderAdvice, TexturesHaveTheSizeThatTheCardStores) {
    const auto bytes = [](int width, int height, Address address, ShaderMap map, int bits) {
        const ShaderAdviceOptions options(
            HeightField(constantHeights(width, height, 0.5F), Surface::Bilinear, address, 0.1));
        for (const ShaderForm& form : shaderForms(options, bits)) {
            if (form.map == map) return form.bytes();
        }
        return std::int64_t{0};
    };
    const auto repeat = Address::Repeat;
    EXPECT_EQ(bytes(64, 32, repeat, ShaderMap::Heights, 8), 64 * 32);
    EXPECT_EQ(bytes(64, 32, repeat, ShaderMap::RelaxedCones, 16), 64 * 32 * 2 * 2);
    EXPECT_EQ(bytes(64, 32, repeat, ShaderMap::CellCones, 16), 64 * 32 * (1 + 2) * 2);
    EXPECT_EQ(bytes(64, 32, Address::Clamp, ShaderMap::CellCones, 8), 64 * 32 + 65 * 33 * 2);
    EXPECT_EQ(bytes(8, 4, repeat, ShaderMap::Maxima, 8), 32 + 8 + 2 + 1);
    // 5 x 3 in levels of 5 x 3, 3 x 2, 2 x 1, 1 x 1, in a texture of 8 x 8; and the heights.
    EXPECT_EQ(bytes(5, 3, repeat, ShaderMap::Maxima, 16), 2 * (64 + 16 + 4 + 1 + 15));
    EXPECT_EQ(bytes(16, 16, repeat, ShaderMap::Distances, 8), 16 * 16 * (1 + 32));
}

// With heights that 8 bits hold, the exact techniques draw the picture itself.
TEST(ShaderAdvice, ExactTechniquesHaveNoError) {
    FloatImage coded = makeRelief("columns", 32, 32, 1);
    for (float& h : coded.pixels()) h = nearestCode(static_cast<double>(h), 8);
    ShaderAdviceOptions options = optionsFor("columns");
    options.field = HeightField(share(std::move(coded)), Surface::Bilinear, Address::Repeat, 0.15);
    Work work;
    const ShaderAdvice advice = recommendShader(options, work);
    expectEachFormOnce(advice);
    for (const ShaderForm& form : advice.forms) {
        // Samplers weight with 8 bits: what is conservative in float is not with them.
        EXPECT_NE(form.guarantee, Guarantee::Conservative) << methodText(form.method);
        if (form.guarantee != Guarantee::Exact) continue;
        EXPECT_EQ(form.flip, 0) << methodText(form.method);
        EXPECT_EQ(form.displaced, 0) << methodText(form.method);
        EXPECT_EQ(form.shiftP99, 0) << methodText(form.method);
    }
    EXPECT_LE(advice.best().flip, 3e-4);
    const auto offset = std::find_if(advice.forms.begin(), advice.forms.end(),
                                     [](const ShaderForm& form) { return form.method.name == "offset"; });
    EXPECT_GT(offset->flip, 0.01);
    EXPECT_GT(offset->displaced, 0.02);
}

ShaderForm made(const std::string& name, double flip, double fetches, int side, Verdict verdict = Verdict::Kept) {
    ShaderForm form;
    form.method.name = name;
    form.flip = flip;
    form.fetchesMean = fetches;
    form.mostFetches = static_cast<std::int64_t>(2 * fetches);
    form.textures = {{"R8", MessageId{}, side, 1}};
    form.verdict = verdict;
    return form;
}

TEST(ShaderAdvice, ChoosesTheFewestFetchesOfEqualErrors) {
    ShaderAdviceOptions options = optionsFor("hills");
    const auto chosen = [&](const std::vector<ShaderForm>& forms) {
        return shaderAdviceOf(options, forms).best().method.name;
    };
    const std::vector<ShaderForm> forms{made("cheap", 0.5, 1, 1), made("same", 0.1005, 10, 1),
                                        made("least", 0.1, 20, 1), made("out", 0, 0, 1, Verdict::Fetches)};
    EXPECT_EQ(chosen(forms), "same");
    EXPECT_EQ(chosen({made("wide", 0.1, 10, 9), made("lean", 0.1, 10, 3)}), "lean");
    options.error = 0.6;
    EXPECT_EQ(chosen(forms), "cheap");
    EXPECT_TRUE(shaderAdviceOf(options, forms).keepsLimits);
    options.error = 0.05;
    EXPECT_EQ(chosen(forms), "least");
    EXPECT_FALSE(shaderAdviceOf(options, forms).keepsLimits);
    // Of none within the limits, the one that exceeds them least.
    options.maxFetches = 10;
    EXPECT_EQ(chosen({made("far", 0, 40, 1, Verdict::Fetches), made("near", 0.3, 7, 1, Verdict::Fetches)}), "near");
}

TEST(ShaderAdvice, SaysAllInBothLanguagesAndAsJson) {
    ShaderAdviceOptions options = optionsFor("bricks");
    options.maxSteps = 20;
    Work work;
    const ShaderAdvice advice = recommendShader(options, work);
    const std::string method = methodText(advice.best().method);
    const std::string text = shaderAdviceText(options, advice);
    for (const char* const name : {"offset", "layers", "layers-secant", "layers-bisection", "cone", "cone-robust",
                                   "relaxed-cone", "relaxed-cone-robust", "max-pyramid", "distance"}) {
        EXPECT_NE(text.find(std::string("\n  ") + name), std::string::npos) << name << "\n" << text;
    }
    EXPECT_NE(text.find("Technique: " + method), std::string::npos) << text;
    const std::string ukrainian = shaderAdviceText(options, advice, Language::Ukrainian);
    EXPECT_NE(ukrainian.find("Спосіб: " + method), std::string::npos) << ukrainian;
    for (const std::string& said : {text, ukrainian}) {
        EXPECT_EQ(said.find('{'), std::string::npos) << said;
        for (const std::string& command : advice.best().commands) EXPECT_NE(said.find(command), std::string::npos);
    }
    const auto json = nlohmann::json::parse(shaderAdviceJson(options, advice));
    EXPECT_EQ(json["chosen"]["text"], method);
    EXPECT_EQ(json["form"], "shader");
    EXPECT_EQ(json["forms"].size(), advice.forms.size());
    EXPECT_EQ(json["chosen"]["memory_bytes"], advice.best().bytes());
}

TEST(ShaderAdvice, OnlyForTheBilinearSurface) {
    ShaderAdviceOptions options = optionsFor("hills");
    options.field = HeightField(share(makeRelief("hills", 16, 16, 1)), Surface::Columns);
    Work work;
    EXPECT_THROW(recommendShader(options, work), InputError);
}

}  // namespace
}  // namespace relief::test
