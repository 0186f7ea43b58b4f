#include "relief/maps/lower_envelope.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "relief/maps/window_lanes.h"

namespace relief {

namespace {

// Samples to one side above which windows may take longer than parabolas line by line.
constexpr int kWidest = 1024;

std::size_t toSize(int at) {
    return static_cast<std::size_t>(at);
}
int padded(int n) {
    return (n + kWindowPad - 1) / kWindowPad * kWindowPad;
}

// One axis: number of samples, and the cost of a sample by its distance. d2: squared spacing; gaps: distances are gaps
// between unit boxes.
struct EnvelopeAxis {
    int n;
    bool wraps;
    float d2;
    bool gaps;

    // Largest distance, in samples, that can matter.
    int farthest() const { return wraps ? n / 2 + 1 : n - 1; }
    // The sample with index k, which is at most one period outside. Without periods the nearest sample, which costs
    // more here than at its own index.
    int sample(int k) const {
        if (!wraps) return std::clamp(k, 0, n - 1);
        return ((k % n) + n) % n;
    }
    float step(int away) const {
        const auto distance = static_cast<float>(gaps ? std::max(away - 1, 0) : away);
        return distance * distance * d2;
    }
    // Distance up to which a sample with the value `least` can matter where a sample has the value `most`.
    int reach(float least, float most) const {
        const double distance =
            std::sqrt(std::max(0.0, static_cast<double>(most) - static_cast<double>(least)) / static_cast<double>(d2));
        return static_cast<int>(std::min<double>(farthest(), std::ceil(distance) + 2));
    }
};

// Writes to s.out the lower envelope of the parabolas line[q] + ((x - q) d)^2 at all x.
void envelope(const std::vector<float>& line, float d2, EnvelopeScratch& s) {
    const int n = static_cast<int>(line.size());
    s.out.resize(line.size());
    s.apex.resize(line.size());
    s.border.resize(line.size() + 1);
    const auto at = [&](int q) { return line[toSize(q)]; };
    const auto crossing = [&](int p, int q) {
        // In double: in float, rounding would choose the wrong parabola near a crossing, with a larger error than that
        // of the sum.
        const double rise = static_cast<double>(at(q)) - static_cast<double>(at(p));
        return 0.5 * (rise / (static_cast<double>(d2) * (q - p)) + (q + p));
    };
    int last = 0;
    s.apex[0] = 0;
    s.border[0] = -std::numeric_limits<double>::infinity();
    for (int q = 1; q < n; ++q) {
        double x = crossing(s.apex[toSize(last)], q);
        while (last > 0 && x <= s.border[toSize(last)]) {
            --last;
            x = crossing(s.apex[toSize(last)], q);
        }
        ++last;
        s.apex[toSize(last)] = q;
        s.border[toSize(last)] = x;
    }
    int k = 0;
    for (int x = 0; x < n; ++x) {
        while (k < last && s.border[toSize(k) + 1] < x) ++k;
        const int q = s.apex[toSize(k)];
        const auto away = static_cast<float>(x - q);
        s.out[toSize(x)] = away * away * d2 + at(q);
    }
}

void dilate(std::vector<float>& line) {
    float before = line.front();
    for (std::size_t i = 0; i < line.size(); ++i) {
        const float here = line[i];
        const float after = i + 1 < line.size() ? line[i + 1] : here;
        line[i] = std::min({before, here, after});
        before = here;
    }
}

// Computes data[i * stride] in linear time. Dilation by one sample turns distances of centres into gaps of boxes.
// Periodic lines are extended by half a period on each side.
void byParabolas(const EnvelopeAxis& axis, float* data, std::ptrdiff_t stride, EnvelopeScratch& s) {
    const int margin = axis.wraps ? axis.farthest() : 0;
    s.line.resize(toSize(axis.n + 2 * margin));
    for (int i = -margin; i < axis.n + margin; ++i) s.line[toSize(i + margin)] = data[axis.sample(i) * stride];
    if (axis.gaps) dilate(s.line);
    envelope(s.line, axis.d2, s);
    for (int i = 0; i < axis.n; ++i) data[i * stride] = s.out[toSize(i + margin)];
}

void setSteps(const EnvelopeAxis& axis, EnvelopeScratch& s) {
    s.steps.resize(toSize(axis.farthest()) + 1);
    for (int away = 0; away <= axis.farthest(); ++away) s.steps[toSize(away)] = axis.step(away);
}

void alongRow(const EnvelopeAxis& axis, const float* from, float* to, EnvelopeScratch& s) {
    const auto [least, most] = extremesOf(from, axis.n);
    const int reach = axis.reach(least, most);
    if (reach > kWidest) {
        std::copy(from, from + axis.n, to);
        byParabolas(axis, to, 1, s);
        return;
    }
    s.line.assign(toSize(padded(axis.n) + 2 * reach), 0);
    for (int i = -reach; i < 0; ++i) s.line[toSize(i + reach)] = from[axis.sample(i)];
    std::copy(from, from + axis.n, s.line.begin() + reach);
    for (int i = axis.n; i < axis.n + reach; ++i) s.line[toSize(i + reach)] = from[axis.sample(i)];
    s.rows.resize(toSize(2 * reach + 1));
    for (int o = 0; o <= 2 * reach; ++o) s.rows[toSize(o)] = s.line.data() + o;
    s.floor.assign(toSize(padded(axis.n)), least);
    leastOverWindows(s.rows.data() + reach, s.steps.data(), reach, s.floor.data(), axis.n, to);
}

// From the rows of s.plane into f.
void downColumns(const EnvelopeAxis& axis, int stride, FloatImage& f, EnvelopeScratch& s) {
    const auto row = [&](int y) { return s.plane.data() + toSize(y) * toSize(stride); };
    s.floor.assign(row(0), row(0) + stride);
    s.out.assign(row(0), row(0) + stride);
    for (int y = 1; y < axis.n; ++y) {
        const float* from = row(y);
        for (std::size_t x = 0; x < toSize(stride); ++x) {
            s.floor[x] = std::min(s.floor[x], from[x]);
            s.out[x] = std::max(s.out[x], from[x]);
        }
    }
    int reach = 0;
    for (int x = 0; x < f.width(); ++x) reach = std::max(reach, axis.reach(s.floor[toSize(x)], s.out[toSize(x)]));
    if (reach > kWidest) {
        for (int x = 0; x < f.width(); ++x) byParabolas(axis, row(0) + x, stride, s);
        for (int y = 0; y < axis.n; ++y) std::copy(row(y), row(y) + f.width(), f.row(y).begin());
        return;
    }
    s.rows.resize(toSize(axis.n + 2 * reach));
    for (int k = -reach; k < axis.n + reach; ++k) s.rows[toSize(k + reach)] = row(axis.sample(k));
    for (int y = 0; y < axis.n; ++y) {
        leastOverWindows(s.rows.data() + y + reach, s.steps.data(), reach, s.floor.data(), f.width(), s.out.data());
        std::copy(s.out.begin(), s.out.begin() + f.width(), f.row(y).begin());
    }
}

void overBothAxes(FloatImage& f, const EnvelopeAxis& x, const EnvelopeAxis& y, EnvelopeScratch& s) {
    const int stride = padded(f.width());
    s.plane.assign(toSize(stride) * toSize(f.height()), 0);
    setSteps(x, s);
    for (int n = 0; n < f.height(); ++n) alongRow(x, f.row(n).data(), s.plane.data() + toSize(n) * toSize(stride), s);
    setSteps(y, s);
    downColumns(y, stride, f, s);
}

}  // namespace

void envelope2D(FloatImage& f, double dx, double dy, bool wraps, EnvelopeScratch& scratch) {
    overBothAxes(f, {f.width(), wraps, static_cast<float>(dx * dx), false},
                 {f.height(), wraps, static_cast<float>(dy * dy), false}, scratch);
}

void gapEnvelope2D(FloatImage& f, bool wraps, EnvelopeScratch& scratch) {
    overBothAxes(f, {f.width(), wraps, 1.0F, true}, {f.height(), wraps, 1.0F, true}, scratch);
}

}  // namespace relief
