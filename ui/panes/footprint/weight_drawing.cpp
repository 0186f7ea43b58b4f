#include "panes/footprint/weight_drawing.h"

#include <algorithm>
#include <cmath>

#include "filtering/weight_map.h"
#include "painting/chart.h"
#include "painting/legend_rows.h"

namespace reliefui {

namespace {

using relief::EllipticalSettings;
using relief::FootprintTexel;
using relief::Message;
using relief::MessageId;
using relief::WeightKind;

// Points, around a plot.
constexpr chart::Margins kMargins{.top = 15};
constexpr double kDot = 5;
constexpr std::size_t kMostDots = 3000;
// Cells of a map that is drawn for weights that come from a formula.
constexpr int kDrawnCells = 32;

// A function of r^2 alone.
bool radial(const EllipticalSettings& settings) {
    return !settings.shaped() && settings.weights != WeightKind::TexelDistance;
}
// Weights by the distance in texels have no place in the pixel.
bool hasMap(const EllipticalSettings& settings) {
    return settings.weights != WeightKind::TexelDistance;
}
bool colored(const EllipticalSettings& settings) {
    return settings.shaped() && !relief::sameInAllChannels(settings.model());
}

struct Plot {
    Box box;
    chart::Scale x, y;
    Point at(double across, double upwards) const { return {x.at(across), y.at(upwards)}; }
};

class WeightPictures {
  public:
    explicit WeightPictures(const PixelFootprint& footprint) : f_(footprint), settings_(*footprint.weighing) {}

    void graph(Drawing& drawing, const Box& room) const {
        const double cut = settings_.radius * settings_.radius;
        double far = cut;
        double high = 1;
        eachTexel([&](const FootprintTexel& texel, double du, double dv) {
            far = std::max(far, std::min(squared(du, dv), 2 * cut));
            high = std::max(high, PixelFootprint::weightOf(texel));
        });
        const Box box = chart::plotIn(room, kMargins);
        const Plot plot{box, {0, far * 1.04, box.x0, box.x1}, {0, high * 1.04, box.y1, box.y0}};
        chart::title(drawing, Message(MessageId::DrawWeightGraph), room);
        const chart::Axes axes(drawing, box, room);
        axes.left(plot.y, true);
        axes.below(plot.x, Message(MessageId::DrawWeightAxis));
        axes.sides();
        if (radial(settings_)) {
            constexpr int kPoints = 80;
            Polyline curve;
            for (int n = 0; n <= kPoints; ++n) {
                const double r2 = cut * n / kPoints;
                // At the very end rounding must not cut the curve off.
                const double r = n == kPoints ? settings_.radius : std::sqrt(r2);
                curve.points.push_back(plot.at(r2, relief::radialWeight(settings_, r)));
            }
            curve.points.push_back(plot.at(cut, 0));
            drawing.add({}, Role::Footprint, std::move(curve));
        }
        eachTexel([&](const FootprintTexel& texel, double du, double dv) {
            const double square = squared(du, dv);
            if (square > far) return;
            const Point at = plot.at(square, PixelFootprint::weightOf(texel));
            if (texel.hidden) {
                drawing.add({}, Role::Hidden, Marker{at, Shape::Cross, kDot});
            } else {
                drawing.add({}, Role::Weight, Marker{at, Shape::Dot, kDot});
            }
        });
    }

    void map(Drawing& drawing, const Box& room) const {
        EllipticalSettings settings = settings_;
        if (settings.source != relief::WeightSource::Map) settings.resolution = kDrawnCells;
        const relief::WeightMap weights(settings);
        const int n = weights.size();
        Box box = chart::plotIn(room, kMargins);
        const double side = std::min(box.width(), box.height());
        box = {box.x0, box.y0, box.x0 + side, box.y0 + side};
        const double reach = settings.radius;
        // Down the screen, as the pixel's y runs.
        const Plot plot{box, {-reach, reach, box.x0, box.x1}, {-reach, reach, box.y0, box.y1}};
        chart::title(drawing, Message(MessageId::DrawWeightMap, {{"cells", n}}), room);
        Cells cells{.values = picture(weights),
                    .x = box.x0,
                    .y = box.y0,
                    .cellWidth = side / n,
                    .cellHeight = side / n,
                    .clip = box,
                    .map = colored(settings) ? ColorMap::Picture : ColorMap::Count};
        cells.scale.high = highest(weights);
        drawing.add({}, Role::HeightFill, std::move(cells));
        drawing.add({}, Role::Frame, Rectangle{box, false, 0, 0});
        const chart::Axes axes(drawing, box, room);
        axes.left(plot.y);
        axes.below(plot.x, Message(MessageId::DrawWeightMapAxis));
        const Point a = plot.at(-0.5, -0.5), b = plot.at(0.5, 0.5);
        if (reach > 0.5) drawing.add({}, Role::Neighbour, Rectangle{{a.x, a.y, b.x, b.y}, false, 0, 0});
        const relief::PixelFromTexel back = relief::pixelFromTexel(f_.log.footprint.widened);
        eachTexel([&](const FootprintTexel& texel, double du, double dv) {
            const double x = back.dx(du, dv), y = back.dy(du, dv);
            if (std::max(std::abs(x), std::abs(y)) > reach) return;
            drawing.add({}, texel.hidden ? Role::Hidden : Role::Weight,
                        Marker{plot.at(x, y), texel.hidden ? Shape::Cross : Shape::Dot, texel.hidden ? kDot : 3.5});
        });
    }

    // A round pixel's is 1, in its middle; of others as in the map.
    double highest(const relief::WeightMap& weights) const {
        if (!settings_.shaped()) return 1;
        float high = 0;
        for (const glm::vec3& w : weights.weights().pixels()) high = std::max({high, w.x, w.y, w.z});
        return high > 0 ? static_cast<double>(high) : 1;
    }

  private:
    template <class Visit>
    void eachTexel(const Visit& visit) const {
        const auto& texels = f_.log.texels;
        const glm::dvec2 centre = f_.log.footprint.centre;
        for (std::size_t k = 0; k < std::min(texels.size(), kMostDots); ++k) {
            visit(texels[k], texels[k].u - centre.x, texels[k].v - centre.y);
        }
    }
    double squared(double du, double dv) const { return relief::squaredRadius(f_.log.footprint.ellipse, du, dv); }

    // As colours where the channels differ.
    std::shared_ptr<const relief::FloatImage> picture(const relief::WeightMap& weights) const {
        const int n = weights.size();
        auto values = std::make_shared<relief::FloatImage>(n, n);
        const auto high = static_cast<float>(highest(weights));
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const glm::vec3 w = weights.weights()(x, y);
                const auto byte = [&](float of) { return std::round(255 * std::clamp(of / high, 0.0F, 1.0F)); };
                (*values)(x, y) = colored(settings_) ? 65536 * byte(w.x) + 256 * byte(w.y) + byte(w.z) : w.x;
            }
        }
        return values;
    }

    const PixelFootprint& f_;
    const EllipticalSettings& settings_;
};

}  // namespace

bool hasWeights(const PixelFootprint& f) {
    return f.weighing && f.listed && f.log.footprint.kind == relief::FootprintKind::Ellipse && !f.log.texels.empty();
}

Drawing weightDrawing(const PixelFootprint& footprint, const Box& room) {
    Drawing drawing;
    drawing.bounds = room;
    const WeightPictures pictures(footprint);
    if (!hasMap(*footprint.weighing)) {
        pictures.graph(drawing, room);
        return drawing;
    }
    Box graph = room, map = room;
    if (room.width() >= room.height()) {
        // The map is square; the graph gets the rest, and no less than half.
        const double square =
            std::min(room.height() - kMargins.top - kMargins.bottom + kMargins.left + kMargins.right, room.width() / 2);
        graph.x1 = map.x0 = room.x1 - square;
    } else {
        graph.y1 = map.y0 = room.center().y;
    }
    pictures.graph(drawing, graph);
    pictures.map(drawing, map);
    return drawing;
}

Drawing weightLegend(const PixelFootprint& footprint, double width, relief::Language language) {
    const EllipticalSettings& settings = *footprint.weighing;
    const auto figures = [](double value) { return relief::numberText(value, 3); };
    LegendRows rows(width, language);
    if (radial(settings)) {
        const bool uniform = settings.weights == WeightKind::Uniform;
        rows.line(Role::Footprint, Message(uniform ? MessageId::DrawWeightConstant : MessageId::DrawWeightCurve,
                                           {{"sigma", figures(settings.sigma)}, {"radius", figures(settings.radius)}}));
    }
    rows.sign(Role::Weight, Marker{{}, Shape::Dot, 6}, Message(MessageId::DrawWeightTexel));
    const auto& texels = footprint.log.texels;
    if (std::any_of(texels.begin(), texels.end(), [](const FootprintTexel& t) { return t.hidden; })) {
        rows.sign(Role::Hidden, Marker{{}, Shape::Cross, 6}, Message(MessageId::DrawFootprintHidden));
    }
    if (!hasMap(settings)) return rows.take();
    if (colored(settings)) {
        rows.words(Message(MessageId::DrawWeightChannels));
    } else {
        const double high = WeightPictures(footprint).highest(relief::WeightMap(settings));
        rows.ramp(ColorMap::Count, Message(MessageId::DrawWeightBar, {{"high", figures(high)}}));
    }
    if (settings.radius > 0.5) rows.line(Role::Neighbour, Message(MessageId::DrawWeightSquare));
    return rows.take();
}

}  // namespace reliefui
