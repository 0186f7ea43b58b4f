// Advice for a height map: the methods that it considers, its bounds, and its text. Times are not tested; the scalar
// form depends on counts alone, so its regret is tested.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "measuring/advise/recommend_trials.h"
#include "relief/reliefs.h"
#include "relief/tracers/map_choice.h"

namespace relief {
namespace {

// Enough time for every map at these sizes, even on a busy machine.
constexpr double kAmpleSeconds = 3600;
constexpr int kSide = 64;

AdviceOptions optionsFor(const std::string& relief, Form form = Form::Scalar, int side = kSide) {
    AdviceOptions options(HeightField(std::make_shared<FloatImage>(makeRelief(relief, side, side, 1))));
    options.name = relief;
    options.form = form;
    options.seconds = kAmpleSeconds;
    options.filters = false;
    return options;
}

std::vector<MethodChoice> choices(const std::vector<std::string>& texts) {
    std::vector<MethodChoice> all;
    for (const std::string& text : texts) all.push_back(parseMethodChoice(text, "--tracers"));
    return all;
}

// Returns the share of rays that violate the error bound, measured independently on other rays.
double shareBeyond(const AdviceOptions& options, const MethodChoice& method) {
    Work work;
    MapCache maps;
    const auto exact = makeTracer({"exact", {}}, options.field, maps, work);
    const auto tracer = makeTracer(method, options.field, maps, work);
    std::size_t beyond = 0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < options.views.size(); ++v) {
        const RayBlock rays = benchRays(options.field, options.views[v], 20000, 1000 + v);
        HitBlock truth;
        HitBlock hits;
        NullSink null;
        exact->trace(rays, truth, null, work);
        tracer->trace(rays, hits, null, work);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const double error =
                std::abs(hits.lambda[i] - truth.lambda[i]) * std::max(1.0, std::hypot(rays.a[i], rays.b[i]));
            const bool hit = truth.outcome[i] == Outcome::Hit;
            if (hits.outcome[i] != truth.outcome[i] || (hit && error > options.error)) ++beyond;
        }
        count += rays.size();
    }
    return static_cast<double>(beyond) / static_cast<double>(count);
}

TEST(Recommend, TriesEveryTracerOfTheListInMoreFormsThanOne) {
    const AdviceOptions options = optionsFor("bricks");
    const std::vector<MethodChoice> forms = adviceForms(options.field, 10);
    for (const MeasuredMethod& method : defaultMethods()) {
        EXPECT_NE(std::find(forms.begin(), forms.end(), method.choice), forms.end()) << method.choice.name;
    }
    for (const std::string text : {"max-pyramid:base=2", "layers:layers=256", "cone:sectors=8", "hybrid:inner=cone",
                                   "distance-refined:rule=classic:sectors=8"}) {
        EXPECT_NE(std::find(forms.begin(), forms.end(), choices({text})[0]), forms.end()) << text;
    }
    for (const MethodChoice& form : forms) {
        EXPECT_NO_THROW(checkMethod(form, "")) << methodText(form);
        EXPECT_EQ(std::count(forms.begin(), forms.end(), form), 1) << methodText(form);
        // Options that are in vain without the refined map.
        EXPECT_FALSE(form.name == "distance-conservative" && form.options.contains("sectors")) << methodText(form);
    }
    // A shader has no other maps than those that can be stored.
    const std::vector<MethodChoice> scalar = adviceForms(options.field, 10, 0, Form::Scalar);
    for (const std::string text : {"cone:layout=texel", "cone:layout=texel:sectors=8"}) {
        EXPECT_EQ(std::count(scalar.begin(), scalar.end(), choices({text})[0]), 1) << text;
    }
    for (const MethodChoice& form : scalar) {
        EXPECT_EQ(form, withStoredMap(form)) << methodText(form);
    }
    // With views flatter than the map's flattest ray, a map for those views is considered.
    const std::vector<MethodChoice> flat = adviceForms(options.field, 4);
    EXPECT_NE(std::find(flat.begin(), flat.end(), choices({"distance-refined:flattest=4"})[0]), flat.end());
}

TEST(Recommend, ScalarRegretIsSmallOnEveryProceduralRelief) {
    // Against the full table on other rays, measured 0 on each relief. Steps are counted, so that there is no noise;
    // two forms whose counts differ by less on the rays of the trial may change places on others.
    constexpr double kMost = 0.01;
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        AdviceOptions options =
            optionsFor(std::string(recipe.name), Form::Scalar, recipe.anySize ? kSide : recipe.defaultSize);
        options.views = parseViews("random", "--views");
        // Unsafe maps are rejected by their errors in every case; here they would only take time.
        options.forms = adviceForms(options.field, 10);
        std::erase_if(options.forms, [](const MethodChoice& form) {
            return form.name == "relaxed-cone" || form.name == "distance-refined-sampled" || form.name == "distance" ||
                   form.name == "cone-dummer";
        });
        Work work;
        const AdviceRegret result = adviceRegret(options, work);
        EXPECT_TRUE(result.keepsBound) << recipe.name << ": " << methodText(result.chosen);
        EXPECT_EQ(result.measured, options.forms.size()) << recipe.name;
        EXPECT_GE(result.regret(), 0) << recipe.name;
        EXPECT_LE(result.regret(), kMost)
            << recipe.name << ": " << methodText(result.chosen) << ", best " << methodText(result.best);
    }
}

// The full table, too, contains only forms within the step budget; without any such form there is no regret.
TEST(Recommend, IsCheckedWithinTheBudgetOfSteps) {
    AdviceOptions options = optionsFor("bricks", Form::Scalar, kSide);
    options.forms = choices({"exact", "cone", "layers:layers=16"});
    options.error = 1e5;
    Work work;
    const AdviceRegret free = adviceRegret(options, work);
    options.maxSteps = 20;
    const AdviceRegret bounded = adviceRegret(options, work);
    EXPECT_NE(free.best.name, "layers");
    EXPECT_EQ(bounded.best.name, "layers");
    EXPECT_EQ(bounded.regret(), 0);
    options.maxSteps = 2;
    const AdviceRegret none = adviceRegret(options, work);
    EXPECT_FALSE(none.anyIsValid());
    EXPECT_TRUE(none.keepsBound) << "the advice itself reports this";
}

TEST(Recommend, KeepsTheErrorBoundAndFindsWhatItAllows) {
    AdviceOptions options = optionsFor("hills");
    options.views = parseViews("40,80", "--views");
    options.forms = choices({"exact", "offset", "layers:layers=16", "layers-secant:layers=128", "max-pyramid"});
    Work work;
    const Advice strict = recommend(options, work);
    EXPECT_LE(shareBeyond(options, strict.best().method), options.outliers) << methodText(strict.best().method);
    for (const AdvisedForm& form : strict.forms) {
        if (form.method.name == "offset") {
            EXPECT_EQ(form.verdict, Verdict::Error);
            EXPECT_GT(form.beyond, options.outliers);
        }
    }
    // With such a large error bound the cheapest method is best.
    options.error = 1e5;
    options.outliers = 1;
    const Advice loose = recommend(options, work);
    EXPECT_EQ(loose.best().method.name, "offset");
    EXPECT_LT(loose.best().cost, strict.best().cost);
}

TEST(Recommend, CostsAreTheStatedOnesAndDependOnTheSeedAlone) {
    AdviceOptions options = optionsFor("city");
    options.forms = choices({"exact", "max-pyramid", "cone", "distance-refined"});
    options.stepCost = 5;
    Work one(1);
    Work all;
    const Advice a = recommend(options, one);
    const Advice b = recommend(options, all);
    ASSERT_EQ(a.forms.size(), b.forms.size());
    for (std::size_t f = 0; f < a.forms.size(); ++f) {
        EXPECT_EQ(a.forms[f].method, b.forms[f].method);
        EXPECT_EQ(a.forms[f].cost, b.forms[f].cost);
        EXPECT_DOUBLE_EQ(a.forms[f].cost, a.forms[f].reads + 5 * a.forms[f].steps);
    }
    EXPECT_EQ(a.best().method, b.best().method);
    options.seed = 2;
    EXPECT_NE(recommend(options, all).best().cost, a.best().cost);
}

// A map that an earlier form built has its building time, too, inside another method. Another layout and another base
// level are other maps.
TEST(Recommend, BuildTimesAreThoseOfTheMap) {
    AdviceOptions options = optionsFor("city");
    Work work;
    AdviceMaps maps(options, work);
    const auto built = [&](const std::string& text) {
        AdviceTrial trial;
        trial.facts.method = choices({text})[0];
        maps.make(trial, kAmpleSeconds);
        EXPECT_TRUE(trial.tracer) << text;
        return trial.facts.buildSeconds;
    };
    const double cone = built("cone");
    const double distance = built("distance-conservative");
    built("max-pyramid");  // puts the map into the cache for the check below
    EXPECT_GE(built("hybrid:inner=cone"), cone);
    EXPECT_GE(built("distance-conservative:rule=classic"), distance);
    EXPECT_GE(built("hybrid"), distance);
    EXPECT_GE(built("hybrid:level=2"), distance);
    // With no time left, forms whose map exists are still measured, and no other map is built.
    for (const auto& [text, verdict] :
         {std::pair("cone", Verdict::Kept), std::pair("cone:layout=texel", Verdict::BuildTime),
          std::pair("max-pyramid", Verdict::Kept), std::pair("max-pyramid:base=1", Verdict::BuildTime)}) {
        AdviceTrial late;
        late.facts.method = choices({text})[0];
        maps.make(late, 0);
        EXPECT_EQ(late.facts.verdict, verdict) << text;
        EXPECT_EQ(late.tracer != nullptr, verdict == Verdict::Kept) << text;
    }
}

TEST(Recommend, MapsNotBuiltAreNamed) {
    AdviceOptions options = optionsFor("city");
    options.forms = choices({"exact", "max-pyramid", "cone", "distance-refined:sectors=4"});
    Work work;
    Advice advice = recommend(options, work);
    for (AdvisedForm& form : advice.forms) {
        if (!form.method.options.empty() || form.method.name == "cone") form.verdict = Verdict::BuildTime;
    }
    const std::string text = adviceText(options, advice);
    for (const char* const order : {"2 (cone, distance-refined:sectors=4)", "2 (distance-refined:sectors=4, cone)"}) {
        if (text.find(order) != std::string::npos) return;
    }
    ADD_FAILURE() << text;
}

TEST(Recommend, KeepsTheMemory) {
    AdviceOptions options = optionsFor("fractal", Form::Scalar, 256);
    options.forms = choices({"exact", "cone:precision=u8", "distance-conservative", "cone"});
    Work work;
    for (const std::int64_t memory : {std::int64_t{0}, std::int64_t{140000}, std::int64_t{64} << 20}) {
        options.memory = memory;
        const Advice advice = recommend(options, work);
        EXPECT_LE(advice.best().bytes, memory);
        if (memory == 0) {
            EXPECT_EQ(advice.best().method.name, "exact");
        }
        if (memory == 140000) {
            EXPECT_EQ(methodText(advice.best().method), "cone:precision=u8");
        }
        for (const AdvisedForm& form : advice.forms) {
            EXPECT_EQ(form.verdict == Verdict::Memory, form.bytes > memory) << methodText(form.method);
        }
    }
}

TEST(Recommend, LanesAreTimedInRoundsAndTheSlowerDropped) {
    AdviceOptions options = optionsFor("hills", Form::Simd);
    options.forms = choices({"exact", "max-pyramid", "layers:layers=8192", "cone"});
    Work work;
    const Advice advice = recommend(options, work);
    EXPECT_EQ(advice.best().verdict, Verdict::Kept);
    EXPECT_GT(advice.best().secondsPerRay, 0);
    EXPECT_EQ(advice.best().cost, advice.best().secondsPerRay);
    for (const AdvisedForm& form : advice.forms) {
        // Thousands of look-ups per ray: slower under any load, so it is rejected after the first trial.
        if (form.method.name == "layers") {
            EXPECT_EQ(form.rounds, 0);
            EXPECT_NE(form.verdict, Verdict::Kept);
        }
    }
}

TEST(Recommend, FormsThatStayAreTimedThriceEvenWithoutTime) {
    AdviceOptions options = optionsFor("hills", Form::Simd, 16);
    options.views = parseViews("60", "--views");
    options.seconds = 1e-9;
    // The same form several times: all stay.
    options.forms = choices({"exact", "exact", "exact", "exact"});
    Work work;
    EXPECT_EQ(recommend(options, work).best().rounds, 3);
}

TEST(Recommend, FlatMapsAreNamedAndNeedNoMap) {
    for (const Form form : {Form::Simd, Form::Scalar}) {
        AdviceOptions options(HeightField(std::make_shared<FloatImage>(32, 32, 0.25F)));
        options.form = form;
        options.seconds = kAmpleSeconds;
        options.filters = false;
        options.forms = choices({"cone", "exact", "max-pyramid", "layers"});
        Work work;
        const Advice advice = recommend(options, work);
        EXPECT_TRUE(advice.relief.flat);
        EXPECT_EQ(advice.best().bytes, 0) << methodText(advice.best().method);
        EXPECT_NE(adviceText(options, advice).find("This map is flat: every height is 0.25."), std::string::npos);
        for (const Message& note : adviceNotes(options, advice)) {
            EXPECT_EQ(sentence(note).find("inf"), std::string::npos) << sentence(note);
        }
    }
    EXPECT_FALSE(reliefFigures(optionsFor("hills").field).flat);
}

TEST(Recommend, KeepsTheStepBudget) {
    AdviceOptions options = optionsFor("hills");
    options.maxSteps = 20;
    options.outliers = 0.01;
    options.error = 4;
    options.forms = choices({"exact", "max-pyramid", "layers:layers=8", "layers-secant:layers=14", "layers:layers=64"});
    Work work;
    const Advice advice = recommend(options, work);
    EXPECT_LE(advice.best().mostSteps, 20) << methodText(advice.best().method);
    EXPECT_EQ(advice.best().verdict, advice.keepsBounds ? Verdict::Kept : advice.best().verdict);
    for (const AdvisedForm& form : advice.forms) {
        if (form.method.name == "exact") {
            EXPECT_EQ(form.verdict, Verdict::Steps);
        }
    }
    EXPECT_NE(adviceText(options, advice).find("At most 20 steps per ray"), std::string::npos);
    // The largest numbers of layers within the budget are among the forms.
    const auto forms = adviceForms(options.field, 10, 32);
    EXPECT_NE(std::find(forms.begin(), forms.end(), choices({"layers-secant:layers=28"})[0]), forms.end());
    // If no method satisfies all bounds, the nearest one is named, and the text says so.
    options.maxSteps = 2;
    options.error = 0;
    options.outliers = 0;
    const Advice none = recommend(options, work);
    EXPECT_FALSE(none.keepsBounds);
    EXPECT_NE(adviceText(options, none).find("No method stays within all bounds"), std::string::npos);
}

// Slow forms are counted on a part of the rays, but those that the advice names on all.
TEST(Recommend, NamesNoSlowFormThatBreaksTheStepLimit) {
    AdviceOptions options = optionsFor("hills");
    options.views = parseViews("10", "--views");
    options.forms = choices({"cone-dummer:iterations=2", "exact"});
    options.error = 1e5;
    Work work;
    MapCache maps;
    AdviceTrial exact;
    exact.tracer = makeTracer({"exact", {}}, options.field, maps, work, options.form);
    // The rays that are counted first need fewer steps than others do.
    std::int64_t first = 0, most = 0;
    while (first == most && options.seed < 20) {
        ++options.seed;
        const AdviceRays rays(options, options.seed, work);
        rays.count(exact, 1, work);
        first = exact.facts.mostSteps;
        rays.count(exact, AdviceRays::kBlocks, work);
        most = exact.facts.mostSteps;
    }
    ASSERT_LT(first, most);
    options.outliers = 0;
    for (const auto& [limit, verdict] : {std::pair(first, Verdict::Steps), std::pair(most, Verdict::Slow)}) {
        options.maxSteps = limit;
        const Advice advice = recommend(options, work);
        EXPECT_EQ(advice.best().method.name, "cone-dummer");
        EXPECT_EQ(advice.forms[advice.exact].verdict, verdict);
        EXPECT_EQ(advice.forms[advice.exact].mostSteps, most);
        EXPECT_EQ(advice.withoutMap.has_value(), verdict == Verdict::Slow);
        EXPECT_EQ(advice.next != advice.chosen, verdict == Verdict::Slow);
    }
}

// Methods that violate a bound are listed with their errors, and no factor is printed as thousands of percent.
TEST(Recommend, ApproximateMethodsAreListedWithTheirErrors) {
    AdviceOptions options = optionsFor("columns");
    options.forms = choices({"exact", "max-pyramid", "cone", "offset", "layers", "relaxed-cone"});
    Work work;
    const Advice advice = recommend(options, work);
    const std::string text = adviceText(options, advice);
    const std::size_t past = text.find("Methods that exceed a bound");
    ASSERT_NE(past, std::string::npos) << text;
    EXPECT_NE(text.find("offset", past), std::string::npos) << text;
    EXPECT_NE(text.find("approximate", past), std::string::npos) << text;
    EXPECT_EQ(text.find("inf"), std::string::npos) << text;
}

// A bound violated on one relief makes the check fail, whatever the results of the others.
TEST(Recommend, ChecksKeepBoundsOnEveryRelief) {
    AdviceRegret kept;
    kept.chosen = kept.best = {"exact", {}};
    kept.chosenCost = kept.bestCost = 2;
    AdviceRegret broken = kept;
    broken.keepsBound = false;
    broken.chosenCost = 3;
    broken.chosenBeyond = 0.25;
    const auto keep = [](const std::vector<CheckedRelief>& reliefs) { return keepsBounds(reliefs); };
    EXPECT_TRUE(keep({{"a", kept}, {"b", kept}}));
    EXPECT_FALSE(keep({{"a", broken}, {"b", kept}}));
    EXPECT_FALSE(keep({{"a", kept}, {"b", broken}, {"c", kept}}));
    const std::vector<CheckedRelief> reliefs{{"a", broken}, {"b", kept}};
    const std::string text = regretText(reliefs);
    for (const char* const part : {" 50.0 ", " 25.0! ", "regret: median 25.0%, worst 50.0%"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    }
}

TEST(Recommend, FiguresOfTheRelief) {
    FloatImage ramp(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) ramp(x, y) = static_cast<float>(x) / 64;
    }
    // 12.8 texels deep, so a slope of 0.2 per texel along x and none along y.
    const ReliefFigures slope =
        reliefFigures(HeightField(std::make_shared<FloatImage>(ramp), Surface::Bilinear, Address::Repeat, 0.2));
    EXPECT_NEAR(slope.roughness, 0.1, 1e-6);
    EXPECT_EQ(slope.steep, 0);
    EXPECT_EQ(slope.flatTiles, 0);
    const ReliefFigures steep =
        reliefFigures(HeightField(std::make_shared<FloatImage>(ramp), Surface::Bilinear, Address::Repeat, 2));
    EXPECT_DOUBLE_EQ(steep.steep, 0.5);
    FloatImage half(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) half(x, y) = y < 32 ? 0.5F : ramp(x, y);
    }
    EXPECT_DOUBLE_EQ(
        reliefFigures(HeightField(std::make_shared<FloatImage>(half), Surface::Bilinear, Address::Repeat, 0.2))
            .flatTiles,
        0.5);
}

TEST(Recommend, FilterOfLeastErrorAndTheFootprintsShape) {
    AdviceOptions options = optionsFor("hills");
    options.views = parseViews("30", "--views");
    Work work;
    const FilterAdvice advice = recommendFilter(options, 1, work).value();
    // Every filter of the list except the reference itself; rates are relative to that of trilinear.
    for (const FilterDescription& filter : filterList()) {
        const bool tried = std::any_of(advice.filters.begin(), advice.filters.end(), [&](const FilterFigures& figures) {
            return figures.filter.name == filter.name;
        });
        EXPECT_EQ(tried, filter.name != kSupersample) << filter.name;
    }
    for (const FilterFigures& figures : advice.filters) {
        EXPECT_GE(figures.rmse, advice.filters[advice.still].rmse) << figures.filter.name;
        EXPECT_GT(figures.texels, 0) << figures.filter.name;
    }
    EXPECT_NE(advice.filters[advice.still].filter.name, "nearest");
    EXPECT_NEAR(advice.anisotropy, 2, 1e-9);
    EXPECT_EQ(advice.elevation, 30);
}

// Seen from 10 degrees, a narrow map and a small one are strips of a few pixels, so they are seen from nearer.
TEST(Recommend, FiltersAreComparedWherePixelsCanBe) {
    AdviceOptions options(HeightField(std::make_shared<FloatImage>(makeRelief("hills", 512, 64, 1))));
    Work work;
    for (const char* views : {"10,80", "10"}) {
        options.views = parseViews(views, "--views");
        const FilterAdvice advice = recommendFilter(options, 1, work).value();
        EXPECT_EQ(advice.elevation, 10);
        for (const FilterFigures& figures : advice.filters) {
            EXPECT_GT(figures.rmse, 0) << figures.filter.name;
            EXPECT_GT(figures.texels, 0) << figures.filter.name;
            EXPECT_GT(figures.rate, 0) << figures.filter.name;
        }
        options.field = optionsFor("hills").field;
    }
    // A single row of texels has no pixel to compare in any view.
    options.field = HeightField(std::make_shared<FloatImage>(1024, 1, 0.5F));
    EXPECT_FALSE(recommendFilter(options, 1, work));
    AdviceTrial exact;
    exact.facts.method = {"exact", {}};
    const std::vector<Message> notes = adviceNotes(options, adviceOf(options, {exact}));
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes.front().id, MessageId::AdviceNoFilter);
}

TEST(Recommend, NamesTheMapsOfTheMethodAndOfTheOneInsideIt) {
    const AdviceOptions options = optionsFor("bricks");
    for (const auto& [text, maps] : {std::pair<std::string, std::string>("max-pyramid", "max-pyramid"),
                                     {"hybrid", "max-pyramid, euclidean-conservative"},
                                     {"hybrid:inner=cone", "max-pyramid, cone"},
                                     {"hybrid:inner.map=refined", "max-pyramid, refined"},
                                     {"distance-conservative:map=refined", "refined"}}) {
        AdviceTrial trial;
        trial.facts.method = choices({text})[0];
        trial.facts.bytes = 1000;
        const Advice advice = adviceOf(options, {trial});
        EXPECT_EQ(nlohmann::json::parse(adviceJson(options, advice))["map"], maps) << text;
        EXPECT_NE(adviceText(options, advice).find("\nMap: " + maps + ", 1000 "), std::string::npos) << text;
    }
}

TEST(Recommend, SaysWhyInBothLanguagesAndAsJson) {
    AdviceOptions options = optionsFor("bricks");
    options.forms = choices({"exact", "max-pyramid", "cone", "offset"});
    Work work;
    const Advice advice = recommend(options, work);
    const std::string text = adviceText(options, advice);
    const std::string method = methodText(advice.best().method);
    for (const std::string& part : {"Method: " + method, std::string("steps and"), std::string("per ray"),
                                    std::string("mean slope"), std::string("flat"), std::string("KiB"),
                                    std::string("Of 4 candidates (methods with options), 1 exceed the error bound")}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    }
    const std::string ukrainian = adviceText(options, advice, Language::Ukrainian);
    EXPECT_NE(ukrainian.find("Метод: " + method), std::string::npos) << ukrainian;
    for (const std::string& said : {text, ukrainian}) EXPECT_EQ(said.find('{'), std::string::npos) << said;
    const auto json = nlohmann::json::parse(adviceJson(options, advice));
    EXPECT_EQ(json["chosen"]["text"], method);
    EXPECT_EQ(json["forms"].size(), 4U);
    EXPECT_EQ(json["form"], "scalar");
    EXPECT_EQ(json["chosen"]["memory_bytes"], advice.best().bytes);
    EXPECT_EQ(json["relief"]["roughness"], advice.relief.roughness);
}

TEST(Recommend, NamesAFilterForStillPicturesOnlyIfItIsAnother) {
    const AdviceOptions options = optionsFor("bricks");
    AdviceTrial exact;
    exact.facts.method = {"exact", {}};
    Advice advice = adviceOf(options, {exact});
    advice.filter.emplace();
    advice.filter->filters.assign(3, {{}, 0.01, 4, 1e6});
    for (const std::size_t still : {0U, 1U}) {
        advice.filter->still = still;
        const std::string text = adviceText(options, advice);
        EXPECT_NE(text.find("\nFilter: "), std::string::npos) << text;
        EXPECT_EQ(text.find("still pictures") != std::string::npos, still == 1) << text;
    }
}

TEST(Recommend, ViewRanges) {
    EXPECT_EQ(parseViews("25", "--views"), (std::vector<Elevation>{25.0}));
    EXPECT_EQ(parseViews("random", "--views"), (std::vector<Elevation>{std::nullopt}));
    const auto range = parseViews("10,70", "--views");
    EXPECT_EQ(range, (std::vector<Elevation>{10.0, 30.0, 50.0, 70.0}));
    EXPECT_EQ(viewsText(range), "10,70");
    for (const std::string wrong : {"", "70,10", "10,", "0,10", "10,91", "10,20,30", "10,random", "x", "nan,nan"}) {
        EXPECT_THROW(parseViews(wrong, "--views"), InputError) << wrong;
    }
}

}  // namespace
}  // namespace relief
