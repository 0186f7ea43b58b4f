#include "panes/footprint/footprint_figure.h"

#include <algorithm>

#include "painting/painter.h"
#include "panes/figure_caption.h"
#include "panes/footprint/weight_drawing.h"

namespace reliefui {

namespace {

// Height, in points, of the weights below the footprint: plots, legend, margin.
double weightsHeight(const PixelFootprint& footprint, const FootprintOptions& options, double points,
                     relief::Language language) {
    if (!options.weights || !hasWeights(footprint)) return 0;
    const Drawing legend = weightLegend(footprint, points - kFigureMargins, language);
    return std::clamp(0.42 * points, 110.0, 220.0) + legendRoom(legend);
}

void paintWeights(QPainter& painter, const PixelFootprint& footprint, const Box& page, const Style& style) {
    const double unit = style.pixelsPerPoint();
    const Drawing legend = weightLegend(footprint, page.width() / unit - kFigureMargins, style.language);
    const Box room = figureRoom(legend, page, style);
    const Drawing plots = weightDrawing(footprint, {0, 0, room.width() / unit, room.height() / unit});
    paintFigure(painter, {&plots}, legend, page, style);
}

// The legend with all numbers, since a figure has no tool tips.
Drawing legendOf(const PixelFootprint& footprint, const FootprintOptions& options, bool weights, double width,
                 relief::Language language) {
    FootprintOptions named = options;
    named.numbers = true;
    return footprintLegend(footprint, named, weights, width, language);
}

void paintFootprint(QPainter& painter, const PixelFootprint& footprint, const FootprintOptions& options,
                    const std::vector<Annotation>& notes, const Box& page, const Style& style) {
    const double width = page.width() / style.pixelsPerPoint() - kFigureMargins;
    Drawing legend = legendOf(footprint, options, true, width, style.language);
    const Box room = figureRoom(legend, page, style);
    const Drawing texture = footprintTexture(footprint, room.width() / room.height());
    const double scale = ViewMap::fitting(texture.bounds, room).scale / style.pixelsPerPoint();
    const FootprintMarks marks = footprintMarks(footprint, options, texture.bounds, scale);
    if (!marks.weights) legend = legendOf(footprint, options, false, width, style.language);
    const Drawing annotations =
        annotationDrawing(notes, footprintAnnotations(footprint, texture.bounds, scale), style.language);
    paintFigure(painter, {&texture, &marks.drawing, &annotations}, legend, page, style);
}

}  // namespace

AnnotationFrame footprintAnnotations(const PixelFootprint& footprint, const Box& seen, double pointsPerTexel) {
    const glm::dvec2 by = footprint.perHeight;
    return {"footprint",
            [by](Point p) {
                return Point{p.x * by.x, p.y * by.y};
            },
            [by](Point p) {
                return Point{p.x / by.x, p.y / by.y};
            },
            seen, 1 / pointsPerTexel};
}

std::shared_ptr<const Figure> footprintFigure(std::shared_ptr<const Snapshot> snapshot, const FootprintOptions& options,
                                              const std::vector<Annotation>& notes) {
    requireRay("footprint", *snapshot);
    if (!snapshot->footprint) throw EmptyFigure("footprint", relief::MessageId::ExportNoHit);
    const auto paint = [snapshot, options, notes](QPainter& painter, const Box& page, const Style& style) {
        const PixelFootprint& footprint = *snapshot->footprint;
        const double unit = style.pixelsPerPoint();
        const double below = weightsHeight(footprint, options, page.width() / unit, style.language) * unit;
        paintFootprint(painter, footprint, options, notes, {page.x0, page.y0, page.x1, page.y1 - below}, style);
        if (below > 0) paintWeights(painter, footprint, {page.x0, page.y1 - below, page.x1, page.y1}, style);
    };
    const auto aspect = [snapshot, options](const FigurePage& page) {
        constexpr double kLeastTexture = 0.35;  // height of the texture's room / the page's width
        const double points = page.widthMm / kMmPerPoint;
        const PixelFootprint& footprint = *snapshot->footprint;
        const Drawing legend = legendOf(footprint, options, true, points - kFigureMargins, page.style.language);
        const double texture = kLeastTexture * page.taller() * points + legendRoom(legend);
        return std::max(kFigureAspect, texture / points) +
               weightsHeight(footprint, options, points, page.style.language) / points;
    };
    return paintedFigure(paint, figureCaption(snapshot), aspect);
}

}  // namespace reliefui
