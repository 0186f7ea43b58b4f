// A small relief edited by hand: a grid of heights, or a profile that all rows repeat. The height of a texel is changed
// by dragging or typing; in a profile the pointer draws. All other panes follow while it changes.
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

// The drawn parts of the scenario and its snapshot.
DrawnSource drawnSource(const Snapshot& snapshot);
// Paints a figure: the drawing fitted to the page, and the legend below.
void paintDrawn(QPainter& painter, const DrawnSource& source, const Box& page, const Style& style);

// The editable relief.
class DrawnGrid : public QWidget {
    Q_OBJECT
  public:
    explicit DrawnGrid(Workspace* workspace, QWidget* parent = nullptr);

    std::optional<std::pair<int, int>> chosen() const { return chosen_; }
    void choose(std::optional<std::pair<int, int>> texel);
    // Widget coordinates of a texel's centre; in a profile, of a height at this column.
    QPointF placeOf(int i, int j, double height = 0.5) const;
    void refresh();

  signals:
    void chosenChanged();
    // first: the key that started it, or null
    void typingRequested(const QKeyEvent* first);
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
    void readOut(QPointF at);
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
    std::optional<QPointF> pointer_;  // where the pointer is; none while it is elsewhere
    double from_ = 0;                 // height at the start of the drag
    int lastColumn_ = -1;             // last column drawn in a profile
};

class DrawnView : public FigureView {
    Q_OBJECT
  public:
    explicit DrawnView(Workspace* workspace, QWidget* parent = nullptr);

    DrawnGrid* grid() const { return grid_; }

  public slots:
    // Starts with a relief of this many texels per side: from the picture around the chosen pixel's hit, flat, or of a
    // recipe.
    void startFromPicture();
    void startFlat(double height = 0);
    void startFromRecipe(const QString& recipe);
    // Changes the number of texels per side; the relief is resampled.
    void setSide(int side);
    void setProfile(bool on);
    // Sets the height of the chosen texel.
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
