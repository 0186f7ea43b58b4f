// The footprint's pane: what the filter reads for the chosen pixel, and how much each texel counts. Wheel and drag zoom
// and move, R shows all again.
#pragma once

#include <memory>
#include <optional>

#include <QWidget>

#include "drawings/footprint_drawing.h"
#include "workspace/workspace.h"

class QComboBox;
class QHBoxLayout;

namespace reliefui {

class DrawingCanvas;

class FootprintView : public QWidget {
    Q_OBJECT
  public:
    explicit FootprintView(Workspace* workspace, QWidget* parent = nullptr);

    DrawingCanvas* canvas() const { return canvas_; }
    const FootprintOptions& options() const { return options_; }
    void setOptions(const FootprintOptions& options);
    // What is on the screen; null where there is nothing to show.
    const PixelFootprint* shown() const { return footprint_.get(); }
    const Drawing* marks() const { return marks_.get(); }
    // What is under the pointer.
    QString readout() const { return readout_; }
    // The pane as a picture, as it is exported, with the options of the screen.
    QImage picture(int width) const;

  public slots:
    void resetZoom();
    // SVG, PDF or PNG, by the ending; says when it is done, or why not.
    void saveFigure(const QString& path);

  signals:
    void saved(const QString& path);
    void hovered(const QString& readout);  // empty: nothing is under the pointer

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void makeBar(QHBoxLayout* bar);
    void refresh();  // another footprint, room or option
    void redraw();   // another part is seen, or another texel is under the pointer
    void showEmpty(relief::MessageId why);
    void tell(const QPointF& widget);
    void setReadout(const QString& text);
    void openMenu(const QPoint& at);
    void askFigure();
    bool inSight() const;

    Workspace* workspace_;
    DrawingCanvas* canvas_;
    QComboBox* neighbours_ = nullptr;
    FootprintOptions options_;
    QString readout_;
    std::shared_ptr<const Snapshot> shown_;
    std::shared_ptr<const PixelFootprint> footprint_;
    std::shared_ptr<const Drawing> texture_;
    std::shared_ptr<const Drawing> marks_;
    std::shared_ptr<const Drawing> legend_;
    std::optional<std::size_t> chosen_;  // the texel under the pointer
    bool stale_ = true;                  // changed while it was hidden
};

}  // namespace reliefui
