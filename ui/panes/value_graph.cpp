#include "panes/value_graph.h"

#include <algorithm>
#include <cmath>

namespace reliefui {

namespace {

// Sizes in points.
constexpr double kPad = 3;          // between the box and the extreme values
constexpr double kFinest = 1;       // steps closer than this are drawn as one
constexpr double kLeastForDot = 4;  // width of a step from which its value is a line instead of a dot
constexpr double kDot = 3;
constexpr double kMark = 7;

class Graph {
  public:
    Graph(Drawing& drawing, const Box& box, std::span<const GraphPart> parts, std::span<const double> values,
          double unit)
        : drawing_(drawing), box_(box), parts_(parts), values_(values), unit_(unit), range_(graphRange(values)) {}

    void curve() {
        std::vector<Point> line;
        const auto end = [&] {
            if (line.size() > 1) drawing_.add({}, Role::Surface, Polyline{line, false});
            line.clear();
        };
        for (std::size_t k = 0; k < values_.size();) {
            // The steps that share the place of this one on the screen.
            std::size_t last = k + 1;
            while (last < values_.size() && isNear(parts_[last].x0, parts_[k].x0) &&
                   isNear(parts_[last].x1, parts_[k].x0)) {
                ++last;
            }
            const GraphRange range = graphRange(values_.subspan(k, last - k));
            if (range.empty()) {
                end();
            } else {
                line.push_back({parts_[k].x0, yAt(std::isfinite(values_[k]) ? values_[k] : range.high)});
                if (last > k + 1) {
                    line.push_back({parts_[k].x0, yAt(range.low)});
                    line.push_back({parts_[k].x0, yAt(range.high)});
                }
                line.push_back(
                    {parts_[last - 1].x1, yAt(std::isfinite(values_[last - 1]) ? values_[last - 1] : range.high)});
                if (last == k + 1 && parts_[k].x1 - parts_[k].x0 < kLeastForDot * unit_)
                    mark(k, kDot, Emphasis::Normal);
            }
            k = last;
        }
        end();
    }
    void current(std::size_t k) {
        if (k >= values_.size()) return;
        const double x = (parts_[k].x0 + parts_[k].x1) / 2;
        drawing_.add(stepId(k), Role::Ray, Polyline{{{x, box_.y0}, {x, box_.y1}}, false}, Emphasis::Faint);
        if (std::isfinite(values_[k])) mark(k, kMark, Emphasis::Strong);
    }

  private:
    bool isNear(double a, double b) const { return std::abs(a - b) < kFinest * unit_; }
    double yAt(double value) const {
        const double pad = std::min(kPad * unit_, box_.height() / 4);
        const double share = range_.high > range_.low ? (value - range_.low) / (range_.high - range_.low) : 0.5;
        return box_.y1 - pad - share * (box_.height() - 2 * pad);
    }
    void mark(std::size_t k, double size, Emphasis emphasis) {
        const Point at{(parts_[k].x0 + parts_[k].x1) / 2, yAt(values_[k])};
        const Role role = emphasis == Emphasis::Strong ? Role::Ray : Role::Surface;
        drawing_.add(stepId(k), role, Marker{at, Shape::Dot, size}, emphasis);
    }

    Drawing& drawing_;
    Box box_;
    std::span<const GraphPart> parts_;
    std::span<const double> values_;
    double unit_;
    GraphRange range_;
};

}  // namespace

GraphRange graphRange(std::span<const double> values) {
    GraphRange range;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        range = range.empty() ? GraphRange{value, value}
                              : GraphRange{std::min(range.low, value), std::max(range.high, value)};
    }
    return range;
}

void addValueGraph(Drawing& drawing, const Box& box, std::span<const GraphPart> parts, std::span<const double> values,
                   std::size_t current, double unit) {
    Graph graph(drawing, box, parts, values, unit);
    graph.curve();
    graph.current(current);
}

}  // namespace reliefui
