#include "filtering/ellipse_rows.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "mapping/rows/derivatives.h"

namespace relief {

namespace {

using FloatJacobian = JacobianOf<float>;

// Smallest F / (A C): below it the two rows of the Jacobian are so nearly parallel that float may lose three digits of
// F.
constexpr float kThinnest = 0x1p-24F;

// Written so that NaN is not usable.
bool usable(const FloatJacobian& j) {
    const EllipseOf<float> e = ellipseOf(j);
    return e.f >= std::numeric_limits<float>::min() && e.f >= kThinnest * (e.a * e.c) &&
           e.a * e.c <= std::numeric_limits<float>::max();
}

FloatJacobian triangular(const ScaledEllipse<float>& e) {
    const bool first = e.c >= e.a;
    const float root = std::sqrt(first ? e.c : e.a);
    const float longer = root / e.square, mixed = -0.5F * e.b / (root * e.square), shorter = std::sqrt(e.f) / root;
    return first ? FloatJacobian{longer, mixed, 0, shorter} : FloatJacobian{shorter, 0, mixed, longer};
}

// Pixels [first, last) of a block that are neighbours in a row of one view.
struct Run {
    std::size_t first, last;
};

std::vector<Run> runsOf(const FilterBlock& block) {
    std::vector<Run> runs;
    const std::size_t count = block.size();
    for (std::size_t first = 0, last = 0; first < count; first = last) {
        for (last = first + 1; last < count && block.view[last] == block.view[first] &&
                               block.y[last] == block.y[first] && block.x[last] == block.x[last - 1] + 1;) {
            ++last;
        }
        runs.push_back({first, last});
    }
    std::stable_sort(runs.begin(), runs.end(), [&](const Run& a, const Run& b) {
        return std::less<>()(block.view[a.first], block.view[b.first]);
    });
    return runs;
}

class EllipseRows {
  public:
    EllipseRows(const FilterBlock& block, FilterBlock& out) : block_(block), out_(out) {}

    void iterative(const Run& run, const DerivativeTerms<float>& terms) {
        static_assert((kEllipseAnchor & (kEllipseAnchor - 1)) == 0);
        const std::int64_t x = block_.x[run.first], before = x & (kEllipseAnchor - 1);
        iterativeDerivatives(terms, x - before, centreOf<float>(block_.y[run.first]),
                             before + static_cast<std::int64_t>(run.last - run.first), kEllipseAnchor,
                             [&](std::int64_t n, const FloatJacobian& j) {
                                 if (n >= before) put(run.first + static_cast<std::size_t>(n - before), j);
                             });
    }
    void cached(const Run& run, const EllipseCaches<float>& caches) {
        for (std::size_t i = run.first; i < run.last; ++i) put(i, triangular(caches.at(block_.x[i], block_.y[i])));
    }

    void direct(std::size_t i) {
        out_.ux[i] = block_.ux[i], out_.vx[i] = block_.vx[i], out_.uy[i] = block_.uy[i], out_.vy[i] = block_.vy[i];
    }

  private:
    void put(std::size_t i, const FloatJacobian& j) {
        if (!usable(j)) return direct(i);
        const double scale = 1 + block_.lambda[i] * block_.spread[i];
        out_.ux[i] = j.ux * scale, out_.vx[i] = j.vx * scale, out_.uy[i] = j.uy * scale, out_.vy[i] = j.vy * scale;
    }

    const FilterBlock& block_;
    FilterBlock& out_;
};

EllipseCaches<float> cachesOf(const FilterBlock& block, std::span<const Run> runs,
                              const DerivativeTerms<float>& terms) {
    const std::int64_t x = block.x[runs.front().first], y = block.y[runs.front().first];
    PixelSpan columns{x, x}, rows{y, y};
    for (const Run& run : runs) {
        columns.begin = std::min<std::int64_t>(columns.begin, block.x[run.first]);
        columns.end = std::max<std::int64_t>(columns.end, block.x[run.last - 1] + std::int64_t{1});
        rows.begin = std::min<std::int64_t>(rows.begin, block.y[run.first]);
        rows.end = std::max<std::int64_t>(rows.end, block.y[run.first] + std::int64_t{1});
    }
    return {terms, columns, rows};
}

}  // namespace

void ellipseRows(EllipseForm form, const FilterBlock& block, FilterBlock& out) {
    assert(form != EllipseForm::Direct);
    out.picture = nullptr;
    out.resize(block.size());
    out.s = block.s, out.t = block.t;
    const std::vector<Run> runs = runsOf(block);
    EllipseRows rows(block, out);
    for (auto begin = runs.begin(), end = begin; begin != runs.end(); begin = end) {
        const PixelView* view = block.view[begin->first];
        end = std::find_if(begin, runs.end(), [&](const Run& run) { return block.view[run.first] != view; });
        if (view == nullptr) {
            for (auto run = begin; run != end; ++run) {
                for (std::size_t i = run->first; i < run->last; ++i) rows.direct(i);
            }
            continue;
        }
        const auto terms = derivativeTerms<float>(view->texelFromScreen);
        const std::span<const Run> here(begin, end);
        if (form == EllipseForm::Iterative) {
            for (const Run& run : here) rows.iterative(run, terms);
        } else {
            const EllipseCaches<float> caches = cachesOf(block, here, terms);
            for (const Run& run : here) rows.cached(run, caches);
        }
    }
}

double largestAxisDifference(const FilterBlock& of, const FilterBlock& from) {
    double most = 0;
    for (std::size_t i = 0; i < of.size(); ++i) {
        const SemiAxes<double> a = ellipseOf(of[i].jacobian).semiAxes(), b = ellipseOf(from[i].jacobian).semiAxes();
        // Zero axes and NaN always come from the direct form, so they are not compared.
        if (b.major > 0) most = std::max(most, std::abs(a.major / b.major - 1));
        if (b.minor > 0) most = std::max(most, std::abs(a.minor / b.minor - 1));
    }
    return most;
}

}  // namespace relief
