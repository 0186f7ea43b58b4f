// The camera of 3-D panes: turns around a point, up stays up. Drag turns, wheel zooms at the pointer.
#pragma once

#include <array>
#include <vector>

class vtkCamera;

namespace reliefui {

class Turntable {
  public:
    using Place = std::array<double, 3>;

    static constexpr double kElevation = 0.55;  // radians, at first

    // Half of the vertical field of view, radians: the smaller, the less near things are larger than far ones.
    explicit Turntable(double halfView = 0.26) : halfView_(halfView) {}

    // Looks along the horizontal direction (x, y), from above.
    void lookAlong(double x, double y);
    // As near as shows all places in a view of this aspect (width over height), without turning.
    void fit(const std::vector<Place>& places, double aspect);
    void setFocus(const Place& focus) { focus_ = focus; }

    // Pixels that the pointer moved; height of the view in pixels.
    void turn(double dx, double dy, double height);
    void move(double dx, double dy, double height);
    // factor > 1: nearer. (x, y): the pointer, from the middle of the view, y upwards, in halves of its height.
    void zoom(double factor, double x, double y);

    void apply(vtkCamera* camera) const;
    Place right() const { return axes().right; }

  private:
    struct Axes {
        Place right;
        Place up;
        Place back;  // towards the eye
    };
    Axes axes() const;

    double halfView_;
    Place focus_{0, 0, 0};
    double azimuth_ = 0;      // radians; where the eye is, around the vertical axis
    double elevation_ = 0.6;  // radians
    double distance_ = 1;
};

}  // namespace reliefui
