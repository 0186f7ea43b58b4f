// Tests the checks of relief stress: a faulty substitute takes the place of what each check examines, and the run must
// report it under that check's name. A substitute without a fault must pass, so that the fault itself is what is
// detected.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"
#include "algorithms/measuring/altered_tracer.h"
#include "measuring/overshoot.h"
#include "measuring/verify/stress.h"
#include "measuring/verify/stress_subjects.h"
#include "relief/errors.h"
#include "relief/reliefs.h"
#include "rendering/pinhole.h"

namespace relief::test {
namespace {

using Checks = std::set<std::string>;

// With this seed the maps are small, and some frames of the two cases may be approximated (--bounded).
constexpr std::uint64_t kSeed = 25;
constexpr std::uint64_t kCases = 2;

class StressFaultsTest : public ::testing::Test {
  protected:
    StressReport run(StressPart part, const StressSubjects& subjects, std::vector<MeasuredMethod> methods = {},
                     std::function<void(const StressViolation&)> onHang = {}) {
        StressOptions options;
        options.seed = kSeed;
        options.cases = kCases;
        options.parts = {part};
        options.folder = folder_ / ".";
        options.methods = std::move(methods);
        options.subjects = std::make_shared<const StressSubjects>(subjects);
        options.onHang = std::move(onHang);
        options.hangSeconds = 0.02;
        Work work(2);
        return stress(options, work);
    }
    static Checks checksOf(const StressReport& report) {
        Checks found;
        for (const StressViolation& violation : report.violations) found.insert(violation.fault.check);
        return found;
    }

    // A camera that sees its scene; refusals and limiting cases are not tested with it.
    static std::vector<StressCameraFamily> plainCamera(bool refused = false) {
        const auto make = [](SceneKind, Random& random) {
            Camera camera;
            camera.azimuth = random.between(10, 80);
            return camera;
        };
        return {{"plain", make, refused}};
    }

    relief::testing::TemporaryFolder folder_;
};

// --- Any-hit queries

class AlteredQuery final : public AnyHitQuery {
  public:
    using Alter = std::function<void(VisibilityBlock&, Overload)>;
    using AlterLog = std::function<void(StepLog&)>;

    AlteredQuery(std::unique_ptr<AnyHitQuery> inner, Alter alter, AlterLog alterLog)
        : inner_(std::move(inner)), alter_(std::move(alter)), alterLog_(std::move(alterLog)) {}

    const MethodDescription& description() const override { return inner_->description(); }
    const HeightField& field() const override { return inner_->field(); }
    double stepBound(const AnyRay& ray) const override { return inner_->stepBound(ray); }
    void query(const AnyRayBlock& rays, VisibilityBlock& results, NullSink& sink, Work& work) const override {
        inner_->query(rays, results, sink, work);
        alter_(results, Overload::Plain);
    }
    void query(const AnyRayBlock& rays, VisibilityBlock& results, BlockCounts& sink, Work& work) const override {
        inner_->query(rays, results, sink, work);
        alter_(results, Overload::Counting);
    }
    void query(const AnyRayBlock& rays, VisibilityBlock& results, StepLog& sink, Work& work) const override {
        inner_->query(rays, results, sink, work);
        alter_(results, Overload::Logging);
        if (alterLog_) alterLog_(sink);
    }

  private:
    std::unique_ptr<AnyHitQuery> inner_;
    Alter alter_;
    AlterLog alterLog_;
};

StressSubjects withQuery(AlteredQuery::Alter alter, AlteredQuery::AlterLog alterLog = {}) {
    StressSubjects subjects;
    subjects.query = [alter = std::move(alter), alterLog = std::move(alterLog)](
                         const MethodChoice& choice, const HeightField& field, MapCache& maps, Work& work) {
        return std::make_unique<AlteredQuery>(makeAnyHit(choice, field, maps, work), alter, alterLog);
    };
    return subjects;
}

TEST_F(StressFaultsTest, FaultyQueriesAreReported) {
    const auto checks = [&](const AlteredQuery::Alter& alter, const AlteredQuery::AlterLog& alterLog = {}) {
        return checksOf(run(StressPart::AnyHit, withQuery(alter, alterLog)));
    };
    const auto change = [](Visibility from, Visibility to) {
        return [=](VisibilityBlock& results, Overload) {
            std::replace(results.visibility.begin(), results.visibility.end(), from, to);
        };
    };
    const AlteredQuery::Alter none = [](VisibilityBlock&, Overload) {};
    EXPECT_EQ(checks(none), Checks{});
    EXPECT_EQ(checks(change(Visibility::Blocked, Visibility::Clear)), Checks{"any-hit"});
    EXPECT_EQ(checks(change(Visibility::Blocked, Visibility::Limit)), Checks{"limit"});
    EXPECT_EQ(checks(none,
                     [](StepLog& log) {
                         if (!log.steps.empty()) log.steps.back().lambdaOut = -1;
                     }),
              Checks{"any-hit"})
        << "blocked before the surface begins";
    EXPECT_EQ(checks([](VisibilityBlock& results, Overload) {
                  std::fill(results.steps.begin(), results.steps.end(), std::numeric_limits<std::uint32_t>::max());
              }),
              Checks{"steps"});
    EXPECT_EQ(checks([](VisibilityBlock& results, Overload overload) {
                  if (overload != Overload::Plain) return;
                  for (Visibility& visibility : results.visibility)
                      visibility = visibility == Visibility::Clear ? Visibility::Blocked : Visibility::Clear;
              }),
              Checks{"sinks"});
}

// --- Frames

// 24 x 18 pixels, as in the run, over a relief with slopes and walls.
const Frame& smallFrame() {
    static const std::shared_ptr<const Frame> frame = [] {
        FrameRequest request(HeightField(std::make_shared<FloatImage>(makeRelief("bricks", 32, 32, 1))));
        request.width = 24;
        request.height = 18;
        Work work(1);
        return FrameRenderer(std::make_shared<MapCache>()).render(request, work);
    }();
    return *frame;
}

// Frames that differ from smallFrame() in one pixel of one buffer.
constexpr std::size_t kPixel = 5 * 24 + 11;

Frame withLight(float value) {
    Frame frame = smallFrame();
    auto stage = std::make_shared<LightStage>(*frame.light);
    stage->color.pixels()[kPixel].y = value;
    frame.light = stage;
    return frame;
}
Frame withColor(float value) {
    Frame frame = smallFrame();
    auto stage = std::make_shared<ColorStage>(*frame.color);
    stage->color.pixels()[kPixel].z = value;
    frame.color = stage;
    return frame;
}
Frame withHit(const std::function<void(HitBlock&)>& change) {
    Frame frame = smallFrame();
    auto stage = std::make_shared<HitStage>(*frame.hits);
    change(stage->hits);
    frame.hits = stage;
    return frame;
}
Frame withRays(const std::function<void(RayStage&)>& change) {
    Frame frame = smallFrame();
    auto stage = std::make_shared<RayStage>(*frame.rays);
    change(*stage);
    frame.rays = stage;
    return frame;
}

using Rendered = std::function<Frame(const FrameRequest&, int threads)>;

StressSubjects withFrame(const Rendered& rendered, std::vector<StressCameraFamily> cameras) {
    StressSubjects subjects;
    subjects.cameras = std::move(cameras);
    subjects.frame = [=](const FrameRequest& request, const std::shared_ptr<MapCache>&, Work& work) {
        return std::make_shared<const Frame>(rendered(request, work.threads().size()));
    };
    return subjects;
}

TEST_F(StressFaultsTest, FaultyFramesAreReported) {
    ASSERT_EQ(smallFrame().hits->hits.outcome[kPixel], Outcome::Hit);
    ASSERT_TRUE(smallFrame().exactHits);
    const auto checks = [&](const Rendered& rendered, bool refused = false) {
        return checksOf(run(StressPart::Frames, withFrame(rendered, plainCamera(refused))));
    };
    const float nan = std::nanf("");
    EXPECT_EQ(checks([](const FrameRequest&, int) { return smallFrame(); }), Checks{});
    EXPECT_EQ(checks([=](const FrameRequest&, int) { return withLight(nan); }), Checks{"not-finite"});
    EXPECT_EQ(checks([](const FrameRequest& request, int) { return request.skip ? smallFrame() : withLight(7); }),
              Checks{"no-skip"});
    // Approximated frames are not compared with one rendered without skipping. Both kinds are compared between numbers
    // of threads.
    EXPECT_EQ(checks([](const FrameRequest&, int n) { return n > 1 ? withLight(7) : smallFrame(); }),
              Checks{"threads"});
    EXPECT_EQ(checks([](const FrameRequest& request, int n) {
                  return n > 1 && request.bounded > 0 ? withLight(7) : smallFrame();
              }),
              Checks{"threads"});
    EXPECT_EQ(checks([](const FrameRequest& request, int) {
                  return request.bounded > 0 ? withHit([](HitBlock& hits) { hits.t[kPixel] += kMaxBounded + 1; })
                                             : smallFrame();
              }),
              Checks{"bounded"});
    const auto failing = [](const auto& error) { return [=](const FrameRequest&, int) -> Frame { throw error; }; };
    EXPECT_EQ(checks(failing(std::runtime_error("out of order"))), Checks{"exception"});
    EXPECT_EQ(checks(failing(WorkError("disk", Message(MessageId::FileTruncated)))), Checks{"exception"});
    EXPECT_EQ(checks(failing(InputError("--camera", Message(MessageId::FileTruncated)))), Checks{"refused"});
    EXPECT_EQ(checks(failing(InputError("--camera", Message(MessageId::FileTruncated))), true), Checks{});
    EXPECT_EQ(checks([](const FrameRequest&, int) { return smallFrame(); }, true), Checks{"accepted"});
}

// Each buffer of a frame is altered separately.
TEST_F(StressFaultsTest, EveryBufferOfAFrameIsCompared) {
    const Frame& right = smallFrame();
    const auto difference = [&](const Frame& other) {
        const auto one = differenceFault(right, other, "no-skip", "once more");
        const auto two = differenceFault(other, right, "no-skip", "once more");
        EXPECT_EQ(one.has_value(), two.has_value());
        return one ? one->detail : "";
    };
    EXPECT_EQ(difference(right), "");
    const auto tells = [&](const Frame& other, const std::string& words) {
        const std::string detail = difference(other);
        EXPECT_EQ(detail.find("pixel 11,5: " + words), 0U) << detail;
        EXPECT_NE(detail.find("once more"), std::string::npos) << detail;
    };
    tells(withRays([](RayStage& rays) { rays.polygon[kPixel] = 3; }), "polygon");
    tells(withRays([](RayStage& rays) { rays.inverseDepth[kPixel] = std::nextafter(rays.inverseDepth[kPixel], 2.0F); }),
          "1 / depth");
    tells(withColor(std::nextafter(right.color->color.pixels()[kPixel].z, 2.0F)), "colour");
    tells(withLight(std::nextafter(right.light->color.pixels()[kPixel].y, 2.0F)), "lit colour");
    tells(withHit([](HitBlock& hits) { hits.outcome[kPixel] = Outcome::Miss; }), "outcome");
    const auto moved = [](std::vector<double> HitBlock::*column) {
        return withHit([=](HitBlock& hits) { (hits.*column)[kPixel] = std::nextafter((hits.*column)[kPixel], 1e9); });
    };
    for (const auto column : {&HitBlock::lambda, &HitBlock::s, &HitBlock::t}) tells(moved(column), "outcome");
}

TEST_F(StressFaultsTest, EveryNumberOfAFrameMustBeOne) {
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    const auto check = [](const Frame& frame) {
        const auto fault = finiteFault(frame);
        return fault ? fault->check : "";
    };
    EXPECT_EQ(check(smallFrame()), "");
    for (const double wrong : {nan, infinite, -infinite}) {
        EXPECT_EQ(check(withColor(static_cast<float>(wrong))), "not-finite");
        EXPECT_EQ(check(withLight(static_cast<float>(wrong))), "not-finite");
        for (const auto column : {&HitBlock::lambda, &HitBlock::s, &HitBlock::t}) {
            EXPECT_EQ(check(withHit([&](HitBlock& hits) { (hits.*column)[kPixel] = wrong; })), "not-finite");
        }
    }
    for (const double wrong : {-1e-9, 1 + 1e-9}) {
        EXPECT_EQ(check(withHit([&](HitBlock& hits) { hits.lambda[kPixel] = wrong; })), "not-finite") << wrong;
    }
    for (const double right : {0.0, 1.0}) {
        EXPECT_EQ(check(withHit([&](HitBlock& hits) { hits.lambda[kPixel] = right; })), "") << right;
    }
    EXPECT_EQ(check(withHit([&](HitBlock& hits) {
                  hits.outcome[kPixel] = Outcome::Miss;
                  hits.lambda[kPixel] = nan;
              })),
              "")
        << "a miss has no position";
}

// The bound applies only to pixels that both frames hit, to s and t alike.
TEST_F(StressFaultsTest, TheBoundIsOnTheDistanceOfHits) {
    const auto moved = [](double s, double t, Outcome outcome = Outcome::Hit) {
        return withHit([=](HitBlock& hits) {
            hits.s[kPixel] += s;
            hits.t[kPixel] += t;
            hits.outcome[kPixel] = outcome;
        });
    };
    for (const auto& [s, t] : {std::pair(0.3, 0.4), std::pair(-0.4, 0.3), std::pair(0.0, -0.5), std::pair(0.5, 0.0)}) {
        EXPECT_FALSE(boundFault(moved(s, t), smallFrame(), 0.501)) << s << " " << t;
        EXPECT_TRUE(boundFault(moved(s, t), smallFrame(), 0.499)) << s << " " << t;
        EXPECT_TRUE(boundFault(smallFrame(), moved(s, t), 0.499)) << s << " " << t;
        EXPECT_FALSE(boundFault(moved(s, t, Outcome::Miss), smallFrame(), 0.1));
        EXPECT_FALSE(boundFault(smallFrame(), moved(s, t, Outcome::Limit), 0.1));
    }
}

// --- Homographies

TEST_F(StressFaultsTest, FaultyMapsAreReported) {
    const auto checks = [&](const std::function<void(StressSubjects&)>& alter) {
        StressSubjects subjects;
        subjects.cameras = plainCamera();
        alter(subjects);
        return checksOf(run(StressPart::Homographies, subjects));
    };
    EXPECT_EQ(checks([](StressSubjects&) {}), Checks{});
    EXPECT_EQ(checks([](StressSubjects& subjects) {
                  subjects.inverse = [](const Homography& map) {
                      Homography inverse = map.inverse();
                      inverse.t1 *= 1 + 1e-9;
                      return inverse;
                  };
              }),
              Checks{"round-trip"});
    EXPECT_EQ(checks([](StressSubjects& subjects) {
                  // The same quotients with the opposite sign of q: behind the eye.
                  subjects.inverse = [](const Homography& map) {
                      const Homography m = map.inverse();
                      return Homography{-m.sx, -m.sy, -m.s1, -m.tx, -m.ty, -m.t1, -m.qx, -m.qy, -m.q1};
                  };
              }),
              Checks{"round-trip"});
    EXPECT_EQ(checks([](StressSubjects& subjects) {
                  subjects.derivatives = [](const Homography& map) {
                      auto terms = derivativeTerms<double>(map);
                      terms.b1 *= 1 + 1e-6;
                      return terms;
                  };
              }),
              Checks{"derivatives"});
}

// A fault in one of the four derivatives is reported for that one.
TEST_F(StressFaultsTest, EachDerivativeIsComparedWithDifferences) {
    Camera camera;
    camera.azimuth = 35;
    const TexturedPlane plane = makeScene(SceneKind::Floor, 64, 48).front().plane;
    const Homography map = fromCameraAndPlane(pinholeCamera(camera, 800, 600), plane);
    const auto right = derivativeTerms<double>(map);
    constexpr double kX = 410.5, kY = 330.5;
    ASSERT_FALSE(derivativeFault(map, right, kX, kY));
    using Terms = DerivativeTerms<double>;
    const auto name = [&](double Terms::*term) {
        Terms wrong = right;
        EXPECT_NE(wrong.*term, 0);
        wrong.*term *= 1 + 1e-6;
        const auto fault = derivativeFault(map, wrong, kX, kY);
        return fault && fault->check == "derivatives" ? fault->detail.substr(0, 3) : "";
    };
    EXPECT_EQ(name(&Terms::a1), "u_x");
    EXPECT_EQ(name(&Terms::b1), "v_x");
    EXPECT_EQ(name(&Terms::c1), "u_y");
    EXPECT_EQ(name(&Terms::d1), "v_y");
    EXPECT_EQ(name(&Terms::m), "u_x");
    EXPECT_EQ(name(&Terms::n), "v_x");
    EXPECT_EQ(name(&Terms::o), "u_y");
    EXPECT_EQ(name(&Terms::p), "v_y");
    EXPECT_EQ(name(&Terms::h), "u_x") << "the denominator is of all four";
}

// Where q is positive and reliable, the texel must not be NaN.
TEST_F(StressFaultsTest, ATexelThatIsNoNumberIsReported) {
    Homography map;
    map.sx = 1e308;
    const auto fault = roundTripFault(map, Homography{}, 400.5, 310.5);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->check, "not-finite");
    EXPECT_FALSE(derivativeFault(map, derivativeTerms<double>(map), 400.5, 310.5)) << "right, but without differences";
}

// --- Rows

template <typename T>
using AlterRow = std::function<void(PixelSpan span, const RowOptions& options, PixelSpan& valid, T* u, T* v)>;

template <typename T>
RowEvaluator<T> alteredRow(AlterRow<T> alter) {
    return [alter = std::move(alter)](const Homography& map, double y, PixelSpan span, const RowOptions& options, T* u,
                                      T* v) {
        PixelSpan valid = evaluateRow<T>(map, y, span, options, u, v);
        alter(span, options, valid, u, v);
        return valid;
    };
}

// Length of the rows whose bounds are stated (stress_rows.cpp); with this seed the rows of cameras have other lengths.
constexpr std::int64_t kStatedPixels = 1500;

class StressRowFaultsTest : public StressFaultsTest {
  protected:
    Checks checks(const std::function<void(StressSubjects&)>& alter, std::vector<StressCameraFamily> cameras) {
        StressSubjects subjects;
        subjects.cameras = std::move(cameras);
        alter(subjects);
        return checksOf(run(StressPart::Rows, subjects));
    }
    // Puts the same fault into rows of float and then of double. Blocks of rows are float and are compared with single
    // rows, so they differ where those are wrong.
    template <class Alter>
    void expectChecks(const Alter& alter, const Checks& expected, std::vector<StressCameraFamily> cameras) {
        EXPECT_EQ(checks([&](StressSubjects& s) { s.doubleRow = alteredRow<double>(alter); }, cameras), expected);
        Checks withBlocks = expected;
        if (!expected.empty()) withBlocks.insert("threads");
        EXPECT_EQ(checks([&](StressSubjects& s) { s.floatRow = alteredRow<float>(alter); }, cameras), withBlocks);
    }
};

TEST_F(StressRowFaultsTest, FaultyRowsAreReported) {
    EXPECT_EQ(checks([](StressSubjects&) {}, plainCamera()), Checks{});
    const auto nothing = [](PixelSpan, const RowOptions&, PixelSpan&, auto*, auto*) {};
    expectChecks(nothing, Checks{}, plainCamera());
    // More than the drift that any stated bound permits, and more than any texel coordinate of a camera's row.
    constexpr float kFarTexels = 1e3F, kFartherTexels = 1e7F;
    for (const bool down : {false, true}) {
        expectChecks(
            [=](PixelSpan span, const RowOptions&, PixelSpan& valid, auto* u, auto* v) {
                if (valid.empty()) return;
                (down ? v : u)[valid.end - 1 - span.begin] = std::numeric_limits<float>::quiet_NaN();
            },
            Checks{"not-finite"}, plainCamera());
        for (const bool stated : {false, true}) {
            expectChecks(
                [=](PixelSpan span, const RowOptions&, PixelSpan& valid, auto* u, auto* v) {
                    if ((span.size() == kStatedPixels) != stated || valid.empty()) return;
                    (down ? v : u)[valid.begin - span.begin] += stated ? kFarTexels : kFartherTexels;
                },
                Checks{"row"}, plainCamera());
        }
        // Within every bound: only the comparison of the SIMD and the scalar version fails.
        expectChecks(
            [=](PixelSpan span, const RowOptions& options, PixelSpan& valid, auto* u, auto* v) {
                if (span.size() == kStatedPixels || valid.empty() || !options.lanes) return;
                auto& value = (down ? v : u)[valid.begin - span.begin];
                value = std::nextafter(value, decltype(value + 0)(1e9));
            },
            Checks{"lanes"}, plainCamera());
    }
}

TEST_F(StressRowFaultsTest, RowsBeyondTheHorizonAreReported) {
    // A level camera, so that half of all rows are above the horizon.
    const auto level = [](SceneKind scene, Random&) {
        Camera camera;
        camera.kind = Camera::Kind::Free;
        camera.eye = scene == SceneKind::Floor ? glm::dvec3(0.2, 0.3, 1) : glm::dvec3(1, 0.1, 0.7);
        camera.target = camera.eye + (scene == SceneKind::Floor ? glm::dvec3(0.1, 0, -1) : glm::dvec3(-1, 0, 0));
        return camera;
    };
    expectChecks(
        [](PixelSpan span, const RowOptions&, PixelSpan& valid, auto* u, auto* v) {
            if (valid.size() == span.size()) return;
            std::fill(u, u + span.size(), 0);
            std::fill(v, v + span.size(), 0);
            valid = span;
        },
        Checks{"horizon"}, {{"level", level, false}});
}

TEST_F(StressRowFaultsTest, FaultyBlocksOfRowsAreReported) {
    using Alter = std::function<void(TexelRows<float>&)>;
    const auto checksOfBlocks = [&](const Alter& alter) {
        return checks(
            [&](StressSubjects& subjects) {
                subjects.rowBlock = [=](const Homography& map, const RowBlock& block, const RowOptions& options,
                                        TexelRows<float>& out, Work& work) {
                    evaluateRows<float>(map, block, options, out, work);
                    alter(out);
                };
            },
            plainCamera());
    };
    EXPECT_EQ(checksOfBlocks([](TexelRows<float>&) {}), Checks{});
    const auto bit = [](float& value) { value = std::nextafter(value, 1e9F); };
    EXPECT_EQ(checksOfBlocks([&](TexelRows<float>& rows) { bit(rows.u(4)[rows.valid(4).end - 1]); }),
              Checks{"threads"});
    EXPECT_EQ(checksOfBlocks([&](TexelRows<float>& rows) { bit(rows.v(0)[rows.valid(0).begin]); }), Checks{"threads"});
    EXPECT_EQ(checksOfBlocks([](TexelRows<float>& rows) { --rows.valid(2).end; }), Checks{"threads"});
}

// --- Tracers: one hand-made answer at a time

class StressAnswerTest : public ::testing::Test {
  protected:
    enum class Steps { AtBound, AboveBound };

    // Returns the name of the check that this answer fails, for a tracer with this guarantee over a relief of height
    // 1/2; "" if it passes.
    std::string check(Guarantee guarantee, const Hit& hit, const Hit& reference, Address address = Address::Repeat,
                      const ViewRay& ray = kRay, Steps steps = Steps::AtBound) {
        const HeightField field(std::make_shared<FloatImage>(FloatImage(16, 12, 0.5F)), Surface::Bilinear, address);
        const auto nothing = [](const ViewRay&, Hit&, std::uint32_t&, Overload) {};
        const AlteredTracer tracer(makeTracer({"exact", {}}, field, maps_, work_), nothing, guarantee);
        const double most = std::floor(tracer.stepBound(ray));
        const auto count = static_cast<std::uint32_t>(steps == Steps::AtBound ? most : most + 1);
        const auto fault = answerFault(tracer, ray, {hit, count, 0}, reference);
        return fault ? fault->check : "";
    }

    static constexpr ViewRay kRay{3.25, 4.5, 2, -1};
    static constexpr ViewRay kBeyond{3.25, 4.5, 2 * kMaxRun, 0};
    static Hit at(double lambda) { return Hit::at(kRay, lambda); }
    static Hit none(Outcome outcome) { return Hit::none(outcome); }

    MapCache maps_;
    Work work_{1};
};

TEST_F(StressAnswerTest, ExactIsBitForBit) {
    const Hit truth = at(0.5);
    EXPECT_EQ(check(Guarantee::Exact, truth, truth), "");
    for (const double other : {std::nextafter(0.5, 0.0), std::nextafter(0.5, 1.0)}) {
        EXPECT_EQ(check(Guarantee::Exact, at(other), truth), "bits");
    }
    EXPECT_EQ(check(Guarantee::Exact, none(Outcome::Limit), truth), "limit");
    EXPECT_EQ(check(Guarantee::Exact, none(Outcome::Unset), truth), "not-finite");
    EXPECT_EQ(check(Guarantee::Exact, none(Outcome::Miss), truth, Address::Border), "bits");
    EXPECT_EQ(check(Guarantee::Exact, truth, none(Outcome::Miss), Address::Border), "bits");
    EXPECT_EQ(check(Guarantee::Exact, none(Outcome::Miss), none(Outcome::Miss), Address::Border), "");
    for (const Address address : {Address::Repeat, Address::Clamp}) {
        EXPECT_EQ(check(Guarantee::Exact, none(Outcome::Miss), none(Outcome::Miss), address), "miss");
    }
}

TEST_F(StressAnswerTest, ConservativeIsNeverLater) {
    const Hit truth = at(0.5);
    for (const double lambda : {0.0, 0.25, 0.5, std::nextafter(0.5, 1.0)}) {
        EXPECT_EQ(check(Guarantee::Conservative, at(lambda), truth), "") << "later by rounding alone";
    }
    for (const double lambda : {0.5 + 2 * kOvershootRounding, 1.0}) {
        EXPECT_EQ(check(Guarantee::Conservative, at(lambda), truth), "overshoot") << lambda;
    }
    EXPECT_EQ(check(Guarantee::Conservative, none(Outcome::Limit), truth), "") << "it may give up";
    EXPECT_EQ(check(Guarantee::Conservative, none(Outcome::Miss), truth, Address::Border), "overshoot");
    EXPECT_EQ(check(Guarantee::Conservative, truth, none(Outcome::Miss), Address::Border), "") << "too early";
    EXPECT_EQ(check(Guarantee::Conservative, none(Outcome::Miss), truth), "miss");
}

TEST_F(StressAnswerTest, EveryAnswerIsANumberOnItsRay) {
    const Hit truth = at(0.5);
    for (const Guarantee guarantee : {Guarantee::Exact, Guarantee::Conservative, Guarantee::Approximate}) {
        for (const double lambda : {-1e-300, std::nextafter(1.0, 2.0), std::nan("")}) {
            EXPECT_EQ(check(guarantee, at(lambda), truth), "not-finite") << lambda;
        }
        Hit wrong = truth;
        wrong.s = std::numeric_limits<double>::infinity();
        EXPECT_EQ(check(guarantee, wrong, truth), "not-finite");
        for (double Hit::*place : {&Hit::s, &Hit::t}) {
            wrong = truth;
            wrong.*place = std::nextafter(wrong.*place, 100.0);
            EXPECT_EQ(check(guarantee, wrong, truth), "inconsistent");
        }
        EXPECT_EQ(check(guarantee, truth, truth), "");
        EXPECT_EQ(check(guarantee, none(Outcome::Miss), truth), "miss");
    }
    EXPECT_EQ(check(Guarantee::Approximate, at(0.9), truth), "");
    EXPECT_EQ(check(Guarantee::Approximate, none(Outcome::Limit), truth), "");
}

TEST_F(StressAnswerTest, StepsEndAtTheBound) {
    const Hit truth = at(0.5);
    for (const Guarantee guarantee : {Guarantee::Exact, Guarantee::Conservative, Guarantee::Approximate}) {
        EXPECT_EQ(check(guarantee, truth, truth, Address::Repeat, kRay, Steps::AboveBound), "steps");
    }
}

// Beyond the supported domain both tracers may have given up; the checks of a hit's validity and of the steps apply
// there, too.
TEST_F(StressAnswerTest, BeyondTheDomainOnlyWhatHoldsThere) {
    const Hit truth = Hit::at(kBeyond, 0.5), late = Hit::at(kBeyond, 0.75);
    for (const Guarantee guarantee : {Guarantee::Exact, Guarantee::Conservative}) {
        EXPECT_EQ(check(guarantee, late, truth, Address::Repeat, kBeyond), "");
        EXPECT_EQ(check(guarantee, none(Outcome::Limit), truth, Address::Repeat, kBeyond), "");
        EXPECT_EQ(check(guarantee, none(Outcome::Miss), truth, Address::Repeat, kBeyond), "miss");
        EXPECT_EQ(check(guarantee, Hit::at(kBeyond, 2), truth, Address::Repeat, kBeyond), "not-finite");
        EXPECT_EQ(check(guarantee, truth, truth, Address::Repeat, kBeyond, Steps::AboveBound), "steps");
    }
}

// --- Endless loops

TEST_F(StressFaultsTest, AFrameAndAQueryThatHangAreReported) {
    constexpr int kMostWaits = 10'000;  // milliseconds: a hundred polls of the watchdog
    for (const StressPart part : {StressPart::Frames, StressPart::AnyHit}) {
        std::atomic<bool> named = false;
        std::atomic<int> left = 1;
        const auto hang = [&] {
            if (left.fetch_sub(1) != 1) return;
            // Limited, so that the test fails if the ray is never reported.
            for (int n = 0; n < kMostWaits && !named; ++n) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        };
        StressSubjects subjects = part == StressPart::AnyHit ? withQuery([&](VisibilityBlock&, Overload) { hang(); })
                                                             : withFrame(
                                                                   [&](const FrameRequest&, int) {
                                                                       hang();
                                                                       return smallFrame();
                                                                   },
                                                                   plainCamera());
        StressViolation found;
        run(part, subjects, {}, [&](const StressViolation& violation) {
            found = violation;
            named = true;
        });
        EXPECT_EQ(found.fault.check, "hang");
        const std::string words = part == StressPart::Frames
                                      ? std::string("relief render ")
                                      : "relief stress --seed " + std::to_string(kSeed) + " --case ";
        EXPECT_EQ(found.command.find(words), 0U) << found.command;
    }
}

}  // namespace
}  // namespace relief::test
