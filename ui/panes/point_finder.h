// Computes the distances of the scenario's point in the background, once per point and relief, for a pane that draws
// them.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "panes/point_query.h"
#include "workspace/latest_job.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Elevation, in degrees, of the flattest ray for which the method's map is valid; the maps' default if it uses none.
double servedFlattest(const relief::MethodChoice& method);
// Computed synchronously, for figures; null if there is no point or it lies outside the picture.
std::shared_ptr<const PointQuery> pointOf(const Snapshot& snapshot, const std::optional<QueryPoint>& point,
                                          relief::Work& work);

class PointFinder {
  public:
    // Must be constructed on the receiver's thread. found: called there when the value of known() has changed
    // asynchronously.
    PointFinder(const QObject* receiver, std::function<void()> found);

    // Starts computing the distances unless they are known or being computed; clears them if there is no point.
    void ask(const std::shared_ptr<const Snapshot>& snapshot, const std::optional<QueryPoint>& point);
    // Null until the distances are computed.
    const std::shared_ptr<const PointQuery>& known() const { return known_; }
    bool busy() const { return job_.busy(); }
    void drop();

  private:
    // Everything on which the distances depend.
    struct Question {
        QueryPoint point;
        std::shared_ptr<const void> heights;
        relief::Surface surface = relief::Surface::Bilinear;
        relief::Address address = relief::Address::Repeat;
        double depth = 0;
        double flattest = 0;
        bool operator==(const Question&) const = default;
    };

    std::function<void()> found_;
    std::optional<Question> pending_;
    std::shared_ptr<const PointQuery> known_;
    LatestJob job_;  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
