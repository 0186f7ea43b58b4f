// The spheres and cones in the distance map's pane are those of the step records.
#include <cmath>
#include <set>

#include <QComboBox>

#include "distance_fixture.h"
#include "panes/distance/distance_view.h"
#include "panes/steps/step_table.h"
#include "windows/time_pane.h"

namespace reliefui {

namespace {

// Returns the drawing's items of this role and kind of primitive.
template <class Primitive>
std::vector<const Item*> itemsOf(const Drawing& drawing, Role role) {
    std::vector<const Item*> found;
    for (const Item& item : drawing.items) {
        if (item.role == role && std::holds_alternative<Primitive>(item.primitive)) found.push_back(&item);
    }
    return found;
}

TEST_F(DistanceTest, SpheresAreCutByTheSlice) {
    for (const char* const method : {"distance-conservative", "distance"}) {
        openPane(walled(method, {{"layers", "16"}}));
        const auto& steps = snapshot()->trace.steps;
        DistanceOptions options;
        options.axis = SliceAxis::Y;
        show(options);
        int seen = 0;
        for (std::size_t k = 0; k < steps.size(); ++k) {
            const DistanceSource source = distanceSource(*snapshot(), {});
            const StepBody body = stepBody(steps[k]);
            if (!body || body.radius < 0.5) continue;
            // The tracer advanced to where the ray leaves the sphere.
            const double perLambda = std::hypot(source.ray.a, source.ray.b, source.field->slabTexels());
            EXPECT_NEAR(body.lambda + body.radius / perLambda, steps[k].lambdaAfter, 1e-6);
            workspace_->chooseStep(static_cast<int>(k));
            settle();
            DistanceFrame frame = view()->shown()->frame;
            const Place3 center = placeOnRay(source, body.lambda);
            for (const double off : {0.0, 0.6 * body.radius, 1.2 * body.radius}) {
                frame.plane = center[1] + off;
                // A frame so large that nothing is clipped.
                constexpr double kFar = 1e4;
                frame.plot = {-kFar, -kFar, kFar, kFar};
                frame.window = {-kFar / frame.scale, -kFar / frame.scale, 0, 0};
                const Drawing marks = distanceMarks(source, frame, static_cast<int>(k));
                Box extent;
                for (const Item* const item : itemsOf<Polyline>(marks, bodyRole(steps[k], source.ray, source.exact))) {
                    if (item->id.i != static_cast<std::int64_t>(k)) continue;
                    for (const Point& p : std::get<Polyline>(item->primitive).points) {
                        extent = extent.joined({p.x, p.y, p.x, p.y});
                    }
                }
                if (off > body.radius) {
                    EXPECT_TRUE(extent.empty());
                    continue;
                }
                const double diameter = 2 * std::sqrt(body.radius * body.radius - off * off) * frame.scale;
                EXPECT_NEAR(extent.width(), diameter, 1e-6 * diameter);
                EXPECT_NEAR(extent.height(), diameter, 1e-6 * diameter) << "a circle is round";
                ++seen;
            }
        }
        EXPECT_GT(seen, 0) << method;
    }
}

// The tracer advanced to where the ray leaves the cone that the map promises to be free; and the relief is outside of
// the cone.
TEST_F(DistanceTest, ConesEndWhereTheStepsDo) {
    openPane(walled("cone", {{"sectors", "8"}}));
    const DistanceSource source = distanceSource(*snapshot(), {});
    int seen = 0;
    for (const relief::Step& step : snapshot()->trace.steps) {
        const StepBody body = stepBody(step);
        if (!body) continue;
        const double run = std::hypot(source.ray.a, source.ray.b);
        const double way = (step.lambdaAfter - body.lambda) * run;
        EXPECT_NEAR(1 - step.lambdaAfter, body.apex + body.slope * way, 1e-6);
        EXPECT_TRUE(body.holds(source.ray.a, source.ray.b));
        EXPECT_FALSE(body.holds(-source.ray.a, -source.ray.b));
        const Place3 over = placeOnRay(source, body.lambda);
        for (double angle = body.from; angle < body.to; angle += 0.05) {
            for (double r = 0; r < 20; r += 0.25) {
                const double height = source.field->at(over[0] + r * std::cos(angle), over[1] + r * std::sin(angle));
                EXPECT_LE(height, body.apex + body.slope * r + 1e-6);
            }
        }
        ++seen;
    }
    EXPECT_GT(seen, 0);
    ASSERT_NE(view()->shown(), nullptr);
    EXPECT_TRUE(view()->shown()->frame.slopes);
    EXPECT_EQ(view()->shown()->frame.sectors, 8);
    EXPECT_TRUE(control<QComboBox>("distance-sector")->isVisible());
    // Another sector has other slopes.
    const auto before = view()->shown()->slice.values;
    DistanceOptions options;
    options.sector = (view()->shown()->frame.sector + 4) % 8;
    show(options);
    EXPECT_FALSE(*before == *view()->shown()->slice.values);
}

TEST_F(DistanceTest, ConesAreCutFromTheSideAndFromAbove) {
    openPane(walled("cone"));
    const DistanceSource source = distanceSource(*snapshot(), {});
    DistanceOptions options;
    options.kind = "euclidean";
    for (const SliceAxis axis : {SliceAxis::X, SliceAxis::Z}) {
        options.axis = axis;
        int cones = 0;
        for (std::size_t k = 0; k < snapshot()->trace.steps.size(); ++k) {
            const relief::Step& step = snapshot()->trace.steps[k];
            const StepBody body = stepBody(step);
            if (!body) continue;
            workspace_->chooseStep(static_cast<int>(k));
            show(options);
            ASSERT_NE(view()->shown(), nullptr);
            const DistanceFrame& frame = view()->shown()->frame;
            const Place3 over = placeOnRay(source, body.lambda);
            const Drawing marks = distanceMarks(source, frame, static_cast<int>(k));
            for (const Item* const item : itemsOf<Polyline>(marks, bodyRole(step, source.ray, source.exact))) {
                if (item->id.i != static_cast<std::int64_t>(k)) continue;
                // Every point of the line lies on the cone.
                for (const Point& p : std::get<Polyline>(item->primitive).points) {
                    const Place3 place = fromSlice(axis, frame.slab, frame.plane, frame.uvAt(p));
                    const double away = body.away(place[0] - over[0], place[1] - over[1]);
                    // Seen from above, the outline of a sector has a corner on the axis.
                    if (axis == SliceAxis::Z && !body.whole() && away < 0.01) continue;
                    // Between its points, the polyline of a circle is slightly inside the circle.
                    EXPECT_NEAR(place[2] / frame.slab, body.apex + body.slope * away, 0.01);
                }
                ++cones;
            }
        }
        EXPECT_GT(cones, 0) << static_cast<int>(axis);
    }
}

// A distance must not be shown as a height, neither in the sentence nor in the 3-D trace.
TEST_F(DistanceTest, StepsAreDescribedByTheirDistances) {
    openPane(walled("distance-conservative"));
    std::set<relief::Decision> described;
    for (std::size_t k = 0; k < snapshot()->trace.steps.size(); ++k) {
        const relief::Step& step = snapshot()->trace.steps[k];
        workspace_->chooseStep(static_cast<int>(k));
        const QString sentence = window_->time()->table()->sentence();
        if (step.decision == relief::Decision::Advance) {
            const QString distance = QString::number(step.value, 'f', 2) + QStringLiteral(" texels");
            EXPECT_TRUE(sentence.contains(distance)) << sentence.toStdString();
        }
        if (step.decision == relief::Decision::Test) {
            EXPECT_FALSE(sentence.contains(QStringLiteral("-1"))) << sentence.toStdString();
        }
        described.insert(step.decision);
    }
    EXPECT_TRUE(described.contains(relief::Decision::Advance));
}

}  // namespace

}  // namespace reliefui
