#include "measuring/compare/rational_hit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/multiprecision/cpp_int.hpp>

namespace relief {

namespace {

using Rational = boost::multiprecision::cpp_rational;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Runs that are smaller do not change a position over lambda in [0, 1].
constexpr double kSmallestRun = 1e-300;
// Relative error of a lambda of a grid line in double, per operation: the start, a subtraction, a division, and a
// comparison are rounded.
constexpr double kLineError = 0x1p-51;
// A cell whose highest point is lower than the ray by this, a height, is passed without rational arithmetic.
constexpr double kFree = 1e-6;
// Halvings of the interval of a root: below half a unit in the last place of any lambda above 1e-4 of the interval.
constexpr int kHalvings = 70;

double nearest(const Rational& x) {
    return x.convert_to<double>();
}

// One axis of a ray in grid coordinates, in which cells lie between whole numbers.
struct Axis {
    Rational start;
    double approximate;  // start in double
    double run;
    int side;
    std::int64_t cell;

    Axis(double origin, double runValue, Surface surface)
        : start(origin), run(std::abs(runValue) < kSmallestRun ? 0 : runValue), side(run > 0 ? 1 : (run < 0 ? -1 : 0)) {
        if (surface == Surface::Bilinear) start -= Rational(1, 2);
        approximate = nearest(start);
        const Rational whole = wholePart(start);
        cell = whole.convert_to<std::int64_t>();
        if (side < 0 && whole == start) --cell;
    }

    // The grid line at which the ray leaves its cell.
    std::int64_t line() const { return side > 0 ? cell + 1 : cell; }
    double lambdaOfLine() const { return side == 0 ? kInfinity : (static_cast<double>(line()) - approximate) / run; }
    // Bound of the error of lambdaOfLine().
    double lambdaError() const {
        if (side == 0) return 0;
        const double lambda = lambdaOfLine();
        return kLineError *
               (std::abs(lambda) + (std::abs(approximate) + std::abs(static_cast<double>(line()))) / std::abs(run));
    }
    Rational exactLambdaOfLine() const { return (line() - start) / Rational(run); }
    Rational at(const Rational& lambda) const { return start + lambda * Rational(run); }

  private:
    static Rational wholePart(const Rational& x) {
        using boost::multiprecision::cpp_int;
        cpp_int quotient, rest;
        divide_qr(cpp_int(numerator(x)), cpp_int(denominator(x)), quotient, rest);
        if (rest < 0) --quotient;
        return Rational(quotient);
    }
};

// f(x) = constant + linear x + square x^2: the surface minus the ray at lambda = in + x.
struct Parabola {
    Rational constant, linear, square;

    Rational at(const Rational& x) const { return constant + x * (linear + x * square); }
};

class Walk {
  public:
    // shortest: columns only: passages that are shorter, texels, are taken for touches in a corner, which are no hits.
    Walk(const HeightField& field, const ViewRay& ray, double shortest = 0)
        : field_(field),
          bilinear_(field.surface() == Surface::Bilinear),
          shortest_(shortest / std::max(std::hypot(ray.a, ray.b), std::numeric_limits<double>::min())),
          x_(ray.s0, ray.a, field.surface()),
          y_(ray.t0, ray.b, field.surface()) {
        if (field.address() != Address::Border) return;
        const Rational s(ray.s0), t(ray.t0);
        if (s < 0 || s > field.width() || t < 0 || t > field.height()) outside_ = true;
        clip(s, x_.run, field.width());
        clip(t, y_.run, field.height());
    }

    std::optional<RationalHit> firstHit() {
        if (outside_) return answer_;
        for (std::int64_t cells = 0; cells < kRationalCells; ++cells) {
            const int sides = nextLine();
            if (!passesAbove()) {
                if (testCell(sides)) return answer_;
            }
            if (sides == 0) return answer_;
            advance(sides);
        }
        return std::nullopt;
    }

    Rational gapAt(const Rational& lambda) {
        while (true) {
            const int sides = nextLine();
            if (sides == 0 || lambda < exactOut(sides)) break;
            advance(sides);
        }
        return parabola(lambda).constant;
    }

  private:
    void clip(const Rational& origin, double run, int size) {
        if (run == 0) return;
        const Rational lambda = ((run > 0 ? Rational(size) : Rational(0)) - origin) / Rational(run);
        end_ = std::min(end_, lambda);
    }

    void advance(int sides) {
        if ((sides & 1) != 0) x_.cell += x_.side;
        if ((sides & 2) != 0) y_.cell += y_.side;
        inLines_ = sides;
    }

    // Returns through which lines the ray leaves the cell: 1: of x, 2: of y, 3: through a corner, 0: it ends before.
    int nextLine() {
        const double x = x_.lambdaOfLine();
        const double y = y_.lambdaOfLine();
        const double end = nearest(end_);
        const double error = x_.lambdaError() + y_.lambdaError() + kLineError;
        latestOut_ = std::min({x, y, end}) + error;
        const auto close = [error](double one, double two) { return std::abs(one - two) <= error; };
        if (!close(x, y) && !close(x, end) && !close(y, end)) return end < std::min(x, y) ? 0 : (x < y ? 1 : 2);
        // Infinite values are close to nothing but one another.
        const bool hasX = x_.side != 0, hasY = y_.side != 0;
        const Rational exactX = hasX ? x_.exactLambdaOfLine() : Rational(2);
        const Rational exactY = hasY ? y_.exactLambdaOfLine() : Rational(2);
        if (end_ <= std::min(exactX, exactY)) return 0;
        return (exactX <= exactY ? 1 : 0) | (exactY <= exactX ? 2 : 0);
    }
    Rational exactOut(int sides) const {
        if (sides == 0) return end_;
        return (sides & 1) != 0 ? x_.exactLambdaOfLine() : y_.exactLambdaOfLine();
    }
    // The lambda at which the ray entered its cell.
    Rational exactIn() const {
        if (inLines_ == 0) return 0;
        const Axis& axis = (inLines_ & 1) != 0 ? x_ : y_;
        return ((axis.side > 0 ? axis.cell : axis.cell + 1) - axis.start) / Rational(axis.run);
    }

    float texel(std::int64_t i, std::int64_t j) const { return field_.texel(i, j); }
    float highestNode() const {
        const std::int64_t i = x_.cell, j = y_.cell;
        return std::max({texel(i, j), texel(i + 1, j), texel(i, j + 1), texel(i + 1, j + 1)});
    }
    // Returns true if the ray certainly passes above the cell.
    bool passesAbove() const {
        const float top = bilinear_ ? highestNode() : texel(x_.cell, y_.cell);
        return static_cast<double>(top) < 1 - latestOut_ - kFree;
    }

    // The surface minus the ray in the current cell, from `in` on.
    Parabola parabola(const Rational& in) const {
        const Rational a(x_.run), b(y_.run);
        if (!bilinear_) return {Rational(texel(x_.cell, y_.cell)) - 1 + in, 1, 0};
        const Rational h00(texel(x_.cell, y_.cell));
        const Rational dx = texel(x_.cell + 1, y_.cell) - h00;
        const Rational dy = texel(x_.cell, y_.cell + 1) - h00;
        const Rational twist = texel(x_.cell + 1, y_.cell + 1) - h00 - dx - dy;
        const Rational u = x_.at(in) - x_.cell;
        const Rational v = y_.at(in) - y_.cell;
        return {h00 + dx * u + dy * v + twist * u * v - 1 + in, dx * a + dy * b + twist * (u * b + v * a) + 1,
                twist * a * b};
    }

    // Returns true if the ray hits the surface in its cell.
    bool testCell(int sides) {
        const Rational in = exactIn();
        const Rational out = exactOut(sides);
        const Rational length = out - in;
        if (length <= 0 && sides != 0) return false;
        if (!bilinear_ && nearest(length) < shortest_) return false;
        const Parabola f = parabola(in);
        if (f.constant >= 0) {
            if (inLines_ != 0) note(f.constant);
            return found(in);
        }
        const auto [top, place] = highest(f, length);
        const bool ends = place == length;
        // A ray that meets the surface just before a border may only touch it, or go on below it.
        const bool continues = bilinear_ && top >= 0 && ends && sides != 0;
        // At the bottom of the slab every surface is hit.
        if (!(ends && out == 1)) note(continues ? std::max(top, highestBehind(sides)) : top);
        if (top < 0) return false;
        Rational low = 0, high = place;
        for (int n = 0; n < kHalvings && low < high; ++n) {
            const Rational middle = (low + high) / 2;
            (f.at(middle) >= 0 ? high : low) = middle;
        }
        return found(in + high);
    }

    // The largest value of f over [0, length], and where it is.
    static std::pair<Rational, Rational> highest(const Parabola& f, const Rational& length) {
        std::pair<Rational, Rational> out{f.at(length), length};
        if (f.square < 0) {
            const Rational vertex = -f.linear / (2 * f.square);
            if (vertex > 0 && vertex < length) out = {f.at(vertex), vertex};
        }
        return out;
    }
    Rational highestBehind(int sides) const {
        Walk next = *this;
        next.advance(sides);
        const Rational in = next.exactIn();
        const Rational length = next.exactOut(next.nextLine()) - in;
        return highest(next.parabola(in), length).first;
    }

    bool found(const Rational& lambda) {
        answer_.hit = true;
        answer_.lambda = nearest(lambda);
        return true;
    }
    void note(const Rational& height) { answer_.clearance = std::min(answer_.clearance, std::abs(nearest(height))); }

    const HeightField& field_;
    bool bilinear_;
    double shortest_;  // lambda
    Axis x_, y_;
    bool outside_ = false;
    Rational end_ = 1;
    double latestOut_ = 0;  // upper bound of the lambda at which the ray leaves its cell
    int inLines_ = 0;
    RationalHit answer_;
};

// Returns true if the ray is within `height` of the bilinear surface from lambda to `other`.
bool liesOnSurface(const HeightField& field, const ViewRay& ray, double lambda, double other, double height) {
    if (field.surface() == Surface::Columns) return false;
    constexpr int kSamples = 8;
    for (int n = 1; n <= kSamples; ++n) {
        const double at = n == kSamples ? other : lambda + (other - lambda) * n / kSamples;
        if (std::abs(rationalGap(field, ray, at)) > height) return false;
    }
    return true;
}

// Returns true if a hit of columns is explained by corners: the ray certainly passes above all columns before it, and
// the column that it names is within `rounding`, texels, of the ray.
bool explainedByCorners(const HeightField& field, const ViewRay& ray, const Hit& hit, double rounding) {
    const auto certain = Walk(field, ray, 4 * rounding).firstHit();
    const double slack = kRationalTexels / std::max(1.0, std::hypot(ray.a, ray.b));
    if (!certain || (certain->hit && hit.lambda > certain->lambda + slack)) return false;
    const Hit place = Hit::at(ray, hit.lambda);
    for (int n = 0; n < 9; ++n) {
        const auto i = static_cast<std::int64_t>(std::floor(place.s + (n % 3 - 1) * 4 * rounding));
        const auto j = static_cast<std::int64_t>(std::floor(place.t + (n / 3 - 1) * 4 * rounding));
        if (static_cast<double>(field.texel(i, j)) >= 1 - hit.lambda - slack) return true;
    }
    return false;
}

}  // namespace

std::optional<RationalHit> rationalHit(const HeightField& field, const ViewRay& ray) {
    if (!ray.finite()) return std::nullopt;
    constexpr double kMostTexels = static_cast<double>(kRationalCells) / 2;
    if (!(std::abs(ray.a) + std::abs(ray.b) < kMostTexels)) return std::nullopt;
    // Cells are counted in 64-bit integers.
    constexpr double kFarthest = 0x1p60;
    if (!(std::abs(ray.s0) < kFarthest && std::abs(ray.t0) < kFarthest)) return std::nullopt;
    return Walk(field, ray).firstHit();
}

double rationalGap(const HeightField& field, const ViewRay& ray, double lambda) {
    return nearest(Walk(field, ray).gapAt(Rational(lambda)));
}

double placeRounding(const HeightField& field, const ViewRay& ray) {
    // Some roundings of positions that are at most this large, texels.
    constexpr double kRoundings = 8 * 0x1p-53;
    return kRoundings * (field.width() + field.height() + std::abs(ray.a) + std::abs(ray.b));
}

RationalVerdict judgeHit(const HeightField& field, const ViewRay& ray, const Hit& hit, const RationalHit& exact) {
    const bool answered = hit.outcome == Outcome::Hit;
    const double scale = std::max(1.0, std::hypot(ray.a, ray.b));
    const auto same = [&](const RationalHit& truth) {
        if (answered != truth.hit) return false;
        return !answered || std::abs(hit.lambda - truth.lambda) * scale <= kRationalTexels;
    };
    if (same(exact)) return RationalVerdict::Same;
    // A surface of heights in [0, 1] rises by at most 1 per texel on each axis.
    const double rounding = placeRounding(field, ray);
    if (exact.clearance <= 2 * rounding) return RationalVerdict::Rounding;
    // Near a tangency the place is uncertain, although it is certain that there is a hit.
    if (answered && exact.hit && liesOnSurface(field, ray, exact.lambda, hit.lambda, 2 * rounding)) {
        return RationalVerdict::Rounding;
    }
    // At walls and at the border of the picture, the ray may start on the other side.
    for (int n = 0; n < 9; ++n) {
        ViewRay shifted = ray;
        shifted.s0 += (n % 3 - 1) * rounding;
        shifted.t0 += (n / 3 - 1) * rounding;
        const auto truth = rationalHit(field, shifted);
        if (truth && same(*truth)) return RationalVerdict::Rounding;
    }
    // At each corner it may pass on another side.
    const bool corners = field.surface() == Surface::Columns && answered && exact.hit;
    return corners && explainedByCorners(field, ray, hit, rounding) ? RationalVerdict::Rounding
                                                                    : RationalVerdict::Wrong;
}

}  // namespace relief
