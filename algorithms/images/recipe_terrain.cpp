// The recipes whose heights depend on the lowest and highest of all: fractal, hills, steps. See reliefs.cpp.
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <mutex>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/parallel.h"
#include "images/recipe_parts.h"
#include "relief/messages.h"

namespace relief {

namespace {

// Numbers of which the lowest becomes 0 and the highest 1; if all are equal they become 0.5.
class Stretched : public RecipeRows {
  public:
    int passes() const override { return 2; }
    void prepare(Work& work, const std::function<void()>& rowDone) override {
        std::mutex mutex;
        low_ = std::numeric_limits<double>::infinity();
        high_ = -low_;
        parallelRanges(work, canvas_.height, 1, [&](int first, int last) {
            std::vector<double> row(static_cast<std::size_t>(canvas_.width));
            for (int y = first; y < last; ++y) {
                std::fill(row.begin(), row.end(), 0.0);
                numbers(y, row.data());
                const auto [low, high] = std::minmax_element(row.begin(), row.end());
                const std::lock_guard lock(mutex);
                low_ = std::min(low_, *low);
                high_ = std::max(high_, *high);
                rowDone();
            }
        });
    }
    std::string learned() const override {
        return nlohmann::json{{"low", numberText(low_)}, {"high", numberText(high_)}}.dump();
    }
    void restore(const std::string& learned) override {
        const auto json = nlohmann::json::parse(learned);
        for (const auto& [name, value] : {std::pair("low", &low_), std::pair("high", &high_)}) {
            const std::string text = json.at(name).get<std::string>();
            std::from_chars(text.data(), text.data() + text.size(), *value);
        }
    }
    void row(int y, float* out) const override {
        std::vector<double> row(static_cast<std::size_t>(canvas_.width));
        numbers(y, row.data());
        const double span = high_ - low_;
        for (std::size_t x = 0; x < row.size(); ++x) out[x] = height(span > 0 ? (row[x] - low_) / span : 0.5);
    }

  protected:
    explicit Stretched(const Canvas& canvas) : canvas_(canvas) {}
    // Adds the numbers of a row to zeros.
    virtual void numbers(int y, double* row) const = 0;
    Canvas canvas_;

  private:
    double low_ = 0, high_ = 0;
};

// Position of texel i between the nodes of a periodic lattice.
struct LatticePoint {
    int node;
    int next;
    double weight;  // of `next`, after smoothing
};

std::vector<LatticePoint> latticePoints(int size, int cells) {
    std::vector<LatticePoint> points(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
        const int node = cellOf(i, cells, size);
        const double f = static_cast<double>(static_cast<std::int64_t>(i) * cells % size) / size;
        points[static_cast<std::size_t>(i)] = {node, (node + 1) % cells, f * f * (3 - 2 * f)};
    }
    return points;
}

class Fractal final : public Stretched {
  public:
    explicit Fractal(const Canvas& canvas) : Stretched(canvas) {
        double amplitude = 1;
        // The longer side gets proportionally more cells.
        for (std::int64_t cells = 4; cells == 4 || cells * 2 <= canvas.side(); cells *= 2, amplitude *= 0.6) {
            const auto along = [&](int size) {
                const std::int64_t count = (cells * size + canvas.side() / 2) / canvas.side();
                return static_cast<int>(std::clamp<std::int64_t>(count, 1, size));
            };
            octaves_.push_back({along(canvas.width), latticePoints(canvas.width, along(canvas.width)),
                                latticePoints(canvas.height, along(canvas.height)), amplitude,
                                Chance(canvas.seed, 100 + static_cast<std::uint64_t>(cells))});
        }
    }

  private:
    struct Octave {
        int cellsAcross;
        std::vector<LatticePoint> across, down;
        double amplitude;
        Chance chance;
    };

    void numbers(int y, double* row) const override {
        std::vector<double> nodes;
        for (const Octave& octave : octaves_) {
            const LatticePoint& py = octave.down[static_cast<std::size_t>(y)];
            nodes.resize(static_cast<std::size_t>(octave.cellsAcross));
            for (int i = 0; i < octave.cellsAcross; ++i) {
                const double upper = octave.chance.at(i, py.node);
                nodes[static_cast<std::size_t>(i)] = upper + (octave.chance.at(i, py.next) - upper) * py.weight;
            }
            for (std::size_t x = 0; x < octave.across.size(); ++x) {
                const LatticePoint& px = octave.across[x];
                const double left = nodes[static_cast<std::size_t>(px.node)];
                const double right = nodes[static_cast<std::size_t>(px.next)];
                row[x] += octave.amplitude * (left + (right - left) * px.weight);
            }
        }
    }

    std::vector<Octave> octaves_;
};

// sin(2 pi turns) for turns >= 0, within 1e-6. A polynomial, so that the bits are the same on every platform.
double sineOfTurns(double turns) {
    double q = (turns - std::floor(turns)) * 4;  // quarters, [0, 4)
    if (q > 3)
        q -= 4;
    else if (q > 1)
        q = 2 - q;
    const double x = q * 1.5707963267948966;
    const double s = x * x;
    return x * (1 + s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 - s / 39916800)))));
}

class Hills : public Stretched {
  public:
    explicit Hills(const Canvas& canvas) : Stretched(canvas) {
        const Chance chance(canvas.seed, 7);
        for (int wave = 0; wave < static_cast<int>(waves_.size()); ++wave) {
            // The first two waves run along the axes, so that heights vary in both directions.
            const int kx = wave == 1 ? 0 : wave == 0 ? 1 : chance.whole(1, 3, wave, 0);
            const int ky = wave == 0 ? 0 : wave == 1 ? 1 : chance.whole(-3, 3, wave, 1);
            const double phase = chance.at(wave, 2) + 8;  // keeps the argument positive
            waves_[static_cast<std::size_t>(wave)] = {kx, ky, phase, chance.between(0.4, 1, wave, 3)};
        }
    }

  private:
    struct Wave {
        int kx, ky;
        double phase, amplitude;
    };

    void numbers(int y, double* row) const override {
        for (const Wave& wave : waves_) {
            for (int x = 0; x < canvas_.width; ++x) {
                const double turns = static_cast<double>(static_cast<std::int64_t>(wave.kx) * x) / canvas_.width +
                                     static_cast<double>(static_cast<std::int64_t>(wave.ky) * y) / canvas_.height;
                row[x] += wave.amplitude * sineOfTurns(turns + wave.phase);
            }
        }
    }

    std::array<Wave, 6> waves_{};
};

class Steps final : public Hills {
  public:
    using Hills::Hills;
    void row(int y, float* out) const override {
        Hills::row(y, out);
        for (int x = 0; x < canvas_.width; ++x)
            out[x] = height(std::min(7.0, std::floor(static_cast<double>(out[x]) * 8)) / 7);
    }
};

}  // namespace

std::unique_ptr<RecipeRows> makeFractal(const Canvas& canvas) {
    return std::make_unique<Fractal>(canvas);
}

std::unique_ptr<RecipeRows> makeHills(const Canvas& canvas) {
    return std::make_unique<Hills>(canvas);
}

std::unique_ptr<RecipeRows> makeSteps(const Canvas& canvas) {
    return std::make_unique<Steps>(canvas);
}

}  // namespace relief
