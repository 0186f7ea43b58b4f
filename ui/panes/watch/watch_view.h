// The watched values of the chosen ray. A click in a graph chooses its value and the step; the bar adds and removes
// values.
#pragma once

#include <memory>

#include "panes/figure_view.h"
#include "panes/watch/watch_drawing.h"

class QComboBox;
class QToolButton;

namespace reliefui {

class DrawingCanvas;

class WatchView : public FigureView {
    Q_OBJECT
  public:
    explicit WatchView(Workspace* workspace, QWidget* parent = nullptr);

    DrawingCanvas* canvas() const { return canvas_; }
    const std::vector<WatchRow>& rows() const { return rows_; }
    const WatchFrame& frame() const { return frame_; }

  public slots:
    // Watches a column or an expression, which becomes the chosen value. What is no expression is refused with a
    // message.
    void watch(const QString& value);
    // Stops watching the chosen value.
    void removeChosen();

  protected:
    void showSnapshot() override;
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void releaseContents() override;

  private:
    void makeBar();
    void change(const WatchPane& pane);
    void adopt();  // takes over the scenario's state of this pane
    void fillNames();
    void choose(const QPointF& widget);
    void draw();

    DrawingCanvas* canvas_;
    QComboBox* names_ = nullptr;
    QToolButton* remove_ = nullptr;
    WatchPane pane_;
    std::vector<WatchRow> rows_;
    WatchFrame frame_;
};

}  // namespace reliefui
