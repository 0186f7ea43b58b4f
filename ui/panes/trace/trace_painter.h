// Paints objects of the 3-D trace on a page, without what the relief hides of them.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <QPainter>

#include "panes/trace/trace3d_bodies.h"
#include "panes/trace/trace_mesh.h"

namespace reliefui {

Rgba faded(Rgba color, double opacity);

class TracePainter {
  public:
    // room: box of the page for the relief, see TraceEye.
    TracePainter(QPainter& painter, const TraceScene& scene, const TraceEye& eye, const Box& room, const Style& style)
        : painter_(painter), scene_(scene), eye_(eye), room_(room), style_(style), mesh_(scene) {}

    const TraceMesh& mesh() const { return mesh_; }
    bool visible(const Place& p) const { return ahead(p) && clearance(p) > 0; }

    void relief() const;
    // A line through places, `width` wide on the page. hidden: its hidden parts are dashed instead of left out.
    void line(const std::vector<Place>& places, Rgba color, double width, bool hidden = false) const;
    // A tube with a radius in the scene.
    void tube(const std::vector<Place>& places, double radius, Rgba color, bool hidden = false) const;
    // Fills the visible part of a surface over the unit square.
    void surface(const std::function<Place(double u, double v)>& at, Rgba color) const;
    void quad(const std::array<Place, 4>& corners, Rgba color) const;
    // The half of a sphere towards the eye, or the one behind it.
    void ball(const BodyShape& shape, Rgba color, bool far) const;
    void disk(const Place& at, double radius, Rgba color) const;
    // The white disk and the black ring of a hit; a hit that the relief hides has a dashed ring alone.
    void hit(const Place& at, double radius) const;
    // Text to the upper right (BottomLeft), lower right (TopLeft) or upper left (Right) of a place.
    void words(const Place& at, const std::string& text, double size, Anchor anchor);
    // A line of words at the lower left corner.
    void note(const std::string& text);
    void paintWords() const;

  private:
    using Runs = std::vector<std::pair<bool, QPolygonF>>;  // visible or not, and the line on the page

    bool ahead(const Place& p) const { return eye_.depth(p) > eye_.nearest(); }
    double clearance(const Place& p) const { return mesh_.clearance(p, eye_) + mesh_.tolerance(); }
    QPolygonF projected(const std::vector<Place>& places) const;
    void addRuns(Runs& runs, const Place& from, const Place& to) const;
    void addRun(Runs& runs, const Place& from, const Place& to, bool seen) const;

    QPainter& painter_;
    const TraceScene& scene_;
    const TraceEye& eye_;
    Box room_;
    const Style& style_;
    TraceMesh mesh_;
    Drawing labels_;
};

}  // namespace reliefui
