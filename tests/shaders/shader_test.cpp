// The exported shaders, run by OpenGL over the same rays as the CPU's methods.
//
// Bound: a hit of the shader is at most kSameAnswer (1/256 texel) from that of the CPU's same method. Where float32
// leads to another answer, the ray is counted and must be one of these:
// - near: the method's own answers jump or spread there: those for rays within kNearRay texels, which is what float32
//   resolves of coordinates after some steps, lie on both sides of the shader's;
// - out of steps: the method took all its iterations without reaching the surface, so that its answer depends on the
//   rounding of each.
#include <cmath>
#include <iostream>
#include <memory>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "shaders/shader_fixture.h"

namespace relief::test {
namespace {

constexpr double kNearRay = 1.0 / 1024;  // texels
constexpr double kMostDifferent = 0.01;  // share of the rays

class Shaders : public ShaderTest {};

// The shader that reads the method's own numbers.
ShaderChoice shaderOf(const MethodChoice& method, Address address) {
    ShaderChoice choice;
    choice.method = method;
    choice.address = address;
    choice.texelSlopes = true;
    return choice;
}

// What the comparison found.
struct Differences {
    int rays = 0;
    int outcomes = 0, hits = 0, steps = 0;  // rays that differ in it; hits by more than kSameAnswer
    int near = 0, outOfSteps = 0;           // why, see above
    double largest = 0;                     // texels, of the hits that count as equal
    double allSteps = 0, allOfCpu = 0;      // steps over all rays

    int unexplained() const { return outcomes + hits - near - outOfSteps; }
    void add(const Differences& one) {
        rays += one.rays, outcomes += one.outcomes, hits += one.hits, steps += one.steps;
        near += one.near, outOfSteps += one.outOfSteps;
        allSteps += one.allSteps, allOfCpu += one.allOfCpu, largest = std::max(largest, one.largest);
    }
    std::string text() const {
        return std::to_string(rays) + " rays, other outcome " + std::to_string(outcomes) + ", other hit " +
               std::to_string(hits) + " (near " + std::to_string(near) + ", out of steps " +
               std::to_string(outOfSteps) + "), else within " + std::to_string(largest) + " texels; other steps " +
               std::to_string(steps) + "\n";
    }
};

// An answer of the shader: found, lambda, steps.
using Found = const float*;

bool sameAnswer(const ViewRay& ray, const Hit& hit, Found found) {
    if ((hit.outcome == Outcome::Hit) != (found[0] > 0)) return false;
    if (hit.outcome != Outcome::Hit) return true;
    return std::abs(hit.lambda - static_cast<double>(found[1])) * texelsOf(ray) <= kSameAnswer;
}

// Whether the method's answers for rays near this one are on both sides of the shader's.
bool nearAnswer(const Tracer& tracer, const ViewRay& ray, Found found, Work& work) {
    RayBlock near;
    Random random(1);
    const auto off = [&] { return random.between(-1, 1) * kNearRay; };
    constexpr int kNear = 100;
    for (int n = 0; n < kNear; ++n) near.push({ray.s0 + off(), ray.t0 + off(), ray.a + off(), ray.b + off()});
    HitBlock hits;
    NullSink sink;
    tracer.trace(near, hits, sink, work);
    bool before = false, behind = false;
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (sameAnswer(near[i], hits[i], found)) return true;
        if (hits[i].outcome != Outcome::Hit) continue;
        (hits[i].lambda < static_cast<double>(found[1]) ? before : behind) = true;
    }
    return found[0] > 0 && before && behind;
}

bool tookAllSteps(const MethodChoice& choice, std::uint32_t steps) {
    const MethodDescription& method = findTracer(choice.name);
    const auto standard = method.defaults.find("iterations");
    if (standard == method.defaults.end()) return false;
    const auto given = choice.options.find("iterations");
    return steps > parseNumber(given == choice.options.end() ? standard->second : given->second, "iterations");
}

Differences compare(Gl& gl, const ShaderChoice& choice, const HeightField& field, const RayBlock& rays, MapCache& maps,
                    Work& work) {
    const auto [numbers, rounded] = shaderRays(rays);
    bindMaps(gl, choice, field, {}, work);
    const std::vector<float> found = gl.compute(rayPassText(shaderText(choice, "test")), numbers);
    const auto tracer = makeTracer(choice.method, field, maps, work, Form::Scalar);
    HitBlock hits;
    BlockCounts counts;
    tracer->trace(rounded, hits, counts, work);
    Differences all;
    all.rays = static_cast<int>(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const ViewRay ray = rounded[i];
        const Hit hit = hits[i];
        const Found one = &found[4 * i];
        all.allSteps += static_cast<double>(one[2]);
        all.allOfCpu += hits.steps[i];
        // The CPU counts the start of a ray as a step.
        all.steps += static_cast<int>(one[2]) != static_cast<int>(hits.steps[i]) - 1;
        if (sameAnswer(ray, hit, one)) {
            if (hit.outcome != Outcome::Hit) continue;
            all.largest = std::max(all.largest, std::abs(hit.lambda - static_cast<double>(one[1])) * texelsOf(ray));
            continue;
        }
        ++((hit.outcome == Outcome::Hit) != (one[0] > 0) ? all.outcomes : all.hits);
        if (nearAnswer(*tracer, ray, one, work)) {
            ++all.near;
        } else if (tookAllSteps(choice.method, hits.steps[i])) {
            ++all.outOfSteps;
        } else if (all.unexplained() <= 3) {
            std::cout << choice.method.name << " ray " << ray.s0 << "," << ray.t0 << "," << ray.a << "," << ray.b
                      << ": CPU " << hit.lambda << ", shader " << one[0] << " " << one[1] << "\n";
        }
    }
    return all;
}

std::vector<MethodChoice> choicesOf(const std::string& tracer) {
    std::vector<MethodChoice> all{{tracer, {}}};
    if (tracer.starts_with("layers")) all.push_back({tracer, {{"layers", "13"}}});
    if (tracer == "layers-bisection") all.push_back({tracer, {{"bisections", "3"}}});
    if (tracer == "cone-dummer") all.push_back({tracer, {{"iterations", "7"}}});
    if (tracer == "relaxed-cone") all.push_back({tracer, {{"iterations", "4"}, {"bisections", "0"}}});
    if (tracer == "distance") {
        all.push_back({tracer, {{"stop", "distance"}, {"within", "1"}}});
        all.push_back({tracer, {{"stop", "never"}, {"iterations", "20"}}});
    }
    return all;
}

// Rays along the lines of the cells, through their corners, straight down, and along them backwards.
RayBlock awkwardRays(const HeightField& field) {
    RayBlock rays;
    for (const double s : {0.0, 0.5, 8.0, 8.5, field.width() - 0.5}) {
        for (const double t : {0.5, 3.0, 7.5, field.height() * 1.0}) {
            for (const double a : {0.0, 5.0, -7.0, 16.0}) {
                for (const double b : {0.0, 5.0, -7.0, 8.0}) rays.push({s, t, a, b});
            }
        }
    }
    return rays;
}

TEST_F(Shaders, HitWhereTheirMethodHits) {
    constexpr std::size_t kRays = 1000;
    constexpr double kLowest = 8;  // degrees
    const std::vector<Heights> reliefs{share(makeRelief("bricks", 64, 64, 1)), share(makeRelief("fractal", 50, 37, 1)),
                                       share(makeRelief("spikes", 48, 64, 1))};
    for (const std::string& tracer : shaderTracers()) {
        Differences sum;
        for (const Address address : allAddresses()) {
            for (std::size_t n = 0; n < reliefs.size(); ++n) {
                const HeightField field(reliefs[n], Surface::Bilinear, address, 0.1);
                RayBlock rays = randomRays(n + 1, field, kRays, kLowest);
                const RayBlock awkward = awkwardRays(field);
                for (std::size_t i = 0; i < awkward.size(); ++i) rays.push(awkward[i]);
                for (const MethodChoice& method : choicesOf(tracer)) {
                    const Differences one = compare(*gl_, shaderOf(method, address), field, rays, maps_, work_);
                    EXPECT_EQ(one.unexplained(), 0) << tracer << " " << addressName(address) << " relief " << n;
                    EXPECT_LE(one.outcomes + one.hits, kMostDifferent * one.rays) << tracer << " relief " << n;
                    sum.add(one);
                }
            }
        }
        std::cout << tracer << ": " << sum.text();
        // Others take other steps by right: maxima are those of the texels, not of cells; marches along cones converge
        // on the surface, which double reaches some steps later.
        if (!readsCones(tracer) && tracer != "max-pyramid") {
            EXPECT_LE(sum.steps, kMostDifferent * sum.rays) << tracer;
        }
        EXPECT_LE(sum.allSteps, sum.allOfCpu) << tracer;
    }
    std::cout << gl_->renderer() << "\n";
}

// Grazing rays that run up to 1,500 texels, over needles.
TEST_F(Shaders, HitWhereTheirMethodHitsAtGrazingAngles) {
    const HeightField field(share(makeRelief("spikes", 256, 200, 1)), Surface::Bilinear, Address::Repeat, 0.1);
    const RayBlock rays = randomRays(5, field, 1000, 1);
    for (const std::string& tracer : shaderTracers()) {
        const Differences found = compare(*gl_, shaderOf({tracer, {}}, Address::Repeat), field, rays, maps_, work_);
        EXPECT_EQ(found.unexplained(), 0) << tracer;
        if (findTracer(tracer).guarantee == Guarantee::Exact) {
            EXPECT_EQ(found.outcomes + found.hits, 0) << tracer;
        }
        std::cout << tracer << ": " << found.text();
    }
}

// A graphics card's sampler weights texels with 8 bits: an H100 moves up to 4.1% of the hits by more than kSameAnswer.
TEST_F(Shaders, HitNearTheirMethodBySampler) {
    const double moved = samplesInFloat() ? kMostDifferent : 0.08;  // share of the rays
    const HeightField field(share(makeRelief("fractal", 50, 37, 1)), Surface::Bilinear, Address::Repeat, 0.1);
    const RayBlock rays = randomRays(2, field, 1000, 8);
    for (const std::string& tracer : shaderTracers()) {
        ShaderChoice choice = shaderOf({tracer, {}}, Address::Repeat);
        choice.interpolation = ShaderInterpolation::Sampler;
        const Differences found = compare(*gl_, choice, field, rays, maps_, work_);
        EXPECT_LE(found.outcomes + found.hits, moved * found.rays) << tracer;
        std::cout << tracer << " by the sampler: " << found.text();
    }
}

// Each cell's cone is the same in every unit, and so are the steps along it.
TEST_F(Shaders, ReadConesInEveryUnit) {
    const HeightField field(share(makeRelief("hills", 64, 64, 1)), Surface::Bilinear, Address::Repeat, 0.1);
    const RayBlock rays = randomRays(3, field, 1000, 20);
    const auto steps = [&](std::string_view unit, double scale) {
        ShaderChoice choice = shaderOf({"cone", {}}, Address::Repeat);
        setConeUnit(choice, unit, "--unit");
        choice.cones.scale = scale;
        const Differences found = compare(*gl_, choice, field, rays, maps_, work_);
        EXPECT_EQ(found.outcomes + found.hits, 0);
        return found.allSteps;
    };
    const double byTexels = steps("texel-slope", 1);
    for (const auto unit : {"ratio", "sqrt-ratio", "slope"}) {
        for (const double scale : {1.0, 0.25}) EXPECT_NEAR(steps(unit, scale), byTexels, byTexels / 1000);
    }
}

}  // namespace
}  // namespace relief::test
