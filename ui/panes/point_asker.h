// The scenario's point with its distances, for a pane that draws it: found in the background, once for each point and
// relief.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "panes/point_query.h"
#include "workspace/latest_job.h"
#include "workspace/snapshot.h"

namespace reliefui {

// The elevation, degrees, of the flattest ray that the method's map serves; of the maps' default where it walks none.
double servedFlattest(const relief::MethodChoice& method);
// At once, for figures; null: no point, or none over the picture.
std::shared_ptr<const PointQuery> pointOf(const Snapshot& snapshot, const std::optional<QueryPoint>& point,
                                          relief::Work& work);

class PointAsker {
  public:
    // To be made on the receiver's thread. found: called there when known() has got another value by itself.
    PointAsker(const QObject* receiver, std::function<void()> found);

    // Starts to find the distances unless they are known or on their way; without a point, forgets.
    void ask(const std::shared_ptr<const Snapshot>& snapshot, const std::optional<QueryPoint>& point);
    // Null until they are found.
    const std::shared_ptr<const PointQuery>& known() const { return known_; }
    bool busy() const { return job_.busy(); }
    void drop();

  private:
    // What the distances depend on.
    struct Question {
        QueryPoint point;
        std::shared_ptr<const relief::FloatImage> heights;
        relief::Surface surface = relief::Surface::Bilinear;
        relief::Address address = relief::Address::Repeat;
        double depth = 0;
        double flattest = 0;
        bool operator==(const Question&) const = default;
    };

    std::function<void()> found_;
    std::optional<Question> asked_;
    std::shared_ptr<const PointQuery> known_;
    LatestJob job_;  // last: ends before the rest
};

}  // namespace reliefui
