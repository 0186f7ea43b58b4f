// What all panes that can be exported have in common: the menu (copy value, copy picture, export), the export dialog,
// the readout of what is under the pointer, and that nothing is drawn out of sight.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QImage>
#include <QWidget>

#include "panes/figure_export.h"
#include "panes/point_state.h"
#include "workspace/workspace.h"

class QMenu;

namespace reliefui {

class FigureView : public QWidget {
    Q_OBJECT
  public:
    // What is under the pointer; empty: nothing.
    QString readout() const { return readout_; }
    // The pane as a picture, as it is exported, with the options of the screen; null where there is nothing.
    QImage image(int width) const;
    // Figures that are being drawn.
    bool saving() const { return saving_ > 0; }
    // Closed: lets go of all that it holds to be seen; made again when it is.
    void giveBack();

  public slots:
    // SVG, PDF or PNG, by the ending; drawn aside, and said when it is done, or why not.
    void saveFigure(const reliefui::FigureFile& file);
    // Drawn aside as well.
    void copyPicture();
    // Asks where to first.
    void askFigure();

    // What it computes; its figures: Workspace::cancel().
    virtual void cancel() {}

  signals:
    void saved(const QString& path);
    void hovered(const QString& readout);

  protected:
    // name: of the figure and of the file; dialog: the title of its dialog, "Export the profile".
    FigureView(Workspace* workspace, const QString& title, const QString& name, const QString& dialog, QWidget* parent);

    // The part of the pane that has the menu.
    void setFace(QWidget* face);
    void setReadout(const QString& text);
    // Draws what the workspace holds; called in sight alone.
    virtual void showSnapshot() = 0;
    // Whether it holds something that is not wanted any more, to be let go while it is out of sight.
    virtual bool outdated() const { return false; }
    // For another snapshot, style or choice: at once, or when it comes into sight.
    void refresh();
    // Remembers that something has changed; true where it is not drawn now.
    bool outOfSight();
    bool stale() const { return stale_; }
    // In showSnapshot(): whether it was out of sight until now.
    bool cameIntoSight() const { return cameIntoSight_; }
    void paintEvent(QPaintEvent* event) override;
    // A pane behind another tab counts as visible for Qt; it only lies outside the window.
    bool inSight() const { return isVisible() && !visibleRegion().isEmpty(); }

    // What it shows; null: there is nothing to be exported.
    virtual std::shared_ptr<const Figure> figure() const = 0;
    // Reads out what lies under this point of the face.
    virtual void tell(const QPointF&) {}
    // Lets go of what it shows; showSnapshot() makes it again.
    virtual void letGo() {}
    // More entries, above the common ones.
    virtual void addToMenu(QMenu&) {}
    // Of a pane that shows a point's distances: the point of the slab under this point of the face; none: there is
    // none.
    virtual bool showsPoints() const { return false; }
    virtual std::optional<QueryPoint> pointAt(const QPointF&) const { return std::nullopt; }
    // Where the point is drawn whose distances are shown; none: it is not seen.
    virtual std::optional<QPointF> pointPlace() const { return std::nullopt; }
    // Makes the point there the one whose distances are shown; if it is that already, shows none.
    void askPoint(const QPointF& widget);
    void openMenu(const QPoint& at);

    Workspace* const workspace_;

  private:
    FigurePage page() const;
    void setPoint(const std::optional<QueryPoint>& point);
    void addPointToMenu(QMenu& menu, const QPoint& at);
    void drawAside(const Figure& figure, BackgroundTasks::Task draw);

    QString name_;
    QString dialog_;
    QWidget* face_ = nullptr;
    QString readout_;
    int saving_ = 0;
    bool stale_ = true;  // changed while it was out of sight
    bool cameIntoSight_ = false;
};

}  // namespace reliefui
