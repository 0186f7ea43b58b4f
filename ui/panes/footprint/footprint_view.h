// The footprint pane: the texels that the filter reads for the chosen pixel, and their weights. Wheel and drag zoom and
// move, R resets the view.
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

class AnnotationLayer;
class DrawingCanvas;

class FootprintView : public FigureView {
    Q_OBJECT
  public:
    explicit FootprintView(Workspace* workspace, QWidget* parent = nullptr);

    DrawingCanvas* canvas() const { return canvas_; }
    DrawingCanvas* weights() const { return weights_; }
    const FootprintOptions& options() const { return options_; }
    void setOptions(const FootprintOptions& options);
    // The footprint on the screen; null if there is none.
    const PixelFootprint* shown() const { return footprint_.get(); }
    const Drawing* marks() const { return marks_.get(); }

  public slots:
    void resetZoom();

  protected:
    void showSnapshot() override;
    bool outdated() const override { return shown_ != workspace_->snapshot(); }
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void releaseContents() override;
    void addToMenu(QMenu& menu) override;

  private:
    void makeBar(QHBoxLayout* bar);
    void makeRoom();     // places the weights to the right or below, if there is room
    void drawWeights();  // for another footprint or size
    void showWeights();  // with the texel under the pointer highlighted
    // Sets the texel under the pointer, for all panes.
    void point(std::optional<std::size_t> texel);
    // Describes a texel and its weight.
    QString describe(const relief::FootprintTexel& texel) const;
    void adopt();   // takes over the scenario's state of this pane
    void redraw();  // draws again for another visible part or texel under the pointer
    void showEmpty(relief::MessageId why);

    DrawingCanvas* canvas_;
    AnnotationLayer* annotations_ = nullptr;
    DrawingCanvas* weights_;  // weight function and map of weights
    QBoxLayout* both_ = nullptr;
    QToolButton* weigh_ = nullptr;
    QComboBox* neighbours_ = nullptr;
    FootprintOptions options_;
    std::shared_ptr<const Snapshot> shown_;
    std::shared_ptr<const PixelFootprint> footprint_;
    std::shared_ptr<const Drawing> texture_;
    std::shared_ptr<const Drawing> marks_;
    std::shared_ptr<const Drawing> legend_;
    std::shared_ptr<const Drawing> plots_, plotsLegend_;  // drawings of the weights
    std::optional<std::size_t> chosen_;                   // texel under the pointer
};

}  // namespace reliefui
