#include "painting/iso_lines.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace reliefui {

namespace {

// Index of the grid edge between sample (i, j) and its neighbour to the right (0) or below (1).
using Edge = std::int64_t;

class Tracer {
  public:
    Tracer(const relief::FloatImage& samples, double value) : samples_(samples), value_(value) {}

    void take(std::vector<IsoLine>& lines) {
        for (int j = 0; j + 1 < samples_.height(); ++j) {
            for (int i = 0; i + 1 < samples_.width(); ++i) square(i, j);
        }
        // Open lines are extracted first; the links that remain unused form closed rings.
        for (const bool rings : {false, true}) {
            for (auto& [edge, link] : links_) {
                if (link.used || (!rings && link.next[1] >= 0)) continue;
                lines.push_back(follow(edge));
                lines.back().closed = rings;
                if (rings) lines.back().points.push_back(lines.back().points.front());
            }
        }
    }

  private:
    struct Link {
        std::array<Edge, 2> next{-1, -1};
        Point at;
        bool used = false;
    };

    Edge edge(int i, int j, int below) const { return ((static_cast<Edge>(j) * samples_.width()) + i) * 2 + below; }
    double at(int i, int j) const { return static_cast<double>(samples_(i, j)); }

    Link& link(int i, int j, int below) {
        Link& link = links_[edge(i, j, below)];
        const double a = at(i, j);
        const double b = below != 0 ? at(i, j + 1) : at(i + 1, j);
        const double f = (value_ - a) / (b - a);
        link.at = {i + 0.5 + (below != 0 ? 0 : f), j + 0.5 + (below != 0 ? f : 0)};
        return link;
    }

    struct Side {
        int i;
        int j;
        int below;
    };
    void join(const Side& a, const Side& b) {
        // Looked up twice, because inserting the second link may invalidate a reference to the first.
        link(a.i, a.j, a.below);
        Link& second = link(b.i, b.j, b.below);
        Link& first = links_[edge(a.i, a.j, a.below)];
        first.next[first.next[0] < 0 ? 0 : 1] = edge(b.i, b.j, b.below);
        second.next[second.next[0] < 0 ? 0 : 1] = edge(a.i, a.j, a.below);
    }

    void square(int i, int j) {
        const std::array<double, 4> v{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        const double sum = v[0] + v[1] + v[2] + v[3];
        if (std::isnan(sum)) return;
        const std::array<Side, 4> sides{{{i, j, 0}, {i + 1, j, 1}, {i, j + 1, 0}, {i, j, 1}}};
        std::array<int, 4> crossed{};
        int count = 0;
        for (int k = 0; k < 4; ++k) {
            const auto a = static_cast<std::size_t>(k);
            if ((v[a] < value_) != (v[(a + 1) % 4] < value_)) crossed[static_cast<std::size_t>(count++)] = k;
        }
        const auto side = [&](int k) { return sides[static_cast<std::size_t>(k)]; };
        if (count == 2) join(side(crossed[0]), side(crossed[1]));
        if (count != 4) return;
        const bool low = v[0] < value_;
        const bool apart = (sum / 4 < value_) != low;  // saddle: corners 0 and 2 are not connected through the centre
        join(side(0), side(apart ? 3 : 1));
        join(side(2), side(apart ? 1 : 3));
    }

    IsoLine follow(Edge from) {
        IsoLine line;
        line.value = value_;
        Edge at = from;
        while (at >= 0) {
            Link& link = links_.at(at);
            link.used = true;
            line.points.push_back(link.at);
            Edge next = -1;
            for (const Edge candidate : link.next) {
                if (candidate >= 0 && !links_.at(candidate).used) next = candidate;
            }
            at = next;
        }
        return line;
    }

    const relief::FloatImage& samples_;
    double value_;
    std::unordered_map<Edge, Link> links_;
};

}  // namespace

std::vector<IsoLine> isoLines(const relief::FloatImage& samples, const std::vector<double>& values) {
    std::vector<IsoLine> lines;
    for (const double value : values) Tracer(samples, value).take(lines);
    return lines;
}

}  // namespace reliefui
