// The annotations over a pane: paints them, and lets the user add, choose, move, edit and remove them.
//
// The context menu and the key Insert add one at the pointer. A click chooses one; a drag moves it, or the end that was
// pressed; a double click or Enter edits its text, arrows move it (Shift: by ten pixels), Delete removes it, Esc lets
// go of it. Shift+Insert chooses the next one. All other mouse and keyboard input goes to the pane.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QWidget>

#include "painting/annotation.h"

class QMenu;

namespace reliefui {

class DrawingCanvas;
class Workspace;

class AnnotationLayer : public QWidget {
    Q_OBJECT
  public:
    // Where the pane's data are now; std::nullopt while it shows none.
    using FrameNow = std::function<std::optional<AnnotationFrame>()>;
    // Over a canvas. The frame's drawing is the canvas's; its unit is set here.
    AnnotationLayer(Workspace* workspace, DrawingCanvas* canvas, FrameNow frame);
    // Over a widget whose pixels are the units of the frame's drawing.
    AnnotationLayer(Workspace* workspace, QWidget* face, FrameNow frame);

    // Adds the entries for the point at which the context menu was requested.
    void addToMenu(QMenu& menu);
    // Number of the chosen annotation in the scenario's list; -1: none.
    int chosen() const { return chosen_; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    enum class Part : std::uint8_t { None, At, To, Both };
    struct Grip {
        int note = -1;
        Part part = Part::None;
    };

    void adopt();
    relief::Language language() const;
    std::optional<AnnotationFrame> frame() const;
    QPointF toWidget(Point drawing) const;
    Point toDrawing(QPointF widget) const;
    std::optional<Point> dataAt(QPointF widget) const;
    Grip gripAt(QPointF widget) const;
    Part partAt(const Annotation& note, QPointF widget) const;
    QPointF pointer() const;
    void choose(int note);
    void chooseNext();
    void add(AnnotationKind kind, QPointF widget);
    void edit(int note);
    void ask(const Annotation& note, const std::function<void(const Annotation&)>& done);
    void remove(int note);
    void move(const Annotation& from, Part part, QPointF by);
    void store(std::vector<Annotation> notes, const QString& what, int choice, const char* series = nullptr);
    Point roundedPlace(const AnnotationFrame& frame, QPointF widget) const;
    void addKinds(QMenu& menu, QPointF at);
    bool pressed(QPointF at);
    bool dragged(QPointF at);
    bool keyPressed(int key, bool shift);
    bool takes(int key, Qt::KeyboardModifiers modifiers) const;

    Workspace* const workspace_;
    QWidget* const face_;
    DrawingCanvas* canvas_ = nullptr;
    FrameNow frame_;
    std::vector<Annotation> notes_;  // of all views
    int chosen_ = -1;
    Grip drag_;
    bool moved_ = false;  // the drag has left the place at which it began
    QPointF pressed_;
    Annotation before_;  // the dragged one, as it was
    QPointF menuAt_;
};

}  // namespace reliefui
