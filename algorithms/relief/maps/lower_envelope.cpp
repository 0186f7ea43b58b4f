#include "relief/maps/lower_envelope.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace relief {

namespace {

// The lower envelope of the parabolas line[q] + ((x - q) d)^2 at all x, into out.
void envelope(const std::vector<float>& line, float d2, EnvelopeScratch& s) {
    const int n = static_cast<int>(line.size());
    s.out.resize(line.size());
    s.apex.resize(line.size());
    s.border.resize(line.size() + 1);
    const auto at = [&](int q) { return line[static_cast<std::size_t>(q)]; };
    const auto crossing = [&](int p, int q) {
        // In float the wrong one of two parabolas would be taken near their crossing: too large by more than rounding.
        const double rise = static_cast<double>(at(q)) - static_cast<double>(at(p));
        return 0.5 * (rise / (static_cast<double>(d2) * (q - p)) + (q + p));
    };
    int last = 0;
    s.apex[0] = 0;
    s.border[0] = -std::numeric_limits<double>::infinity();
    for (int q = 1; q < n; ++q) {
        double x = crossing(s.apex[static_cast<std::size_t>(last)], q);
        while (last > 0 && x <= s.border[static_cast<std::size_t>(last)]) {
            --last;
            x = crossing(s.apex[static_cast<std::size_t>(last)], q);
        }
        ++last;
        s.apex[static_cast<std::size_t>(last)] = q;
        s.border[static_cast<std::size_t>(last)] = x;
    }
    int k = 0;
    for (int x = 0; x < n; ++x) {
        while (k < last && s.border[static_cast<std::size_t>(k) + 1] < x) ++k;
        const int q = s.apex[static_cast<std::size_t>(k)];
        const auto away = static_cast<float>(x - q);
        s.out[static_cast<std::size_t>(x)] = away * away * d2 + at(q);
    }
}

// Runs `pass` over a line of n values at data[i * stride]; periodic lines are given half a period on each side.
template <class Pass>
void overLine(float* data, int n, std::ptrdiff_t stride, bool wraps, EnvelopeScratch& s, const Pass& pass) {
    const int margin = wraps ? n / 2 + 1 : 0;
    s.line.resize(static_cast<std::size_t>(n + 2 * margin));
    for (int i = -margin; i < n + margin; ++i) {
        const int from = i < 0 ? i + n : (i >= n ? i - n : i);
        s.line[static_cast<std::size_t>(i + margin)] = data[(wraps ? (from % n + n) % n : from) * stride];
    }
    pass();
    for (int i = 0; i < n; ++i) data[i * stride] = s.out[static_cast<std::size_t>(i + margin)];
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

template <class Pass>
void overBothAxes(FloatImage& f, bool wraps, EnvelopeScratch& s, const Pass& pass) {
    for (int y = 0; y < f.height(); ++y) {
        overLine(f.row(y).data(), f.width(), 1, wraps, s, [&] { pass(0); });
    }
    for (int x = 0; x < f.width(); ++x) overLine(f.data() + x, f.height(), f.width(), wraps, s, [&] { pass(1); });
}

}  // namespace

void envelope2D(FloatImage& f, double dx, double dy, bool wraps, EnvelopeScratch& scratch) {
    const std::array<float, 2> squares{static_cast<float>(dx * dx), static_cast<float>(dy * dy)};
    overBothAxes(f, wraps, scratch,
                 [&](int axis) { envelope(scratch.line, squares[static_cast<std::size_t>(axis)], scratch); });
}

// A box one nearer by the dilation is as far as the gap: min over q of f(q) + gap(x - q)^2 is the envelope of the
// smallest of each three neighbours.
void gapEnvelope2D(FloatImage& f, bool wraps, EnvelopeScratch& scratch) {
    overBothAxes(f, wraps, scratch, [&](int) {
        dilate(scratch.line);
        envelope(scratch.line, 1.0F, scratch);
    });
}

}  // namespace relief
