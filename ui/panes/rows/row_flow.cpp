#include "panes/rows/row_flow.h"

#include <algorithm>
#include <set>
#include <utility>

#include "painting/chart.h"
#include "painting/formula_text.h"
#include "painting/text_width.h"
#include "panes/figure_caption.h"
#include "panes/rows/rows_figure.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;
using relief::RowCurve;
using relief::RowVariant;

constexpr std::int64_t kPixels = 8;  // shown in a row
// Lengths in points.
constexpr double kLeft = 24;  // for the names of the numbers
constexpr double kTitle = 13;
constexpr double kLane = 7;  // between the arrows of two streams
constexpr double kDrop = 9;  // arrow from the coefficients to a pixel
constexpr double kNumber = 10;
constexpr double kDivide = 13;
constexpr double kBelow = 9;
constexpr double kInset = 3.5;  // of a pixel's boxes, which leaves room for the arrows between them
// Sizes of letters: in the column of a journal, 6 and 5.5 points.
constexpr double kSmall = 0.6;
constexpr double kNote = 0.55;
constexpr double kSides = 1.5;  // between a number and the sides of its box

int stepOf(const RowCurve& curve) {
    const RowVariant variant = curve.options.variant;
    if (variant == RowVariant::Subspan) return curve.options.span;
    return variant == RowVariant::Opposed ? 1 : streamsOf(curve);
}

MessageId titleOf(const RowCurve& curve) {
    switch (curve.options.variant) {
        case RowVariant::Affine:
            return MessageId::DrawFlowLinear;
        case RowVariant::Direct:
        case RowVariant::RowConstant:
            return MessageId::DrawFlowOwn;
        case RowVariant::Streams:
        case RowVariant::RowsParallel:
            return MessageId::DrawFlowStreams;
        case RowVariant::Opposed:
            return MessageId::DrawFlowOpposed;
        case RowVariant::Subspan:
            return MessageId::DrawFlowSpans;
        default:
            return MessageId::DrawFlowChain;
    }
}

// "+3A": what is added after `step` pixels.
std::string times(std::int64_t step, const char* what) {
    return (step == 1 ? std::string("+") : step == -1 ? "−" : "+" + std::to_string(step)) + what;
}

class FlowWriter {
  public:
    FlowWriter(const RowsData& data, double width) : data_(data), width_(width) {}

    void add(std::size_t c) {
        const RowCurve& curve = data_.row.curves[c];
        const std::vector<RowFlowPixel> pixels = rowFlow(curve);
        title(c);
        named_.clear();
        if (pixels.empty()) return;
        side_ = (width_ - kLeft) / static_cast<double>(pixels.size());
        const bool arcs = std::any_of(pixels.begin(), pixels.end(), [](const RowFlowPixel& p) {
            return p.divides && p.from && std::abs(p.pixel - *p.from) > 1;
        });
        const double lanes = arcs ? std::min(streamsOf(curve), static_cast<int>(kPixels)) : 0;
        bus_ = y_ + kNumber;
        top_ = bus_ + kDrop + kLane * lanes;
        coefficients(pixels, curve);
        names();
        for (std::size_t k = 0; k < pixels.size(); ++k) pixel(pixels, k, curve);
        y_ = top_ + 2 * kNumber + kDivide + kNumber + kBelow;
    }
    Drawing take() {
        drawing_.bounds = {0, 0, width_, std::max(y_, 1.0)};
        return std::move(drawing_);
    }

  private:
    double center(std::size_t k) const { return kLeft + side_ * (static_cast<double>(k) + 0.5); }
    double quotient() const { return top_ + 2 * kNumber + kDivide; }  // top of the box of u

    void text(Point at, std::string formula, Anchor anchor = Anchor::Center, double size = kSmall) {
        drawing_.add(
            {}, Role::Legend,
            Label{.at = at, .text = plainText(std::move(formula)), .anchor = anchor, .size = size, .formula = true});
    }
    // A number in a box of this width, whose sides it does not touch.
    void boxed(Point at, double value, double width) {
        const std::string number = relief::numberText(value, 3);
        text(at, number, Anchor::Center, kSmall * std::min(1.0, (width - kSides) / textWidth(number, kSmall)));
    }
    void arrow(std::vector<Point> points, int stream) {
        drawing_.add({}, Role::Stream, Polyline{std::move(points), true}, Emphasis::Normal, {stream, 1});
    }
    void title(std::size_t c) {
        const RowCurve& curve = data_.row.curves[c];
        Message words(titleOf(curve), {{"name", data_.names[c]}, {"count", stepOf(curve)}});
        const double size = chart::fittingSize(chart::widthOf(words), width_);
        drawing_.add({}, Role::Legend, Label{.at = {0, y_}, .text = words, .anchor = Anchor::TopLeft, .size = size});
        y_ += kTitle;
    }
    // The line from which pixels take the row's coefficients, and what they take.
    void coefficients(const std::vector<RowFlowPixel>& pixels, const RowCurve& curve) {
        const auto own = [](const RowFlowPixel& p) { return p.divides && !p.from; };
        const auto first = std::find_if(pixels.begin(), pixels.end(), own);
        const auto last = std::find_if(pixels.rbegin(), pixels.rend(), own);
        if (first == pixels.end()) return;
        const double left = center(static_cast<std::size_t>(first - pixels.begin()));
        const double right = center(static_cast<std::size_t>(pixels.rend() - last - 1));
        drawing_.add({}, Role::Frame, Polyline{{{left, bus_}, {right, bus_}}});
        const bool constant = curve.options.variant == RowVariant::RowConstant;
        text({left - side_ / 2 + kInset, bus_ - 1},
             constant ? "w_n = u_t + A n,  q_n = u_b + G n" : "w = A x + B y + C,  q = G x + H y + I",
             Anchor::BottomLeft);
    }
    void names() {
        text({0, top_ + kNumber / 2}, "w_n", Anchor::Left);
        text({0, top_ + 1.5 * kNumber}, "q_n", Anchor::Left);
        text({0, quotient() + kNumber / 2}, "u_n", Anchor::Left);
    }
    void pixel(const std::vector<RowFlowPixel>& pixels, std::size_t k, const RowCurve& curve) {
        const RowFlowPixel& one = pixels[k];
        const std::size_t i = static_cast<std::size_t>(one.pixel - data_.row.span.begin);
        const double x = center(k), half = side_ / 2 - kInset;
        const int stream = curve.stream[i];
        const Box result{x - half, quotient(), x + half, quotient() + kNumber};
        if (one.divides) {
            const Box box{x - half, top_, x + half, top_ + 2 * kNumber};
            drawing_.add({}, Role::Stream, Rectangle{box, false}, Emphasis::Normal, {stream, 1});
            const double at = data_.row.x[i], y = data_.place.y;
            const relief::Homography& map = data_.place.map;
            boxed({x, top_ + kNumber / 2}, map.sx * at + map.sy * y + map.s1, 2 * half);
            boxed({x, top_ + 1.5 * kNumber}, map.denominator(at, y), 2 * half);
            arrow({{x, box.y1}, {x, result.y0}}, stream);
            if (k == 0) text({x + 4, (box.y1 + result.y0) / 2 - 1}, "w_n / q_n", Anchor::Left, kNote);
        }
        drawing_.add({}, Role::Stream, Rectangle{result, false}, Emphasis::Normal, {stream, 1});
        boxed(result.center(), curve.u[i], 2 * half);
        text({x, result.y1 + 1}, "n = " + std::to_string(one.pixel), Anchor::Top, kNote);
        if (k > 0 && one.pixel != pixels[k - 1].pixel + 1) text({x - side_ / 2, top_ + kNumber}, "…");
        comesFrom(pixels, k, stream);
    }
    void comesFrom(const std::vector<RowFlowPixel>& pixels, std::size_t k, int stream) {
        const RowFlowPixel& one = pixels[k];
        const double x = center(k), half = side_ / 2 - kInset;
        if (!one.from) {
            if (one.divides) arrow({{x, bus_}, {x, top_}}, stream);
            return;
        }
        const auto source = std::find_if(pixels.begin(), pixels.end(),
                                         [&](const RowFlowPixel& other) { return other.pixel == *one.from; });
        if (source == pixels.end()) return;
        const double from = center(static_cast<std::size_t>(source - pixels.begin()));
        const std::int64_t step = one.pixel - *one.from;
        const bool unnamed = named_.insert({one.divides, step}).second;
        if (std::abs(step) == 1) {
            const double y = one.divides ? top_ + kNumber : quotient() + kNumber / 2;
            const double side = step > 0 ? half : -half;
            arrow({{from + side, y}, {x - side, y}}, stream);
            if (unnamed && one.divides) {
                text({(from + x) / 2, top_ - 1}, times(step, "A, ") + times(step, "G"), Anchor::Bottom, kNote);
            } else if (unnamed) {
                text({x, quotient() - 1}, "+Δu", Anchor::BottomLeft, kNote);
            }
        } else {
            const double lane = top_ - kLane * (stream + 1);
            arrow({{from + 2, top_}, {from + 2, lane}, {x - 2, lane}, {x - 2, top_}}, stream);
            // At the arrow's beginning, because arrows to the pixels between cross it.
            if (unnamed) text({from + 3.5, lane - 1}, times(step, "A, ") + times(step, "G"), Anchor::BottomLeft, kNote);
        }
    }

    const RowsData& data_;
    double width_;
    double side_ = 0;                                // width of a pixel's column
    double y_ = 0;                                   // top of the next diagram
    double bus_ = 0;                                 // height of the coefficients' line
    double top_ = 0;                                 // of the boxes of w and q
    std::set<std::pair<bool, std::int64_t>> named_;  // kinds of arrows of this diagram that have their text
    Drawing drawing_;
};

}  // namespace

std::vector<RowFlowPixel> rowFlow(const RowCurve& curve) {
    std::vector<RowFlowPixel> pixels;
    const RowVariant variant = curve.options.variant;
    const bool opposed = variant == RowVariant::Opposed;
    const bool own = variant == RowVariant::Direct || variant == RowVariant::RowConstant;
    const std::int64_t begin = curve.valid.begin, end = curve.valid.end, step = stepOf(curve);
    for (std::int64_t n = begin; n < end; ++n) {
        const std::int64_t nth = n - begin;
        if (nth >= (opposed ? kPixels / 2 : kPixels) && !(opposed && end - n <= kPixels / 2)) continue;
        RowFlowPixel one{n, true, std::nullopt};
        const auto exact = [&](std::int64_t p) {
            return std::binary_search(curve.exact.begin(), curve.exact.end(), p);
        };
        if (variant == RowVariant::Affine || variant == RowVariant::Subspan) {
            one.divides = nth == 0 || exact(n);
            if (!one.divides) one.from = n - 1;
        } else if (opposed) {
            const bool left = nth < (end - begin + 1) / 2;
            if (!exact(n)) one.from = left ? n - 1 : n + 1;
        } else if (!own) {
            // The first pixel of each stream, and those behind a restart, are computed from the coefficients.
            const auto restart = std::upper_bound(curve.exact.begin(), curve.exact.end(), n);
            const std::int64_t start = restart == curve.exact.begin() ? begin : *(restart - 1);
            if (n - step >= start) one.from = n - step;
        }
        pixels.push_back(one);
    }
    return pixels;
}

Drawing rowFlowDrawing(const RowsData& data, double width) {
    FlowWriter writer(data, width);
    for (std::size_t c = 0; c < data.row.curves.size(); ++c) writer.add(c);
    return writer.take();
}

std::shared_ptr<const Figure> rowFlowFigure(std::shared_ptr<const Snapshot> snapshot, const RowsPane& pane) {
    const auto data = std::make_shared<const RowsData>(rowsOf(*snapshot, rowsOptions(pane), "row-flow"));
    const auto paint = [data](QPainter& painter, const Box& page, const Style& style) {
        const Drawing drawing = rowFlowDrawing(*data, page.width() / style.pixelsPerPoint() - kFigureMargins);
        paintFigure(painter, {&drawing}, {}, page, style);
    };
    const auto aspect = [data](const FigurePage& page) {
        const double points = page.widthMm / kMmPerPoint;
        return (rowFlowDrawing(*data, points - kFigureMargins).bounds.height() + kFigureMargins) / points;
    };
    return paintedFigure(paint, figureCaption(std::move(snapshot)), aspect);
}

}  // namespace reliefui
