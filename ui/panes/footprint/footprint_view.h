// The footprint's pane: what the filter reads for the chosen pixel, and how much each texel counts. Wheel and drag zoom
// and move, R shows all again.
#pragma once

#include <memory>
#include <optional>

#include "panes/figure_view.h"
#include "panes/footprint/footprint_drawing.h"

class QBoxLayout;
class QComboBox;
class QHBoxLayout;
class QToolButton;

namespace reliefui {

class DrawingCanvas;

class FootprintView : public FigureView {
    Q_OBJECT
  public:
    explicit FootprintView(Workspace* workspace, QWidget* parent = nullptr);

    DrawingCanvas* canvas() const { return canvas_; }
    DrawingCanvas* weights() const { return weights_; }
    const FootprintOptions& options() const { return options_; }
    void setOptions(const FootprintOptions& options);
    // What is on the screen; null where there is nothing to show.
    const PixelFootprint* shown() const { return footprint_.get(); }
    const Drawing* marks() const { return marks_.get(); }

  public slots:
    void resetZoom();

  protected:
    void showSnapshot() override;
    bool outdated() const override { return shown_ != workspace_->snapshot(); }
    std::shared_ptr<const Figure> figure() const override;
    void tell(const QPointF& widget) override;
    void letGo() override;

  private:
    void makeBar(QHBoxLayout* bar);
    void makeRoom();     // for the weights, beside or below, where there is some
    void drawWeights();  // another footprint or room
    void showWeights();  // with the texel under the pointer
    // The texel under the pointer, for all panes.
    void point(std::optional<std::size_t> texel);
    // What it counts for.
    QString describe(const relief::FootprintTexel& texel) const;
    void adopt();   // what the scenario says
    void redraw();  // another part is seen, or another texel is under the pointer
    void showEmpty(relief::MessageId why);

    DrawingCanvas* canvas_;
    DrawingCanvas* weights_;  // the weight function and its map
    QBoxLayout* both_ = nullptr;
    QToolButton* weigh_ = nullptr;
    QComboBox* neighbours_ = nullptr;
    FootprintOptions options_;
    std::shared_ptr<const Snapshot> shown_;
    std::shared_ptr<const PixelFootprint> footprint_;
    std::shared_ptr<const Drawing> texture_;
    std::shared_ptr<const Drawing> marks_;
    std::shared_ptr<const Drawing> legend_;
    std::shared_ptr<const Drawing> plots_, plotsLegend_;  // of the weights
    std::optional<std::size_t> chosen_;                   // the texel under the pointer
};

}  // namespace reliefui
