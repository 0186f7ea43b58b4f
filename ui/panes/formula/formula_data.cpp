#include "panes/formula/formula_data.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "filtering/weight_map.h"
#include "mapping/rows/derivatives.h"
#include "mapping/rows/row_terms.h"
#include "panes/formula/formula_terms.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

constexpr const char* kPersp = "[PERSP] (1)";
constexpr const char* kTex = "[TEX]";

struct PixelNumbers {
    relief::PixelCoefficients at;
    std::int64_t first = 0;  // first pixel of the polygon's span in this row
};

// Numbers of the top plane at the pixel; std::nullopt if no polygon is visible there.
std::optional<PixelNumbers> numbersOf(const Snapshot& snapshot) {
    if (!snapshot.frame || !snapshot.scenario.pixel) return std::nullopt;
    const relief::Frame& frame = *snapshot.frame;
    const relief::FrameRequest& request = *snapshot.request;
    const auto inFrame = [](int at, int side, int whole) { return std::clamp(at * side / whole, 0, side - 1); };
    const int x = inFrame(snapshot.scenario.pixel->x, frame.width, snapshot.scenario.width);
    const int y = inFrame(snapshot.scenario.pixel->y, frame.height, snapshot.scenario.height);
    const relief::VisiblePolygons visible = frame.visible(request);
    const relief::VisiblePolygon* const polygon = visible.at(x, y, frame.width);
    if (polygon == nullptr) return std::nullopt;
    return PixelNumbers{relief::pixelCoefficients(polygon->texelFromScreen, x + 0.5, y + 0.5),
                        polygon->span(y, frame.width).begin};
}

// Recurrence of a variant along the row, as in [PERSP] with the letters of these formulas.
struct RowFormula {
    const char* formula;
    const char* source;
};
RowFormula rowFormula(relief::RowVariant variant) {
    using relief::RowVariant;
    switch (variant) {
        case RowVariant::Affine:
            return {"u_{n+1} = u_n + Δu, v_{n+1} = v_n + Δv", ""};
        case RowVariant::Direct:
        case RowVariant::RowConstant:
            return {"u_n = (u_t + A n) / (u_b + G n), v_n = (v_t + D n) / (u_b + G n)", "[PERSP] (3)"};
        case RowVariant::Incremental:
        case RowVariant::IncrementalShared:
        case RowVariant::IncrementalReciprocal:
            return {"w_{n+1} = w_n + A, q_{n+1} = q_n + G, u_n = w_n / q_n", "[PERSP] (4)"};
        case RowVariant::Streams:
        case RowVariant::RowsParallel:
            return {"w_{n+k} = w_n + k A, q_{n+k} = q_n + k G, u_n = w_n / q_n", "[PERSP] (5)"};
        case RowVariant::Opposed:
            return {"w_{n±1} = w_n ± A, q_{n±1} = q_n ± G, u_n = w_n / q_n", "[PERSP]"};
        case RowVariant::Subspan:
            break;
    }
    return {"u_{n+1} = u_n + (u_m − u_0) / m", ""};
}

// Builds the groups of one pixel in one language.
class Groups {
  public:
    Groups(const Snapshot& snapshot, int step, relief::Language language, std::optional<std::size_t> texel)
        : s_(snapshot), step_(step), language_(language), texel_(texel) {}

    std::vector<FormulaGroup> take() {
        const auto pixel = numbersOf(s_);
        if (pixel) mapping(pixel->at);
        if (pixel && s_.request->mapping.variant != relief::RowVariant::Direct && !s_.trace.fromFile)
            alongTheRow(*pixel);
        if (pixel || s_.trace.fromFile) ray();
        if (!s_.trace.steps.empty()) groups_.push_back(stepFormulas(s_, step_, language_));
        if (pixel) {
            derivatives(pixel->at);
            ellipse(pixel->at);
        }
        if (s_.footprint) weights(*s_.footprint);
        return std::move(groups_);
    }

  private:
    std::string say(MessageId id, std::vector<relief::MessageValue> values = {}) const {
        return relief::sentence(Message(id, std::move(values)), language_);
    }
    std::string with(double value, MessageId unit, const char* power = "") const {
        return formulaNumber(value) + " " + say(unit) + power;
    }
    void group(FormulaPart part, std::string title, std::string note = {}) {
        groups_.push_back({part, std::move(title), std::move(note), {}});
    }
    // Adds the row "symbol = right"; `value` is the symbol's value.
    void row(const std::string& symbol, const std::string& right, std::string numbers, double value, std::string result,
             std::string source) {
        groups_.back().rows.push_back(
            {symbol + " = " + right, std::move(numbers), std::move(result), std::move(source), {{symbol, value}}});
    }
    void list(std::vector<FormulaValue> values, std::string source = {}) {
        groups_.back().rows.push_back({{}, {}, {}, std::move(source), std::move(values)});
    }

    void mapping(const relief::PixelCoefficients& p) {
        group(FormulaPart::Mapping,
              say(MessageId::DrawFormulaMapping, {{"x", s_.scenario.pixel->x}, {"y", s_.scenario.pixel->y}}),
              say(MessageId::DrawFormulaLetters));
        const relief::Homography& f = p.map;
        list({{"A", f.sx}, {"B", f.sy}, {"C", f.s1}}, kPersp);
        list({{"D", f.tx}, {"E", f.ty}, {"F", f.t1}}, kPersp);
        list({{"G", f.qx}, {"H", f.qy}, {"I", f.q1}}, kPersp);
        list({{"x", p.x}, {"y", p.y}});
        const auto sum = [&](double a, double b, double c) {
            return term::product(a, p.x) + term::plus(term::product(b, p.y)) + term::plus(formulaNumber(c));
        };
        row("q", "G x + H y + I", sum(f.qx, f.qy, f.q1), p.q, formulaNumber(p.q), kPersp);
        const auto over = [&](const std::string& top) { return "(" + top + ") / " + term::atom(p.q); };
        row("u", "(A x + B y + C) / q", over(sum(f.sx, f.sy, f.s1)), p.u, with(p.u, MessageId::DrawFormulaTexels),
            kPersp);
        row("v", "(D x + E y + F) / q", over(sum(f.tx, f.ty, f.t1)), p.v, with(p.v, MessageId::DrawFormulaTexels),
            kPersp);
    }

    // For variants that compute coordinates along the row instead of per pixel: how, and by how much the result
    // differs.
    void alongTheRow(const PixelNumbers& pixel) {
        const relief::PixelCoefficients& p = pixel.at;
        const relief::Homography& f = p.map;
        const auto n = static_cast<std::int64_t>(std::floor(p.x)) - pixel.first;
        group(FormulaPart::Mapping, say(MessageId::DrawFormulaRow, {{"mapping", s_.scenario.mapping}, {"n", n}}));
        const auto terms = relief::rowTerms<double>(
            f, p.y, pixel.first, n + 1, 0, [](double value) { return value; }, [](double value) { return value; });
        const double x = terms.x(0);
        list({{"x_0", x}});
        const auto start = [&](const char* symbol, const char* right, double a, double b, double c, double value) {
            row(symbol, right, term::product(a, x) + term::plus(term::product(b, p.y)) + term::plus(formulaNumber(c)),
                value, formulaNumber(value), "[PERSP] (3)");
        };
        start("u_t", "A x_0 + B y + C", f.sx, f.sy, f.s1, terms.ut);
        start("v_t", "D x_0 + E y + F", f.tx, f.ty, f.t1, terms.vt);
        start("u_b", "G x_0 + H y + I", f.qx, f.qy, f.q1, terms.ub);
        const RowFormula formula = rowFormula(s_.request->mapping.variant);
        groups_.back().rows.push_back({formula.formula, {}, {}, formula.source, {}});
        const relief::ViewRay& ray = s_.trace.ray;
        if (!s_.trace.onRelief) return;
        list({{"u_n", ray.s0}, {"v_n", ray.t0}});
        list({{"u_n − u", ray.s0 - p.u}, {"v_n − v", ray.t0 - p.v}});
    }

    void ray() {
        const relief::ViewRay& ray = s_.trace.ray;
        group(FormulaPart::Ray, say(MessageId::DrawFormulaRay));
        list({{"s_0", ray.s0}, {"t_0", ray.t0}, {"a", ray.a}, {"b", ray.b}});
        const relief::Hit& hit = s_.trace.hit;
        if (hit.outcome != relief::Outcome::Hit) return;
        const auto place = [&](const char* symbol, const char* right, double start, double run, double value) {
            row(symbol, right, formulaNumber(start) + term::plus(term::product(hit.lambda, run)), value,
                with(value, MessageId::DrawFormulaTexels), {});
        };
        list({{"λ", hit.lambda}});
        place("s", "s_0 + λ a", ray.s0, ray.a, hit.s);
        place("t", "t_0 + λ b", ray.t0, ray.b, hit.t);
        row("z", "1 − λ", "1 − " + term::atom(hit.lambda), 1 - hit.lambda, formulaNumber(1 - hit.lambda), {});
    }

    void derivatives(const relief::PixelCoefficients& p) {
        group(FormulaPart::Mapping, say(MessageId::DrawFormulaDerivatives));
        const relief::Homography& f = p.map;
        const relief::DerivativeTerms<double> terms = relief::derivativeTerms<double>(f);
        const auto minor = [&](const char* symbol, const char* right, double k, double l, double r, double s,
                               double value) {
            row(symbol, right, term::product(k, l) + term::minus(term::product(r, s)), value, formulaNumber(value),
                kTex);
        };
        minor("M", "A H − B G", f.sx, f.qy, f.sy, f.qx, p.m);
        minor("N", "D H − E G", f.tx, f.qy, f.ty, f.qx, p.n);
        minor("O", "B G − A H", f.sy, f.qx, f.sx, f.qy, p.o);
        minor("P", "E G − D H", f.ty, f.qx, f.tx, f.qy, p.p);
        // Formats k l − r s, or "0" if only rounding errors remain of it.
        const auto rounded = [](double value, double k, double l, double r, double s) {
            constexpr double kLost = 1e-13;
            return std::abs(value) > kLost * (std::abs(k * l) + std::abs(r * s)) ? formulaNumber(value) : "0";
        };
        const auto line = [&](const char* symbol, const char* right, double slope, double at, const std::string& own,
                              double value) {
            row(symbol, right, term::product(slope, at) + term::plus(own), value, formulaNumber(value), kTex);
        };
        line("a", "M y + (A I − C G)", terms.m, p.y, rounded(terms.a1, f.sx, f.q1, f.s1, f.qx), terms.a(p.y));
        line("b", "N y + (D I − F G)", terms.n, p.y, rounded(terms.b1, f.tx, f.q1, f.t1, f.qx), terms.b(p.y));
        line("c", "O x + (B I − C H)", terms.o, p.x, rounded(terms.c1, f.sy, f.q1, f.s1, f.qy), terms.c(p.x));
        line("d", "P x + (E I − F H)", terms.p, p.x, rounded(terms.d1, f.ty, f.q1, f.t1, f.qy), terms.d(p.x));
        const auto slope = [&](const char* symbol, const char* right, double top, double value) {
            row(symbol, right, term::atom(top) + " / " + term::square(p.q), value, formulaNumber(value), kTex);
        };
        slope("u_x", "a / q²", terms.a(p.y), p.derivatives.ux);
        slope("v_x", "b / q²", terms.b(p.y), p.derivatives.vx);
        slope("u_y", "c / q²", terms.c(p.x), p.derivatives.uy);
        slope("v_y", "d / q²", terms.d(p.x), p.derivatives.vy);
    }

    void ellipse(const relief::PixelCoefficients& p) {
        group(FormulaPart::Footprint, say(MessageId::DrawFormulaEllipse), say(MessageId::DrawFormulaEllipsePlace));
        const relief::Jacobian& j = p.derivatives;
        const relief::Ellipse& e = p.ellipse;
        // The unit is a power of that of the derivatives: power 2 for A, B, C, power 4 for F.
        const auto scaled = [&](double value, const char* power) {
            return formulaNumber(value) + " " + say(MessageId::DrawFormulaTexelsPixel, {{"power", std::string(power)}});
        };
        groups_.back().rows.push_back({"A U² + B U V + C V² = F", {}, {}, kTex, {}});
        row("A", "v_x² + v_y²", term::square(j.vx) + " + " + term::square(j.vy), e.a, scaled(e.a, "²"), kTex);
        row("B", "−2 (u_x v_x + u_y v_y)",
            "−2 (" + term::product(j.ux, j.vx) + term::plus(term::product(j.uy, j.vy)) + ")", e.b, scaled(e.b, "²"),
            kTex);
        row("C", "u_x² + u_y²", term::square(j.ux) + " + " + term::square(j.uy), e.c, scaled(e.c, "²"), kTex);
        row("F", "(u_x v_y − u_y v_x)²",
            "(" + term::product(j.ux, j.vy) + term::minus(term::product(j.uy, j.vx)) + ")²", e.f, scaled(e.f, "⁴"),
            kTex);
        row("l_1", "√((A + C + √((A − C)² + B²)) / 2)",
            "√((" + formulaNumber(e.a) + " + " + formulaNumber(e.c) + " + √((" + formulaNumber(e.a) + " − " +
                formulaNumber(e.c) + ")² + " + term::square(e.b) + ")) / 2)",
            p.axes.major, with(p.axes.major, MessageId::DrawFormulaTexels), "Heckbert 1989");
        row("l_2", "√F / l_1", "√" + term::atom(e.f) + " / " + term::atom(p.axes.major), p.axes.minor,
            with(p.axes.minor, MessageId::DrawFormulaTexels), "Heckbert 1989");
    }

    void weights(const PixelFootprint& f) {
        const relief::LevelFootprint& log = f.log.footprint;
        const bool ellipse = f.weighing && log.kind == relief::FootprintKind::Ellipse;
        std::string note = ellipse ? say(MessageId::DrawFormulaSeen, {{"level", log.level}}) + " " : "";
        const auto& texels = f.log.texels;
        const bool pointed = texel_ && *texel_ < texels.size();
        const relief::FootprintTexel* const texel = pointed ? &texels[*texel_] : f.listed ? heaviestTexel(f) : nullptr;
        if (pointed) {
            note += say(MessageId::DrawFormulaPointed, {{"i", texel->i}, {"j", texel->j}, {"level", texel->level}});
            if (texel->hidden) note += " " + say(MessageId::DrawFormulaHidden);
        } else if (texel != nullptr) {
            const auto counted =
                std::count_if(texels.begin(), texels.end(), [](const relief::FootprintTexel& t) { return !t.hidden; });
            note += say(MessageId::DrawFormulaTexel,
                        {{"i", texel->i}, {"j", texel->j}, {"level", texel->level}, {"texels", counted}});
        } else if (!f.listed) {
            note += say(MessageId::DrawFootprintMany, {{"texels", f.counts.texels}});
        }
        std::string title = say(MessageId::DrawFormulaFilter, {{"filter", f.filter.name}, {"level", log.level}});
        const bool small = f.weighing && log.kind == relief::FootprintKind::Bilinear;
        if (small) title += " · " + say(MessageId::DrawFootprintSmall);
        group(FormulaPart::Footprint, std::move(title), std::move(note));
        if (ellipse) {
            const relief::Ellipse& e = log.ellipse;
            list({{"A", e.a}, {"B", e.b}, {"C", e.c}, {"F", e.f}}, kTex);
        }
        if (texel == nullptr) return;
        const double du = texel->u - log.centre.x;
        const double dv = texel->v - log.centre.y;
        list({{"U", du}, {"V", dv}});
        const double weight = PixelFootprint::weightOf(*texel);
        if (ellipse) {
            inEllipse(f, du, dv, weight);
        } else {
            atPoint(f, du, dv, weight);
        }
        if (texel->hidden) return;
        const double share = f.weightSum > 0 ? weight / f.weightSum : 0;
        groups_.back().rows.push_back({"w / Σw",
                                       term::atom(weight) + " / " + term::atom(f.weightSum),
                                       formulaNumber(share),
                                       kTex,
                                       {{"w / Σw", share}}});
    }

    // Adds the weight. The formula is shown only if it gives the logged value: weights from tables or maps, or of
    // partially visible texels, differ.
    void weight(const char* right, std::string numbers, double byFormula, double logged, const char* source) {
        constexpr double kSame = 1e-3;
        const bool same = std::abs(byFormula - logged) <= kSame;
        if (!same) {
            list({{"w", logged}}, kTex);
            groups_.back().note += " " + say(MessageId::DrawFormulaLogged);
            return;
        }
        row("w", right, std::move(numbers), logged, formulaNumber(logged), source);
    }

    // Bilinear weight, unless the filter reads a single texel or samples many places.
    void atPoint(const PixelFootprint& f, double du, double dv, double logged) {
        const bool between =
            f.log.footprint.kind == relief::FootprintKind::Bilinear && f.filter.name != "nearest" && f.rays.empty();
        if (!between) return list({{"w", logged}});
        const auto side = [](double d) { return "(1 − " + formulaNumber(std::abs(d)) + ")"; };
        weight("(1 − |U|) (1 − |V|)", side(du) + " " + side(dv), (1 - std::abs(du)) * (1 - std::abs(dv)), logged, "");
    }

    void inEllipse(const PixelFootprint& f, double du, double dv, double logged) {
        const relief::EllipticalSettings& settings = *f.weighing;
        const relief::Ellipse& e = f.log.footprint.ellipse;
        const double square = relief::squaredRadius(e, du, dv);
        const std::string u = term::atom(du), v = term::atom(dv);
        const std::string cross = formulaNumber(std::abs(e.b)) + " · " + u + " · " + v;
        row("r²", "(A U² + B U V + C V²) / F",
            "(" + formulaNumber(e.a) + " · " + u + "²" + (e.b < 0 ? " − " : " + ") + cross + " + " +
                formulaNumber(e.c) + " · " + v + "²) / " + term::atom(e.f),
            square, with(square, MessageId::DrawFormulaPixels, "²"), kTex);
        if (settings.shaped()) {
            const relief::PixelFromTexel back = relief::pixelFromTexel(f.log.footprint.widened);
            const double x = back.dx(du, dv), y = back.dy(du, dv);
            groups_.back().rows.push_back({"(x, y) = J^{−1} (U, V)",
                                           {},
                                           term::pair(x, y) + " " + say(MessageId::DrawFormulaPixels),
                                           kTex,
                                           {{"x", x}, {"y", y}}});
            list({{"w(x, y)", logged}}, kTex);
            return;
        }
        if (settings.weights == relief::WeightKind::Uniform) {
            weight("1", {}, 1, logged, kTex);
        } else if (settings.weights == relief::WeightKind::TexelDistance) {
            weight("1 / (1 + √(U² + V²))", "1 / (1 + √(" + u + "² + " + v + "²))", 1 / (1 + std::hypot(du, dv)), logged,
                   "");
        } else {
            list({{"σ", settings.sigma}, {"R", settings.radius}});
            const double byFormula = relief::radialWeight(settings, std::sqrt(square));
            weight("exp(−r² / (2 σ²))", "exp(−" + term::atom(square) + " / (2 · " + term::square(settings.sigma) + "))",
                   byFormula, logged, "[TEX] fig. 3");
        }
    }

    const Snapshot& s_;
    int step_;
    relief::Language language_;
    std::optional<std::size_t> texel_;  // the texel under the pointer
    std::vector<FormulaGroup> groups_;
};

}  // namespace

const relief::FootprintTexel* heaviestTexel(const PixelFootprint& footprint) {
    const relief::FootprintTexel* best = nullptr;
    for (const relief::FootprintTexel& texel : footprint.log.texels) {
        if (texel.hidden) continue;
        if (best == nullptr || PixelFootprint::weightOf(texel) > PixelFootprint::weightOf(*best)) best = &texel;
    }
    return best;
}

std::vector<FormulaGroup> formulas(const Snapshot& snapshot, int step, relief::Language language,
                                   std::optional<std::size_t> texel) {
    return Groups(snapshot, step, language, texel).take();
}

MessageId formulasMissing(const Snapshot& snapshot) {
    return snapshot.scenario.pixel ? MessageId::DrawNoRelief : MessageId::DrawFormulaNoPixel;
}

}  // namespace reliefui
