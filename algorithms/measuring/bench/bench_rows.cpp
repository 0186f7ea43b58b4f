#include "measuring/bench/bench_rows.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>

#include "mapping/rows/derivatives.h"
#include "mapping/rows/row_lanes.h"
#include "mapping/rows/row_planner.h"
#include "measuring/quantiles.h"

namespace relief {

namespace {

using Clock = std::chrono::steady_clock;

// Number of pixels whose errors are measured: whole rows distributed over the block.
constexpr std::int64_t kErrorPixels = 1 << 18;
constexpr std::int64_t kFewestErrorRows = 3;
constexpr std::uint64_t kOrderSeed = 1;

struct WallView {
    double focal, principal;     // pixels, horizontal
    double nearDepth, farDepth;  // wall widths
};
WallView wallView(double width, double elevation) {
    const double angle = elevation * std::numbers::pi / 180;
    const double nearDepth = kWallDistance - 0.5 * std::cos(angle);
    const double farDepth = kWallDistance + 0.5 * std::cos(angle);
    const double nearAt = -0.5 * std::sin(angle) / nearDepth;
    const double farAt = 0.5 * std::sin(angle) / farDepth;
    const double focal = width / (farAt - nearAt);
    return {focal, -focal * nearAt, nearDepth, farDepth};
}

// A row variant prepared for a block: span and anchor are planned.
template <typename T>
struct Ready {
    const RowMethod* method;
    RowBenchRow row;
    std::optional<RowOptions> options;  // set for row variants only
    std::optional<DerivativeVariant> derivative;
};

template <typename T>
class Block {
  public:
    Block(const RowBenchOptions& options, std::int64_t width, double elevation, Work& work)
        : options_(options),
          work_(work),
          width_(width),
          rows_(rowsOf(options, width)),
          times_(std::max<std::int64_t>(options.pixels / (width * rows_), 1)),
          map_(obliqueWall(options.texels, width, elevation)),
          block_(wallRows(width, rows_, elevation)),
          cached_(width, rows_),
          pastCache_(width, rows_),
          terms_(derivativeTerms<T>(map_)) {
        for (auto* plane : {&a_, &b_, &c_, &f_}) plane->resize(static_cast<std::size_t>(width));
        for (const RowMethod& method : options.methods) ready_.push_back(make(method, elevation));
    }

    std::size_t size() const { return ready_.size(); }
    RowBenchRow& row(std::size_t i) { return ready_[i].row; }

    // Returns pixels per second.
    double rate(std::size_t i) {
        const auto begun = Clock::now();
        for (std::int64_t n = 0; n < times_; ++n) run(ready_[i]);
        const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
        return static_cast<double>(width_ * rows_ * times_) / std::max(seconds, 1e-9);
    }

    void count(std::size_t i) {
        Ready<T>& ready = ready_[i];
        ready.row.counts = pixelCounts(*ready.method, ready.options ? ready.options->span : 1, ready.row.anchor);
        ready.row.errorMax = ready.options      ? coordinateError(*ready.options)
                             : ready.derivative ? extentError(*ready.derivative)
                                                : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    static std::int64_t rowsOf(const RowBenchOptions& options, std::int64_t width) {
        const std::int64_t most = std::max<std::int64_t>(options.pixels / width, 1);
        return options.rows > 0 ? std::min(options.rows, most) : most;
    }

    double lineOf(std::int64_t r) const { return block_.firstY + static_cast<double>(r) * block_.stepY; }

    Ready<T> make(const RowMethod& method, double elevation) const {
        Ready<T> ready{&method, {}, {}, {}};
        RowBenchRow& row = ready.row;
        row.variant = method.description->name;
        row.width = width_;
        row.rows = rows_;
        row.elevation = elevation;
        row.precision = sizeof(T) == sizeof(float) ? RowPrecision::Float : RowPrecision::Double;
        if (const auto* derivative = std::get_if<DerivativeVariant>(&method.description->kind)) {
            ready.derivative = *derivative;
            if (*derivative == DerivativeVariant::Iterative) row.anchor = derivativeAnchor();
            return ready;
        }
        if (std::holds_alternative<RowFill>(method.description->kind)) return ready;
        ready.options = method.options();
        const RowVariant variant = ready.options->variant;
        if (method.settings.error > 0) ready.options->span = plannedSpan(method.settings.error);
        if (variant == RowVariant::Streams || variant == RowVariant::RowsParallel)
            row.streams = method.settings.streams;
        if (variant == RowVariant::Opposed) row.streams = 2;
        if (variant == RowVariant::Subspan) row.span = ready.options->span;
        if (variant == RowVariant::Affine) row.span = width_;
        if (variant == RowVariant::RowsParallel) row.threads = work_.threads().size();
        // Apart from the influence of v on the largest coordinate, the anchor is equal on all rows of the wall; the
        // middle row's is reported.
        row.anchor = planRow<T>(map_, lineOf(rows_ / 2), {0, width_}, *ready.options).anchor;
        return ready;
    }

    int plannedSpan(double error) const {
        std::int64_t span = width_;
        for (const std::int64_t r : {std::int64_t{0}, rows_ / 2, rows_ - 1}) {
            span = std::min(span, longestSpan(map_, lineOf(r), {0, width_}, error));
        }
        return static_cast<int>(std::min<std::int64_t>(span, kLongestSpan));
    }
    // The anchor is that of coordinates evaluated with steps of one pixel, for the whole texture.
    std::int64_t derivativeAnchor() const {
        const RowOptions one{RowVariant::IncrementalShared};
        const std::int64_t anchor = planRow<T>(map_, lineOf(rows_ / 2), {0, width_}, one).anchor;
        return anchor;
    }

    void run(const Ready<T>& ready) {
        if (ready.derivative) return derivatives(*ready.derivative, ready.row.anchor);
        if (ready.options) {
            const bool lanes = ready.row.streams > 2 && hasStreamLanes(ready.row.streams);
            return evaluateRows(map_, block_, *ready.options, lanes ? pastCache_ : cached_, work_);
        }
        for (std::int64_t r = 0; r < rows_; ++r) {
            fillPastCache(pastCache_.u(r), width_, T(1));
            fillPastCache(pastCache_.v(r), width_, T(1));
        }
        finishStores();
    }

    // All rows are written to the same four arrays, as a filter would use them; the time includes making the caches.
    void derivatives(DerivativeVariant variant, std::int64_t anchor) {
        const EllipseRow<T> to{a_.data(), b_.data(), c_.data(), f_.data()};
        if (variant == DerivativeVariant::Cached) {
            const EllipseCaches<T> caches(terms_, {0, width_}, {0, rows_});
            for (std::int64_t r = 0; r < rows_; ++r) caches.ellipses(0, r, width_, to);
            return;
        }
        for (std::int64_t r = 0; r < rows_; ++r) {
            const T y = centreOf<T>(r);
            if (variant == DerivativeVariant::Direct) {
                directEllipses(terms_, 0, y, width_, to);
            } else {
                iterativeEllipses(terms_, 0, y, width_, anchor, to);
            }
        }
    }

    template <typename Visit>
    void forErrorRows(const Visit& visit) {
        const std::int64_t rows = std::clamp<std::int64_t>(kErrorPixels / width_, kFewestErrorRows, rows_ + 2);
        for (std::int64_t k = 0; k < rows; ++k) {
            work_.throwIfStopped();
            visit(rows > 1 ? k * (rows_ - 1) / (rows - 1) : 0);
        }
    }

    double coordinateError(const RowOptions& options) {
        double worst = 0;
        forErrorRows([&](std::int64_t r) {
            const double y = lineOf(r);
            T* u = cached_.u(0);
            T* v = cached_.v(0);
            const PixelSpan valid = evaluateRow(map_, y, {0, width_}, options, u, v);
            const long double wu = map_.sy * static_cast<long double>(y) + map_.s1;
            const long double wv = map_.ty * static_cast<long double>(y) + map_.t1;
            const long double wq = map_.qy * static_cast<long double>(y) + map_.q1;
            for (std::int64_t i = valid.begin; i < valid.end; ++i) {
                const long double x = static_cast<long double>(i) + 0.5L;
                const long double part = 1 / (map_.qx * x + wq);
                const long double du = static_cast<long double>(u[i]) - (map_.sx * x + wu) * part;
                const long double dv = static_cast<long double>(v[i]) - (map_.tx * x + wv) * part;
                worst = std::max(worst, static_cast<double>(std::max(std::abs(du), std::abs(dv))));
            }
        });
        return worst;
    }

    double extentError(DerivativeVariant variant) {
        const EllipseRow<T> to{a_.data(), b_.data(), c_.data(), f_.data()};
        const std::int64_t anchor = variant == DerivativeVariant::Iterative ? derivativeAnchor() : 0;
        double worst = 0;
        forErrorRows([&](std::int64_t r) {
            const T y = centreOf<T>(r);
            if (variant == DerivativeVariant::Direct) directEllipses(terms_, 0, y, width_, to);
            if (variant == DerivativeVariant::Iterative) iterativeEllipses(terms_, 0, y, width_, anchor, to);
            std::optional<EllipseCaches<T>> caches;
            if (variant == DerivativeVariant::Cached) caches.emplace(terms_, PixelSpan{0, width_}, PixelSpan{r, r + 1});
            for (std::int64_t i = 0; i < width_; ++i) {
                const HalfExtents<T> found = caches ? caches->at(i, r).halfExtents(T(1)) : to.at(i).halfExtents(T(1));
                const Jacobian j = jacobianAt(map_, static_cast<double>(i) + 0.5, static_cast<double>(r) + 0.5);
                worst = std::max({worst, std::abs(static_cast<double>(found.u) - std::hypot(j.ux, j.uy)),
                                  std::abs(static_cast<double>(found.v) - std::hypot(j.vx, j.vy))});
            }
        });
        return worst;
    }

    const RowBenchOptions& options_;
    Work& work_;
    std::int64_t width_, rows_, times_;
    Homography map_;
    RowBlock block_;
    // Separate buffers, so that non-temporal stores do not meet lines that other variants left in the cache.
    TexelRows<T> cached_, pastCache_;
    DerivativeTerms<T> terms_;
    std::vector<T> a_, b_, c_, f_;
    std::vector<Ready<T>> ready_;
};

template <typename T>
void benchBlock(const RowBenchOptions& options, std::int64_t width, double elevation, Work& work,
                std::vector<RowBenchRow>& rows) {
    Block<T> block(options, width, elevation, work);
    std::vector<std::vector<double>> rates(block.size());
    for (std::size_t i = 0; i < block.size(); ++i) {
        if (options.pass != BenchPass::Times) block.count(i);
        work.progress().advance();
    }
    const int rounds = options.pass == BenchPass::Counts ? -1 : options.rounds;
    // The first round warms up. Every round has its own random order, so that no variant always runs after the same
    // one.
    std::vector<std::size_t> order(block.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937_64 engine(kOrderSeed);
    for (int round = -1; round < rounds; ++round) {
        std::shuffle(order.begin(), order.end(), engine);
        for (const std::size_t i : order) {
            work.throwIfStopped();
            const double rate = block.rate(i);
            if (round >= 0) rates[i].push_back(rate);
            work.progress().advance();
        }
    }
    for (std::size_t i = 0; i < block.size(); ++i) {
        RowBenchRow& row = block.row(i);
        if (!rates[i].empty()) {
            row.rate = quantile(rates[i], 0.5);
            row.spread = relativeSpread(rates[i]);
        }
        if (options.onRow) options.onRow(row);
        rows.push_back(row);
    }
}

}  // namespace

Homography obliqueWall(double texels, std::int64_t width, double elevation) {
    const WallView view = wallView(static_cast<double>(width), elevation);
    const double angle = elevation * std::numbers::pi / 180;
    PinholeCamera camera;  // at the origin, looking along -z, x to the right
    camera.focal = {view.focal, view.focal};
    camera.principal = {view.principal, 0};
    TexturedPlane wall;
    // The wall runs from the near edge on the left to the far edge on the right; its middle row is at the height of the
    // eye.
    wall.perS = glm::dvec3(std::sin(angle), 0, -std::cos(angle)) / texels;
    wall.perT = glm::dvec3(0, -1, 0) / texels;
    wall.origin = glm::dvec3(-0.5 * std::sin(angle), 0.5, -view.nearDepth);
    return fromCameraAndPlane(camera, wall);
}

RowBlock wallRows(std::int64_t width, std::int64_t rows, double elevation) {
    const WallView view = wallView(static_cast<double>(width), elevation);
    const double height = view.focal / view.farDepth;  // pixels, of the far edge, whose middle is at y = 0
    const double step = height / static_cast<double>(rows);
    return {width, rows, 0.5 * (step - height), step};
}

std::vector<RowBenchRow> benchRows(const RowBenchOptions& options, Work& work) {
    const std::size_t cells =
        options.widths.size() * options.elevations.size() * options.precisions.size() * options.methods.size();
    work.progress().begin("bench", static_cast<std::int64_t>(cells) * (options.rounds + 2));
    std::vector<RowBenchRow> rows;
    for (const std::int64_t width : options.widths) {
        for (const double elevation : options.elevations) {
            for (const RowPrecision precision : options.precisions) {
                if (precision == RowPrecision::Float) {
                    benchBlock<float>(options, width, elevation, work, rows);
                } else {
                    benchBlock<double>(options, width, elevation, work, rows);
                }
            }
        }
    }
    return rows;
}

}  // namespace relief
