// Certificates: safe maps are proved safe, unsafe ones are refuted by a ray that shows the error, and a single stored
// value altered by one code is detected.
#include "measuring/verify/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "algorithms/relief/maps/brute_cells.h"
#include "measuring/verify/azimuth_geometry.h"
#include "measuring/verify/certificate_rays.h"
#include "relief/maps/cone_builders.h"
#include "relief/tracers/map_choice.h"

namespace relief::test {

namespace {

constexpr CertificateOptions kFewRays{.rays = 3000, .seed = 11};
constexpr CertificateOptions kValuesOnly{.rays = 0, .seed = 11};

// The conservative methods, with options that cover each part of the check: footprints that do not divide the size,
// sectors whose number is and is not a multiple of four, low precision.
std::vector<MethodChoice> safeChoices(bool clamp) {
    std::vector<MethodChoice> all{
        {"distance-conservative", {{"layers", "9"}}},
        {"distance-conservative", {{"footprint", "3"}, {"layers", "8"}, {"precision", "u8"}}},
        {"cone", {}},
        {"cone", {{"sectors", "8"}, {"precision", "u8"}}},
        {"cone", {{"sectors", "3"}, {"precision", "u16"}}},
    };
    if (clamp) return all;
    all.push_back({"distance-refined", {}});
    all.push_back({"distance-refined", {{"footprint", "1"}, {"layers", "8"}, {"sectors", "8"}}});
    all.push_back({"distance-refined", {{"footprint", "3"}, {"sectors", "2"}, {"precision", "u8"}}});
    return all;
}

Certificate certified(const MethodChoice& choice, const HeightField& field, const CertificateOptions& options,
                      MapCache& cache) {
    Work work;
    return certify(choice, field, options, cache, work);
}

std::string failure(const Certificate& certificate, const HeightField& field) {
    return describe(field) + "\n" + certificateText(certificate, field);
}

// Returns a copy in which one code is changed by `by`.
template <class Values>
Values altered(const Values& values, std::size_t at, int by) {
    auto codes = values.codes();
    std::visit(
        [&](auto& all) {
            using Code = typename std::decay_t<decltype(all)>::value_type;
            if constexpr (std::is_same_v<Code, float>) {
                // Floats are rounded to the safe side by about 1e-6; a change of 1e-5 is distinguishable from that.
                all[at] *= 1 + static_cast<float>(by) * 1e-5F;
            } else {
                all[at] = static_cast<Code>(all[at] + by);
            }
        },
        codes);
    return Values(values.width(), values.height(), values.layers(), std::move(codes), values.unit());
}

std::size_t placeOf(const StoredValues& values, int x, int y, int layer) {
    return static_cast<std::size_t>((layer * values.height() + y) * values.width() + x);
}

}  // namespace

// Under repeat a ray through a point enters within the picture, an integer number of periods away.
TEST(Certificate, RaysThroughAPlaceGoThroughIt) {
    const HeightField field(randomHeights(40, 12, 5), Surface::Bilinear, Address::Repeat, 0.3);
    const CertificateRays rays(field, 100);
    Random random(9);
    for (int n = 0; n < 200; ++n) {
        const double s = 40 * random.unit(), t = 12 * random.unit(), z = random.unit();
        const double a = 200 * random.unit() - 100, b = 200 * random.unit() - 100;
        const auto ray = rays.through(s, t, z, a, b);
        ASSERT_TRUE(ray);
        EXPECT_TRUE(ray->s0 >= 0 && ray->s0 <= 40 && ray->t0 >= 0 && ray->t0 <= 12) << describe(*ray);
        EXPECT_NEAR(std::remainder(ray->s0 + (1 - z) * a - s, 40), 0, 1e-9);
        EXPECT_NEAR(std::remainder(ray->t0 + (1 - z) * b - t, 12), 0, 1e-9);
    }
}

// On ground that rises to the right and down, those are the ways up.
TEST(Certificate, RaysIntoWallsComeFromTheLowSide) {
    FloatImage image(16, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) image(x, y) = static_cast<float>(x + y) / 32;
    }
    const HeightField field(share(std::move(image)), Surface::Columns, Address::Clamp, 0.3);
    const CertificateRays rays(field, 4);
    ASSERT_EQ(CertificateRays::families()[3], "into walls");
    Random random(9);
    for (int n = 0; n < 100; ++n) {
        const ViewRay ray = rays.ray(random, 3);
        EXPECT_TRUE(ray.a > 0 || ray.b > 0) << describe(ray);
    }
}

TEST(Certificate, ARectangleOfVectorsMeetsTheSectorsOfItsVectors) {
    for (const int sectors : {3, 8}) {
        for (int x = -4; x <= 4; ++x) {
            for (int y = -4; y <= 4; ++y) {
                const AzimuthRange range({x + 0.0, x + 2.0, y + 0.0, y + 1.0});
                for (const double right : {0.01, 1.0, 1.99}) {
                    for (const double down : {0.01, 0.5, 0.99}) {
                        const int sector = azimuthSector(x + right, y + down, sectors);
                        EXPECT_TRUE(range.meets(sector, sectors)) << x << " " << y << " sector " << sector;
                    }
                }
            }
        }
    }
    for (int sector = 1; sector < 8; ++sector) EXPECT_FALSE(AzimuthRange({4, 6, 1, 2}).meets(sector, 8)) << sector;
}

TEST(Certificate, ConservativeMapsAreProvenOnEveryRelief) {
    std::uint64_t seed = 40;
    std::uint64_t values = 0;
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        const int width = recipe.anySize ? 37 : recipe.defaultSize;
        const int height = recipe.anySize ? 26 : recipe.defaultSize;
        const Heights heights = share(makeRelief(recipe.name, width, height, ++seed));
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(heights, surface, address, 0.1 + 0.1 * static_cast<double>(seed % 4));
                MapCache cache;
                for (const MethodChoice& choice : safeChoices(address == Address::Clamp)) {
                    const Certificate certificate = certified(choice, field, kFewRays, cache);
                    EXPECT_TRUE(certificate.proven()) << recipe.name << " seed " << seed << " " << describe(choice)
                                                      << " " << failure(certificate, field);
                    ASSERT_TRUE(certificate.bounds);
                    values += certificate.bounds->values;
                }
            }
        }
    }
    EXPECT_GT(values, std::uint64_t{1} << 20);
}

// In such maps the envelope's crossings, computed in float, once selected the wrong parabola.
TEST(Certificate, LargeMapsAreProvenToo) {
    MapCache cache;
    const HeightField field(share(makeRelief("bricks", 256, 256, 1)));
    for (const char* name : {"distance-conservative", "cone"}) {
        const Certificate certificate = certified({name, {}}, field, kValuesOnly, cache);
        EXPECT_TRUE(certificate.proven()) << failure(certificate, field);
    }
}

// The cones of Ban et al. 2024: the corrected ones are proven, though interpolated; the relaxed ones are refuted.
TEST(Certificate, CorrectedConesAreProvenAndRelaxedOnesRefuted) {
    for (const char* recipe : {"bricks", "spikes"}) {
        for (const Address address : {Address::Repeat, Address::Border}) {
            const HeightField field(share(makeRelief(recipe, 64, 48, 5)), Surface::Bilinear, address);
            for (const char* precision : {"float", "u8"}) {
                MapCache cache;
                const Certificate corrected =
                    certified({"cone-robust", {{"precision", precision}}}, field, {.rays = 20'000, .seed = 3}, cache);
                EXPECT_TRUE(corrected.proven()) << failure(corrected, field);
            }
        }
    }
    const HeightField field(share(makeRelief("spikes", 64, 64, 5)));
    MapCache cache;
    const Certificate relaxed = certified({"relaxed-cone-robust", {}}, field, {.rays = 60'000, .seed = 3}, cache);
    EXPECT_FALSE(relaxed.bounds);
    EXPECT_FALSE(relaxed.safe());
    // A single wider cone is no longer proven.
    ConeMap map = buildConeMap(ConeKind::Robust, {}, field, *std::make_unique<Work>());
    auto slopes = std::get<0>(map.slopes.codes());
    float& steepest = *std::max_element(slopes.begin(), slopes.end());
    steepest = 0;
    map.slopes = StoredValues(map.nx(), map.ny(), 1, std::move(slopes), Precision::Float, Rounding::Up);
    cache.put(coneMapKey(ConeKind::Robust, {}, field), std::make_shared<const ConeMap>(std::move(map)));
    EXPECT_FALSE(certified({"cone-robust", {}}, field, {.rays = 2000, .seed = 3}, cache).proven());
}

TEST(Certificate, UnsafeMethodsAreRefutedByARay) {
    for (const char* recipe : {"bricks", "columns", "pits", "spikes"}) {
        const HeightField field(share(makeRelief(recipe, 64, 64, 5)));
        for (const char* name : {"cone-dummer", "distance-refined-sampled", "distance"}) {
            SCOPED_TRACE(std::string(recipe) + " " + name);
            MapCache cache;
            const MethodChoice choice{name, {}};
            const Certificate certificate = certified(choice, field, {.rays = 50'000, .seed = 3}, cache);
            EXPECT_FALSE(certificate.safe());
            ASSERT_TRUE(certificate.first);
            EXPECT_FALSE(certificate.bounds);
            Work work;
            const CounterExample& shown = *certificate.first;
            const Hit truth = traceLogged(*makeTracer({"exact", {}}, field, cache, work), shown.ray).hit;
            const Hit found = traceLogged(*makeTracer(choice, field, cache, work), shown.ray).hit;
            EXPECT_EQ(truth.lambda, shown.surface);
            EXPECT_TRUE(found.outcome == Outcome::Miss ||
                        (found.lambda - truth.lambda) * std::hypot(shown.ray.a, shown.ray.b, field.slabTexels()) >
                            kCoarseTexels);
            EXPECT_NE(shown.where.find("goes from lambda"), std::string::npos) << shown.where;
        }
    }
}

// One value of a distance map increased by one code, at any position.
TEST(Certificate, DamagedDistancesAreFound) {
    Random random(77);
    int tried = 0;
    for (const char* recipe : {"columns", "hills"}) {
        const HeightField field(share(makeRelief(recipe, 32, 32, 9)), Surface::Bilinear, Address::Repeat, 0.25);
        for (const char* name : {"distance-conservative", "distance-refined"}) {
            for (const char* precision : {"float", "u16", "u8"}) {
                MapCache building;
                Work work;
                const MethodChoice choice{name, {{"precision", precision}, {"layers", "8"}, {"footprint", "2"}}};
                const std::string kind = findTracer(name).maps.front();
                const StoredMap stored = buildMap(kind, choice.options, field, building, work);
                const DistanceMap& whole = *std::get<0>(stored);
                for (int n = 0; n < 5; ++n) {
                    const int i = random.below(whole.nx());
                    const int j = random.below(whole.ny());
                    const int k = random.below(whole.layers());
                    if (!(whole.at(i, j, k, 0) > 0)) continue;
                    auto damaged = std::make_shared<DistanceMap>(whole);
                    damaged->values = altered(whole.values, placeOf(whole.values, i, j, k), 1);
                    MapCache cache;
                    (void)useMap("damaged", std::shared_ptr<const DistanceMap>(damaged), choice, field, cache);
                    const Certificate certificate = certified(choice, field, kValuesOnly, cache);
                    EXPECT_FALSE(certificate.safe()) << describe(choice);
                    ASSERT_TRUE(certificate.bounds);
                    ASSERT_EQ(certificate.bounds->broken, 1U) << failure(certificate, field);
                    const BrokenBound& broken = certificate.bounds->first.front();
                    EXPECT_EQ(broken.what, BrokenBound::What::Distance);
                    EXPECT_EQ(std::tuple(broken.i, broken.j, broken.k), std::tuple(i, j, k));
                    EXPECT_GE(broken.bound, static_cast<double>(whole.at(i, j, k, 0)));
                    ++tried;
                }
            }
        }
    }
    EXPECT_GT(tried, 20);
}

// Apexes lowered by one code, slopes by slightly more than a rounding. Slopes are altered only where a cell determines
// them, not the limit for distant ground, and below exact apexes, since an apex rounded up would leave room.
TEST(Certificate, DamagedConesAreFound) {
    Random random(78);
    const HeightField field(share(makeRelief("columns", 32, 32, 9)));
    int slopes = 0;
    for (const std::string precision : {"float", "u16", "u8"}) {
        MapCache building;
        Work work;
        const MethodChoice choice{"cone", {{"precision", precision}}};
        const StoredMap stored = buildMap("cone", choice.options, field, building, work);
        ConeMap whole = *std::get<1>(stored);
        if (precision == "float") {
            // Built without slack, so that a slope one step smaller is unsafe.
            UnfilledVector<float> apex;
            UnfilledVector<float> exact(static_cast<std::size_t>(whole.nx()) * static_cast<std::size_t>(whole.ny()));
            conservativeCones(field, 1, 0, apex, exact, work);
            whole.slopes = StoredValues(whole.nx(), whole.ny(), 1, std::move(exact), Precision::Float, Rounding::Up);
        }
        for (int n = 0; n < 40; ++n) {
            const int i = random.below(whole.nx());
            const int j = random.below(whole.ny());
            const bool apex = precision != "float" || n % 4 == 0;
            const double guard = (1 - static_cast<double>(whole.apex(i, j, 0))) / (0.5 * whole.nx());
            if (!apex && static_cast<double>(whole.slopes(i, j, 0)) * (1 - 2e-5) <= guard) continue;
            auto damaged = std::make_shared<ConeMap>(whole);
            StoredValues& values = apex ? damaged->apex : damaged->slopes;
            values = altered(values, placeOf(values, i, j, 0), -1);
            MapCache cache;
            (void)useMap("damaged", std::shared_ptr<const ConeMap>(damaged), choice, field, cache);
            const Certificate certificate = certified(choice, field, kValuesOnly, cache);
            ASSERT_TRUE(certificate.bounds);
            ASSERT_EQ(certificate.bounds->broken, 1U) << failure(certificate, field);
            const BrokenBound& broken = certificate.bounds->first.front();
            EXPECT_EQ(broken.what, apex ? BrokenBound::What::Apex : BrokenBound::What::Slope);
            EXPECT_EQ(std::pair(broken.i, broken.j), std::pair(i, j));
            slopes += apex ? 0 : 1;
        }
    }
    EXPECT_GT(slopes, 10);
}

// Every value of every layer, including the lowest, is set to a distance that no bound permits; voxels that contain the
// surface are thereby declared free.
TEST(Certificate, EveryValueMadeFreeOrTooLargeIsFound) {
    Work work;
    for (const Heights& heights : {constantHeights(8, 8, 0), constantHeights(8, 8, 1), randomHeights(8, 8, 5)}) {
        const HeightField field(heights, Surface::Bilinear, Address::Repeat, 0.25);
        DistanceParameters parameters;
        parameters.layers = 4;
        const DistanceMap whole = buildDistanceMap(DistanceKind::EuclideanConservative, parameters, field, work);
        ASSERT_EQ(checkDistanceBounds(whole, field, work).broken, 0U);
        for (int layer = 0; layer < parameters.layers; ++layer) {
            DistanceMap damaged = whole;
            auto codes = whole.values.codes();
            auto& all = std::get<0>(codes);
            const std::size_t each = static_cast<std::size_t>(whole.nx() * whole.ny());
            std::size_t marks = 0;
            for (std::size_t n = layer * each; n < (layer + 1) * each; ++n) {
                marks += all[n] < 0 ? 1 : 0;
                all[n] = 1e3F;
            }
            EXPECT_TRUE(layer > 0 || marks == each) << "the floor is never free";
            damaged.values = StoredValues(whole.nx(), whole.ny(), whole.values.layers(), codes, 0);
            const BoundCheck check = checkDistanceBounds(damaged, field, work);
            EXPECT_EQ(check.broken, each) << layer;
            const auto free = std::count_if(check.first.begin(), check.first.end(), [](const BrokenBound& broken) {
                return broken.what == BrokenBound::What::Free;
            });
            EXPECT_EQ(static_cast<std::size_t>(free), marks) << layer;
        }
        ConeMap cones = buildConeMap(ConeKind::Conservative, {}, field, work);
        ASSERT_EQ(checkConeBounds(cones, field, work).broken, 0U);
        // on level ground any cone is safe
        if (field.heights().pixels().front() == field.heights().pixels().back()) continue;
        const std::size_t cells = static_cast<std::size_t>(cones.nx() * cones.ny());
        cones.slopes =
            StoredValues(cones.nx(), cones.ny(), 1, UnfilledVector<float>(cells, 0.0F), Precision::Float, Rounding::Up);
        cones.apex =
            StoredValues(cones.nx(), cones.ny(), 1, UnfilledVector<float>(cells, 0.0F), Precision::Float, Rounding::Up);
        EXPECT_EQ(checkConeBounds(cones, field, work).broken, cells);
    }
}

// The counts of a certificate against counts from the same rays: late hits, and rays that miss altogether, which is
// possible only under border.
TEST(Certificate, CountsWhatGoesPastTheFirstHit) {
    constexpr std::uint64_t kRays = 20'000;
    std::uint64_t missed = 0, late = 0;
    for (const Address address : allAddresses()) {
        for (const MethodChoice& choice : {MethodChoice{"layers", {{"layers", "64"}}}, MethodChoice{"cone-dummer", {}},
                                           MethodChoice{"layers", {{"layers", "1"}}}}) {
            const HeightField field(share(makeRelief("spikes", 16, 16, 3)), Surface::Bilinear, address, 0.2);
            MapCache cache;
            const Certificate certificate = certified(choice, field, {.rays = kRays, .seed = 5}, cache);
            SCOPED_TRACE(failure(certificate, field) + describe(choice));
            ASSERT_EQ(certificate.rays, kRays);
            const RayBlock rays = CertificateRays(field, certificate.longest).block(seedFor(5, 0), kRays);
            Work work;
            HitBlock truth, found;
            NullSink sink;
            makeTracer({"exact", {}}, field, cache, work)->trace(rays, truth, sink, work);
            makeTracer(choice, field, cache, work)->trace(rays, found, sink, work);
            std::uint64_t past = 0, missedHere = 0;
            double worst = 0;
            for (std::size_t r = 0; r < kRays; ++r) {
                if (truth.outcome[r] != Outcome::Hit || found.outcome[r] == Outcome::Limit) continue;
                const bool hit = found.outcome[r] == Outcome::Hit;
                const double texels =
                    hit ? (found.lambda[r] - truth.lambda[r]) * std::hypot(rays.a[r], rays.b[r], field.slabTexels())
                        : std::numeric_limits<double>::infinity();
                if (!(texels > kCoarseTexels)) continue;
                ++(hit ? late : missedHere);
                ++past;
                worst = std::max(worst, texels);
            }
            missed += missedHere;
            EXPECT_TRUE(address == Address::Border || missedHere == 0);
            EXPECT_EQ(certificate.overshoots, past);
            EXPECT_EQ(certificate.worst, worst);
            EXPECT_EQ(certificate.safe(), past == 0);
            EXPECT_EQ(certificate.first.has_value(), past > 0);
        }
    }
    EXPECT_GT(missed, 10U);
    EXPECT_GT(late, 10U);
}

// For a map with a large error a ray through the wrong value shows it, without any random rays.
TEST(Certificate, ARayShowsALargeDamage) {
    const HeightField field(share(makeRelief("columns", 32, 32, 9)), Surface::Columns, Address::Repeat, 0.25);
    MapCache building;
    Work work;
    for (const char* name : {"distance-conservative", "distance-refined"}) {
        const MethodChoice choice{name, {{"layers", "8"}, {"footprint", "2"}}};
        const StoredMap stored = buildMap(findTracer(name).maps.front(), choice.options, field, building, work);
        auto damaged = std::make_shared<DistanceMap>(*std::get<0>(stored));
        auto codes = damaged->values.codes();
        for (float& value : std::get<0>(codes)) value = value > 0 ? value * 3 : value;
        damaged->values = StoredValues(damaged->nx(), damaged->ny(), damaged->values.layers(), codes, 0);
        MapCache cache;
        (void)useMap("damaged", std::shared_ptr<const DistanceMap>(damaged), choice, field, cache);
        const Certificate certificate = certified(choice, field, kValuesOnly, cache);
        ASSERT_TRUE(certificate.first) << failure(certificate, field);
        const auto tracer = makeTracer(choice, field, cache, work);
        const Hit found = traceLogged(*tracer, certificate.first->ray).hit;
        EXPECT_TRUE(found.outcome != Outcome::Hit || found.lambda > certificate.first->surface);
    }
}

// A tracer that walks another map than its own, chosen by an option or by a map file, is certified with that map.
TEST(Certificate, TheMapThatTheTracerWalksIsChecked) {
    const HeightField field(share(makeRelief("columns", 32, 32, 9)), Surface::Bilinear, Address::Repeat, 0.25);
    MapCache building;
    Work work;
    const StoredMap stored = buildMap("refined", {{"layers", "8"}, {"footprint", "2"}}, field, building, work);
    auto damaged = std::make_shared<DistanceMap>(*std::get<0>(stored));
    const auto codes = damaged->values.codes();
    const auto& distances = std::get<0>(codes);
    const auto first = std::find_if(distances.begin(), distances.end(), [](float value) { return value > 0; });
    damaged->values = altered(damaged->values, static_cast<std::size_t>(first - distances.begin()), 10'000);
    for (const char* name : {"distance-conservative", "hybrid"}) {
        MapCache cache;
        const MethodChoice choice =
            useMap("damaged", std::shared_ptr<const DistanceMap>(damaged), {name, {}}, field, cache);
        const Certificate certificate = certified(choice, field, kValuesOnly, cache);
        EXPECT_EQ(certificate.map, "refined") << describe(choice);
        ASSERT_TRUE(certificate.bounds) << describe(choice);
        EXPECT_EQ(certificate.bounds->broken, 1U) << failure(certificate, field);
    }
    // With options that only the refined map has, or only the map that it replaces.
    MapCache cache;
    const Certificate sectors = certified(
        {"distance-conservative", {{"map", "refined"}, {"sectors", "4"}, {"layers", "8"}}}, field, kFewRays, cache);
    EXPECT_EQ(sectors.map, "refined");
    EXPECT_TRUE(sectors.proven()) << failure(sectors, field);
    EXPECT_EQ(certified({"distance", {{"map", "refined-sampled"}, {"directions", "4"}}}, field, kValuesOnly, cache).map,
              "refined-sampled");
}

TEST(Certificate, MarksTakenAwayAndNoNumbersAreFound) {
    const HeightField field(share(makeRelief("bricks", 16, 16, 2)));
    MapCache building;
    Work work;
    const MethodChoice choice{"distance-conservative", {{"layers", "4"}}};
    const StoredMap stored = buildMap("euclidean-conservative", choice.options, field, building, work);
    const DistanceMap& whole = *std::get<0>(stored);
    const auto with = [&](std::size_t at, float value) {
        auto damaged = std::make_shared<DistanceMap>(whole);
        auto codes = whole.values.codes();
        std::get<0>(codes)[at] = value;
        damaged->values = StoredValues(whole.nx(), whole.ny(), whole.values.layers(), codes, 0);
        const BoundCheck check = checkDistanceBounds(*damaged, field, work);
        EXPECT_EQ(check.broken, 1U);
        return check.broken == 1 ? check.first.front().what : BrokenBound::What::Apex;
    };
    EXPECT_EQ(with(placeOf(whole.values, 5, 6, 0), 0), BrokenBound::What::Free);
    EXPECT_EQ(with(placeOf(whole.values, 5, 6, 3), std::numeric_limits<float>::quiet_NaN()),
              BrokenBound::What::NotANumber);
}

// The bound itself against a loop over all cells and their copies: values that are far too large make the check report
// it.
TEST(Certificate, BoundsAreThoseOfALoopOverAllCells) {
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            const HeightField field(randomHeights(7, 5, 3), surface, address, 0.6);
            const BruteCells cells(field);
            Work work;
            DistanceParameters parameters;
            parameters.layers = 6;
            parameters.footprint = 2;
            DistanceMap map = buildDistanceMap(DistanceKind::EuclideanConservative, parameters, field, work);
            auto codes = map.values.codes();
            for (float& value : std::get<0>(codes)) value = value >= 0 ? 1e6F : value;
            map.values = StoredValues(map.nx(), map.ny(), map.values.layers(), codes, 0);
            const BoundCheck check = checkDistanceBounds(map, field, work);
            ASSERT_GT(check.broken, 0U) << describe(field);
            for (const BrokenBound& broken : check.first) {
                const int x0 = broken.i * 2;
                const int y0 = broken.j * 2;
                const int x1 = std::min(x0 + 2, cells.nx);
                const int y1 = std::min(y0 + 2, cells.ny);
                double best = std::numeric_limits<double>::infinity();
                cells.each([&](int i, int j, double highest) {
                    const double dx = std::max({0, i - x1, x0 - i - 1});
                    const double dy = std::max({0, j - y1, y0 - j - 1});
                    const double drop = std::max(broken.k / 6.0 - highest, 0.0) * field.slabTexels();
                    best = std::min(best, std::sqrt(dx * dx + dy * dy + drop * drop));
                });
                EXPECT_NEAR(broken.bound, best, 1e-12) << describe(field);
            }
        }
    }
}

TEST(Certificate, SameForAnyThreadsAndOfTheInnerMapToo) {
    const HeightField field(share(makeRelief("pits", 48, 40, 4)));
    const auto textWith = [&](int threads, std::uint64_t seed) {
        Work work(threads);
        MapCache cache;
        return certificateText(certify({"cone-dummer", {}}, field, {.rays = 70'000, .seed = seed}, cache, work), field);
    };
    EXPECT_EQ(textWith(1, 5), textWith(0, 5));
    EXPECT_NE(textWith(1, 5), textWith(1, 6));
    MapCache cache;
    const Certificate hybrid = certified({"hybrid", {{"inner", "cone"}}}, field, kFewRays, cache);
    EXPECT_EQ(hybrid.map, "cone");
    EXPECT_TRUE(hybrid.proven());
    const Certificate exact = certified({"exact", {}}, field, kFewRays, cache);
    EXPECT_TRUE(exact.safe());
    EXPECT_FALSE(exact.proven()) << "rays alone prove nothing";
}

TEST(Certificate, CanBeCancelled) {
    const HeightField field(share(makeRelief("hills", 64, 64, 4)));
    std::stop_source stop;
    int stages = 0;
    Work work(0, stop.get_token(), [&](std::string_view what, double) {
        if (what != "checking voxels") return;
        ++stages;
        stop.request_stop();
    });
    MapCache cache;
    EXPECT_THROW((void)certify({"distance-conservative", {}}, field, kFewRays, cache, work), Cancelled);
    EXPECT_GT(stages, 0);
}

}  // namespace relief::test
