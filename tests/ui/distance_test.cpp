// The distance map's pane shows the values of the maps.
#include <cmath>
#include <set>

#include <QLabel>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>

#include "distance_fixture.h"
#include "painting/painter.h"
#include "panes/distance/distance_view.h"
#include "panes/drawing_canvas.h"
#include "panes/ray_geometry.h"
#include "relief/tracers/map_choice.h"

namespace reliefui {

namespace {

using relief::StoredValues;

int distance(QColor a, QColor b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
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
        // Zoomed in, so that lines cover little of the cells.
        const Point middle = frame.plot.center();
        canvas()->zoomTo(Box{middle.x, middle.y, middle.x, middle.y}.grown(0.2 * frame.plot.height()));
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
        // Probed in a corner of each cell, because numbers are in its middle.
        constexpr double kCorner = 0.2;
        const double v0 = slice.start.y + (std::floor((frame.window.y0 - slice.start.y) / slice.cellHeight) + kCorner) *
                                              slice.cellHeight;
        const double u0 = slice.start.x +
                          (std::floor((frame.window.x0 - slice.start.x) / slice.cellWidth) + kCorner) * slice.cellWidth;
        for (double v = v0; v < frame.window.y1; v += slice.cellHeight) {
            for (double u = u0; u < frame.window.x1; u += slice.cellWidth) {
                const Point at = frame.at(Point{u, v});
                const QPoint pixel = canvas()->toWidget(at).toPoint();
                // Cells outside the visible part may be covered by the legend.
                if (!frame.plot.grown(-2).contains(at) || !canvas()->visible().contains(at)) continue;
                const Place3 place = fromSlice(axis, frame.slab, frame.cut, {u, v});
                // Under repeat, bilinear cells lie between texel centres.
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
        // The others are covered by lines, numbers and the ray.
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
    // For each step, the slice that contains it, exactly through it.
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
        // Both are bounds, each rounded by its own amount.
        constexpr float kRounding = 1e-4F;
        EXPECT_GE(value, -kRounding);
        most = std::max(most, value);
    }
    EXPECT_GT(most, 0.01F) << "between houses the refined distance is larger at some voxel";
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

TEST_F(DistanceTest, AFailedBuildIsReported) {
    relief::Scenario scenario = walled("exact");
    scenario.address = relief::Address::Clamp;
    openPane(scenario);
    DistanceOptions options;
    options.kind = "refined";
    show(options);
    EXPECT_EQ(view()->shown(), nullptr);
    EXPECT_TRUE(view()->problem().contains(QStringLiteral("clamp"))) << view()->problem().toStdString();
    EXPECT_TRUE(control<QWidget>("distance-waiting")->isVisible());
    const auto* const words = control<QWidget>("distance-waiting")->findChild<QLabel*>();
    EXPECT_LE(words->minimumSizeHint().width(), words->width()) << "its lines are whole";
    EXPECT_LE(words->heightForWidth(words->width()), words->height());
    options.kind = "euclidean";
    show(options);
    EXPECT_NE(view()->shown(), nullptr);
    EXPECT_FALSE(control<QWidget>("distance-waiting")->isVisible());
}

TEST_F(DistanceTest, ABuildIsCancelledAndRequestedAgain) {
    relief::Scenario scenario = walled("exact");
    scenario.pictures.recipeWidth = scenario.pictures.recipeHeight = 512;
    openPane(scenario);
    DistanceOptions options;
    options.kind = "refined-sampled";  // seconds
    view()->setOptions(options);
    // The window stays responsive while the map is built.
    auto* const waiting = control<QWidget>("distance-waiting");
    ASSERT_TRUE(QTest::qWaitFor([&] { return waiting->isVisible(); }, kDistancePatienceMs));
    ASSERT_FALSE(view()->isUpToDate());
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
    const auto wrapped = [](double x) { return static_cast<int>(std::floor(x - 0.5) + 640) % 64; };
    // Searches from the right for the first voxel of the uppermost layer that is outside the relief.
    Point at;
    Place3 place{};
    int layer = 0;
    float value = -1;
    for (double x = frame.plot.x1 - 4; !(value > 0) && x > frame.plot.x0; x -= 4) {
        at = frame.uvAt({x, frame.plot.y0 + 3});
        place = fromSlice(frame.axis, frame.slab, frame.plane, at);
        layer = static_cast<int>(std::ceil(place[2] / frame.slab * 8)) - 1;
        value = distances.at(wrapped(place[0]), wrapped(place[1]), layer, 0);
    }
    ASSERT_GT(value, 0);
    QTest::mouseMove(canvas(), canvas()->toWidget(frame.at(at)).toPoint());
    QTest::qWait(50);
    const QString text = view()->readout();
    EXPECT_TRUE(text.contains(QStringLiteral("(%1, %2, %3)").arg(wrapped(place[0])).arg(wrapped(place[1])).arg(layer)))
        << text.toStdString();
    EXPECT_TRUE(text.contains(QString::number(static_cast<double>(value), 'f', 2))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("texels")));
}

TEST_F(DistanceTest, ARefinedMapHasItsSectors) {
    for (const std::string sectors : {"1", "8"}) {
        openPane(walled("distance-refined", {{"sectors", sectors}, {"layers", "8"}}));
        ASSERT_NE(view()->shown(), nullptr);
        EXPECT_EQ(std::to_string(view()->shown()->frame.sectors), sectors);
    }
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
            // Serve the bilinear surface only.
            if (kind.ends_with("-robust") && scenario.surface == relief::Surface::Columns) continue;
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

TEST_F(DistanceTest, WhileItIsHiddenItDropsTheMapOfAnEarlierRay) {
    openPane(walled("distance-conservative"));
    window_->findChild<QWidget*>(QStringLiteral("distance-pane"))->hide();
    ASSERT_NE(view()->shown(), nullptr);
    workspace_->choosePixel(scenario().pixel->x + 9, scenario().pixel->y + 5);
    waitForFull();
    EXPECT_EQ(view()->shown(), nullptr);
    EXPECT_TRUE(view()->image(100).isNull());
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
