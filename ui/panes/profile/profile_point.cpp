// The plane of the profile's ray, for drawing the point whose distances are shown.
#include <cmath>

#include "panes/profile/profile_drawing.h"

namespace reliefui {

std::optional<PointPlane> pointPlane(const PointQuery& query, const ProfileSource& source, const ProfileFrame& frame) {
    const double slab = source.field->slabTexels();
    if (frame.vertical || slab <= 0) return std::nullopt;
    const RayPath path(*source.field, source.ray);
    const auto lambdaOf = [=, &frame](double s, double t) {
        return ((s - path.start.x) * path.run.x + (t - path.start.y) * path.run.y) / (frame.run * frame.run);
    };
    const auto offOf = [=, &frame](double s, double t) {
        return ((s - path.start.x) * path.run.y - (t - path.start.y) * path.run.x) / frame.run;
    };
    PointPlane view;
    view.plot = frame.plot;
    view.at = [=, &frame](const Place3& place) { return frame.at(lambdaOf(place[0], place[1]), place[2] / slab); };
    view.center = {query.point.s, query.point.t, query.point.z * slab};
    const double lambda = lambdaOf(view.center[0], view.center[1]);
    const bool seen = lambda >= 0 && lambda <= frame.lambdaEnd &&
                      std::abs(offOf(view.center[0], view.center[1])) <= query.distances.refined;
    if (source.field->address() == relief::Address::Repeat && !seen) {
        const Point middle = path.at(frame.lambdaEnd / 2);
        view.center[0] = nearestCopy(view.center[0], middle.x, source.field->width());
        view.center[1] = nearestCopy(view.center[1], middle.y, source.field->height());
    }
    view.off = offOf(view.center[0], view.center[1]);
    view.scaleX = frame.plot.width() / (frame.lambdaEnd * frame.run);
    view.scaleY = frame.plot.height() / ((frame.high - frame.low) * slab);
    view.slab = slab;
    return view;
}

}  // namespace reliefui
