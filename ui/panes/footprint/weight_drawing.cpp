#include "panes/footprint/weight_drawing.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

// Margins around a plot, in points.
constexpr chart::Margins kMargins{.top = 15};
constexpr double kDot = 5;
constexpr std::size_t kMostDots = 3000;
// Resolution of the map of weights that come from a formula.
constexpr int kDrawnCells = 32;

// Returns true if the weight depends on r^2 only.
bool radial(const EllipticalSettings& settings) {
    return !settings.shaped() && settings.weights != WeightKind::TexelDistance;
}
// Weights that depend on the distance in texels cannot be drawn as a map over the pixel.
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

    // Plot of the weight function; slightly larger than its content.
    Plot graphPlot(const Box& room) const {
        constexpr double kMore = 1.04;
        double high = 1;
        eachTexel([&](ItemId, const FootprintTexel& texel, double du, double dv) {
            if (onGraph(squared(du, dv))) high = std::max(high, PixelFootprint::weightOf(texel));
        });
        const Box box = chart::plotIn(room, kMargins);
        return {box, {0, farthest() * kMore, box.x0, box.x1}, {0, high * kMore, box.y1, box.y0}};
    }

    void graph(Drawing& drawing, const Box& room) const {
        const double cut = settings_.radius * settings_.radius;
        const Plot plot = graphPlot(room);
        chart::title(drawing, Message(MessageId::DrawWeightGraph), room);
        const chart::Axes axes(drawing, plot.box, room);
        axes.left(plot.y, true);
        axes.below(plot.x, Message(MessageId::DrawWeightAxis));
        axes.sides();
        if (radial(settings_)) {
            constexpr int kPoints = 80;
            Polyline curve;
            for (int n = 0; n <= kPoints; ++n) {
                const double r2 = cut * n / kPoints;
                // Exactly the radius at the end, so that rounding does not cut the curve off.
                const double r = n == kPoints ? settings_.radius : std::sqrt(r2);
                curve.points.push_back(plot.at(r2, relief::radialWeight(settings_, r)));
            }
            curve.points.push_back(plot.at(cut, 0));
            drawing.add({}, Role::Footprint, std::move(curve));
        }
        eachTexel([&](ItemId id, const FootprintTexel& texel, double du, double dv) {
            const auto at = onGraph(plot, texel, du, dv);
            if (!at) return;
            drawing.add(id, texel.hidden ? Role::Hidden : Role::Weight,
                        Marker{*at, texel.hidden ? Shape::Cross : Shape::Dot, kDot});
        });
    }

    // y points downwards, as in the picture.
    Plot mapPlot(const Box& room) const {
        Box box = chart::plotIn(room, kMargins);
        const double side = std::min(box.width(), box.height());
        box = {box.x0, box.y0, box.x0 + side, box.y0 + side};
        const double reach = settings_.radius;
        return {box, {-reach, reach, box.x0, box.x1}, {-reach, reach, box.y0, box.y1}};
    }

    void ring(Drawing& drawing, const Box& graphRoom, const std::optional<Box>& mapRoom, std::size_t texel) const {
        constexpr double kRing = 4.5;
        const Plot graph = graphPlot(graphRoom);
        eachTexel([&](ItemId id, const FootprintTexel& at, double du, double dv) {
            if (static_cast<std::size_t>(id.i) != texel) return;
            if (const auto place = onGraph(graph, at, du, dv)) drawing.add(id, Role::Highlight, Ring{*place, kRing});
            if (!mapRoom) return;
            if (const auto place = onMap(mapPlot(*mapRoom), du, dv)) {
                drawing.add(id, Role::Highlight, Ring{*place, kRing});
            }
        });
    }

    void map(Drawing& drawing, const Box& room) const {
        EllipticalSettings settings = settings_;
        if (settings.source != relief::WeightSource::Map) settings.resolution = kDrawnCells;
        const relief::WeightMap weights(settings);
        const int n = weights.size();
        const Plot plot = mapPlot(room);
        const Box& box = plot.box;
        chart::title(drawing, Message(MessageId::DrawWeightMap, {{"cells", n}}), room);
        Cells cells{.values = picture(weights),
                    .x = box.x0,
                    .y = box.y0,
                    .cellWidth = box.width() / n,
                    .cellHeight = box.width() / n,
                    .clip = box,
                    .map = colored(settings) ? ColorMap::Picture : ColorMap::Count};
        cells.scale.high = highest(weights);
        drawing.add({}, Role::HeightFill, std::move(cells));
        drawing.add({}, Role::Frame, Rectangle{box, false, 0, 0});
        const chart::Axes axes(drawing, box, room);
        axes.left(plot.y);
        axes.below(plot.x, Message(MessageId::DrawWeightMapAxis));
        const Point a = plot.at(-0.5, -0.5), b = plot.at(0.5, 0.5);
        if (settings.radius > 0.5) drawing.add({}, Role::Neighbour, Rectangle{{a.x, a.y, b.x, b.y}, false, 0, 0});
        eachTexel([&](ItemId id, const FootprintTexel& texel, double du, double dv) {
            const auto at = onMap(plot, du, dv);
            if (!at) return;
            drawing.add(id, texel.hidden ? Role::Hidden : Role::Weight,
                        Marker{*at, texel.hidden ? Shape::Cross : Shape::Dot, texel.hidden ? kDot : 3.5});
        });
    }

    // Returns true if a dot lies visibly off the curve of the weight function: the weights of a texel's parts are
    // added, and each is that of the part's own place.
    bool offCurve() const {
        constexpr double kVisible = 0.02;
        bool off = false;
        if (radial(settings_)) {
            eachTexel([&](ItemId, const FootprintTexel& texel, double du, double dv) {
                if (!onGraph(squared(du, dv))) return;
                const double r = std::sqrt(squared(du, dv));
                const double curve = r <= settings_.radius ? relief::radialWeight(settings_, r) : 0;
                off = off || std::abs(PixelFootprint::weightOf(texel) - curve) > kVisible;
            });
        }
        return off;
    }

    // Largest weight: for a round pixel 1, at the centre; otherwise the maximum of the map.
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
            visit(ItemId{ItemKind::Texel, 0, static_cast<std::int64_t>(k), 0}, texels[k], texels[k].u - centre.x,
                  texels[k].v - centre.y);
        }
    }
    // Largest r^2 drawn.
    double farthest() const {
        const double cut = settings_.radius * settings_.radius;
        double far = cut;
        eachTexel([&](ItemId, const FootprintTexel&, double du, double dv) {
            far = std::max(far, std::min(squared(du, dv), 2 * cut));
        });
        return far;
    }
    // Position of a texel on the plot; std::nullopt if it is outside.
    std::optional<Point> onGraph(const Plot& plot, const FootprintTexel& texel, double du, double dv) const {
        const double square = squared(du, dv);
        if (!onGraph(square)) return std::nullopt;
        return plot.at(square, PixelFootprint::weightOf(texel));
    }
    // The graph ends at twice the square of the filter's radius.
    bool onGraph(double square) const { return square <= 2 * settings_.radius * settings_.radius; }
    std::optional<Point> onMap(const Plot& plot, double du, double dv) const {
        const relief::PixelFromTexel back = relief::pixelFromTexel(f_.log.footprint.widened);
        const double x = back.dx(du, dv), y = back.dy(du, dv);
        if (std::max(std::abs(x), std::abs(y)) > settings_.radius) return std::nullopt;
        return plot.at(x, y);
    }
    double squared(double du, double dv) const { return relief::squaredRadius(f_.log.footprint.ellipse, du, dv); }

    // As colours if the channels differ.
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

namespace {

struct Rooms {
    Box graph;
    std::optional<Box> map;
};

Rooms roomsOf(const PixelFootprint& footprint, const Box& room) {
    if (!hasMap(*footprint.weighing)) return {room, std::nullopt};
    Box graph = room, map = room;
    if (room.width() >= room.height()) {
        // The map is square; the graph gets the rest, but at least half.
        const double square =
            std::min(room.height() - kMargins.top - kMargins.bottom + kMargins.left + kMargins.right, room.width() / 2);
        graph.x1 = map.x0 = room.x1 - square;
    } else {
        graph.y1 = map.y0 = room.center().y;
    }
    return {graph, map};
}

}  // namespace

Drawing weightDrawing(const PixelFootprint& footprint, const Box& room) {
    Drawing drawing;
    drawing.bounds = room;
    const WeightPictures pictures(footprint);
    const Rooms rooms = roomsOf(footprint, room);
    pictures.graph(drawing, rooms.graph);
    if (rooms.map) pictures.map(drawing, *rooms.map);
    return drawing;
}

Drawing weightHighlight(const PixelFootprint& footprint, const Box& room, std::size_t texel) {
    Drawing drawing;
    drawing.bounds = room;
    const Rooms rooms = roomsOf(footprint, room);
    WeightPictures(footprint).ring(drawing, rooms.graph, rooms.map, texel);
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
    if (WeightPictures(footprint).offCurve()) rows.words(Message(MessageId::DrawWeightParts), LegendRows::kBetween);
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
