// A small relief by hand: a grid of heights, or a profile that every row repeats. A texel is dragged up and down, or
// its height is typed; in a profile the pointer draws. All other panes follow while it changes.
#pragma once

#include <memory>
#include <optional>

#include <QWidget>

#include "painting/view_map.h"
#include "panes/drawn/drawn_drawing.h"
#include "panes/figure_view.h"

class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QToolButton;

namespace reliefui {

// What of the scenario and its snapshot is drawn.
DrawnSource drawnSource(const Snapshot& snapshot);
// The same as a figure: the drawing fitted into the page, the legend below.
void paintDrawn(QPainter& painter, const DrawnSource& source, const Box& page, const Style& style);

// The relief itself, with the mouse.
class DrawnGrid : public QWidget {
    Q_OBJECT
  public:
    explicit DrawnGrid(Workspace* workspace, QWidget* parent = nullptr);

    std::optional<std::pair<int, int>> chosen() const { return chosen_; }
    void choose(std::optional<std::pair<int, int>> texel);
    // The middle of a texel, of a profile the place of a height above it, on this widget.
    QPointF placeOf(int i, int j, double height = 0.5) const;
    void refresh();

  signals:
    void chosenChanged();
    // first: the key that began it, or none
    void typingWanted(const QKeyEvent* first);
    void hovered(const QString& readout);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    const relief::DrawnRelief& drawn() const { return workspace_->scenario().pictures.drawn; }
    Point toDrawing(QPointF widget) const;
    void setHeights(int first, int last, int row, double height);
    void drag(QPointF at);
    void tell(QPointF at);
    bool step(int key, bool large);
    bool typesHeight(const QKeyEvent& event) const;

    Workspace* workspace_;
    DrawnSource source_;
    DrawnPicture picture_;
    Drawing legend_;
    ViewMap map_;
    std::optional<std::pair<int, int>> chosen_;
    bool dragging_ = false;
    QPointF pressed_;
    double from_ = 0;      // the height where the drag began
    int lastColumn_ = -1;  // of a profile that is drawn
};

class DrawnView : public FigureView {
    Q_OBJECT
  public:
    explicit DrawnView(Workspace* workspace, QWidget* parent = nullptr);

    DrawnGrid* grid() const { return grid_; }

  public slots:
    // A relief of this many texels a side: from the picture around the chosen pixel's hit, flat, or of a recipe.
    void startFromPicture();
    void startFlat(double height = 0);
    void startFromRecipe(const QString& recipe);
    // Another number of texels a side; what is drawn is kept, as near as it can be.
    void setSide(int side);
    void setProfile(bool on);
    // Of the chosen texel.
    void setHeight(double height);

  protected:
    std::shared_ptr<const Figure> figure() const override;
    void showSnapshot() override;

  private:
    void makeBar(QHBoxLayout* starts, QHBoxLayout* bar);
    void showControls();
    void set(relief::DrawnRelief drawn, const QString& what);
    int side() const;
    const relief::DrawnRelief& drawn() const { return workspace_->scenario().pictures.drawn; }

    DrawnGrid* grid_;
    QComboBox* start_ = nullptr;
    QComboBox* side_ = nullptr;
    QToolButton* profile_ = nullptr;
    QDoubleSpinBox* height_ = nullptr;
};

}  // namespace reliefui
