#include "panes/turntable.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>

namespace reliefui {

namespace {

constexpr double kSteepest = 1.55;    // in radians; never vertical, so that up stays up
constexpr double kTurnPerHeight = 3;  // radians for a drag over the height of the view
constexpr double kNearest = 1e-4;     // relative to the fitted distance
constexpr double kFit = 1.04;         // margin around the fitted places

double dot(const Turntable::Place& a, const Turntable::Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

Turntable::Axes Turntable::axes() const {
    const double ca = std::cos(azimuth_);
    const double sa = std::sin(azimuth_);
    const double ce = std::cos(elevation_);
    const double se = std::sin(elevation_);
    return {{-sa, ca, 0}, {-se * ca, -se * sa, ce}, {ce * ca, ce * sa, se}};
}

void Turntable::lookAlong(double x, double y) {
    azimuth_ = std::atan2(-y, -x);
    elevation_ = kElevation;
}

void Turntable::fit(const std::vector<Place>& places, double aspect) {
    if (places.empty()) return;
    Place low = places.front();
    Place high = low;
    for (const Place& p : places) {
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    }
    for (std::size_t c = 0; c < 3; ++c) focus_[c] = (low[c] + high[c]) / 2;
    const Axes a = axes();
    const double vertical = std::tan(halfView_);
    const double horizontal = vertical * std::max(aspect, 0.1);
    // Two passes, because the centre of the projection is not that of the bounding box.
    for (int pass = 0; pass < 2; ++pass) {
        distance_ = 0;
        double bottom = 0;
        double top = 0;
        for (const Place& p : places) {
            const Place d{p[0] - focus_[0], p[1] - focus_[1], p[2] - focus_[2]};
            const double near = dot(d, a.back);
            distance_ = std::max(distance_, near + std::abs(dot(d, a.right)) / horizontal);
            distance_ = std::max(distance_, near + std::abs(dot(d, a.up)) / vertical);
            bottom = std::min(bottom, dot(d, a.up));
            top = std::max(top, dot(d, a.up));
        }
        distance_ = std::max(distance_ * kFit, 1e-9);
        if (pass > 0) break;
        for (std::size_t c = 0; c < 3; ++c) focus_[c] += a.up[c] * (bottom + top) / 2;
    }
}

void Turntable::turn(double dx, double dy, double height) {
    azimuth_ -= dx / height * kTurnPerHeight;
    elevation_ = std::clamp(elevation_ + dy / height * kTurnPerHeight, -kSteepest, kSteepest);
}

void Turntable::move(double dx, double dy, double height) {
    const Axes a = axes();
    const double unit = 2 * distance_ * std::tan(halfView_) / height;
    for (std::size_t c = 0; c < 3; ++c) focus_[c] += (-dx * a.right[c] + dy * a.up[c]) * unit;
}

void Turntable::zoom(double factor, double x, double y) {
    const Axes a = axes();
    const double half = distance_ * std::tan(halfView_);
    const double by = half * (1 - 1 / factor);
    for (std::size_t c = 0; c < 3; ++c) focus_[c] += (x * a.right[c] + y * a.up[c]) * by;
    distance_ = std::max(distance_ / factor, kNearest);
}

void Turntable::apply(vtkCamera* camera) const {
    const Axes a = axes();
    camera->SetViewAngle(2 * halfView_ * 180 / M_PI);
    camera->SetFocalPoint(focus_.data());
    camera->SetPosition(eye().data());
    camera->SetViewUp(a.up.data());
}

Turntable::Place Turntable::eye() const {
    const Axes a = axes();
    return {focus_[0] + distance_ * a.back[0], focus_[1] + distance_ * a.back[1], focus_[2] + distance_ * a.back[2]};
}

double Turntable::viewHeight() const {
    return 2 * distance_ * std::tan(halfView_);
}

}  // namespace reliefui
