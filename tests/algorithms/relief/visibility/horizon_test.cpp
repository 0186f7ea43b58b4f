// Bounds of the horizon against rays: whatever they decide, every ray that may start there answers alike, also at the
// very edge of what they decide.
#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/every_target.h"
#include "algorithms/relief/fields.h"
#include "relief/visibility/any_hit.h"
#include "relief/visibility/horizon_bounds.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261126;
// A shadow ray starts at most that far before the hit, in texels and in heights.
constexpr double kStart = 1e-6;

struct Start {
    double s, t, z;
};
struct Tally {
    std::size_t clear = 0, blocked = 0, undecided = 0;
    std::size_t all() const { return clear + blocked + undecided; }
};

Horizon decided(const HorizonBounds& bounds, const Start& start) {
    const double lambda = 1 - start.z, wanted = 1;
    Horizon answer{};
    bounds.decide(SlopeScene(bounds.field()), {&start.s, 1}, {&start.t, 1}, {&lambda, 1}, {&wanted, 1}, {&answer, 1});
    return answer;
}

AnyRay rayFrom(const Start& start, glm::dvec2 run) {
    const double left = 1 - start.z;
    return {start.s, start.t, start.z, left * run.x, left * run.y, left};
}

// Checks one start: the rays that may begin there, against what the bounds decide.
class Checker {
  public:
    Checker(const HeightField& field, glm::dvec2 run, std::uint64_t seed)
        : field_(field),
          run_(run),
          work_(1),
          bounds_(field, run, work_),
          truth_(makeAnyHit({"max-pyramid-any", {}}, field, cache_, work_)),
          random_(seed) {}

    const HorizonBounds& bounds() const { return bounds_; }
    Random& random() { return random_; }

    void check(const Start& start, Tally& tally) {
        const Horizon answer = decided(bounds_, start);
        ++(answer == Horizon::Clear ? tally.clear : answer == Horizon::Blocked ? tally.blocked : tally.undecided);
        for (int n = 0; n < 3; ++n) {
            const double angle = random_.between(0, 7), off = kStart * (n == 0 ? 0 : 1);
            Start moved{start.s + off * std::cos(angle), start.t + off * std::sin(angle),
                        start.z + (n == 2 ? kStart : 0)};
            // Rays start on the free side of the surface.
            const double surface = field_.at(moved.s, moved.t);
            if (surface > moved.z + (n == 0 ? 1e-12 : 0)) continue;
            const AnyRay ray = rayFrom(moved, run_);
            if (!(ray.dz > 0)) continue;
            const Visibility truth = answerOf(ray);
            if (answer != Horizon::Undecided) {
                ASSERT_EQ(answer == Horizon::Blocked, truth == Visibility::Blocked)
                    << describe(field_) << ", light " << numberText(run_.x) << "," << numberText(run_.y) << ", start "
                    << numberText(moved.s) << "," << numberText(moved.t) << "," << numberText(moved.z);
            }
        }
    }

    // Checks starts above (s, t) at the edge of what the bounds decide, within 1e-9.
    void checkEdges(double s, double t, Tally& tally) {
        const double surface = field_.at(s, t);
        for (const Horizon kind : {Horizon::Clear, Horizon::Blocked}) {
            double in = kind == Horizon::Clear ? 1 - 1e-9 : surface, out = kind == Horizon::Clear ? surface : 1 - 1e-9;
            if (decided(bounds_, {s, t, in}) != kind) continue;
            if (decided(bounds_, {s, t, out}) == kind) in = out;
            for (int n = 0; n < 40 && std::abs(in - out) > 1e-10; ++n) {
                const double middle = 0.5 * (in + out);
                (decided(bounds_, {s, t, middle}) == kind ? in : out) = middle;
            }
            ASSERT_NO_FATAL_FAILURE(check({s, t, in}, tally));
        }
    }

  private:
    Visibility answerOf(const AnyRay& ray) {
        AnyRayBlock block;
        block.push(ray);
        VisibilityBlock result;
        BlockCounts counts;
        truth_->query(block, result, counts, work_);
        return result.visibility[0];
    }

    HeightField field_;
    glm::dvec2 run_;
    Work work_;
    MapCache cache_;
    HorizonBounds bounds_;
    std::unique_ptr<AnyHitQuery> truth_;
    Random random_;
};

glm::dvec2 runFor(Random& random, const HeightField& field) {
    const double length = std::exp(random.between(-4, 1.5)) * field.width();
    const double azimuth = random.between(0, 7);
    glm::dvec2 run{length * std::cos(azimuth), length * std::sin(azimuth)};
    if (random.below(6) == 0) run.x = 0;
    if (random.below(6) == 0) run.y = 0;
    if (random.below(6) == 0) run.y = run.x;
    if (random.below(9) == 0) run *= 40;
    return run;
}

Start startFor(Random& random, const HeightField& field) {
    Start start{random.between(0, field.width()), random.between(0, field.height()), 0};
    if (random.below(7) == 0) start.s = std::floor(start.s);
    if (random.below(7) == 0) start.t = std::floor(start.t) + 0.5;
    if (random.below(9) == 0) start.s += 5e-6 * random.between(-1, 1);
    start.z = field.at(start.s, start.t);
    if (random.below(4) == 0) start.z += random.between(0, 1 - start.z);
    return start;
}

void checkAll(const HeightField& field, int lights, int starts, Tally& tally) {
    Random random(kSeed);
    for (int n = 0; n < lights; ++n) {
        const glm::dvec2 run = runFor(random, field);
        if (!HorizonBounds::suits(field, run)) continue;
        Checker checker(field, run, kSeed + static_cast<std::uint64_t>(n));
        for (int k = 0; k < starts; ++k) {
            const Start start = startFor(random, field);
            ASSERT_NO_FATAL_FAILURE(checker.check(start, tally));
            if (k % 8 == 0) {
                ASSERT_NO_FATAL_FAILURE(checker.checkEdges(start.s, start.t, tally));
            }
        }
    }
}

TEST(HorizonBounds, DecideAsRaysDo) {
    for (const Surface surface : allSurfaces()) {
        Tally tally;
        for (const Address address : allAddresses()) {
            for (const ReliefRecipe& recipe : reliefRecipes()) {
                const std::string relief(recipe.name);
                const HeightField field(
                    share(relief == "paper8x8" ? makeRelief(relief, 8, 8, 3) : makeRelief(relief, 75, 52, 3)), surface,
                    address, 0.3);
                SCOPED_TRACE(relief + " seed " + std::to_string(kSeed));
                ASSERT_NO_FATAL_FAILURE(checkAll(field, 12, 150, tally));
            }
        }
        std::printf("clear %zu, blocked %zu, undecided %zu\n", tally.clear, tally.blocked, tally.undecided);
        EXPECT_GT(tally.clear, tally.all() / 5);
        EXPECT_GT(tally.blocked, tally.all() / 10);
    }
}

TEST(HorizonBounds, DecideAsRaysDoOnAwkwardSizes) {
    Tally tally;
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{1, 1}, {1, 9}, {7, 1}, {3, 3}, {17, 2}, {33, 18}, {5, 300}}) {
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(randomHeights(width, height, kSeed), surface, address, 0.3);
                ASSERT_NO_FATAL_FAILURE(checkAll(field, 15, 100, tally));
            }
        }
    }
    EXPECT_GT(tally.clear, 100U);
    EXPECT_GT(tally.blocked, 100U);
}

// The same answers on every instruction set, and wherever a start stands in its row.
TEST(HorizonBounds, AnswerAlikeOnEveryTarget) {
    Random random(kSeed);
    for (const Surface surface : allSurfaces()) {
        const HeightField field(share(makeRelief("city", 75, 52, 3)), surface, Address::Repeat, 0.3);
        const glm::dvec2 run{31, -17};
        std::vector<double> s, t, lambda;
        for (int n = 0; n < 1003; ++n) {
            const Start start = startFor(random, field);
            s.push_back(start.s), t.push_back(start.t), lambda.push_back(1 - start.z);
        }
        s[5] = t[5] = lambda[5] = std::numeric_limits<double>::quiet_NaN();
        std::vector<double> wanted(s.size(), 1);
        wanted[7] = 0;
        std::vector<Horizon> first;
        onEveryTarget([&] {
            Work work(2);
            const HorizonBounds bounds(field, run, work);
            std::vector<Horizon> answers(s.size());
            bounds.decide(SlopeScene(field), s, t, lambda, wanted, answers);
            EXPECT_EQ(answers[7], Horizon::Undecided);
            EXPECT_EQ(answers[5], Horizon::Undecided);
            if (first.empty()) first = answers;
            EXPECT_EQ(answers, first);
            for (std::size_t i = 8; i < s.size(); ++i) {
                ASSERT_EQ(decided(bounds, {s[i], t[i], 1 - lambda[i]}), answers[i]) << i;
            }
        });
    }
}

// A start next to the border of a strip or a cell may belong to either side (kHorizonNear).
TEST(HorizonBounds, StartsNextToBordersBelongToBothSides) {
    Tally tally;
    for (const Surface surface : allSurfaces()) {
        const HeightField field(randomHeights(40, 30, kSeed), surface, Address::Repeat, 0.3);
        Random random(kSeed);
        for (int light = 0; light < 30; ++light) {
            const glm::dvec2 run{random.between(4, 30), random.between(0, 4)};
            Checker checker(field, run, kSeed);
            const HorizonBounds::Frame& f = checker.bounds().frame();
            for (int k = 0; k < 200; ++k) {
                const double off = 3e-6 * random.between(-1, 1), x = random.between(0, 40);
                double s = x, t = random.below(30) + off;
                if (k % 3 == 0) t += f.slope * x;
                if (k % 3 == 1) s = random.below(40) + off, t = random.between(0, 30);
                s -= f.shiftX, t -= f.shiftY;
                ASSERT_NO_FATAL_FAILURE(checker.check({s, t, field.at(s, t)}, tally));
                ASSERT_NO_FATAL_FAILURE(checker.checkEdges(s, t, tally));
            }
        }
    }
    EXPECT_GT(tally.all(), 10000U);
}

// Over hundreds of lines the roundings of the sweep add up (kHorizonStep), and the stored heights are coarse; a start
// may be raised (kHorizonStart). The walls' heights are just above and just below a stored height.
TEST(HorizonBounds, HoldFarBehindAWall) {
    Tally tally;
    Random random(kSeed);
    for (int n = 0; n < 400; ++n) {
        FloatImage heights(1500, 1, 0.0F);
        const double steps = 1 / 65500.0;
        heights(0, 0) = 1;
        const double wall = (random.below(30000) + 30000 + (n % 2 == 0 ? 0.03 : 0.97)) * steps;
        heights(1200, 0) = static_cast<float>(wall);
        const HeightField field(share(std::move(heights)), n % 4 < 2 ? Surface::Columns : Surface::Bilinear,
                                Address::Clamp, 0.3);
        Checker checker(field, {random.between(1000, 4000), 0}, kSeed);
        for (int k = 0; k < 30; ++k) {
            ASSERT_NO_FATAL_FAILURE(checker.checkEdges(random.between(100, 1199), 0.5, tally));
        }
    }
    EXPECT_GT(tally.clear, 5000U);
    EXPECT_GT(tally.blocked, 1000U);
}

// Where the whole relief is lower than the margins of float, these are many of the stored units.
TEST(HorizonBounds, HoldOverVeryLittleRelief) {
    Tally tally;
    Random random(kSeed);
    FloatImage heights(20, 20, 0.0F);
    heights(8, 8) = heights(9, 9) = 3e-4F;
    const HeightField field(share(std::move(heights)), Surface::Bilinear, Address::Clamp, 0.3);
    Checker checker(field, {10000, 0}, kSeed);
    for (int n = 0; n < 2000; ++n) {
        const double s = random.between(6, 11), t = random.between(8, 11);
        ASSERT_NO_FATAL_FAILURE(checker.check({s, t, field.at(s, t)}, tally));
    }
    EXPECT_GT(tally.all(), 1000U);
}

// A slope that rises faster than the light by less than float distinguishes blocks it after a hundred cells
// (kHorizonSteepest).
TEST(HorizonBounds, SlopesAsSteepAsTheLightAreNotClear) {
    Tally tally;
    Random random(kSeed);
    for (int n = 0; n < 100; ++n) {
        constexpr int kSide = 200;
        const double step = (150 + random.below(150)) * 0x1p-16;  // exact in float, and so are the heights
        FloatImage heights(kSide, 3);
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < kSide; ++x) heights(x, y) = static_cast<float>(step * x);
        }
        const HeightField field(share(std::move(heights)), Surface::Bilinear, Address::Clamp, 0.3);
        Checker checker(field, {(1 + 0x1p-26) / step, 0}, kSeed);
        for (int k = 0; k < 30; ++k) {
            const double s = random.between(10, kSide / 2.0), t = random.between(1, 2);
            ASSERT_NO_FATAL_FAILURE(checker.check({s, t, field.at(s, t)}, tally));
        }
    }
    EXPECT_EQ(tally.clear, 0U);
}

}  // namespace
}  // namespace relief::test
