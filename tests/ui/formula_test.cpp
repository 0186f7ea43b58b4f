// The formula pane: its numbers are those of the library, the printed numbers are consistent, and they fit the sheet.
#include <cmath>
#include <map>

#include "filtering/weight_map.h"
#include "painting/formula_text.h"
#include "panes/footprint/weight_drawing.h"
#include "panes/formula/formula_drawing.h"
#include "printed_formula.h"
#include "relief/ray_length.h"
#include "scenario/row_methods.h"
#include "window_fixture.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

using relief::Language;

relief::Scenario tiny() {
    relief::Scenario scenario = smallScenario();
    scenario.width = 60;
    scenario.height = 45;
    scenario.pixel = relief::PixelChoice{27, 24};
    return scenario;
}

// Makes snapshots without a window.
class Maker {
  public:
    std::shared_ptr<const Snapshot> operator()(const relief::Scenario& scenario) {
        relief::Work work(1);
        SnapshotOrder order;
        order.scenario = scenario;
        return maker_.make(order, work);
    }

  private:
    SnapshotMaker maker_;
};

std::shared_ptr<const Snapshot> tracedBy(const std::string& method) {
    relief::Scenario scenario = tiny();
    scenario.method = {method, {}};
    return Maker()(scenario);
}

// Returns the values of `count` groups from `first` on, by symbol; of equal symbols the first value.
std::map<std::string, double> valuesOf(const std::vector<FormulaGroup>& groups, std::size_t first, std::size_t count) {
    std::map<std::string, double> values;
    for (std::size_t g = first; g < std::min(groups.size(), first + count); ++g) {
        for (const FormulaRow& row : groups[g].rows) {
            for (const FormulaValue& value : row.values) values.emplace(value.symbol, value.number);
        }
    }
    return values;
}

// Checks that a printed relation such as "0.70 ≥ 0.65" holds, within the printed digits.
void expectRelation(const std::string& numbers) {
    for (const char* const sign : {" < ", " ≤ ", " ≥ "}) {
        const std::size_t at = numbers.find(sign);
        if (at == std::string::npos) continue;
        const Range left = PrintedFormula::value(numbers.substr(0, at));
        const Range right = PrintedFormula::value(numbers.substr(at + std::string(sign).size()));
        if (sign == std::string(" ≥ ")) {
            EXPECT_GE(left.high, right.low);
        } else {
            EXPECT_LE(left.low, right.high);
        }
        return;
    }
    EXPECT_EQ(numbers, "") << "no relation";
}

// Checks a printed pair such as "(10.44, 9.41) texels".
void expectPair(const FormulaRow& row) {
    ASSERT_EQ(row.values.size(), 2U);
    const std::size_t comma = row.result.find(", ");
    for (const auto& [text, value] : {std::pair(row.result.substr(1), row.values[0].number),
                                      std::pair(row.result.substr(comma + 2), row.values[1].number)}) {
        const Range printed = PrintedFormula::leading(text);
        EXPECT_LE(printed.low, value);
        EXPECT_GE(printed.high, value);
    }
}

// Checks that all results are numbers, and that the printed right-hand sides give them.
void expectConsistent(const std::vector<FormulaGroup>& groups, const std::string& what) {
    for (const FormulaGroup& group : groups) {
        EXPECT_FALSE(group.title.empty()) << what;
        for (const FormulaRow& row : group.rows) {
            SCOPED_TRACE(what + " · " + row.formula + " = " + row.numbers + " = " + row.result);
            for (const FormulaValue& value : row.values) EXPECT_TRUE(std::isfinite(value.number)) << value.symbol;
            if (row.formula.empty()) {
                EXPECT_FALSE(row.values.empty());
                continue;
            }
            if (row.result.empty()) expectRelation(row.numbers);
            if (row.result.starts_with("(")) expectPair(row);
            if (row.result.empty() || row.result.starts_with("(")) continue;
            const Range result = PrintedFormula::leading(row.result);
            ASSERT_EQ(row.values.size(), 1U);
            const double exactly = 1e-12 * std::abs(row.values[0].number);
            EXPECT_LE(result.low, row.values[0].number + exactly);
            EXPECT_GE(result.high, row.values[0].number - exactly);
            if (row.numbers.empty()) continue;
            // The library computes in double, the filter's weights in float.
            const Range worked = PrintedFormula::value(row.numbers);
            const double rounding = 1e-3 * std::max(std::abs(result.low), 1e-6);
            EXPECT_LE(worked.low - rounding, result.high);
            EXPECT_GE(worked.high + rounding, result.low);
        }
    }
}

TEST(Formula, SignsAreLoweredAndRaised) {
    const auto runs = formulaRuns("V_{i+1} = 2 V_i^2 + λ_0");
    ASSERT_EQ(runs.size(), 7U);
    EXPECT_EQ(runs[1].text, "i+1");
    EXPECT_EQ(runs[1].level, -1);
    EXPECT_EQ(runs[4].text, "2");
    EXPECT_EQ(runs[4].level, 1);
    EXPECT_EQ(runs[5].text, " + λ");
    EXPECT_LT(formulaWidth("a^2"), formulaWidth("a2"));
    EXPECT_EQ(formulaNumber(-0.25), "−0.2500");
    EXPECT_EQ(formulaNumber(-1.5e-7), "−1.500×10^{−7}");
    EXPECT_EQ(formulaNumber(1234.4), "1234");
}

TEST(Formula, CoefficientsGiveTheTextureCoordinatesAndTheirDerivatives) {
    Maker make;
    for (const relief::SceneKind scene : {relief::SceneKind::Floor, relief::SceneKind::Wall, relief::SceneKind::Cube}) {
        relief::Scenario scenario = tiny();
        scenario.scene = scene;
        const auto snapshot = make(scenario);
        const auto groups = formulas(*snapshot, snapshot->scenario.step, Language::English);
        ASSERT_GE(groups.size(), 5U);
        auto v = valuesOf(groups, 0, 1);
        const auto at = [&](double x, double y) {
            const double q = v["G"] * x + v["H"] * y + v["I"];
            return Point{(v["A"] * x + v["B"] * y + v["C"]) / q, (v["D"] * x + v["E"] * y + v["F"]) / q};
        };
        const relief::TexelPoint core =
            snapshot->frame->visible(*snapshot->request).at(27, 24, 60)->texelFromScreen.at(27.5, 24.5);
        EXPECT_NEAR(at(v["x"], v["y"]).x, core.s, 1e-9);
        EXPECT_NEAR(at(v["x"], v["y"]).y, core.t, 1e-9);
        EXPECT_NEAR(v["u"], core.s, 1e-9);
        EXPECT_NEAR(v["v"], core.t, 1e-9);
        EXPECT_EQ(v["q"], core.q);
        // The ray enters the slab there.
        EXPECT_NEAR(snapshot->trace.ray.s0, core.s, 1e-6);
        auto d = valuesOf(groups, 3, 1);
        constexpr double kStep = 1e-4;
        const Point right = at(27.5 + kStep, 24.5), left = at(27.5 - kStep, 24.5);
        const Point down = at(27.5, 24.5 + kStep), up = at(27.5, 24.5 - kStep);
        const auto near = [](double shown, double by) { EXPECT_NEAR(shown, by, 1e-5 * std::max(1.0, std::abs(by))); };
        near(d["u_x"], (right.x - left.x) / (2 * kStep));
        near(d["v_x"], (right.y - left.y) / (2 * kStep));
        near(d["u_y"], (down.x - up.x) / (2 * kStep));
        near(d["v_y"], (down.y - up.y) / (2 * kStep));
        EXPECT_EQ(d["M"], -d["O"]);
        // The ellipse passes through the ends of its axes.
        auto e = valuesOf(groups, 4, 1);
        EXPECT_NEAR(e["F"], e["A"] * e["C"] - e["B"] * e["B"] / 4, 1e-9 * e["A"] * e["C"]);
        const relief::SemiAxes<double> axes = snapshot->footprint->behind.axes;
        EXPECT_NEAR(e["l_1"], axes.major, 1e-12 * axes.major);
        EXPECT_NEAR(e["l_2"], axes.minor, 1e-12 * axes.major);
        const auto form = [&](double u, double w) { return e["A"] * u * u + e["B"] * u * w + e["C"] * w * w; };
        EXPECT_NEAR(form(e["l_1"] * axes.majorU, e["l_1"] * axes.majorV), e["F"], 1e-6 * e["F"]);
        EXPECT_NEAR(form(-e["l_2"] * axes.majorV, e["l_2"] * axes.majorU), e["F"], 1e-6 * e["F"]);
        expectConsistent(groups, std::string(relief::sceneName(scene)));
    }
}

// For coordinates evaluated along the row: the row's constants give them, up to the stated error of the variant.
TEST(Formula, EveryMappingHasItsEquationAndWhatItIsOffBy) {
    Maker make;
    for (const std::string& mapping : relief::mappingNames()) {
        SCOPED_TRACE(mapping);
        relief::Scenario scenario = tiny();
        scenario.mapping = mapping;
        const auto snapshot = make(scenario);
        const auto groups = formulas(*snapshot, snapshot->scenario.step, Language::English);
        expectConsistent(groups, mapping);
        auto v = valuesOf(groups, 0, 1);
        auto r = valuesOf(groups, 1, 1);
        EXPECT_EQ(r.contains("u_t"), mapping != "direct");
        if (mapping == "direct") continue;
        const double n = v["x"] - r["x_0"];
        EXPECT_NEAR((r["u_t"] + n * v["A"]) / (r["u_b"] + n * v["G"]), v["u"], 1e-9);
        EXPECT_NEAR((r["v_t"] + n * v["D"]) / (r["u_b"] + n * v["G"]), v["v"], 1e-9);
        EXPECT_EQ(r["u_n − u"], snapshot->trace.ray.s0 - v["u"]);
        if (mapping == "affine") {
            EXPECT_GT(std::abs(r["u_n − u"]), 1e-3);
        } else {
            EXPECT_LT(std::abs(r["u_n − u"]), 1.0);
        }
    }
}

TEST(Formula, EveryFilterHasItsHeaviestTexelAndTheFiltersSum) {
    Maker make;
    std::vector<relief::FilterChoice> choices = relief::filterForms();
    for (const char* const text : {"elliptical:weights=uniform", "elliptical:weights=texel-distance",
                                   "elliptical:weights=lcd", "elliptical:source=map", "elliptical:levels=exhaustive"}) {
        choices.push_back(relief::parseFilter(text, "test"));
    }
    int formulasOfWeights = 0;
    for (const relief::FilterChoice& choice : choices) {
        const std::string name = relief::filterText(choice);
        SCOPED_TRACE(name);
        relief::Scenario scenario = tiny();
        scenario.filter = choice;
        const auto snapshot = make(scenario);
        const auto groups = formulas(*snapshot, snapshot->scenario.step, Language::English);
        expectConsistent(groups, name);
        ASSERT_NE(snapshot->footprint, nullptr);
        const PixelFootprint& f = *snapshot->footprint;
        double sum = 0, heaviest = 0;
        for (const relief::FootprintTexel& texel : f.log.texels) {
            if (texel.hidden) continue;
            sum += PixelFootprint::weightOf(texel);
            heaviest = std::max(heaviest, PixelFootprint::weightOf(texel));
        }
        if (!(sum > 0)) continue;  // a shape that is sampled at many positions
        auto v = valuesOf(groups, groups.size() - 1, 1);
        EXPECT_NEAR(v["w / Σw"], heaviest / sum, 1e-6);
        if (!f.weighing || f.log.footprint.kind != relief::FootprintKind::Ellipse) continue;
        EXPECT_NEAR(v["r²"] * v["F"], v["A"] * v["U"] * v["U"] + v["B"] * v["U"] * v["V"] + v["C"] * v["V"] * v["V"],
                    1e-9 * v["F"]);
        for (const FormulaRow& row : groups.back().rows) formulasOfWeights += row.formula.starts_with("w = ") ? 1 : 0;
    }
    EXPECT_GE(formulasOfWeights, 4) << "Gaussian, uniform and by distance, from the formula and from level 0";
}

// For any texel under the pointer: its position, its r^2, its weight; a hidden texel has no share of the sum.
TEST(Formula, TheTexelThatIsPointedAtHasItsNumbers) {
    Maker make;
    relief::Scenario scenario = tiny();
    scenario.filter = relief::parseFilter("elliptical-visible", "test");
    const auto snapshot = make(scenario);
    ASSERT_NE(snapshot->footprint, nullptr);
    const PixelFootprint& f = *snapshot->footprint;
    ASSERT_EQ(f.log.footprint.kind, relief::FootprintKind::Ellipse);
    for (std::size_t n = 0; n < f.log.texels.size(); ++n) {
        const relief::FootprintTexel& texel = f.log.texels[n];
        const auto groups = formulas(*snapshot, snapshot->scenario.step, Language::English, n);
        auto v = valuesOf(groups, groups.size() - 1, 1);
        EXPECT_NEAR(v["U"], texel.u - f.log.footprint.centre.x, 1e-12);
        EXPECT_NEAR(v["r²"], relief::squaredRadius(f.log.footprint.ellipse, v["U"], v["V"]), 1e-12);
        EXPECT_EQ(v.contains("w / Σw"), !texel.hidden);
        if (!texel.hidden) {
            EXPECT_NEAR(v["w / Σw"], PixelFootprint::weightOf(texel) / f.weightSum, 1e-9);
        }
        EXPECT_NE(groups.back().note.find("under the pointer"), std::string::npos);
    }
}

// Checks that the formulas of a step contain the numbers of its record.
void expectTheRecord(const FormulaGroup& group, const Snapshot& snapshot, const relief::Step& step,
                     std::map<std::string, int>& seen) {
    std::map<std::string, double> v;
    for (const FormulaRow& row : group.rows) {
        for (const FormulaValue& value : row.values) {
            const auto [at, fresh] = v.emplace(value.symbol, value.number);
            EXPECT_EQ(at->second, value.number) << value.symbol << ": twice, and not the same";
        }
        ++seen[row.formula];
    }
    EXPECT_EQ(v["λ_{in}"], step.lambdaIn);
    EXPECT_EQ(v["λ_{out}"], step.lambdaOut);
    EXPECT_EQ(v["λ′"], step.lambdaAfter);
    if (v.contains("z_{out}")) {
        EXPECT_EQ(v["z_{out}"], step.zOut());
    }
    if (v.contains("h_{max}")) {
        EXPECT_EQ(v["h_{max}"], step.value);
    }
    const relief::ViewRay& ray = snapshot.trace.ray;
    if (v.contains("D") && v.contains("L")) {
        EXPECT_EQ(v["L"], relief::texelsPerLambda(ray.a, ray.b, snapshot.request->field.slabTexels()));
    }
    if (const auto* const texel = step.as<relief::subject::Texel>();
        texel != nullptr && texel->ray && v.contains("x")) {
        EXPECT_EQ(v["x"], 2 * texel->ray->x);
        EXPECT_EQ(v["y"], 2 * texel->ray->y);
    }
}

TEST(Formula, StepsAreSetAsTheirRecordsSay) {
    Maker make;
    std::map<std::string, int> seen;
    for (const relief::MethodDescription& method : relief::tracerList()) {
        relief::Scenario scenario = tiny();
        scenario.method = {method.name, {}};
        const auto made = make(scenario);
        const Snapshot& snapshot = *made;
        for (std::size_t step = 0; step < snapshot.trace.steps.size(); ++step) {
            SCOPED_TRACE(method.name + ", step " + std::to_string(step + 1));
            const FormulaGroup group = stepFormulas(snapshot, static_cast<int>(step), Language::English);
            expectTheRecord(group, snapshot, snapshot.trace.steps[step], seen);
            expectConsistent({group}, method.name);
        }
        expectConsistent(formulas(snapshot, 0, Language::Ukrainian), method.name);
    }
    for (const char* const formula :
         {"V_{i+1} = 2 V_i", "h_{max} < z_{out}", "h_{max} ≥ z_{out}", "λ_{out} = n / N", "λ′ = 1 − h(s_0, t_0)",
          "λ′ = (1 − h(s_0, t_0)) D / L", "λ′ = (λ_0 + λ_1) / 2", "λ′ = λ_{out} + d / L", "λ′ = λ_{in} + d / L",
          "λ′ = λ_{in} + (λ_{out} − λ_{in}) d_0 / (d_0 − d_1)", "λ′ = λ_{in} + (z − h_{apex}) / (1 + κ L)",
          "λ′ = λ_{out} + (z − h_{apex}) / (1 + κ L)"}) {
        std::string bound = formula;  // the formula may be a bound: reduced by a margin, or limited by the ray's end
        bound.replace(bound.find(" = ") != std::string::npos ? bound.find(" = ") : 0, 3, " ≤ ");
        EXPECT_GT(seen[formula] + seen[bound], 0) << formula << " was never set";
    }
}

TEST(Formula, EveryStepOfABisectionIsTheMiddleOfItsInterval) {
    const auto snapshot = tracedBy("layers-bisection");
    const auto& steps = snapshot->trace.steps;
    int atLow = 0, atHigh = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (steps[k].decision != relief::Decision::Refine) continue;
        std::map<std::string, int> seen;
        expectTheRecord(stepFormulas(*snapshot, static_cast<int>(k), Language::English), *snapshot, steps[k], seen);
        EXPECT_EQ(seen["λ′ = (λ_0 + λ_1) / 2"], 1) << k;
        ++(steps[k].lambdaAfter == steps[k].lambdaIn ? atLow : atHigh);
    }
    EXPECT_GT(atLow, 0);
    EXPECT_GT(atHigh, 0);
}

// [MIP18]: if the ray has not advanced, the doubled coordinates of a descent are those at which the next one begins.
TEST(Formula, CoordinatesDoubleFromLevelToLevel) {
    const auto snapshot = tracedBy("max-pyramid-paper");
    const auto& steps = snapshot->trace.steps;
    int pairs = 0;
    for (std::size_t k = 1; k < steps.size(); ++k) {
        const auto* const coarse = steps[k - 1].as<relief::subject::Texel>();
        const auto* const fine = steps[k].as<relief::subject::Texel>();
        if (coarse == nullptr || fine == nullptr || !coarse->ray || !fine->ray) continue;
        if (steps[k].lambdaIn != steps[k - 1].lambdaIn || fine->level + 1 != coarse->level) continue;
        EXPECT_NEAR(fine->ray->x, 2 * coarse->ray->x, 1e-9);
        EXPECT_NEAR(fine->ray->y, 2 * coarse->ray->y, 1e-9);
        ++pairs;
    }
    EXPECT_GT(pairs, 0);
}

TEST(Formula, NothingStandsBesideTheSheet) {
    Maker make;
    relief::Scenario scenario = tiny();
    scenario.filter = relief::parseFilter("elliptical", "test");
    scenario.method = {"cone", {}};
    scenario.step = 2;
    const auto snapshot = make(scenario);
    for (const Language language : {Language::English, Language::Ukrainian}) {
        for (const double width : {120.0, 226.0, 300.0, 442.0, 700.0, 960.0}) {
            const FormulaSheet sheet = formulaSheet(formulas(*snapshot, snapshot->scenario.step, language), width);
            EXPECT_NEAR(sheet.drawing.bounds.width(), width, 1e-9);
            std::vector<Box> taken;
            for (const Item& item : sheet.drawing.items) {
                const auto* const label = std::get_if<Label>(&item.primitive);
                if (label == nullptr) continue;
                const std::string words = labelText(*label, language);
                const bool bold = item.emphasis == Emphasis::Strong;
                const double wide =
                    label->formula ? formulaWidth(words, label->size, bold) : textWidth(words, label->size, bold);
                const double left = label->anchor == Anchor::Right ? label->at.x - wide : label->at.x;
                EXPECT_GE(left, -0.5) << words << " on " << width;
                EXPECT_LE(left + wide, width + 0.5) << words << " on " << width;
                EXPECT_LT(label->at.y, sheet.drawing.bounds.y1);
                const double high = 4 * label->size;
                const Box box{left, label->at.y - high, left + wide, label->at.y + high};
                for (const Box& other : taken) EXPECT_FALSE(box.overlaps(other)) << words << " on " << width;
                taken.push_back(box);
            }
            EXPECT_GT(taken.size(), 60U);
        }
    }
}

TEST(Formula, WeightsLieOnTheWeightFunctionAndTheMapIsTheFilters) {
    Maker make;
    for (const char* const filter : {"elliptical:levels=exhaustive", "elliptical:weights=uniform",
                                     "elliptical:weights=texel-distance", "elliptical:weights=crt"}) {
        SCOPED_TRACE(filter);
        relief::Scenario scenario = tiny();
        scenario.filter = relief::parseFilter(filter, "test");
        const auto snapshot = make(scenario);
        const PixelFootprint& f = *snapshot->footprint;
        if (!hasWeights(f)) {
            EXPECT_STREQ(filter, "elliptical:weights=crt");  // too few texels to carry the shape
            continue;
        }
        const Drawing drawing = weightDrawing(f, {0, 0, 400, 180});
        const Polyline* curve = nullptr;
        const relief::FloatImage* map = nullptr;
        std::vector<Point> dots;
        for (const Item& item : drawing.items) {
            if (const auto* const line = std::get_if<Polyline>(&item.primitive)) {
                if (item.role == Role::Footprint) curve = line;
                for (const Point& p : line->points) EXPECT_TRUE(drawing.bounds.contains(p));
            }
            if (const auto* const dot = std::get_if<Marker>(&item.primitive)) {
                EXPECT_TRUE(drawing.bounds.contains(dot->at));
                if (item.role == Role::Weight && dot->size > 4) dots.push_back(dot->at);
            }
            if (const auto* const cells = std::get_if<Cells>(&item.primitive)) map = cells->values.get();
        }
        EXPECT_EQ(dots.size(), f.log.texels.size());
        const bool byTexels = f.weighing->weights == relief::WeightKind::TexelDistance;
        EXPECT_EQ(map == nullptr, byTexels);
        EXPECT_EQ(curve == nullptr, byTexels);
        if (byTexels) continue;
        // Each dot lies on the curve between the points around it.
        for (const Point& dot : dots) {
            const auto after = std::find_if(curve->points.begin() + 1, curve->points.end(),
                                            [&](const Point& p) { return p.x >= dot.x; });
            ASSERT_NE(after, curve->points.end());
            const Point& a = *(after - 1);
            const double at = a.y + (after->y - a.y) * (dot.x - a.x) / std::max(after->x - a.x, 1e-9);
            EXPECT_NEAR(dot.y, at, 1.0) << "points";
        }
        const int n = map->width();
        const relief::EllipticalSettings& settings = *f.weighing;
        const double centre = settings.radius / n * std::sqrt(2.0);
        EXPECT_NEAR(static_cast<double>((*map)(n / 2, n / 2)), relief::radialWeight(settings, centre), 1e-6);
        EXPECT_EQ((*map)(0, 0), 0.0F) << "a corner lies beyond R";
    }
}

// Texels that rays found beside the pixel's footprint have no place on the map.
TEST(Formula, MarksOfTexelsLieOnTheWeightMap) {
    Maker make;
    for (const char* const form : {"rays", "grid"}) {
        SCOPED_TRACE(form);
        relief::Scenario scenario = tiny();
        scenario.filter = relief::parseFilter(std::string("elliptical-visible:form=") + form, "test");
        const auto snapshot = make(scenario);
        ASSERT_TRUE(hasWeights(*snapshot->footprint));
        const Drawing drawing = weightDrawing(*snapshot->footprint, {0, 0, 400, 180});
        const Box* map = nullptr;
        int marks = 0;
        for (const Item& item : drawing.items) {
            const auto* const frame = std::get_if<Rectangle>(&item.primitive);
            if (item.role == Role::Frame && frame != nullptr) map = &frame->box;
            const auto* const mark = std::get_if<Marker>(&item.primitive);
            if (map == nullptr || mark == nullptr) continue;
            EXPECT_TRUE(map->contains(mark->at)) << mark->at.x << " " << mark->at.y;
            ++marks;
        }
        EXPECT_GT(marks, 0);
    }
}

}  // namespace

}  // namespace reliefui
