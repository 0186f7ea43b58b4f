#include "panes/trace/trace_eye.h"

#include <cmath>

namespace reliefui {

TraceEye::TraceEye(const Turntable& camera, const Box& room)
    : axes_(camera.axes()),
      place_(camera.eye()),
      center_(room.center()),
      focal_(room.height() / 2 / std::tan(camera.halfView())) {
    constexpr double kNearest = 0.01;  // relative to the height of the view at the camera's focus
    nearest_ = kNearest * camera.viewHeight();
}

TraceEye::Place TraceEye::turned(const Place& direction) const {
    const auto along = [&](const Place& axis) {
        return direction[0] * axis[0] + direction[1] * axis[1] + direction[2] * axis[2];
    };
    return {along(axes_.right), along(axes_.up), along(axes_.back)};
}

Point TraceEye::project(const Place& p) const {
    const Place at = turned(away(p));
    return {center_.x - focal_ * at[0] / at[2], center_.y + focal_ * at[1] / at[2]};
}

}  // namespace reliefui
