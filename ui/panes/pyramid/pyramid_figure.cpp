#include "panes/pyramid/pyramid_figure.h"

#include <algorithm>

#include <vtkGenericOpenGLRenderWindow.h>

#include "painting/cell_image.h"
#include "painting/painter.h"
#include "panes/figure_caption.h"
#include "panes/pyramid/slab_scene.h"
#include "panes/space_figure.h"

namespace reliefui {

namespace {

struct Page {
    Drawing legend;
    Box room;
    PyramidParts parts;
};

Page pageOf(const Snapshot& snapshot, const PyramidOptions& options, const Box& page, const Style& style) {
    const double unit = style.pixelsPerPoint();
    Page made;
    // Two passes: the legend's height determines the room of the levels, and their visible part determines the legend.
    for (int n = 0; n < 2; ++n) {
        made.room = figureRoom(made.legend, page, style);
        made.parts =
            pyramidParts(snapshot, options, made.room.width() / unit, made.room.height() / unit, style.language);
        made.legend = pyramidLegend(pyramidSource(snapshot, options), made.parts.heights,
                                    page.width() / unit - kFigureMargins, style.language);
    }
    return made;
}

bool everyValueIsWritten(const Page& page, const Style& style) {
    const double scale = ViewMap::fitting(page.parts.levels.bounds, page.room).scale;
    return std::all_of(page.parts.levels.items.begin(), page.parts.levels.items.end(), [&](const Item& item) {
        const auto* const cells = std::get_if<Cells>(&item.primitive);
        return cells == nullptr || cellText(*cells, visibleCells(*cells, cells->clip), scale, style).pixels > 0;
    });
}

// High enough to print every value, unless the page would become higher than wide.
double aspectOf(const Snapshot& snapshot, const PyramidOptions& options, const FigurePage& page) {
    // pixels per point; fine enough that rounding of font sizes to whole pixels does not matter
    constexpr double kFiner = 8;
    constexpr double kHigher = 0.04;
    Style style = page.style;
    style.projector = false;
    style.screenPixelsPerPoint = kFiner;
    const double width = page.widthMm / kMmPerPoint * kFiner;
    const double least = kFigureAspect * page.taller();
    for (double aspect = least; aspect <= 1; aspect += kHigher) {
        if (everyValueIsWritten(pageOf(snapshot, options, {0, 0, width, width * aspect}, style), style)) return aspect;
    }
    return least;
}

struct SlabsFigure : SpaceFigure {
    std::shared_ptr<const Snapshot> snapshot;
    int step = 0;
    PyramidOptions options;
    std::optional<Turntable> camera;
    std::optional<double> turn;

    double aspect(const FigurePage& page) const override { return 0.5 * page.taller(); }
    std::string caption(relief::Language language) const override { return figureCaption(snapshot, step)(language); }
    QImage draw(vtkGenericOpenGLRenderWindow& window, const Style& style, const QSize& pixels) const override {
        SlabScene scene;
        scene.addTo(&window);
        const double width = pixels.width() / style.screenPixelsPerPoint;
        const double height = pixels.height() / style.screenPixelsPerPoint;
        const PyramidParts parts = pyramidParts(*snapshot, options, width, height);
        scene.show(parts, style);
        scene.showStep(step);
        scene.lookFromHome();
        if (camera) scene.camera = *camera;
        // Keeps the camera's direction and moves it as close as the picture allows.
        const auto fit = [&] { scene.showAll(pixels.width(), pixels.height()); };
        fit();
        if (turn) turnForOrbit(scene.camera, *turn, fit);
        scene.place();
        const QImage image = rendered(window, pixels);
        scene.takeFrom(&window);
        return image;
    }
};

}  // namespace

std::shared_ptr<const Figure> pyramidFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            const PyramidOptions& options, const std::vector<Annotation>& notes) {
    return paintedFigure(
        [snapshot, step, options, notes](QPainter& painter, const Box& page, const Style& style) {
            const Page made = pageOf(*snapshot, options, page, style);
            const Drawing marks = partsMarks(made.parts, step);
            const Drawing annotations = made.parts.parts.empty()
                                            ? Drawing{}
                                            : annotationDrawing(notes, pyramidAnnotations(made.parts), style.language);
            paintFigure(painter, {&made.parts.levels, &marks, &annotations}, made.legend, page, style);
        },
        figureCaption(snapshot, step),
        [snapshot, options](const FigurePage& page) { return aspectOf(*snapshot, options, page); });
}

AnnotationFrame pyramidAnnotations(const PyramidParts& parts) {
    const LevelBlock block = parts.parts.front().picture.blocks.front();
    return {"pyramid", [block](Point p) { return block.toDrawing(p); },
            [block](Point p) {
                const Box at = block.toTexels({p.x, p.y, p.x, p.y});
                return Point{at.x0, at.y0};
            },
            block.box};
}

std::shared_ptr<const Figure> slabsFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                          const PyramidOptions& options, const std::optional<Turntable>& camera,
                                          std::optional<double> turn) {
    auto figure = std::make_shared<SlabsFigure>();
    figure->snapshot = std::move(snapshot);
    figure->step = step;
    figure->options = options;
    figure->options.slender = true;
    figure->camera = camera;
    figure->turn = turn;
    return figure;
}

}  // namespace reliefui
