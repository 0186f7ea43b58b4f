// Base class of all panes that can be exported: the context menu (copy value, copy picture, export), the export dialog,
// the readout of the item under the pointer. Panes that are not on screen are not drawn.
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
    // Text for the item under the pointer; empty if there is none.
    QString readout() const { return readout_; }
    // Renders the pane as it is exported, with the options used on screen; null if it shows nothing.
    QImage image(int width) const;
    // Returns true while figures are being written.
    bool saving() const { return saving_ > 0; }
    // The pane was closed: releases everything needed only for display. It is created again when the pane is shown.
    void releaseClosed();

  public slots:
    // Writes an SVG, PDF or PNG, depending on the extension. Drawn in the background; completion or failure is
    // reported.
    void saveFigure(const reliefui::FigureFile& file);
    // Also drawn in the background.
    void copyPicture();
    // Asks for a file name, then saves.
    void askFigure();

    // Cancels the pane's computations and returns true if there were any; figures are cancelled by Workspace::cancel().
    virtual bool cancel() { return false; }

  signals:
    void saved(const QString& path);
    void hovered(const QString& readout);

  protected:
    // name: of the figure and the file; dialog: title of the export dialog, "Export the profile".
    FigureView(Workspace* workspace, const QString& title, const QString& name, const QString& dialog, QWidget* parent);

    // Sets the part of the pane that has the context menu.
    void setFace(QWidget* face);
    void setReadout(const QString& text);
    // Draws the workspace's snapshot. Called only while the pane is on screen.
    virtual void showSnapshot() = 0;
    // Returns true if the pane holds data that is no longer needed and can be released while it is not on screen.
    virtual bool outdated() const { return false; }
    // Call this after a change of snapshot, style or choice: draws now, or when the pane is next on screen.
    void refresh();
    // Records a change; returns true if the pane is not on screen, so that it is not drawn now.
    bool markStaleIfHidden();
    bool stale() const { return stale_; }
    // For use in showSnapshot(): returns true if the pane was not on screen until now.
    bool becameVisible() const { return becameVisible_; }
    void paintEvent(QPaintEvent* event) override;
    // Returns true if the pane is on screen. A pane behind another tab lies outside the window, but is visible to Qt.
    bool isOnScreen() const { return isVisible() && !visibleRegion().isEmpty(); }

    // The figure that the pane shows; null if there is nothing to export.
    virtual std::shared_ptr<const Figure> figure() const = 0;
    // Reads out the item at this point of the face.
    virtual void readOut(const QPointF&) {}
    // Releases what the pane shows; showSnapshot() creates it again.
    virtual void releaseContents() {}
    // Adds entries above the common ones of the menu.
    virtual void addToMenu(QMenu&) {}
    // For panes that show a point's distances. pointAt(): the point of the slab at this point of the face; std::nullopt
    // if there is none.
    virtual bool showsPoints() const { return false; }
    virtual std::optional<QueryPoint> pointAt(const QPointF&) const { return std::nullopt; }
    // Widget coordinates of the point whose distances are shown; std::nullopt if it is not visible.
    virtual std::optional<QPointF> pointPlace() const { return std::nullopt; }
    // Shows the distances of the point there; if they are shown already, hides them.
    void askPoint(const QPointF& widget);
    void openMenu(const QPoint& at);

    Workspace* const workspace_;

  private:
    FigurePage page() const;
    void setPoint(const std::optional<QueryPoint>& point);
    void addPointToMenu(QMenu& menu, const QPoint& at);
    void drawInBackground(const Figure& figure, BackgroundTasks::Task draw);

    QString name_;
    QString dialog_;
    QWidget* face_ = nullptr;
    QString readout_;
    int saving_ = 0;
    bool stale_ = true;  // changed while it was not on screen
    bool becameVisible_ = false;
};

}  // namespace reliefui
