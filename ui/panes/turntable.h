// Camera of 3-D panes: orbits around a point with a fixed up direction. A drag rotates, the wheel zooms at the pointer.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

class vtkCamera;

namespace reliefui {

class Turntable {
  public:
    using Place = std::array<double, 3>;

    static constexpr double kElevation = 0.55;  // initial elevation, in radians

    // halfView: half of the vertical field of view, in radians; small values give little perspective.
    explicit Turntable(double halfView = 0.26) : halfView_(halfView) {}

    // Looks along the horizontal direction (x, y), from above.
    void lookAlong(double x, double y);
    // Moves the camera as close as possible with all places visible in a view of this aspect (width / height), without
    // rotating it.
    void fit(const std::vector<Place>& places, double aspect);
    // Turns the camera around the vertical through the focus, by an angle in radians.
    void rotate(double angle) { azimuth_ += angle; }
    // Moves the camera back until it is at least as far from its focus as the other one.
    void keepBack(const Turntable& other) { distance_ = std::max(distance_, other.distance_); }
    void setFocus(const Place& focus) { focus_ = focus; }

    // dx, dy: movement of the pointer in pixels; height: of the view in pixels.
    void turn(double dx, double dy, double height);
    void move(double dx, double dy, double height);
    // factor > 1: zooms in. (x, y): position of the pointer relative to the view's centre, y upwards, in units of half
    // its height.
    void zoom(double factor, double x, double y);

    void apply(vtkCamera* camera) const;
    // Height of the view at the focus, in units of the scene.
    double viewHeight() const;
    Place right() const { return axes().right; }
    struct Axes {
        Place right;
        Place up;
        Place back;  // direction towards the eye
    };
    Axes axes() const;
    Place eye() const;
    double halfView() const { return halfView_; }

  private:
    double halfView_;
    Place focus_{0, 0, 0};
    double azimuth_ = 0;      // in radians; direction of the eye around the vertical axis
    double elevation_ = 0.6;  // in radians
    double distance_ = 1;
};

}  // namespace reliefui
