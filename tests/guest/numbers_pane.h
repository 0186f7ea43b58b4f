// A guest: a pane of somebody else's, with its figure. It writes where the chosen ray enters the relief and where it
// hits.
#pragma once

#include <QVBoxLayout>

#include "painting/painter.h"
#include "panes/drawing_canvas.h"
#include "panes/figure_caption.h"
#include "panes/figure_view.h"
#include "panes/pane.h"
#include "scenario/step_sentence.h"

namespace reliefui {

inline Drawing numbersDrawing(const Snapshot& snapshot) {
    Drawing drawing;
    drawing.bounds = {0, 0, 200, 40};
    const relief::ViewRay& ray = snapshot.trace.ray;
    const auto write = [&](double y, const std::string& name, double value) {
        Label label;
        label.at = {0, y};
        label.text = plainText(name + " = " + relief::fixedText(value, 3));
        drawing.add({}, Role::Label, std::move(label));
    };
    write(10, "s0", ray.s0);
    write(20, "t0", ray.t0);
    if (snapshot.trace.hit.outcome == relief::Outcome::Hit) write(30, "lambda", snapshot.trace.hit.lambda);
    return drawing;
}

inline std::shared_ptr<const Figure> numbersFigure(std::shared_ptr<const Snapshot> snapshot) {
    return paintedFigure(
        [snapshot](QPainter& painter, const Box& page, const Style& style) {
            const Drawing drawing = numbersDrawing(*snapshot);
            paintFigure(painter, {&drawing}, {}, page, style);
        },
        figureCaption(snapshot));
}

class NumbersView : public FigureView {
  public:
    NumbersView(Workspace* workspace, QWidget* parent)
        : FigureView(workspace, QStringLiteral("Numbers"), QStringLiteral("numbers"), QStringLiteral("Export numbers"),
                     parent),
          canvas_(new DrawingCanvas(this)) {
        setFace(canvas_);
        auto* const column = new QVBoxLayout(this);
        column->addWidget(canvas_);
        connect(workspace, &Workspace::styleChanged, this, &NumbersView::refresh);
    }

  protected:
    std::shared_ptr<const Figure> figure() const override {
        const auto shown = workspace_->snapshot();
        return shown ? numbersFigure(shown) : nullptr;
    }

    void showSnapshot() override {
        const auto shown = workspace_->snapshot();
        if (!shown) return;
        canvas_->setStyle(workspace_->style());
        canvas_->setLayers({std::make_shared<const Drawing>(numbersDrawing(*shown))}, nullptr);
    }
    void letGo() override { canvas_->letGo(); }

  private:
    DrawingCanvas* canvas_;
};

inline PaneKind numbersPane() {
    PaneKind kind;
    kind.name = QStringLiteral("numbers");
    kind.title = QStringLiteral("Numbers");
    kind.help = QStringLiteral("Where the ray enters and hits");
    kind.make = makePane<NumbersView>;
    kind.figures = {{"numbers", true, plainFigure<numbersFigure>}};
    return kind;
}

}  // namespace reliefui
