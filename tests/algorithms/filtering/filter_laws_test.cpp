// Properties that every filter must have, tested for the whole list.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <set>

#include "filter_cases.h"
#include "filtering/elliptical.h"

using namespace relief;
using namespace relief::test;

namespace {

// Rounding of sums in double of some thousand float weights times values of at most one.
constexpr double kRounding = 2e-6;
// Half a step of 16 bits, and sums in float.
constexpr double kLaneRounding = 1.2e-5;
constexpr int kFootprints = 60;

double rounding(const FilterChoice& choice) {
    return choice.name.starts_with("elliptical") ? kLaneRounding : kRounding;
}

void expectNear(Color a, Color b, double tolerance, const std::string& what) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << what << ", channel " << k;
}

TEST(FilterLaws, aConstantPictureStaysConstant) {
    const Color color{0.25F, 0.5F, 0.8F};
    Random random(1);
    for (const auto& [w, h] : std::vector<std::pair<int, int>>{{64, 64}, {37, 50}, {5, 3}, {1, 1}, {1, 40}}) {
        const Picture picture = constantPicture(w, h, color);
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            for (const FilterChoice& choice : allFilters()) {
                MadeFilter filter(choice, picture, fieldFor(*picture, address));
                for (int n = 0; n < 8; ++n) {
                    const glm::dvec2 place{random.between(0, w), random.between(0, h)};
                    expectNear(filter.at(place, randomJacobian(random)), color, rounding(choice),
                               filterText(choice) + " " + std::to_string(w) + "x" + std::to_string(h));
                }
            }
        }
    }
}

// Mirroring everything at the diagonal gives the same colour.
TEST(FilterLaws, transposedIsTheSame) {
    const Picture picture = randomPicture(45, 32, 7);
    auto turned = std::make_shared<ColorImage>(32, 45);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 45; ++x) (*turned)(y, x) = (*picture)(x, y);
    }
    Random random(2);
    for (const FilterChoice& choice : allFilters()) {
        // The stripes and spots of displays have a direction of their own.
        const auto weights = choice.options.find("weights");
        if (weights != choice.options.end() && (weights->second == "lcd" || weights->second == "crt")) continue;
        MadeFilter one(choice, picture, fieldFor(*picture, Address::Repeat));
        MadeFilter other(choice, turned, fieldFor(*turned, Address::Repeat));
        // The cells of a map are not symmetric to the last bit, nor is a tie between two cells.
        const bool cells = choice.options.contains("source") || weights != choice.options.end();
        for (int n = 0; n < kFootprints; ++n) {
            const Jacobian j = randomJacobian(random);
            const glm::dvec2 place{random.between(0, 45), random.between(0, 32)};
            // Both the texel axes and the pixel axes are exchanged.
            const Jacobian t{j.vy, j.uy, j.vx, j.ux};
            expectNear(one.at(place, j), other.at({place.y, place.x}, t), cells ? 0.02 : 1e-5, filterText(choice));
        }
    }
}

// Inside a linear ramp a symmetric filter returns the ramp's value at the centre.
TEST(FilterLaws, aRampIsReproduced) {
    auto ramp = std::make_shared<ColorImage>(256, 256);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            (*ramp)(x, y) = Color(static_cast<float>(0.001 * (x + 0.5) + 0.002 * (y + 0.5)));
        }
    }
    Random random(3);
    // Largest error in texels: a footprint's texels lie on a lattice that is not symmetric about its centre.
    constexpr double kLattice = 0.35;
    for (const char* text : {"bilinear", "trilinear", "elliptical", "elliptical:weights=uniform",
                             "elliptical:source=map", "elliptical:levels=exhaustive"}) {
        const FilterChoice choice = parseFilter(text, "test");
        MadeFilter filter(choice, ramp, fieldFor(*ramp, Address::Clamp));
        for (int n = 0; n < kFootprints; ++n) {
            const Jacobian j = randomJacobian(random, 6);
            const glm::dvec2 place{random.between(80, 176), random.between(80, 176)};
            const double expected = 0.001 * place.x + 0.002 * place.y;
            FootprintLog log;
            const Color color = filter.at(place, j, &log);
            const double texel = std::ldexp(1.0, log.footprint.level) * 0.003;
            EXPECT_NEAR(color.r, expected, kLattice * texel + kRounding) << text;
        }
    }
}

TEST(FilterLaws, weightsOfTheLogMakeTheColour) {
    const Picture picture = randomPicture(50, 41, 5);
    Random random(4);
    for (const FilterChoice& choice : allFilters()) {
        MadeFilter filter(choice, picture, fieldFor(*picture, Address::Repeat));
        const ColorLevels levels(picture, filter.work);
        for (int n = 0; n < kFootprints; ++n) {
            FootprintLog log;
            const glm::dvec2 place{random.between(0, 50), random.between(0, 41)};
            const Jacobian j = randomJacobian(random);
            const Color color = filter.at(place, j, &log);
            EXPECT_EQ(color, log.color) << filterText(choice);
            EXPECT_EQ(color, filter.at(place, j)) << filterText(choice) << ": the log changed it";
            if (log.texels.empty()) continue;
            glm::dvec3 sum(0), total(0);
            for (const FootprintTexel& texel : log.texels) {
                sum += glm::dvec3(texel.weight * levels.level(texel.level)(texel.i, texel.j));
                total += glm::dvec3(texel.weight);
            }
            expectNear(Color(sum / total), color, rounding(choice), filterText(choice));
        }
    }
}

// The footprint contains exactly the texels of the quadratic form, on the level chosen.
TEST(FilterLaws, theEllipseHoldsExactlyItsTexels) {
    const Picture picture = randomPicture(96, 96, 6);
    Random random(5);
    Work work(1);
    const auto levels = std::make_shared<const ColorLevels>(picture, work);
    const EllipticalKernel kernel(levels, Address::Clamp, EllipticalSettings::of({}));
    int texels = 0;
    for (int n = 0; n < 200; ++n) {
        FootprintLog log;
        FootprintCounts counts;
        kernel.filter(randomJacobian(random, 8), {random.between(30, 66), random.between(30, 66)}, counts, &log);
        const LevelFootprint& f = log.footprint;
        if (f.kind != FootprintKind::Ellipse) continue;
        std::set<std::pair<double, double>> visited;
        for (const FootprintTexel& texel : log.texels) visited.emplace(texel.u, texel.v);
        EXPECT_EQ(visited.size(), log.texels.size());
        // Texels so near to the outline that rounding decides are skipped.
        constexpr double kOutline = 1e-9;
        for (double v = -200.5; v < 300; ++v) {
            for (double u = -200.5; u < 300; ++u) {
                const double r2 = f.ellipse.form(u - f.centre.x, v - f.centre.y) / (f.ellipse.f * f.radius * f.radius);
                if (std::abs(r2 - 1) < kOutline) continue;
                ASSERT_EQ(visited.contains({u, v}), r2 < 1) << u << " " << v << " r2 " << r2;
                texels += r2 < 1 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(texels, 1000);
}

TEST(FilterLaws, nothingAtTheHorizonOrEdgeOnIsNotANumber) {
    const Picture picture = randomPicture(33, 20, 8);
    const double huge = std::numeric_limits<double>::max();
    const double infinite = std::numeric_limits<double>::infinity();
    const std::vector<Jacobian> degenerate{{0, 0, 0, 0},
                                           {1, 0, 0, 0},
                                           {1e-300, 0, 0, 1e-300},
                                           {1e300, 0, 0, 1},
                                           {1e6, 1e6, 1e6, 1e6},
                                           {1e12, 3, -1e12, 4},
                                           {huge, huge, huge, huge},
                                           {infinite, 0, 0, 1},
                                           {std::nan(""), 1, 1, 1},
                                           {3, 3, 3, 3},
                                           {0, 1e9, 0, 1e-9},
                                           {5, 0, 0, 1e-17}};
    for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
        for (const FilterChoice& choice : allFilters()) {
            MadeFilter filter(choice, picture, fieldFor(*picture, address, 0.5F));
            for (const Jacobian& j : degenerate) {
                for (const glm::dvec2& place : {glm::dvec2(0, 0), glm::dvec2(16.5, 10), glm::dvec2(1e6, -1e6)}) {
                    const Color color = filter.at(place, j);
                    for (int k = 0; k < 3; ++k) {
                        EXPECT_TRUE(color[k] >= -kRounding && color[k] <= 1 + kRounding)
                            << filterText(choice) << " " << j.ux << " " << j.vx << " " << j.uy << " " << j.vy;
                    }
                }
            }
        }
    }
}

// One whole period further the colour is the same, also if the size is not a power of two.
TEST(FilterLaws, repeatHasNoSeam) {
    const Picture picture = randomPicture(37, 26, 9);
    Random random(6);
    for (const FilterChoice& choice : allFilters()) {
        MadeFilter filter(choice, picture, fieldFor(*picture, Address::Repeat));
        const bool cells = choice.options.contains("source") || choice.options.contains("weights");
        for (int n = 0; n < 20; ++n) {
            const Jacobian j = randomJacobian(random);
            // Multiples of 1/16 are exact in both places.
            const glm::dvec2 place{random.below(37 * 16) / 16.0, random.below(26 * 16) / 16.0};
            if (choice.name == "nearest" && (place.x == std::floor(place.x) || place.y == std::floor(place.y)))
                continue;
            expectNear(filter.at(place, j), filter.at(place + glm::dvec2(37 * 3, -26 * 2), j), cells ? 0.02 : 1e-4,
                       filterText(choice));
        }
    }
}

TEST(FilterLaws, tablesAndMapsKeepTheirStatedError) {
    const Picture picture = randomPicture(128, 128, 10);
    Random random(7);
    for (const char* resolution : {"16", "64", "256"}) {
        MadeFilter direct({"elliptical", {}}, picture, fieldFor(*picture, Address::Repeat));
        for (const char* source : {"table", "map"}) {
            const FilterChoice choice{"elliptical", {{"source", source}, {"resolution", resolution}}};
            EllipticalOptions options;
            options.resolution = std::atoi(resolution);
            const double error = mapError(EllipticalSettings::of(options));
            MadeFilter other(choice, picture, fieldFor(*picture, Address::Repeat));
            for (int n = 0; n < kFootprints; ++n) {
                FootprintLog exact, near;
                const Jacobian j = randomJacobian(random);
                const glm::dvec2 place{random.between(0, 128), random.between(0, 128)};
                direct.at(place, j, &exact);
                other.at(place, j, &near);
                ASSERT_EQ(exact.texels.size(), near.texels.size());
                for (std::size_t k = 0; k < exact.texels.size(); ++k) {
                    const float w = exact.texels[k].weight.r;
                    // The map cuts the Gaussian at R along its cells, not along the circle; the error is at most the
                    // weight at the rim.
                    const double rim = std::exp(-0.5 * 2.5 * 2.5);
                    EXPECT_NEAR(near.texels[k].weight.r, w, error + rim) << source << " " << resolution;
                }
            }
        }
    }
}

TEST(FilterLaws, aMirroredPixelSeesAMirroredShape) {
    // The left half is white: a pixel centred on the edge sees white in its red stripe but not in its blue one.
    auto picture = std::make_shared<ColorImage>(64, 64, Color(0));
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 32; ++x) (*picture)(x, y) = Color(1);
    }
    for (const double size : {2.0, 12.0}) {
        MadeFilter filter({"elliptical", {{"weights", "lcd"}}}, picture, fieldFor(*picture, Address::Clamp));
        const Color straight = filter.at({32, 32}, {size, 0, 0, size});
        EXPECT_GT(straight.r, 0.95F) << size;
        EXPECT_NEAR(straight.g, 0.5F, 0.05) << size;
        EXPECT_LT(straight.b, 0.05F) << size;
        const Color mirrored = filter.at({32, 32}, {-size, 0, 0, size});
        EXPECT_LT(mirrored.r, 0.05F) << size;
        EXPECT_GT(mirrored.b, 0.95F) << size;
    }
}

}  // namespace
