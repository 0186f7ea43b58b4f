// An external pane with its figure and a setting that is stored in scenarios. It prints where the chosen ray enters the
// relief and where it hits, with the chosen number of decimals.
#pragma once

#include <QSpinBox>
#include <QVBoxLayout>

#include "painting/painter.h"
#include "panes/drawing_canvas.h"
#include "panes/figure_caption.h"
#include "panes/figure_view.h"
#include "panes/pane.h"
#include "scenario/step_sentence.h"
#include "workspace/pane_store.h"

namespace reliefui {

struct NumbersState {
    static constexpr const char* kName = "numbers";
    int decimals = 3;

    void read(relief::JsonReader reader) {
        reader.readWhole("decimals", decimals);
        reader.finish();
    }
    void check(const std::string& subject) const { checkWithin(subject, "decimals", decimals, 0, 9); }
    relief::Json json() const { return {{"decimals", decimals}}; }
    bool operator==(const NumbersState&) const = default;
};

inline Drawing numbersDrawing(const Snapshot& snapshot, const NumbersState& state) {
    Drawing drawing;
    drawing.bounds = {0, 0, 200, 40};
    const relief::ViewRay& ray = snapshot.trace.ray;
    const auto write = [&](double y, const std::string& name, double value) {
        Label label;
        label.at = {0, y};
        label.text = plainText(name + " = " + relief::fixedText(value, state.decimals));
        drawing.add({}, Role::Label, std::move(label));
    };
    write(10, "s0", ray.s0);
    write(20, "t0", ray.t0);
    if (snapshot.trace.hit.outcome == relief::Outcome::Hit) write(30, "lambda", snapshot.trace.hit.lambda);
    return drawing;
}

inline std::shared_ptr<const Figure> numbersFigure(std::shared_ptr<const Snapshot> snapshot,
                                                   const relief::Scenario& scenario) {
    return paintedFigure(
        [snapshot, state = stateOf<NumbersState>(scenario)](QPainter& painter, const Box& page, const Style& style) {
            const Drawing drawing = numbersDrawing(*snapshot, state);
            paintFigure(painter, {&drawing}, {}, page, style);
        },
        figureCaption(snapshot));
}

class NumbersView : public FigureView {
  public:
    NumbersView(Workspace* workspace, QWidget* parent)
        : FigureView(workspace, QStringLiteral("Numbers"), QStringLiteral("numbers"), QStringLiteral("Export numbers"),
                     parent),
          canvas_(new DrawingCanvas(this)),
          decimals_(new QSpinBox(this)) {
        setFace(canvas_);
        auto* const column = new QVBoxLayout(this);
        column->addWidget(decimals_);
        column->addWidget(canvas_);
        decimals_->setRange(0, 9);
        decimals_->setValue(stateOf<NumbersState>(workspace->scenario()).decimals);
        connect(decimals_, qOverload<int>(&QSpinBox::valueChanged), this, [this](int decimals) {
            workspace_->change(withState(workspace_->scenario(), NumbersState{decimals}), QStringLiteral("Decimals"));
        });
        connect(workspace, &Workspace::panesChanged, this, [this] {
            const QSignalBlocker blocked(decimals_);
            decimals_->setValue(stateOf<NumbersState>(workspace_->scenario()).decimals);
            refresh();
        });
        connect(workspace, &Workspace::styleChanged, this, &NumbersView::refresh);
    }

  protected:
    std::shared_ptr<const Figure> figure() const override {
        const auto shown = workspace_->snapshot();
        return shown ? numbersFigure(shown, workspace_->scenario()) : nullptr;
    }

    void showSnapshot() override {
        const auto shown = workspace_->snapshot();
        if (!shown) return;
        canvas_->setStyle(workspace_->style());
        const auto state = stateOf<NumbersState>(workspace_->scenario());
        canvas_->setLayers({std::make_shared<const Drawing>(numbersDrawing(*shown, state))}, nullptr);
    }
    void releaseContents() override { canvas_->releaseContents(); }

  private:
    DrawingCanvas* canvas_;
    QSpinBox* decimals_;
};

inline PaneKind numbersPane() {
    PaneKind kind;
    kind.name = QStringLiteral("numbers");
    kind.title = QStringLiteral("Numbers");
    kind.help = QStringLiteral("Where the ray enters and hits");
    kind.make = makePane<NumbersView>;
    kind.figures = {{"numbers", true, numbersFigure}};
    kind.states = {readerOf<NumbersState>()};
    return kind;
}

}  // namespace reliefui
