// The distance map's pane: what it shows is what the maps hold; spheres and cones are those of the records.
#include <cmath>
#include <set>

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>

#include "drawings/ray_geometry.h"
#include "relief/maps/map_choice.h"
#include "views/distance_view.h"
#include "views/drawing_canvas.h"
#include "views/result_painting.h"
#include "views/step_table.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

using relief::StoredValues;

constexpr int kPatienceMs = 20000;

class DistanceTest : public WindowTest {
  protected:
    void openPane(const relief::Scenario& scenario) {
        openWindow(scenario);
        QTest::keyClick(window_.get(), Qt::Key_7);
        QTest::qWait(100);
        ASSERT_TRUE(view()->isVisible());
        ASSERT_NO_FATAL_FAILURE(settle());
        ASSERT_NE(view()->shown(), nullptr) << view()->problem().toStdString();
    }
    void settle() {
        // What a changed option asks for comes at once; what a new picture asks for, with it.
        QTest::qWait(20);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view()->settled(); }, kPatienceMs)) << "no map in time";
    }
    void show(const DistanceOptions& options) {
        view()->setOptions(options);
        ASSERT_NO_FATAL_FAILURE(settle());
    }
    DistanceView* view() { return window_->distance(); }
    DrawingCanvas* canvas() { return view()->canvas(); }
    template <class Widget>
    Widget* control(const char* name) {
        return view()->findChild<Widget*>(QString::fromLatin1(name));
    }
    relief::StoredMap map(const std::string& kind) {
        relief::Work work;
        relief::MapCache cache;
        DistanceOptions options;
        options.kind = kind;
        const MapOptions wanted = mapOptions(options, *snapshot()).front();
        return relief::buildMap(kind, wanted.options, snapshot()->request->field, cache, work);
    }
};

relief::Scenario walled(const char* method, relief::OptionValues options = {}) {
    relief::Scenario scenario = smallScenario();
    scenario.pictures.recipe = "city";
    scenario.reliefDepth = 0.2;
    scenario.camera.elevation = 20;
    scenario.method = {method, std::move(options)};
    return scenario;
}

int distance(QColor a, QColor b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

// Of the drawing's items of this kind.
template <class Primitive>
std::vector<const Item*> itemsOf(const Drawing& drawing, Role role) {
    std::vector<const Item*> found;
    for (const Item& item : drawing.items) {
        if (item.role == role && std::holds_alternative<Primitive>(item.primitive)) found.push_back(&item);
    }
    return found;
}

TEST_F(DistanceTest, EachPixelHasTheColourOfItsVoxel) {
    openPane(walled("distance-conservative", {{"layers", "12"}}));
    const relief::StoredMap stored = map("euclidean-conservative");
    const auto& distances = *std::get<std::shared_ptr<const relief::DistanceMap>>(stored);
    for (const SliceAxis axis : {SliceAxis::X, SliceAxis::Y, SliceAxis::Z}) {
        DistanceOptions options;
        options.axis = axis;
        options.isoLines = false;
        options.slice = axis == SliceAxis::Z ? 7 : 30;
        show(options);
        const DistanceFrame& frame = view()->shown()->frame;
        ASSERT_EQ(frame.axis, axis);
        ASSERT_EQ(frame.slice, *options.slice);
        const QImage shown = grab(canvas());
        float most = 0;
        for (int k = 0; k < distances.layers(); ++k) {
            for (int j = 0; j < distances.ny(); ++j) {
                for (int i = 0; i < distances.nx(); ++i) most = std::max(most, distances.at(i, j, k, 0));
            }
        }
        int probes = 0;
        int right = 0;
        std::set<int> kinds;
        const MapSlice& slice = view()->shown()->slice;
        int buried = 0;
        int hatched = 0;
        // In a corner of each cell: numbers stand in its middle.
        constexpr double kCorner = 0.2;
        const double v0 = slice.start.y + (std::floor((frame.window.y0 - slice.start.y) / slice.cellHeight) + kCorner) *
                                              slice.cellHeight;
        const double u0 = slice.start.x +
                          (std::floor((frame.window.x0 - slice.start.x) / slice.cellWidth) + kCorner) * slice.cellWidth;
        for (double v = v0; v < frame.window.y1; v += slice.cellHeight) {
            for (double u = u0; u < frame.window.x1; u += slice.cellWidth) {
                const Point at = frame.at(Point{u, v});
                const QPoint pixel = canvas()->toWidget(at).toPoint();
                if (!frame.plot.grown(-2).contains(at) || !shown.valid(pixel)) continue;
                const Place3 place = fromSlice(axis, frame.slab, frame.cut, {u, v});
                // Bilinear cells of a repeated map lie between texel centres.
                const auto wrapped = [](double x) { return static_cast<int>(std::floor(x - 0.5) + 640) % 64; };
                const int layer = static_cast<int>(std::clamp(std::ceil(place[2] / frame.slab * 12) - 1, 0.0, 11.0));
                const float value = distances.at(wrapped(place[0]), wrapped(place[1]), layer, 0);
                const Style& style = workspace_->style();
                const Rgba free =
                    style.mapped(ColorMap::Distance, static_cast<double>(value) / static_cast<double>(most));
                const Rgba expected = value == StoredValues::kBuried    ? style.color(Role::HeightFill)
                                      : value == StoredValues::kSurface ? style.color(Role::Tested)
                                                                        : free;
                kinds.insert(value < 0 ? static_cast<int>(value) : 0);
                const bool same = distance(shown.pixelColor(pixel), toColor(expected)) <= 12;
                (value == StoredValues::kBuried ? buried : probes) += 1;
                (value == StoredValues::kBuried ? hatched : right) += same ? 1 : 0;
            }
        }
        EXPECT_GE(hatched, buried / 4) << "of those between the lines of the hatch";
        EXPECT_GT(probes, 100);
        // The rest lies under lines, numbers and the ray.
        EXPECT_GT(right, probes * 8 / 10) << static_cast<int>(axis);
        EXPECT_GE(kinds.size(), 2u);
    }
}

TEST_F(DistanceTest, TheSliderGoesThroughTheSlicesAndTheStepTakesItBack) {
    openPane(walled("distance-conservative"));
    auto* const slider = control<QSlider>("distance-slice");
    auto* const follow = control<QToolButton>("distance-follow");
    EXPECT_TRUE(follow->isChecked());
    const QImage before = grab(canvas());
    slider->setValue(slider->value() > 10 ? 3 : 20);
    settle();
    EXPECT_EQ(view()->shown()->frame.slice, slider->value());
    EXPECT_FALSE(follow->isChecked());
    EXPECT_NE(grab(canvas()), before);
    QTest::mouseClick(follow, Qt::LeftButton);
    settle();
    EXPECT_EQ(grab(canvas()), before);
    // Of each step the slice that holds it, exactly through it.
    for (const char* const axis : {"distance-axis-x", "distance-axis-y", "distance-axis-z"}) {
        QTest::mouseClick(control<QToolButton>(axis), Qt::LeftButton);
        for (int step = 0; step < static_cast<int>(snapshot()->trace.steps.size()); ++step) {
            workspace_->chooseStep(step);
            settle();
            const DistanceFrame& frame = view()->shown()->frame;
            const DistanceMaps maps{map("euclidean-conservative"), {}, nullptr, nullptr};
            DistanceSource source = distanceSource(*snapshot(), maps);
            EXPECT_EQ(frame.plane, stepPlace(source, step)[static_cast<std::size_t>(frame.axis)]);
            EXPECT_EQ(slider->value(), frame.slice);
        }
    }
}

TEST_F(DistanceTest, AMapDiffersFromItselfNowhereAndRefinedIsNeverBelow) {
    openPane(walled("distance-refined", {{"footprint", "2"}, {"layers", "24"}}));
    DistanceOptions options;
    options.kind = options.minus = "refined";
    show(options);
    ASSERT_NE(view()->shown(), nullptr);
    for (const float value : view()->shown()->slice.values->pixels()) {
        EXPECT_TRUE(std::isnan(value) || value == 0);
    }
    const QImage blank = grab(canvas());
    const DistanceFrame& frame = view()->shown()->frame;
    const QPoint low = canvas()->toWidget({frame.plot.x0, frame.plot.y0}).toPoint();
    const QPoint high = canvas()->toWidget({frame.plot.x1, frame.plot.y1}).toPoint();
    int white = 0;
    for (int y = low.y(); y < high.y(); ++y) {
        for (int x = low.x(); x < high.x(); ++x) white += blank.pixel(x, y) == qRgb(255, 255, 255) ? 1 : 0;
    }
    EXPECT_GT(white, 1000);

    options.minus = "euclidean-conservative";
    show(options);
    float most = 0;
    for (const float value : view()->shown()->slice.values->pixels()) {
        if (std::isnan(value)) continue;
        // Both are bounds, rounded each by its own share.
        constexpr float kRounding = 1e-4F;
        EXPECT_GE(value, -kRounding);
        most = std::max(most, value);
    }
    EXPECT_GT(most, 0.01F) << "between houses a refined distance is larger somewhere";
    EXPECT_EQ(view()->shown()->slice.low, -view()->shown()->slice.high);
}

TEST_F(DistanceTest, DistancesAndSlopesAreNotCompared) {
    openPane(walled("distance-conservative"));
    DistanceOptions options;
    options.minus = "cone";
    show(options);
    EXPECT_EQ(view()->shown(), nullptr);
    EXPECT_TRUE(view()->problem().contains(QStringLiteral("cone"))) << view()->problem().toStdString();
    options.minus.clear();
    show(options);
    EXPECT_NE(view()->shown(), nullptr);
    EXPECT_TRUE(view()->problem().isEmpty());
}

TEST_F(DistanceTest, WhatCannotBeBuiltIsSaid) {
    relief::Scenario scenario = walled("exact");
    scenario.address = relief::Address::Clamp;
    openPane(scenario);
    DistanceOptions options;
    options.kind = "refined";
    show(options);
    EXPECT_EQ(view()->shown(), nullptr);
    EXPECT_TRUE(view()->problem().contains(QStringLiteral("clamp"))) << view()->problem().toStdString();
    EXPECT_TRUE(control<QWidget>("distance-waiting")->isVisible());
    options.kind = "euclidean";
    show(options);
    EXPECT_NE(view()->shown(), nullptr);
    EXPECT_FALSE(control<QWidget>("distance-waiting")->isVisible());
}

TEST_F(DistanceTest, ABuildIsCancelledAndAskedForAgain) {
    relief::Scenario scenario = walled("exact");
    scenario.pictures.recipeWidth = scenario.pictures.recipeHeight = 512;
    openPane(scenario);
    DistanceOptions options;
    options.kind = "refined-sampled";  // seconds
    view()->setOptions(options);
    // The window goes on while the map is built.
    auto* const waiting = control<QWidget>("distance-waiting");
    ASSERT_TRUE(QTest::qWaitFor([&] { return waiting->isVisible(); }, kPatienceMs));
    ASSERT_FALSE(view()->settled());
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    settle();
    EXPECT_EQ(view()->shown(), nullptr);
    EXPECT_FALSE(view()->problem().isEmpty());
    options.kind = "euclidean";
    show(options);
    EXPECT_NE(view()->shown(), nullptr);
}

TEST_F(DistanceTest, HoverReadsTheVoxel) {
    openPane(walled("distance-conservative", {{"layers", "8"}}));
    const relief::StoredMap stored = map("euclidean-conservative");
    const auto& distances = *std::get<std::shared_ptr<const relief::DistanceMap>>(stored);
    const DistanceFrame& frame = view()->shown()->frame;
    const Point at = frame.uvAt({frame.plot.x1 - 30, frame.plot.y0 + 3});
    QTest::mouseMove(canvas(), canvas()->toWidget(frame.at(at)).toPoint());
    QTest::qWait(50);
    const QString text = view()->readout();
    const Place3 place = fromSlice(frame.axis, frame.slab, frame.plane, at);
    const auto wrapped = [](double x) { return static_cast<int>(std::floor(x - 0.5) + 640) % 64; };
    const int layer = static_cast<int>(std::ceil(place[2] / frame.slab * 8)) - 1;
    const float value = distances.at(wrapped(place[0]), wrapped(place[1]), layer, 0);
    ASSERT_GT(value, 0);
    EXPECT_TRUE(text.contains(QStringLiteral("(%1, %2, %3)").arg(wrapped(place[0])).arg(wrapped(place[1])).arg(layer)))
        << text.toStdString();
    EXPECT_TRUE(text.contains(QString::number(static_cast<double>(value), 'f', 2))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("texels")));
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
            const StepBody body = stepBody(source.walk, *source.field, *source.maxima, source.ray, steps[k]);
            if (!body || body.radius < 0.5) continue;
            // The tracer went on to where the ray leaves the sphere.
            const double perLambda = std::hypot(source.ray.a, source.ray.b, source.field->slabTexels());
            EXPECT_NEAR(body.lambda + body.radius / perLambda, steps[k].lambdaAfter, 1e-6);
            workspace_->chooseStep(static_cast<int>(k));
            settle();
            DistanceFrame frame = view()->shown()->frame;
            const Place3 center = placeOnRay(source, body.lambda);
            for (const double off : {0.0, 0.6 * body.radius, 1.2 * body.radius}) {
                frame.plane = center[1] + off;
                // Nothing is clipped.
                constexpr double kFar = 1e4;
                frame.plot = {-kFar, -kFar, kFar, kFar};
                frame.window = {-kFar / frame.scale, -kFar / frame.scale, 0, 0};
                const Drawing marks = distanceMarks(source, frame, static_cast<int>(k));
                Box extent;
                for (const Item* const item : itemsOf<Polyline>(marks, Role::Empty)) {
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

// The ray leaves the empty cone where the tracer went on; and the relief stays outside of the cone.
TEST_F(DistanceTest, ConesEndWhereTheStepsDo) {
    openPane(walled("cone", {{"sectors", "8"}}));
    const DistanceSource source = distanceSource(*snapshot(), {});
    int seen = 0;
    for (const relief::Step& step : snapshot()->trace.steps) {
        const StepBody body = stepBody(source.walk, *source.field, *source.maxima, source.ray, step);
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
            const StepBody body = stepBody(source.walk, *source.field, *source.maxima, source.ray, step);
            if (!body) continue;
            workspace_->chooseStep(static_cast<int>(k));
            show(options);
            ASSERT_NE(view()->shown(), nullptr);
            const DistanceFrame& frame = view()->shown()->frame;
            const Place3 over = placeOnRay(source, body.lambda);
            const Drawing marks = distanceMarks(source, frame, static_cast<int>(k));
            for (const Item* const item : itemsOf<Polyline>(marks, Role::Empty)) {
                if (item->id.i != static_cast<std::int64_t>(k)) continue;
                // Every point of the line lies on the cone.
                for (const Point& p : std::get<Polyline>(item->primitive).points) {
                    const Place3 place = fromSlice(axis, frame.slab, frame.plane, frame.uvAt(p));
                    const double away = std::hypot(place[0] - over[0], place[1] - over[1]);
                    // Between its points the line of a circle lies a little inside.
                    EXPECT_NEAR(place[2] / frame.slab, body.apex + body.slope * away, 0.01);
                }
                ++cones;
            }
        }
        EXPECT_GT(cones, 0) << static_cast<int>(axis);
    }
}

// A distance is no height: neither in words nor in the 3-D trace.
TEST_F(DistanceTest, StepsAreToldByTheirDistances) {
    openPane(walled("distance-conservative"));
    std::set<relief::Decision> told;
    for (std::size_t k = 0; k < snapshot()->trace.steps.size(); ++k) {
        const relief::Step& step = snapshot()->trace.steps[k];
        workspace_->chooseStep(static_cast<int>(k));
        const QString sentence = window_->steps()->sentence();
        if (step.decision == relief::Decision::Advance) {
            const QString distance = QString::number(step.value, 'f', 2) + QStringLiteral(" texels");
            EXPECT_TRUE(sentence.contains(distance)) << sentence.toStdString();
        }
        if (step.decision == relief::Decision::Test) {
            EXPECT_FALSE(sentence.contains(QStringLiteral("-1"))) << sentence.toStdString();
        }
        told.insert(step.decision);
    }
    EXPECT_TRUE(told.contains(relief::Decision::Advance));
}

TEST_F(DistanceTest, EveryMapOfEveryAddressingIsShown) {
    for (const relief::Address address : {relief::Address::Repeat, relief::Address::Clamp, relief::Address::Border}) {
        relief::Scenario scenario = walled("max-pyramid");
        scenario.address = address;
        scenario.surface = address == relief::Address::Border ? relief::Surface::Columns : relief::Surface::Bilinear;
        scenario.pictures.recipeWidth = 33;
        scenario.pictures.recipeHeight = 21;
        openPane(scenario);
        for (const std::string& kind : relief::mapKinds()) {
            if (kind == "refined" && address == relief::Address::Clamp) continue;
            for (const SliceAxis axis : {SliceAxis::X, SliceAxis::Y, SliceAxis::Z}) {
                for (const bool near : {true, false}) {
                    DistanceOptions options;
                    options.kind = kind;
                    options.axis = axis;
                    options.nearRay = near;
                    show(options);
                    ASSERT_NE(view()->shown(), nullptr) << kind << " " << view()->problem().toStdString();
                    EXPECT_EQ(view()->shown()->kind, kind);
                    const DistanceFrame& frame = view()->shown()->frame;
                    EXPECT_TRUE(frame.plot.width() > 20 && std::isfinite(frame.scale)) << kind;
                }
            }
            EXPECT_GT(colorsIn(grab(canvas())), 20) << kind;
        }
    }
}

TEST_F(DistanceTest, ItIsExportedAsItIsShown) {
    openPane(walled("distance-conservative"));
    const QTemporaryDir folder;
    DistanceOptions options;
    options.axis = SliceAxis::Z;
    options.slice = 20;
    show(options);
    for (const char* const ending : {"svg", "pdf", "png"}) {
        const QString file = folder.filePath(QStringLiteral("map.") + QString::fromLatin1(ending));
        saveFigure(view(), file);
        EXPECT_GT(QFileInfo(file).size(), 3000) << ending;
    }
    EXPECT_GT(colorsIn(QImage(folder.filePath(QStringLiteral("map.png")))), 50);
    EXPECT_GT(colorsIn(view()->image(800)), 50);
}

}  // namespace

}  // namespace reliefui
