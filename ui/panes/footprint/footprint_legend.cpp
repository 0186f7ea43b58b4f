#include "painting/legend_rows.h"
#include "panes/footprint/footprint_drawing.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::FootprintKind;
using relief::FootprintTexel;
using relief::Message;
using relief::MessageId;

std::string figures(double value) {
    return relief::numberText(value, 3);
}

class Rows {
  public:
    Rows(const PixelFootprint& f, const FootprintOptions& options, double width, relief::Language language)
        : f_(f), options_(options), rows_(width, language) {}

    Drawing take(bool weights) {
        // An opaque background hides the texture behind the legend; kFar, in points, exceeds the size of any pane.
        constexpr double kFar = 1e4;
        rows_.add(Role::Background, Rectangle{{-kFar, -3, kFar, kFar}, true, 0, 0}, {}, Emphasis::Strong);
        numbers();
        if (!weights) entry(Message(MessageId::DrawFootprintZoom));
        signs(weights);
        return rows_.take();
    }

  private:
    void entry(const Message& message) { rows_.words(message, 2 * LegendRows::kBetween); }
    // Adds a mark and its explanation.
    void sign(Role role, Primitive primitive, MessageId what) {
        const Emphasis emphasis = role == Role::Weight ? Emphasis::Strong : Emphasis::Normal;
        rows_.sign(role, std::move(primitive), Message(what), {}, emphasis);
    }

    void numbers() {
        const relief::LevelFootprint& f = f_.log.footprint;
        entry(Message(
            MessageId::DrawFootprintLevel,
            {{"filter", f_.filter.name}, {"level", f.level}, {"width", f_.across.size}, {"height", f_.down.size}}));
        if (f_.bounded) {
            entry(Message(MessageId::DrawFootprintAxes, {{"major", figures(f.major)},
                                                         {"minor", figures(f.minor)},
                                                         {"ratio", f.minor > 0 ? figures(f.major / f.minor) : "∞"}}));
        }
        if (options_.numbers) coefficients();
        if (!f_.listed) {
            entry(Message(MessageId::DrawFootprintMany, {{"texels", f_.counts.texels}}));
        } else if (!f_.log.texels.empty()) {
            entry(Message(MessageId::DrawFootprintTexels, {{"texels", f_.texelCount}, {"sum", figures(f_.weightSum)}}));
        }
        if (f_.filter.name == relief::kSupersample) {
            entry(Message(MessageId::DrawFootprintSamples, {{"samples", f_.filter.samples}}));
        }
        const bool ellipse = relief::findFilter(f_.filter.name).ellipse;
        if (ellipse && f_.listed && f.kind == FootprintKind::Bilinear) entry(Message(MessageId::DrawFootprintSmall));
        if (f.kind == FootprintKind::Shape) entry(Message(MessageId::DrawFootprintShape));
        if (f.kind == FootprintKind::Top) entry(Message(MessageId::DrawFootprintTop));
        visibility();
    }

    void coefficients() {
        const relief::Jacobian& j = f_.behind.derivatives;
        const relief::Ellipse& e = f_.behind.ellipse;
        entry(Message(MessageId::DrawFootprintDerivatives, {{"ux", figures(j.ux)},
                                                            {"uy", figures(j.uy)},
                                                            {"vx", figures(j.vx)},
                                                            {"vy", figures(j.vy)},
                                                            {"q", figures(f_.behind.q)}}));
        entry(Message(MessageId::DrawFootprintForm,
                      {{"A", figures(e.a)}, {"B", figures(e.b)}, {"C", figures(e.c)}, {"F", figures(e.f)}}));
    }

    void visibility() {
        // Where the filter proved that nothing hides a texel, it may still have traced points for the proof.
        if (f_.log.skipped) {
            entry(Message(MessageId::DrawFootprintSkipped));
        } else if (f_.counts.tested > 0) {
            entry(
                Message(MessageId::DrawFootprintTested, {{"tested", f_.counts.tested}, {"hidden", f_.counts.hidden}}));
        }
        if (f_.log.allHidden) entry(Message(MessageId::DrawFootprintAllHidden));
    }

    void signs(bool weights) {
        const relief::LevelFootprint& f = f_.log.footprint;
        if (f.kind == FootprintKind::Ellipse && f_.listed) {
            rows_.line(Role::Footprint, Message(MessageId::DrawFootprintEllipse, {{"radius", figures(f.radius)}}));
            rows_.line(Role::Frame, Message(MessageId::DrawFootprintBox));
        }
        if (f_.bounded) rows_.line(Role::PixelCircle, Message(MessageId::DrawFootprintPixel));
        if (options_.neighbours > 0) rows_.line(Role::Neighbour, Message(MessageId::DrawFootprintNeighbours));
        bool hidden = false;
        bool finer = false;
        bool coarser = false;
        for (const FootprintTexel& texel : f_.log.texels) {
            hidden = hidden || texel.hidden;
            finer = finer || f_.sideOf(texel) < 1;
            coarser = coarser || f_.sideOf(texel) > 1;
        }
        if (!f_.log.texels.empty() && weights) {
            sign(Role::Weight, Circle{{}, 4.2, true, true}, MessageId::DrawFootprintWeight);
        }
        if (!f_.rays.empty()) sign(Role::Sample, Marker{{}, Shape::Dot, 6}, MessageId::DrawFootprintRay);
        const Rectangle square{{-4, -4, 4, 4}, false, 0, 0};
        if (finer && weights) sign(Role::Neighbour, square, MessageId::DrawFootprintFiner);
        if (coarser && weights) sign(Role::Neighbour, square, MessageId::DrawFootprintCoarser);
        if (!hidden || !weights) return;
        sign(Role::Hidden, Marker{{}, Shape::Cross, 7}, MessageId::DrawFootprintHidden);
        sign(Role::Blocker, Marker{{}, Shape::Diamond, 7}, MessageId::DrawFootprintBlocker);
    }

    const PixelFootprint& f_;
    const FootprintOptions& options_;
    LegendRows rows_;
};

}  // namespace

Drawing footprintLegend(const PixelFootprint& footprint, const FootprintOptions& options, bool weights, double width,
                        relief::Language language) {
    return Rows(footprint, options, width, language).take(weights);
}

}  // namespace reliefui
