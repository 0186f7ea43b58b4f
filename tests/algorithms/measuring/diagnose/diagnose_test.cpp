// diagnose() names every fault that specimens have, alone and in pairs, and no other.
#include "measuring/diagnose/diagnose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "measuring/diagnose/conventions.h"
#include "measuring/diagnose/error_picture.h"
#include "measuring/diagnose/searched_rays.h"
#include "measuring/diagnose/surface_match.h"
#include "measuring/random_rays.h"
#include "specimens.h"

namespace relief::test {

namespace {

constexpr std::size_t kRays = 1000;

std::set<std::string> namesIn(const Diagnosis& diagnosis) {
    std::set<std::string> names;
    for (const Finding& finding : diagnosis.findings) names.emplace(faultName(finding.fault.fault));
    return names;
}

std::string listed(const std::set<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += name + " ";
    return text;
}

// Expects that exactly these faults are named, or such as come with them.
void expectFaults(const std::vector<Specimen>& faults, const std::string& relief, const Diagnosis& diagnosis) {
    const std::set<std::string> found = namesIn(diagnosis);
    std::set<std::string> allowed;
    for (const Specimen& fault : faults) {
        EXPECT_TRUE(found.contains(fault.name)) << relief << ": not " << fault.name << ", but " << listed(found);
        allowed.insert(fault.name);
        allowed.insert(fault.company.begin(), fault.company.end());
    }
    for (const std::string& name : found) {
        EXPECT_TRUE(allowed.contains(name)) << relief << ": " << name << " beside " << listed(allowed);
    }
    EXPECT_FALSE(diagnosis.healthy());
    EXPECT_FALSE(diagnosis.unknown());
    for (std::size_t n = 1; n < diagnosis.findings.size(); ++n) {
        EXPECT_GE(diagnosis.findings[n - 1].rays, diagnosis.findings[n].rays);
    }
    for (const Finding& finding : diagnosis.findings) {
        EXPECT_GT(finding.texels, kRightTexels);
        EXPECT_EQ(static_cast<float>(finding.texels), diagnosis.errors[finding.worst]);
    }
}

// Returns the first of evenly spaced layers that is below the surface, after halving the last layer so often.
double halvedLayers(const HeightField& field, const ViewRay& ray, double layer, int halvings) {
    const auto below = [&](double at) { return field.at(ray.s0 + at * ray.a, ray.t0 + at * ray.b) >= 1 - at; };
    double at = 0;
    while (!below(at)) at += layer;
    for (int n = 0; n < halvings && at > 0; ++n) {
        layer /= 2;
        if (below(at - layer)) at -= layer;
    }
    return at;
}

class DiagnoseOn : public testing::TestWithParam<std::string> {
  protected:
    DiagnoseOn() : field_(specimenField(GetParam())), rays_(specimenRays(field_, kRays)) {}
    Diagnosis of(const std::vector<Specimen>& faults) { return diagnose(record(faults, field_, rays_), field_, work_); }

    HeightField field_;
    RayBlock rays_;
    Work work_;
};
INSTANTIATE_TEST_SUITE_P(Maps, DiagnoseOn, testing::Values("bricks", "fractal"),
                         [](const auto& info) { return info.param; });

}  // namespace

TEST_P(DiagnoseOn, EverySpecimen) {
    EXPECT_EQ(specimens().size(), kFaultNames.size());
    for (const Specimen& one : specimens()) {
        SCOPED_TRACE(one.name);
        expectFaults({one}, GetParam(), of({one}));
    }
}

TEST_P(DiagnoseOn, Pairs) {
    const std::vector<std::pair<const char*, const char*>> pairs{
        {"swapped-axes", "inverted-heights"},   {"y-flipped", "stair-steps"},
        {"relief-depth", "missed-spike"},       {"tangent-frame", "no-refinement"},
        {"half-texel-shift", "8-bit-terraces"}, {"zero-level", "direction-sign"},
        {"mip-level", "wrap-against-clamp"},    {"inverted-heights", "self-shadow-bias"},
        {"direction-sign", "unsafe-map"},       {"swapped-axes", "step-limit"},
        {"offset-limiting", "y-flipped"},       {"relief-depth", "inverted-heights"}};
    for (const auto& [first, second] : pairs) {
        SCOPED_TRACE(std::string(first) + " and " + second);
        const std::vector<Specimen> both{specimen(first), specimen(second)};
        expectFaults(both, GetParam(), of(both));
    }
}

// Parallax occlusion mapping as in many public shaders: from 8 layers along the normal to 32 along the plane, and a
// line between the last two.
TEST_P(DiagnoseOn, LayersThatDependOnTheView) {
    TracerRecord record{rays_, HitBlock(rays_.size()), {}};
    for (std::size_t r = 0; r < rays_.size(); ++r) {
        const ViewRay ray = rays_[r];
        const auto gapAt = [&](double at) { return field_.at(ray.s0 + at * ray.a, ray.t0 + at * ray.b) - (1 - at); };
        const double slab = field_.slabTexels();
        const double layer = 1 / (32 - 24 * slab / std::hypot(ray.a, ray.b, slab));
        double at = 0;
        while (gapAt(at) < 0) at += layer;
        const double after = gapAt(at), before = at > 0 ? gapAt(at - layer) : 0;
        record.hits.set(r, Hit::at(ray, std::min(1.0, after > 0 ? at - layer * after / (after - before) : at)));
    }
    const Diagnosis diagnosis = diagnose(record, field_, work_);
    EXPECT_FALSE(diagnosis.unknown());
    std::set<std::string> names = namesIn(diagnosis);
    EXPECT_EQ(names.count("stair-steps"), 1U) << listed(names);
    names.erase("stair-steps");
    names.erase("missed-spike");
    EXPECT_TRUE(names.empty()) << listed(names);
}

// Relief mapping as in public shaders: some layers, of which the last is halved too seldom. The answer is the lower end
// of what is left, or its middle, which may be above the surface.
TEST_P(DiagnoseOn, LayersThatAreHalvedTooSeldom) {
    struct Case {
        double normal, plane;
        int halvings;
        bool middle;
    };
    for (const Case& one :
         {Case{16, 16, 3, false}, Case{10, 10, 2, true}, Case{1, 30, 3, true}, Case{64, 16, 1, true}}) {
        SCOPED_TRACE(one.normal + one.halvings);
        TracerRecord record{rays_, HitBlock(rays_.size()), {}};
        for (std::size_t r = 0; r < rays_.size(); ++r) {
            const ViewRay ray = rays_[r];
            const double slab = field_.slabTexels();
            const double layer = 1 / (one.plane + (one.normal - one.plane) * slab / std::hypot(ray.a, ray.b, slab));
            double at = halvedLayers(field_, ray, layer, one.halvings);
            if (one.middle && at > 0) at -= std::ldexp(layer, -one.halvings - 1);
            record.hits.set(r, Hit::at(ray, std::min(1.0, at)));
        }
        const Diagnosis diagnosis = diagnose(record, field_, work_);
        EXPECT_FALSE(diagnosis.unknown());
        std::set<std::string> names = namesIn(diagnosis);
        EXPECT_EQ(names.erase("no-refinement"), 1U) << listed(names);
        names.erase("missed-spike");
        EXPECT_TRUE(names.empty()) << listed(names);
    }
}

// Exact methods, also in other orders of operations, and a marcher in float with fine steps.
TEST_P(DiagnoseOn, CorrectTracersHaveNoFault) {
    for (const std::string name : {"exact", "max-pyramid", "cone", "distance-conservative"}) {
        Specimen same{name, [&](Patient& p) { p.method = {name, {}}; }, {}};
        const Diagnosis diagnosis = of({same});
        EXPECT_TRUE(diagnosis.healthy()) << name << ": " << diagnosis.wrong << " wrong";
        EXPECT_TRUE(diagnosis.findings.empty());
    }
    TracerRecord inFloat = record({}, field_, rays_);
    const auto heightAt = [&](float s, float t) {
        return static_cast<float>(field_.at(static_cast<double>(s), static_cast<double>(t)));
    };
    for (std::size_t r = 0; r < rays_.size(); ++r) {
        const auto s0 = static_cast<float>(rays_.s0[r]), t0 = static_cast<float>(rays_.t0[r]);
        const auto a = static_cast<float>(rays_.a[r]), b = static_cast<float>(rays_.b[r]);
        const auto below = [&](float at) { return heightAt(s0 + at * a, t0 + at * b) >= 1 - at; };
        constexpr int kSteps = 8192;
        const float step = 1.0F / kSteps;
        float at = 0;
        while (at < 1 && !below(at)) at += step;
        float low = std::max(at - step, 0.0F), high = at;
        for (int n = 0; n < 12; ++n) {
            const float middle = 0.5F * (low + high);
            (below(middle) ? high : low) = middle;
        }
        inFloat.hits.set(r, Hit::at(rays_[r], static_cast<double>(std::min(high, 1.0F))));
    }
    const Diagnosis diagnosis = diagnose(inFloat, field_, work_);
    EXPECT_TRUE(diagnosis.healthy()) << diagnosis.wrong << " wrong";
}

TEST_P(DiagnoseOn, NonsenseIsUnknown) {
    TracerRecord nonsense = record({}, field_, rays_);
    Random random(5);
    for (double& lambda : nonsense.hits.lambda) lambda = random.unit();
    const Diagnosis diagnosis = diagnose(nonsense, field_, work_);
    EXPECT_TRUE(diagnosis.findings.empty()) << listed(namesIn(diagnosis));
    EXPECT_TRUE(diagnosis.unknown());
    EXPECT_FALSE(diagnosis.healthy());
}

// Answers scattered in front of the surface follow no fault, although a few rays may look as if they did.
TEST_P(DiagnoseOn, NamesNoFaultOfFewRaysWithScatteredAnswers) {
    constexpr int kSeeds = 4, kByChance = 1;
    int named = 0;
    for (const double share : {0.1, 1.0}) {
        for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
            TracerRecord scattered = record({}, field_, specimenRays(field_, share < 1 ? 120 : 60));
            Random random(seed);
            for (double& lambda : scattered.hits.lambda) {
                const double off = std::min(0.5 * lambda, 0.1) * random.unit();
                if (random.unit() <= share) lambda -= off;
            }
            const Diagnosis diagnosis = diagnose(scattered, field_, work_);
            EXPECT_FALSE(diagnosis.healthy());
            if (diagnosis.findings.empty()) continue;
            ++named;
            std::printf("share %g, seed %llu: %s\n", share, static_cast<unsigned long long>(seed),
                        listed(namesIn(diagnosis)).c_str());
        }
    }
    EXPECT_LE(named, kByChance) << "of " << 2 * kSeeds;
}

// Rays of two lengths, of which only long ones end in the air, but no more than a fifth of all rays.
TEST_P(DiagnoseOn, NamesAStepLimitOfRaysOfTwoLengths) {
    constexpr int kShort = 30, kLong = 30, kEnded = 10;
    Random random(7);
    RayBlock rays;
    for (int r = 0; r < kShort + kLong; ++r) {
        const double run = r < kShort ? 8 : 40;
        const double sign = random.unit() < 0.5 ? 1 : -1;
        const bool along = random.unit() < 0.5;
        rays.push({random.unit() * 128, random.unit() * 128, along ? sign * run : 0, along ? 0 : sign * run});
    }
    TracerRecord limited = record({}, field_, rays);
    for (std::size_t r = kShort; r < kShort + kEnded; ++r) limited.hits.lambda[r] *= 0.4 + 0.3 * random.unit();
    const std::set<std::string> names = namesIn(diagnose(limited, field_, work_));
    EXPECT_EQ(names, std::set<std::string>{"step-limit"}) << listed(names);
}

// A fault that is not in the list: heights through another curve.
TEST_P(DiagnoseOn, AForeignFaultIsUnknown) {
    const Specimen bent{"bent",
                        [](Patient& p) {
                            for (float& h : p.heights.pixels()) h = h * h * h;
                        },
                        {}};
    const Diagnosis diagnosis = of({bent});
    EXPECT_TRUE(diagnosis.unknown()) << listed(namesIn(diagnosis));
}

// Refined layers that pass the top of a peak miss it if the ray goes through it, not if it barely touches it.
TEST(Diagnose, LayersThatPassATouchMissNothing) {
    FloatImage heights(64, 64);
    // Rows of other heights, so that the layers are not off by the same everywhere.
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) heights(x, y) = 0.2F + 0.0015F * static_cast<float>(y);
    }
    heights(32, 32) = 0.75F;
    const HeightField field(share(std::move(heights)), Surface::Bilinear, Address::Repeat, 0.3);
    constexpr double kPeak = 32.5;
    ASSERT_EQ(field.at(kPeak, kPeak), 0.75);
    constexpr double kRun = 20, kLayer = 1.0 / 22;
    constexpr int kHalvings = 8;
    constexpr double kThrough = 0.01;  // below the peak's top
    constexpr std::size_t kRaysThrough = 20;
    TracerRecord record;
    for (std::size_t n = 0; n < 10 * kRaysThrough; ++n) {
        const bool through = n % 10 == 0, touching = n % 10 == 5;
        const double lambda = 0.25 + (through ? kThrough : kTouchDepth / 2);
        const double t = through || touching ? kPeak : 2 + 0.1 * static_cast<double>(n);
        record.rays.push({kPeak - lambda * kRun, t, kRun, 0});
    }
    record.hits = HitBlock(record.rays.size());
    for (std::size_t r = 0; r < record.rays.size(); ++r) {
        const ViewRay ray = record.rays[r];
        record.hits.set(r, Hit::at(ray, halvedLayers(field, ray, kLayer, kHalvings)));
    }
    Work work;
    const Diagnosis diagnosis = diagnose(record, field, work);
    ASSERT_EQ(listed(namesIn(diagnosis)), "missed-spike ");
    EXPECT_EQ(diagnosis.findings[0].rays, kRaysThrough);
}

TEST(Diagnose, ReportsLimitsAndMisses) {
    const HeightField field = specimenField("bricks");
    const RayBlock rays = specimenRays(field, 400);
    TracerRecord stopped = record({}, field, rays);
    for (std::size_t r = 0; r < 60; ++r) stopped.hits.set(r, Hit::none(Outcome::Limit));
    Work work;
    const Diagnosis diagnosis = diagnose(stopped, field, work);
    ASSERT_EQ(diagnosis.findings.size(), 1U);
    EXPECT_EQ(diagnosis.findings[0].fault.fault, Fault::StepLimit);
    EXPECT_EQ(diagnosis.findings[0].rays, 60U);
    EXPECT_TRUE(std::isinf(diagnosis.findings[0].texels));
    TracerRecord missed = record({}, field, specimenRays(field, 100));
    for (std::size_t r = 0; r < 20; ++r) missed.hits.set(r, Hit::none(Outcome::Miss));
    EXPECT_EQ(listed(namesIn(diagnose(missed, field, work))), "missed-spike ");
}

TEST(Diagnose, AFewOddAnswersAreNoFurtherFault) {
    const HeightField field = specimenField("bricks");
    TracerRecord inverted = record({specimen("inverted-heights")}, field, specimenRays(field, 100));
    for (const std::size_t r : {std::size_t{20}, std::size_t{60}}) inverted.hits.set(r, Hit::none(Outcome::Limit));
    Work work;
    const Diagnosis diagnosis = diagnose(inverted, field, work);
    EXPECT_EQ(listed(namesIn(diagnosis)), "inverted-heights ");
    EXPECT_EQ(diagnosis.unexplained, 2U);
}

TEST(Diagnose, ShiftsToTheOtherSide) {
    const HeightField field = specimenField("bricks");
    const auto moved = [](Patient& p) {
        for (double& s : p.rays.s0) s -= 0.5;
        for (double& t : p.rays.t0) t -= 0.5;
    };
    Work work;
    const TracerRecord shifted = record({{"shifted", moved, {}}}, field, specimenRays(field, 40));
    EXPECT_EQ(listed(namesIn(diagnose(shifted, field, work))), "half-texel-shift ");
}

// The direction is not divided by its height, but the surface is searched.
TEST(Diagnose, OffsetLimitingBesideSwappedAxes) {
    const HeightField field = specimenField("bricks");
    const auto limit = [slab = field.slabTexels()](Patient& p) {
        for (std::size_t r = 0; r < p.rays.size(); ++r) {
            const ViewRay ray = p.rays[r];
            const double share = slab / std::hypot(ray.a, ray.b, slab);
            p.rays.set(r, {ray.s0, ray.t0, ray.a * share, ray.b * share});
        }
    };
    Work work;
    const std::vector<Specimen> both{{"limited", limit, {}}, specimen("swapped-axes")};
    const Diagnosis diagnosis = diagnose(record(both, field, specimenRays(field, 60)), field, work);
    EXPECT_EQ(namesIn(diagnosis), (std::set<std::string>{"swapped-axes", "offset-limiting"}));
}

TEST(Diagnose, TurnsAreAlsoTriedAsRoundNumbers) {
    const HeightField field = specimenField("fractal");
    constexpr double kTurn = 25 * std::numbers::pi / 180;
    const auto turn = [](Patient& p) {
        const double c = std::cos(kTurn), s = std::sin(kTurn);
        for (std::size_t r = 0; r < p.rays.size(); ++r) {
            const ViewRay ray = p.rays[r];
            p.rays.set(r, {ray.s0, ray.t0, c * ray.a - s * ray.b, s * ray.a + c * ray.b});
        }
    };
    const TracerRecord turned = record({{"turned", turn, {}}}, field, specimenRays(field, 12));
    AnsweredRays given{turned.rays, {}};
    for (std::size_t r = 0; r < turned.rays.size(); ++r) given.answers.push_back(turned.hits[r]);
    Work work;
    ModelFields fields(field, work);
    const auto models = surfaceMatches(given, {}, fields, 2, 0, work);
    EXPECT_TRUE(std::any_of(models.begin(), models.end(),
                            [](const TracerModel& model) { return std::abs(model.turn - kTurn) < 1e-12; }));
}

// Turned and stretched farther than the directions that are tried without such places.
TEST(Diagnose, DirectionsAreReadFromTheReportedPlaces) {
    const HeightField field = specimenField("bricks");
    const RayBlock rays = specimenRays(field, 40);
    constexpr double kTurn = 0.4, kScale = 3, kLambda = 0.5;
    for (const bool limited : {false, true}) {
        AnsweredRays given{rays, {}};
        for (std::size_t r = 0; r < rays.size(); ++r) {
            const ViewRay ray = rays[r];
            const double length = kLambda * kScale * (limited ? limitedShare(ray, field) : 1);
            const double c = length * std::cos(kTurn), s = length * std::sin(kTurn);
            const ViewRay turned{ray.s0, ray.t0, c * ray.a - s * ray.b, s * ray.a + c * ray.b};
            given.answers.push_back(Hit::at(turned, 1));
            given.answers.back().lambda = kLambda;
        }
        const auto models = reportedDirections(given, {}, field);
        ASSERT_EQ(models.size(), 1U);
        EXPECT_EQ(models[0].limited, limited);
        EXPECT_NEAR(models[0].turn, kTurn, 1e-9);
        EXPECT_NEAR(models[0].runScale, kScale, 1e-9);
    }
}

TEST(Diagnose, AHalfTurnIsTheOppositeDirection) {
    for (const double turn : {std::numbers::pi, -std::numbers::pi}) {
        TracerModel model;
        model.turn = turn;
        const std::vector<ModelFault> faults = modelFaults(model, Address::Repeat);
        ASSERT_EQ(faults.size(), 1U);
        EXPECT_EQ(faults[0].fault, Fault::DirectionSign);
        EXPECT_EQ(withoutFault(model, Fault::DirectionSign), TracerModel());
    }
}

// Answers to rays along s, on a flat surface at 0.5.
class AnswersOnAPlane : public testing::Test {
  protected:
    void answer(double run, double lambda) {
        given_.rays.push({0.5, 0.5 + static_cast<double>(given_.size()), run, 0});
        given_.answers.push_back({Outcome::Hit, lambda});
    }
    // Returns the fault of each ray by the kind of the errors.
    std::vector<std::optional<Fault>> causes() {
        SearchedRays rays(given_, {}, fields_, work_);
        std::vector<std::optional<Fault>> causes;
        for (const RayVerdict& ray : explanationByShape(rays, {}).rays) causes.push_back(ray.cause);
        return causes;
    }

    Work work_{1};
    ModelFields fields_{{share(FloatImage(64, 64, 0.5F)), Surface::Bilinear, Address::Repeat, 0.3}, work_};
    AnsweredRays given_;
};

TEST_F(AnswersOnAPlane, AfterTheSameTexelsAreThoseOfALimit) {
    for (int n = 0; n < 10; ++n) answer(50 + n, 20.0 / (50 + n));
    for (const auto& cause : causes()) EXPECT_EQ(cause, Fault::StepLimit);
}

TEST_F(AnswersOnAPlane, AtTheSameDepthDoNotFollowTheHeight) {
    for (int n = 0; n < 40; ++n) answer(16, 0.5 + 1.0 / 16);
    for (const auto& cause : causes()) EXPECT_EQ(cause, Fault::StairSteps);
}

TEST_F(AnswersOnAPlane, ThatAreRightHaveNoFault) {
    for (int n = 0; n < 20; ++n) answer(16, n % 5 == 0 ? 0.6 : 0.5);
    const auto found = causes();
    for (std::size_t r = 0; r < found.size(); ++r) {
        EXPECT_EQ(found[r], r % 5 == 0 ? std::optional(Fault::UnsafeMap) : std::nullopt);
    }
}

// Answers here and there below the plane could be those of an unsafe map. Steps from one sample of the surface to the
// next show that the tracer has no map.
TEST_F(AnswersOnAPlane, WithRecordedStepsAreThoseOfTheSteps) {
    StepLog log;
    for (int n = 0; n < 60; ++n) {
        const double lambda = n % 5 == 0 ? 0.55 + 0.1 * std::fmod(0.618 * n, 1.0) : 0.5;
        answer(16, lambda);
        for (const double to : {0.45, lambda}) {
            Step step;
            step.lambdaIn = to == lambda ? 0.45 : 0;
            step.lambdaOut = step.lambdaAfter = to;
            step.decision = Decision::Advance;
            step.subject = subject::Point{0.5};
            log.steps.push_back(step);
        }
        log.begin.push_back(log.steps.size());
    }
    TracerRecord record{given_.rays, HitBlock(given_.size()), {}};
    for (std::size_t r = 0; r < given_.size(); ++r) record.hits.set(r, given_.answers[r]);
    EXPECT_EQ(listed(namesIn(diagnose(record, fields_.given(), work_))), "unsafe-map ");
    record.steps = log;
    EXPECT_EQ(listed(namesIn(diagnose(record, fields_.given(), work_))), "missed-spike ");
}

TEST_F(AnswersOnAPlane, ThatAreScatteredHaveNoBias) {
    for (int n = 0; n < 40; ++n) answer(2, 0.47 - 0.03 * std::fmod(0.618 * n, 1.0));
    for (const Explanation& one : explanations(given_, {}, {}, false, fields_, work_)) {
        EXPECT_TRUE(one.model.bias == 0 && one.model.biasTexels == 0);
    }
}

TEST(Diagnose, LinesBeginWithTheNameInBothLanguages) {
    const HeightField field = specimenField("bricks");
    const RayBlock rays = specimenRays(field, 400);
    Work work;
    const auto name = [](std::size_t ray) { return Message(MessageId::DiagnosisRay, {{"ray", ray}}); };
    const auto lines = diagnosisLines(diagnose(record({specimen("stair-steps")}, field, rays), field, work), name);
    ASSERT_FALSE(lines.empty());
    EXPECT_TRUE(sentence(lines[0]).starts_with("stair-steps: ")) << sentence(lines[0]);
    EXPECT_NE(sentence(lines[0]).find("12 layers"), std::string::npos);
    EXPECT_TRUE(sentence(lines[0], Language::Ukrainian).starts_with("stair-steps: "));
    const auto healthy = diagnosisLines(diagnose(record({}, field, rays), field, work), name);
    ASSERT_EQ(healthy.size(), 1U);
    EXPECT_TRUE(sentence(healthy[0]).starts_with("no fault"));
    for (std::size_t n = 0; n < kFaultNames.size(); ++n) {
        EXPECT_FALSE(sentence(faultCause(static_cast<Fault>(n))).empty());
        EXPECT_NE(sentence(faultCure(static_cast<Fault>(n))),
                  sentence(faultCure(static_cast<Fault>(n)), Language::Ukrainian));
    }
}

TEST(Diagnose, PicturesShowTheErrors) {
    EXPECT_EQ(errorColor(0), errorColor(kRightTexels));
    EXPECT_NE(errorColor(1), errorColor(2));
    EXPECT_EQ(errorColor(100), errorColor(1000));
    const ColorImage view = errorPicture(3, 2, {{0, 0}, {2, 1}}, {0.5F, INFINITY});
    EXPECT_EQ(view(0, 0), errorColor(0.5));
    EXPECT_EQ(view(2, 1), errorColor(INFINITY));
    EXPECT_EQ(view(1, 1), Color(0));
    const HeightField field = specimenField("bricks");
    RayBlock rays(2);
    rays.set(0, {3.5, 4.5, 1, 1});
    rays.set(1, {3.7 - field.width(), 4.2, 1, 1});
    EXPECT_EQ(errorPicture(field, rays, {1.0F, 3.0F})(3, 4), errorColor(3));
}

TEST(Chords, AreTheIntervalsBelowTheSurface) {
    FloatImage heights(16, 1);
    for (int i = 0; i < 16; ++i) heights(i, 0) = i == 4 || i == 9 ? 0.8F : 0.1F;
    const HeightField field(std::make_shared<const FloatImage>(heights), Surface::Columns, Address::Clamp, 0.5);
    // Enters the columns at 4 and 9, 0.5 and 0.9 of the way down; both are higher there.
    const ViewRay ray{0, 0.5, 10, 0};
    const auto chords = solidChords(field, ray, 0.4);
    ASSERT_GE(chords.size(), 2U);
    EXPECT_NEAR(chords[0].out, 0.5, 1e-6);
    EXPECT_NEAR(chords[1].in, 0.9, 1e-6);
    EXPECT_NEAR(chords[0].depth, 0.8 - 0.5, 0.01);
}

}  // namespace relief::test
