// The camera of the 3-D trace without VTK: the same perspective, onto a page.
#pragma once

#include "painting/drawing.h"
#include "panes/turntable.h"

namespace reliefui {

class TraceEye {
  public:
    using Place = Turntable::Place;

    // room: box of the page that the camera's view fills.
    TraceEye(const Turntable& camera, const Box& room);

    const Place& place() const { return place_; }
    // Direction of the scene in the camera's axes: to the right, up, towards the eye.
    Place turned(const Place& direction) const;
    // Distance from the eye along its axis; what is nearer than nearest() is not drawn.
    double depth(const Place& p) const { return -turned(away(p))[2]; }
    double nearest() const { return nearest_; }
    Point project(const Place& p) const;
    // Size on the page of a unit of the scene there.
    double unit(const Place& p) const { return focal_ / depth(p); }

  private:
    Place away(const Place& p) const { return {p[0] - place_[0], p[1] - place_[1], p[2] - place_[2]}; }

    Turntable::Axes axes_;
    Place place_;
    Point center_;
    double focal_;
    double nearest_;
};

}  // namespace reliefui
