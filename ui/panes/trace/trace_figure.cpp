#include "panes/trace/trace_figure.h"

#include <algorithm>

#include <vtkGenericOpenGLRenderWindow.h>

#include "panes/figure_caption.h"
#include "panes/space_figure.h"
#include "panes/trace/trace3d_picture.h"
#include "panes/trace/trace_vectors.h"

namespace reliefui {

namespace {

struct TraceFigure : SpaceFigure {
    std::shared_ptr<const Snapshot> snapshot;
    int step = 0;
    TraceOptions options;

    bool vectors() const override { return true; }
    void paint(QPainter& painter, const Box& page, const Style& style) const override {
        paintTraceVectors(painter, page, style, *snapshot, step, options);
    }
    double aspect(const FigurePage& page) const override { return std::min(1.0, 0.75 * page.taller()); }
    std::string caption(relief::Language language) const override { return figureCaption(snapshot, step)(language); }
    QImage draw(vtkGenericOpenGLRenderWindow& window, const Style& style, const QSize& pixels) const override {
        TracePicture picture;
        picture.addTo(&window);
        picture.setSize(pixels);
        picture.setColors(options.colors);
        picture.show(snapshot, style, options.exaggeration);
        picture.showStep(step);
        if (options.camera) {
            picture.camera = *options.camera;
        } else {
            picture.fit(kTraceRoom);
            if (options.turn) turnForOrbit(picture.camera, *options.turn, [&] { picture.showAll(kTraceRoom); });
        }
        picture.place();
        const QImage image = rendered(window, pixels);
        picture.takeFrom(&window);
        return image;
    }
};

}  // namespace

std::shared_ptr<const Figure> traceFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                          const TraceOptions& options) {
    requireRay("trace", *snapshot);
    auto figure = std::make_shared<TraceFigure>();
    figure->snapshot = std::move(snapshot);
    figure->step = step;
    figure->options = options;
    return figure;
}

}  // namespace reliefui
