// The chosen step as equations, depending on its subject.
#include <algorithm>
#include <cmath>

#include "painting/step_body.h"
#include "panes/formula/formula_data.h"
#include "panes/formula/formula_terms.h"
#include "relief/ray_length.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

namespace subject = relief::subject;
using relief::Decision;
using relief::MessageId;
using relief::Step;

constexpr const char* kMip = "[MIP18]";

class StepRows {
  public:
    StepRows(const Snapshot& snapshot, std::size_t index, relief::Language language)
        : step_(snapshot.trace.steps[index]),
          before_(index > 0 ? &snapshot.trace.steps[index - 1] : nullptr),
          ray_(snapshot.trace.ray),
          slab_(snapshot.request ? snapshot.request->field.slabTexels() : 0),
          language_(language) {}

    std::vector<FormulaRow> take() {
        list({{"λ_{in}", step_.lambdaIn}, {"λ_{out}", step_.lambdaOut}, {"λ′", step_.lambdaAfter}});
        if (step_.as<subject::Texel>() != nullptr || step_.as<subject::Quad>() != nullptr) {
            highest();
        } else if (step_.as<subject::Layer>() != nullptr || step_.as<subject::Point>() != nullptr) {
            sample();
        } else if (const auto* const sphere = step_.as<subject::Sphere>()) {
            if (step_.trustsMap()) distance("λ_{in}", step_.lambdaIn, sphere->radius, "Donnelly 2005; [DIST17] fig. 4");
        } else if (const auto* const voxel = step_.as<subject::Voxel>()) {
            if (step_.trustsMap()) distance("λ_{out}", step_.lambdaOut, voxel->distance, "[DIST17]");
        } else if (const auto* const cone = step_.as<subject::Cone>()) {
            if (step_.trustsMap()) coneStep(*cone);
        }
        return std::move(rows_);
    }

  private:
    void list(std::vector<FormulaValue> values, const char* source = "") {
        rows_.push_back({{}, {}, {}, source, std::move(values)});
    }
    void row(const std::string& symbol, const std::string& right, std::string numbers, double value,
             const char* source = "") {
        rows_.push_back({symbol + " = " + right, std::move(numbers), formulaNumber(value), source, {{symbol, value}}});
    }
    // Compares a height of the surface, or a maximum, with the ray's height.
    void compare(const std::string& symbol, double height, const std::string& rayHeight, double z, const char* source) {
        const char* const sign = height < z ? " < " : " ≥ ";
        rows_.push_back({symbol + sign + rayHeight,
                         formulaNumber(height) + sign + formulaNumber(z),
                         {},
                         source,
                         {{symbol, height}, {rayHeight, z}}});
    }
    // The lambda at which the tracer continued: the value of the formula, or less, if a margin for rounding or the end
    // of the searched part limits it. No row is added if the record agrees with neither.
    void goesOn(const std::string& right, const std::string& numbers, double byFormula, const char* source) {
        constexpr double kSame = 1e-4;
        const double after = step_.lambdaAfter;
        if (std::abs(byFormula - after) <= kSame * std::abs(after)) {
            row("λ′", right, numbers, after, source);
        } else if (after < byFormula) {
            rows_.push_back({"λ′ ≤ " + right, formulaNumber(after) + " ≤ " + numbers, {}, source, {{"λ′", after}}});
        }
    }

    // [MIP18]: compares the maximum of a texel with the ray's lowest point in it.
    void highest() {
        const auto* const texel = step_.as<subject::Texel>();
        const auto* const quad = step_.as<subject::Quad>();
        const double maximum = texel != nullptr ? step_.value : quad->maximum;
        const char* const source = texel != nullptr && texel->level > 0 ? kMip : "";
        if (step_.decision == Decision::Start || step_.decision == Decision::Miss) return;
        if (step_.phase == relief::Phase::Start) {
            list({{"h_{max}", maximum}}, kMip);
            goesOn("1 − h_{max}", "1 − " + formulaNumber(maximum), 1 - maximum, kMip);
            return;
        }
        row("z_{out}", "1 − λ_{out}", "1 − " + formulaNumber(step_.lambdaOut), step_.zOut());
        compare("h_{max}", maximum, "z_{out}", step_.zOut(), source);
        if (step_.decision == Decision::Descend && texel != nullptr && texel->ray) {
            const double x = texel->ray->x, y = texel->ray->y;
            rows_.push_back({"V_{i+1} = 2 V_i",
                             "2 · " + term::pair(x, y),
                             term::pair(2 * x, 2 * y) + " " +
                                 relief::sentence(relief::Message(MessageId::DrawFormulaTexels), language_),
                             kMip,
                             {{"x", 2 * x}, {"y", 2 * y}}});
        }
        if (step_.decision == Decision::Hit) {
            row("h(s, t)", "1 − λ′", "1 − " + formulaNumber(step_.lambdaAfter), 1 - step_.lambdaAfter);
        }
    }

    // The surface's height at one point of the ray.
    void sample() {
        if (step_.decision == Decision::Start || step_.decision == Decision::Miss) return;
        if (step_.decision == Decision::Refine) return refined();
        const bool first = before_ != nullptr && before_->decision == Decision::Start && step_.lambdaIn == 0;
        const auto* const layer = step_.as<subject::Layer>();
        if (layer == nullptr && first && step_.decision == Decision::Hit) return offset();
        if (layer != nullptr) {
            row("λ_{out}", "n / N", std::to_string(layer->n) + " / " + std::to_string(layer->count), step_.lambdaOut,
                "[DIST17] fig. 2");
        }
        row("z_{out}", "1 − λ_{out}", "1 − " + formulaNumber(step_.lambdaOut), step_.zOut());
        compare("h", step_.value, "z_{out}", step_.zOut(), layer != nullptr ? "[DIST17] fig. 2" : "");
    }

    // A single height: the formula of Kaneko, or of Welsh, whose offset is never longer than the relief is deep. If
    // neither gives the recorded value (another method), only the height is listed.
    void offset() {
        constexpr double kSame = 1e-9;
        const double depth = 1 - step_.value;
        const double length = relief::texelsPerLambda(ray_.a, ray_.b, slab_);
        list({{"h(s_0, t_0)", step_.value}, {"D", slab_}});
        if (std::abs(step_.lambdaAfter - depth) <= kSame) {
            row("λ′", "1 − h(s_0, t_0)", "1 − " + formulaNumber(step_.value), step_.lambdaAfter,
                "Kaneko 2001; [DIST17]");
        } else if (length > 0 && std::abs(step_.lambdaAfter - depth * slab_ / length) <= kSame) {
            lengthRow(length);
            row("λ′", "(1 − h(s_0, t_0)) D / L",
                "(1 − " + formulaNumber(step_.value) + ") · " + formulaNumber(slab_) + " / " + formulaNumber(length),
                step_.lambdaAfter, "Welsh 2004");
        }
    }

    // The secant's result lies inside the interval, that of a bisection at one end of the new interval.
    void refined() {
        const double middle = step_.lambdaAfter;
        const bool above = middle == step_.lambdaIn;
        const bool below = middle == step_.lambdaOut && step_.value != step_.zOut();
        if (above || below) {
            const double from = above ? 2 * middle - step_.lambdaOut : step_.lambdaIn;
            const double to = above ? step_.lambdaOut : 2 * middle - step_.lambdaIn;
            row("λ′", "(λ_0 + λ_1) / 2", "(" + formulaNumber(from) + " + " + formulaNumber(to) + ") / 2", middle,
                "Policarpo 2005");
            row("z′", "1 − λ′", "1 − " + formulaNumber(middle), 1 - middle);
            compare("h(λ′)", step_.value, "z′", 1 - middle, "Policarpo 2005");
            return;
        }
        const double low = step_.value - step_.zOut();
        const bool known = before_ != nullptr && before_->atPoint() && before_->lambdaOut == step_.lambdaIn;
        const double high = known ? before_->value - before_->zOut() : 0;
        const auto gap = [&](const char* symbol, const char* right, double height, double lambda, double value) {
            row(symbol, right, formulaNumber(height) + " − (1 − " + formulaNumber(lambda) + ")", value,
                "Tatarchuk 2006");
        };
        if (known) gap("d_0", "h(λ_{in}) − (1 − λ_{in})", before_->value, step_.lambdaIn, high);
        gap("d_1", "h(λ_{out}) − (1 − λ_{out})", step_.value, step_.lambdaOut, low);
        if (!known) return;
        const double run = step_.lambdaOut - step_.lambdaIn;
        goesOn("λ_{in} + (λ_{out} − λ_{in}) d_0 / (d_0 − d_1)",
               formulaNumber(step_.lambdaIn) + " + " + formulaNumber(run) + " · " + term::atom(high) + " / (" +
                   formulaNumber(high) + term::minus(formulaNumber(low)) + ")",
               step_.lambdaIn + run * high / (high - low), "Tatarchuk 2006");
    }

    void lengthRow(double length) {
        row("L", "√(a² + b² + D²)",
            "√(" + term::square(ray_.a) + " + " + term::square(ray_.b) + " + " + term::square(slab_) + ")", length);
    }

    // A sphere with the map's distance as its radius, centred at `from` on the ray; the ray advances to its surface.
    void distance(const std::string& symbol, double from, double distance, const char* source) {
        const double length = relief::texelsPerLambda(ray_.a, ray_.b, slab_);
        list({{"d", distance}, {"D", slab_}}, source);
        if (!(length > 0)) return;
        lengthRow(length);
        goesOn(symbol + " + d / L",
               formulaNumber(from) + " + " + formulaNumber(distance) + " / " + formulaNumber(length),
               from + distance / length, source);
    }

    void coneStep(const subject::Cone& cone) {
        const char* const source = cone.ofCell ? "Dummer 2006; Ban et al. 2024" : "Dummer 2006";
        const double from = cone.ofCell ? step_.lambdaOut : step_.lambdaIn;
        const char* const symbol = cone.ofCell ? "λ_{out}" : "λ_{in}";
        const double z = 1 - from;
        const double length = stepBody(step_).away(ray_.a, ray_.b);
        list({{"κ", cone.slope}, {"h_{apex}", cone.apex}}, source);
        row("z", std::string("1 − ") + symbol, "1 − " + formulaNumber(from), z);
        if (cone.square) {
            row("L", "max(|a|, |b|)",
                "max(" + formulaNumber(std::abs(ray_.a)) + ", " + formulaNumber(std::abs(ray_.b)) + ")", length);
        } else {
            row("L", "√(a² + b²)", "√(" + term::square(ray_.a) + " + " + term::square(ray_.b) + ")", length);
        }
        goesOn(std::string(symbol) + " + (z − h_{apex}) / (1 + κ L)",
               formulaNumber(from) + " + (" + formulaNumber(z) + term::minus(formulaNumber(cone.apex)) + ") / (1 + " +
                   term::product(cone.slope, length) + ")",
               from + (z - cone.apex) / (1 + cone.slope * length), source);
    }

    const Step& step_;
    const Step* before_;
    relief::ViewRay ray_;
    double slab_;  // in texels
    relief::Language language_;
    std::vector<FormulaRow> rows_;
};

}  // namespace

FormulaGroup stepFormulas(const Snapshot& snapshot, int step, relief::Language language) {
    const PixelTrace& trace = snapshot.trace;
    const int last = static_cast<int>(trace.steps.size()) - 1;
    const auto index = static_cast<std::size_t>(std::clamp(step, 0, last));
    FormulaGroup group;
    group.part = FormulaPart::Ray;
    const std::string& method = trace.fromFile ? snapshot.scenario.other.steps : snapshot.scenario.method.name;
    group.title = relief::sentence(
        relief::Message(MessageId::DrawFormulaStep, {{"step", static_cast<std::int64_t>(index) + 1},
                                                     {"steps", static_cast<std::int64_t>(trace.steps.size())},
                                                     {"method", method}}),
        language);
    group.note = relief::sentence(relief::stepSentence(trace.steps, index, trace.ray, trace.exact), language);
    group.rows = StepRows(snapshot, index, language).take();
    return group;
}

}  // namespace reliefui
