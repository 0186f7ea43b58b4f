// The distances of a point, queried in the distance map and in the profile.
#include "panes/point_query.h"

#include <algorithm>
#include <cmath>

#include "distance_fixture.h"
#include "lessons/lessons.h"
#include "panes/point_finder.h"
#include "panes/profile/profile_view.h"
#include "windows/pane_list.h"
#include "workspace/pane_store.h"

namespace reliefui {

namespace {

constexpr double kRounding = 1e-5;  // of heights in float

std::optional<QueryPoint> pointIn(const relief::Scenario& scenario) {
    return stateOf<PointState>(scenario).point;
}

relief::Scenario walls(bool withPoint = true) {
    relief::Scenario scenario = lessonScenario(QStringLiteral("paper_walls"));
    if (!withPoint) {
        setState(scenario, PointState{});
    }
    return scenario;
}

// Returns the distances in texels from C to the points of the circles with this role.
std::vector<double> radii(const Drawing& drawing, Role role, Point center, double scale) {
    constexpr std::size_t kLine = 2;
    std::vector<double> all;
    for (const Item& item : drawing.items) {
        const auto* const line = std::get_if<Polyline>(&item.primitive);
        if (line == nullptr || item.role != role || line->points.size() <= kLine) continue;
        for (const Point& p : line->points) all.push_back(std::hypot(p.x - center.x, p.y - center.y) / scale);
    }
    return all;
}

TEST_F(DistanceTest, OfThePapersPointBothSpheresAndLinesAreDrawn) {
    openPane(walls());
    ASSERT_NE(view()->point(), nullptr);
    const PointQuery& query = *view()->point();
    EXPECT_NEAR(query.distances.euclidean, 3, kRounding);
    EXPECT_NEAR(query.distances.refined, 4, kRounding);
    DistanceFrame frame = view()->shown()->frame;
    const relief::HeightField& field = snapshot()->request->field;
    Drawing drawing;
    addPointMarks(drawing, query, pointPlane(query, field, frame));
    const Point c = frame.at(Place3{4, 4.5, 6});
    for (const auto& [role, radius] : {std::pair(Role::Series, 3.0), std::pair(Role::SeriesDashed, 4.0)}) {
        const std::vector<double> found = radii(drawing, role, c, frame.scale);
        ASSERT_GT(found.size(), 50U);
        for (const double one : found) EXPECT_NEAR(one, radius, 0.01);
    }
    // Also the ray that the right wall blocks.
    const auto crossed = std::find_if(drawing.items.begin(), drawing.items.end(), [](const Item& item) {
        return item.role == Role::Hidden && std::holds_alternative<Marker>(item.primitive);
    });
    ASSERT_NE(crossed, drawing.items.end());
    EXPECT_GE(frame.uvAt(std::get<Marker>(crossed->primitive).at).x, 8 - kRounding);
    // A slice that misses both spheres shows neither.
    frame.plane += 4.5;
    Drawing missed;
    addPointMarks(missed, query, pointPlane(query, field, frame));
    EXPECT_TRUE(missed.items.empty());

    LegendRows rows(600, relief::Language::English);
    addPointLegend(rows, query);
    std::string text;
    for (const Item& item : rows.take().items) {
        if (const auto* const label = std::get_if<Label>(&item.primitive)) {
            text += labelText(*label, relief::Language::English) + "\n";
        }
    }
    EXPECT_NE(text.find("3.000"), std::string::npos) << text;
    EXPECT_NE(text.find("4.000 texels; decided by V2, the ray that enters at (4, 4.5) and runs by (0, 0) texels"),
              std::string::npos)
        << text;
}

TEST_F(DistanceTest, CtrlClickChoosesAPointAndASecondOneRemovesIt) {
    openPane(walls(false));
    EXPECT_EQ(view()->point(), nullptr);
    const QImage without = view()->image(500);
    const int step = scenario().step;
    const DistanceFrame frame = view()->shown()->frame;
    const QPoint at = canvas()->toWidget(frame.at(Place3{4, 4.5, 6})).toPoint();
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::ControlModifier, at);
    ASSERT_NO_FATAL_FAILURE(settle());
    ASSERT_TRUE(pointIn(scenario()));
    ASSERT_NE(view()->point(), nullptr);
    const double pixel = 2 / frame.scale;  // texels; with a margin
    EXPECT_NEAR(pointIn(scenario())->s, 4, pixel);
    EXPECT_EQ(pointIn(scenario())->t, frame.plane);
    EXPECT_NEAR(pointIn(scenario())->z, 0.6, pixel / 10);
    EXPECT_NEAR(view()->point()->distances.euclidean, 3, pixel);
    EXPECT_NEAR(view()->point()->distances.refined, 4, pixel);
    EXPECT_EQ(scenario().step, step) << "it chooses no step";
    EXPECT_NE(view()->image(500), without) << "it is exported, too";
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::ControlModifier, at + QPoint(2, 1));
    ASSERT_NO_FATAL_FAILURE(settle());
    EXPECT_FALSE(pointIn(scenario()));
    EXPECT_EQ(view()->point(), nullptr);
    EXPECT_EQ(view()->image(500), without);
    workspace_->undo();
    ASSERT_NO_FATAL_FAILURE(settle());
    EXPECT_TRUE(pointIn(scenario()));
}

TEST_F(DistanceTest, ASecondClickRemovesItInAnotherCopyAndAtThePlotsEdgeToo) {
    openPane(walled("distance-conservative"));
    const DistanceFrame frame = view()->shown()->frame;
    const relief::HeightField& field = snapshot()->request->field;
    const auto click = [&](Point drawn) {
        QTest::mouseClick(canvas(), Qt::LeftButton, Qt::ControlModifier, canvas()->toWidget(drawn).toPoint());
        settle();
    };
    const Point middle = frame.plot.center();
    click(middle);
    ASSERT_TRUE(pointIn(scenario()));
    PointState other{pointIn(scenario())};
    other.point->s -= 2 * field.width();  // drawn in the visible periodic copy
    other.point->t += field.height();
    workspace_->change(withState(scenario(), other), {});
    ASSERT_NO_FATAL_FAILURE(settle());
    ASSERT_NE(view()->point(), nullptr);
    click(middle);
    EXPECT_FALSE(pointIn(scenario()));
    const Point corner{frame.plot.x0 + 2, frame.plot.y1 - 2};
    click(corner);
    ASSERT_TRUE(pointIn(scenario()));
    click(corner);
    EXPECT_FALSE(pointIn(scenario()));
}

TEST_F(DistanceTest, InEveryCopyOfAPictureAPointHasTheSameDistances) {
    openPane(walled("distance-conservative"));
    const relief::HeightField& field = snapshot()->request->field;
    ASSERT_EQ(field.address(), relief::Address::Repeat);
    relief::MapCache cache;
    relief::Work work;
    const auto first = pointQuery(field, {3.5, 4.5, 0.9}, 10, cache, work);
    const auto copy = pointQuery(field, {3.5 - field.width(), 4.5 + 2 * field.height(), 0.9}, 10, cache, work);
    EXPECT_EQ(first->distances.euclidean, copy->distances.euclidean);
    EXPECT_EQ(first->distances.refined, copy->distances.refined);
    // Without repetition a point beyond the picture cannot be queried.
    const relief::HeightField alone(field.sharedHeights(), field.surface(), relief::Address::Border, 0.2);
    EXPECT_EQ(pointQuery(alone, {-0.5, 4.5, 0.9}, 10, cache, work), nullptr);
}

// The figures that `reliefscope FILE --export` makes.
TEST_F(WindowTest, FiguresOfAScenarioShowItsPoint) {
    openWindow(walls());
    for (const char* const name : {"distance", "profile"}) {
        ASSERT_TRUE(pointIn(scenario()));
        const auto picture = [&](const relief::Scenario& of) {
            relief::Work work;
            return figureImage(*figureKind(name).make(snapshot(), of), {}, 500, work);
        };
        EXPECT_NE(picture(withState(scenario(), PointState{})), picture(scenario())) << name;
    }
}

TEST_F(WindowTest, TheProfileShowsThePointAndChoosesAnother) {
    openWindow(walls());
    QTest::keyClick(window_.get(), Qt::Key_6);
    ProfileView* const view = window_->pane<ProfileView>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view->point() != nullptr; }, kDistancePatienceMs));
    EXPECT_NEAR(view->point()->distances.refined, 4, kRounding);
    // Next to the ray, before it reaches C.
    const double lambda = snapshot()->trace.hit.lambda / 4;
    const QPoint at = view->canvas()->toWidget(view->frame().onRay(lambda)).toPoint() + QPoint(0, -6);
    QTest::mouseClick(view->canvas(), Qt::LeftButton, Qt::ControlModifier, at);
    ASSERT_TRUE(pointIn(scenario()));
    EXPECT_NE(pointIn(scenario()), pointIn(walls()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return view->point() != nullptr; }, kDistancePatienceMs));
    EXPECT_EQ(view->point()->point, *pointIn(scenario()));
    EXPECT_GT(view->point()->distances.euclidean, 0);
    EXPECT_GE(view->point()->distances.refined, view->point()->distances.euclidean - kRounding);
    QTest::mouseClick(view->canvas(), Qt::LeftButton, Qt::ControlModifier, at);
    EXPECT_FALSE(pointIn(scenario()));
    EXPECT_EQ(view->point(), nullptr);
    QTest::mouseClick(view->canvas(), Qt::LeftButton, Qt::ControlModifier, at);
    EXPECT_TRUE(pointIn(scenario())) << "where none was";
}

}  // namespace

}  // namespace reliefui
