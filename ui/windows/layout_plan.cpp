#include "windows/layout_plan.h"

namespace reliefui {

namespace {

// Smallest window in which two panes, one above the other, are both large enough to read.
constexpr QSize kWide(1400, 850);

}  // namespace

LayoutPlan layoutPlan(bool teaching, bool projector, const QSize& window) {
    //                           controls one    table  left  right  steps  upper
    constexpr LayoutPlan kDesktop{true, false, true, 0.20, 0.38, 0.23, 5.0 / 9};
    constexpr LayoutPlan kSmallDesktop{true, true, true, 0.20, 0.42, 0.27, 1};
    constexpr LayoutPlan kProjector{false, true, true, 0, 0.52, 0.30, 1};
    constexpr LayoutPlan kTeaching{false, true, false, 0, 0.70, 0, 1};
    if (teaching) return kTeaching;
    if (projector) return kProjector;
    const bool wide = window.width() >= kWide.width() && window.height() >= kWide.height();
    return wide ? kDesktop : kSmallDesktop;
}

}  // namespace reliefui
