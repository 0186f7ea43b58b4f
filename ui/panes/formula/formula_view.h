// The formula pane: a sheet that scrolls if it is higher than the pane. It follows the pixel, the step, the method and
// the filter.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QAbstractScrollArea>

#include "panes/figure_view.h"
#include "panes/formula/formula_drawing.h"

namespace reliefui {

// Shows the groups at full size in its own width.
class FormulaFace : public QAbstractScrollArea {
    Q_OBJECT
  public:
    explicit FormulaFace(QWidget* parent);

    // Without groups, shows the message `missing`.
    void setGroups(std::vector<FormulaGroup> groups, relief::Message missing, const Style& style);
    void setGroups(std::vector<FormulaGroup> groups, relief::MessageId missing, const Style& style) {
        setGroups(std::move(groups), relief::Message(missing), style);
    }
    const FormulaSheet& sheet() const { return sheet_; }
    // The row at this point of the viewport as one line of text; empty if there is none.
    QString rowAt(const QPointF& at) const;

  signals:
    void pointed(const QPointF& at);
    void left();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    bool viewportEvent(QEvent* event) override;

  private:
    void layOut();
    double margin() const;  // in pixels
    void readAgain();

    std::vector<FormulaGroup> groups_;
    relief::Message missing_;
    Style style_;
    FormulaSheet sheet_;
    std::optional<QPointF> pointer_;  // where the pointer is; none while it is elsewhere
};

class FormulaView : public FigureView {
    Q_OBJECT
  public:
    explicit FormulaView(Workspace* workspace, QWidget* parent = nullptr);

    const FormulaFace* face() const { return face_; }

  protected:
    void showSnapshot() override;
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& at) override;
    void releaseContents() override;

  private:
    FormulaFace* face_;
};

}  // namespace reliefui
