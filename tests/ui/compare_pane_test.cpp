// The compare pane, operated as by a person, and its figures exported by the program.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <QFileInfo>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QWheelEvent>

#include "measuring/bench/view_bench.h"
#include "measuring/compare/picture_error.h"
#include "painting/chart.h"
#include "panes/compare/compare_drawing.h"
#include "panes/compare/compare_painting.h"
#include "panes/compare/compare_view.h"
#include "scenario/scenario.h"
#include "window_fixture.h"
#include "workspace/pane_store.h"
#include "workspace/range_json.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 60000;

class ComparePane : public WindowTest {
  protected:
    void openPane(std::vector<relief::MethodChoice> others = {{"layers", {{"layers", "8"}}}, {"exact", {}}}) {
        relief::Scenario scenario = smallScenario();
        scenario.camera.elevation = 30;
        scenario.comparison.others = std::move(others);
        openWindow(scenario);
        QTest::keyClick(window_.get(), Qt::Key_1, Qt::AltModifier);
        settle();
    }
    void settle() {
        QTest::qWait(100);
        ASSERT_TRUE(QTest::qWaitFor([&] { return pane()->isUpToDate() && !workspace_->busy(); }, kPatienceMs));
    }
    CompareView* pane() { return window_->pane<CompareView>(); }
    ComparePictures* pictures() { return pane()->pictures(); }
    const ComparedPicture& method(std::size_t n) { return pane()->view()->pictures[n]; }
    // Returns a pixel in which two methods have clearly different colours, away from the ring around the chosen pixel.
    relief::PixelChoice whereTheyDiffer(const QImage& a, const QImage& b) {
        int most = 0;
        relief::PixelChoice best;
        for (int y = 0; y < a.height(); ++y) {
            for (int x = 0; x < a.width(); ++x) {
                if (std::hypot(x - scenario().pixel->x, y - scenario().pixel->y) < 25) continue;
                const int by = std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
                if (by > most) most = by, best = {x, y};
            }
        }
        EXPECT_GT(most, 30);
        return best;
    }
    void zoomAt(QPointF at, int notches) {
        QWheelEvent wheel(at, pictures()->mapToGlobal(at.toPoint()), {}, {0, 120 * notches}, Qt::NoButton,
                          Qt::ControlModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(pictures(), &wheel);
    }
    // Returns true if the text is drawn around the pictures.
    bool says(const std::string& part) {
        const std::vector<Item>& items = pictures()->layoutNow().drawing.items;
        return std::any_of(items.begin(), items.end(), [&](const Item& item) {
            const auto* const label = std::get_if<Label>(&item.primitive);
            return label != nullptr && relief::sentence(label->text).find(part) != std::string::npos;
        });
    }
    void compare(relief::CompareSubject subject, std::vector<relief::MethodChoice> others) {
        relief::Scenario changed = scenario();
        changed.comparison.subject = subject;
        relief::othersOf(changed.comparison) = std::move(others);
        workspace_->change(changed, QStringLiteral("test"));
        settle();
    }
    QColor colorAt(std::size_t n, relief::PixelChoice pixel) {
        const auto at = pictures()->pixelIn(n, pixel);
        if (!at) return {};
        return grab(pictures()).pixelColor(at->toPoint());
    }
};

TEST_F(ComparePane, ItMeasuresWhatItShows) {
    openPane();
    ASSERT_NE(pane()->view(), nullptr);
    ASSERT_EQ(pane()->view()->pictures.size(), 3u);
    EXPECT_EQ(method(0).frame, snapshot()->frame);
    EXPECT_GT(colorsIn(grab(pictures())), 100);
    // The numbers equal those that the library computes alone.
    relief::Work work;
    relief::FrameRequest request = *snapshot()->request;
    const auto alone = [&](const relief::MethodChoice& choice) {
        request.method = choice;
        relief::FrameRenderer renderer(std::make_shared<relief::MapCache>());
        return renderer.render(request, work);
    };
    const auto exact = alone({"exact", {}});
    for (std::size_t n = 0; n < 3; ++n) {
        const auto frame = alone(method(n).choice);
        ASSERT_TRUE(std::ranges::equal(frame->light->color.pixels(), method(n).frame->light->color.pixels()));
        relief::FloatImage flip;
        const relief::PictureError error =
            relief::pictureError(exact->light->color, frame->light->color, relief::kPixelsPerDegree, flip, work);
        EXPECT_EQ(error.rmse, method(n).error->rmse);
        EXPECT_EQ(error.flip, method(n).error->flip);
        EXPECT_TRUE(std::ranges::equal(flip.pixels(), method(n).flip->pixels()));
        EXPECT_EQ(method(n).equal, n != 1) << "max-pyramid and exact agree bit by bit, eight layers do not";
        const double l1 = std::accumulate(method(n).l1->pixels().begin(), method(n).l1->pixels().end(), 0.0);
        EXPECT_EQ(l1 > 0, n == 1);
        // Steps are the mean over the rays that were timed.
        const relief::RayBlock rays = relief::sampledRays(*snapshot()->frame, kComparedRays);
        ASSERT_EQ(rays.size(), pane()->view()->rays);
        relief::HitBlock hits;
        relief::BlockCounts counts;
        method(n).tracer->trace(rays, hits, counts, work);
        const double steps = std::accumulate(hits.steps.begin(), hits.steps.end(), 0.0) / double(rays.size());
        ASSERT_TRUE(method(n).steps && method(n).rate);
        EXPECT_NEAR(*method(n).steps, steps, 1e-9 * steps);
        EXPECT_GT(*method(n).rate, 0);
    }
}

TEST_F(ComparePane, EverySubjectIsMeasuredAgainstItsTruth) {
    openPane({});
    using Subject = relief::CompareSubject;
    const std::pair<Subject, std::vector<relief::MethodChoice>> all[]{
        {Subject::Filters, {{"trilinear", {}}, {"supersample", {{"samples", "3"}}}}},
        {Subject::Mappings, {{"affine", {}}}},
        {Subject::Heights, {{"quantised", {{"bits", "3"}}}}}};
    relief::Work work;
    for (const auto& [subject, others] : all) {
        compare(subject, others);
        ASSERT_EQ(pane()->view()->pictures.size(), others.size() + 1);
        const auto alone = [&, subject = subject](const relief::MethodChoice& choice) {
            relief::Assets assets = snapshot()->assets;
            if (subject == Subject::Heights) assets.heights = relief::variedHeights(assets.heights, choice);
            relief::FrameRenderer renderer(std::make_shared<relief::MapCache>());
            return renderer.render(relief::frameRequest(relief::varied(scenario(), subject, choice), assets), work);
        };
        const auto truth = alone(relief::referenceVariation(scenario()));
        for (std::size_t n = 0; n < pane()->view()->pictures.size(); ++n) {
            const auto frame = alone(method(n).choice);
            ASSERT_TRUE(std::ranges::equal(frame->light->color.pixels(), method(n).frame->light->color.pixels()));
            relief::FloatImage flip;
            const relief::PictureError error =
                relief::pictureError(truth->light->color, frame->light->color, relief::kPixelsPerDegree, flip, work);
            EXPECT_EQ(error.rmse, method(n).error->rmse) << method(n).name;
            EXPECT_EQ(error.flip, method(n).error->flip) << method(n).name;
            EXPECT_EQ(method(n).equal, subject != Subject::Filters && n == 0) << method(n).name;
            // Grey heights are sampled at the hit, without a filter, so no rate is measured.
            const bool timed = subject == Subject::Filters && method(n).choice.name != relief::kSupersample &&
                               method(n).frame->filter != nullptr;
            EXPECT_EQ(method(n).rate.value_or(0) > 0, timed) << method(n).name;
        }
    }
    compare(Subject::Mappings, {{"affine", {}}});
    EXPECT_GT(method(1).frame->mappingOff, 0);
    EXPECT_TRUE(says("coordinates off by up to " + relief::numberText(method(1).frame->mappingOff, 3)));
}

// Old pictures and numbers next to a new scene would be taken for its results.
TEST_F(ComparePane, WhatIsNotComputedYetIsVeiledAndHasNoNumbers) {
    openPane();
    ASSERT_TRUE(says("equal to the reference") && says("FLIP") && says("Mrays/s"));
    bool numbers = true;
    bool computing = false;
    const auto watch = QObject::connect(workspace_.get(), &Workspace::scenarioChanged, [&] {
        numbers = says("equal to the reference") || says("FLIP") || says("Mrays/s");
        computing = says("computing");
    });
    relief::Scenario other = scenario();
    other.pictures.seed = 2;
    workspace_->change(other, QStringLiteral("test"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return computing; }, kPatienceMs));
    QObject::disconnect(watch);
    EXPECT_FALSE(numbers);
    settle();
    EXPECT_TRUE(says("FLIP") && !says("computing"));
    // While a slow picture is computed, the previous one stays visible, but veiled.
    compare(relief::CompareSubject::Filters, {{"supersample", {{"samples", "2"}}}});
    const QImage before = method(1).picture;
    other = scenario();
    other.comparison.filters[0].options["samples"] = "48";
    workspace_->change(other, QStringLiteral("test"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return pictures()->veiled() && says(" %"); }, kPatienceMs));
    ASSERT_EQ(method(1).picture, before);
    const relief::PixelChoice pixel{40, 100};
    EXPECT_NE(colorAt(1, pixel), before.pixelColor(pixel.x, pixel.y));
    EXPECT_TRUE(pane()->view()->current(scenario(), 0));
    pane()->cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return says("cancelled"); }, kPatienceMs));
    EXPECT_FALSE(says("FLIP"));
    workspace_->undo();
    settle();
    EXPECT_TRUE(says("FLIP") && !pictures()->veiled());
    // Pictures that are there are not announced while their errors are measured, unless that was cancelled.
    ComparedView unmeasured = *pane()->view();
    unmeasured.complete = false;
    ComparePending pending;
    for (const bool stopped : {false, true}) {
        pending.stopped = stopped;
        const CompareTile tile = compareSource(unmeasured, scenario(), 0, pending).tiles[1];
        EXPECT_TRUE(tile.measuring);
        EXPECT_EQ(tile.pending.has_value(), stopped);
    }
}

TEST_F(ComparePane, NothingIsSetAgainstItself) {
    openPane({{"layers", {}}});
    const relief::MethodChoice own = scenario().method;
    pane()->setChoice(1, QString::fromStdString(own.name));
    const relief::MethodChoice other = scenario().comparison.others[0];
    EXPECT_EQ(other.name, own.name);
    EXPECT_FALSE(relief::sameVariation(relief::CompareSubject::Methods, other, own));
    // If A becomes equal to B, by whatever control, B becomes what A was.
    pane()->setChoice(1, QStringLiteral("layers"));
    relief::Scenario changed = scenario();
    changed.method = {"layers", {}};
    workspace_->change(changed, QStringLiteral("test"));
    EXPECT_EQ(scenario().method.name, "layers");
    EXPECT_EQ(scenario().comparison.others[0], own);
    // If there is no other variant, the change is refused with a message.
    pane()->setSubject(relief::CompareSubject::Mappings);
    ASSERT_EQ(scenario().comparison.mappings, (std::vector<relief::MethodChoice>{{"affine", {}}}));
    QSignalSpy notices(workspace_.get(), &Workspace::notice);
    pane()->setChoice(1, QStringLiteral("direct"));
    EXPECT_EQ(scenario().comparison.mappings[0].name, "affine");
    EXPECT_EQ(notices.size(), 1);
    // An option may be changed so that both variants are equal; the pane then says so.
    compare(relief::CompareSubject::Methods, {{"layers", {{"layers", "3"}}}});
    EXPECT_FALSE(says("the same as A"));
    pane()->setOption(1, QStringLiteral("layers"),
                      QString::fromStdString(relief::findTracer("layers").defaults.at("layers")));
    settle();
    EXPECT_TRUE(says("the same as A"));
}

// Its rate and steps, too, are measured on the level that the view selects.
TEST_F(ComparePane, ALevelChosenByTheViewIsTimedAsItIsDrawn) {
    openPane({{"max-pyramid", {{"base", "auto"}}}});
    ASSERT_EQ(pane()->view()->pictures.size(), 2u);
    ASSERT_FALSE(method(1).problem);
    EXPECT_TRUE(method(1).steps && method(1).rate);
    // What is drawn has its room, whose height need not be whole pixels.
    relief::Scenario other = scenario();
    other.height = 131;
    workspace_->change(other, QStringLiteral("test"));
    settle();
    const Box page{0, 0, static_cast<double>(pictures()->width()), static_cast<double>(pictures()->height())};
    const CompareSource source = compareSource(*pane()->view(), scenario(), 0);
    EXPECT_GE(pictures()->minimumHeight(), comparePage(source, page, workspace_->style(), false).leastHeight);
}

TEST_F(ComparePane, PicturesAreRightAndZoomTogether) {
    openPane();
    const relief::PixelChoice pixel = whereTheyDiffer(method(0).picture, method(1).picture);
    const QPointF home = *pictures()->pixelIn(1, pixel);
    zoomAt(home, 20);
    // The point under the pointer stays there, in its own tile and in the others.
    const QPointF zoomed = *pictures()->pixelIn(1, pixel);
    EXPECT_LT(std::hypot(zoomed.x() - home.x(), zoomed.y() - home.y()), 40);
    for (std::size_t n = 0; n < 3; ++n) {
        EXPECT_EQ(colorAt(n, pixel).rgb(), method(n).picture.pixelColor(pixel.x, pixel.y).rgb()) << n;
    }
    EXPECT_NE(colorAt(0, pixel), colorAt(1, pixel));
    QTest::keyClick(pictures(), Qt::Key_R);
    EXPECT_EQ(*pictures()->pixelIn(1, pixel), home);
}

TEST_F(ComparePane, AClickChoosesThePixelAndThePointerReadsAllMethods) {
    openPane();
    const relief::PixelChoice pixel{40, 100};
    const QPointF there = *pictures()->pixelIn(2, pixel);
    const double scale = pictures()->pixelIn(2, {pixel.x + 1, pixel.y})->x() - there.x();
    const double near = 0.5 / scale + 1;  // a click hits a whole pixel of the screen
    QTest::mouseClick(pictures(), Qt::LeftButton, {}, there.toPoint());
    waitForFull();
    ASSERT_TRUE(scenario().pixel);
    EXPECT_NEAR(scenario().pixel->x, pixel.x, near);
    EXPECT_NEAR(scenario().pixel->y, pixel.y, near);
    EXPECT_EQ(snapshot()->trace.pixel, *scenario().pixel) << "all panes answer for it";
    const ComparedView* const before = pane()->view();
    settle();
    EXPECT_EQ(pane()->view(), before) << "another pixel does not require rendering";
    QTest::mouseMove(pictures(), pictures()->pixelIn(0, pixel)->toPoint() + QPoint(3, 0));
    QTest::mouseMove(pictures(), pictures()->pixelIn(0, pixel)->toPoint());
    QTest::qWait(50);
    for (const char* const name : {"A max-pyramid", "B layers", "C exact", "FLIP"}) {
        EXPECT_TRUE(pane()->readout().contains(QString::fromLatin1(name))) << pane()->readout().toStdString();
    }
}

TEST_F(ComparePane, TheDividerIsDraggedAndUndone) {
    openPane({{"layers", {{"layers", "8"}}}});
    pane()->setMode(relief::CompareMode::Swipe);
    settle();
    const relief::PixelChoice pixel = whereTheyDiffer(method(0).picture, method(1).picture);
    // Only one of the two is visible at a time.
    EXPECT_NE(pictures()->pixelIn(0, pixel).has_value(), pictures()->pixelIn(1, pixel).has_value());
    const relief::Scenario before = scenario();
    const Box room = pictures()->layoutNow().rooms[0];
    const double unit = workspace_->style().pixelsPerPoint();
    const auto drag = [&](double from, double to) {
        const int y = pictures()->height() / 3;
        const auto at = [&](double share) { return QPoint(int((6 + room.x0 + share * room.width()) * unit), y); };
        QTest::mousePress(pictures(), Qt::LeftButton, {}, at(from));
        QTest::mouseMove(pictures(), at((from + to) / 2));
        QMouseEvent move(QEvent::MouseMove, at(to), Qt::LeftButton, Qt::LeftButton, {});
        QApplication::sendEvent(pictures(), &move);
        QTest::mouseRelease(pictures(), Qt::LeftButton, {}, at(to));
    };
    drag(0.5, 0.95);
    settle();
    ASSERT_EQ(scenario().comparison.dividers.size(), 1u);
    EXPECT_NEAR(scenario().comparison.dividers[0], 0.95, 0.02);
    EXPECT_EQ(scenario().camera, before.camera) << "the divider moves, not the camera";
    workspace_->undo();
    settle();
    EXPECT_EQ(scenario(), before);
    workspace_->redo();
    settle();
    EXPECT_NEAR(pictures()->layoutNow().dividers[0], 0.95, 0.02);
}

TEST_F(ComparePane, DifferencesAreShownInTheColoursOfTheirScale) {
    openPane();
    pane()->setMode(relief::CompareMode::Difference);
    for (const auto measure : {relief::CompareMeasure::L1, relief::CompareMeasure::Flip}) {
        pane()->setMeasure(measure);
        settle();
        const bool l1 = measure == relief::CompareMeasure::L1;
        const relief::PixelChoice pixel = whereTheyDiffer(method(0).picture, method(1).picture);
        const relief::FloatImage& errors = l1 ? *method(1).l1 : *method(1).flip;
        const ColorScale& scale = pane()->view()->scaleOf(measure).scale;
        const Rgba expected = Style().cell(ColorMap::Count, double(errors(pixel.x, pixel.y)), scale);
        QTest::keyClick(pictures(), Qt::Key_R);
        zoomAt(*pictures()->pixelIn(1, pixel), 20);
        EXPECT_EQ(colorAt(1, pixel).rgb(), qRgb(expected.r, expected.g, expected.b));
        const Rgba none = Style().mapped(ColorMap::Count, 0);
        EXPECT_EQ(colorAt(0, pixel).rgb(), qRgb(none.r, none.g, none.b));
    }
    // With A as the reference: A is exact, so the other method has the same error as before.
    const double before = method(1).error->flip;
    pane()->setReference(relief::CompareReference::MethodA);
    settle();
    EXPECT_EQ(pane()->view()->reference, "A max-pyramid");
    EXPECT_EQ(method(1).error->flip, before);
    EXPECT_TRUE(method(0).equal);
}

// The legend shows the ends of the scale, and its range can be chosen as for every other picture.
TEST_F(ComparePane, DifferencesHaveTheirRange) {
    openPane();
    pane()->setMode(relief::CompareMode::Difference);
    pane()->setMeasure(relief::CompareMeasure::L1);
    settle();
    const auto says = [&](const char* part) {
        const std::vector<std::string> texts = rangeTexts(*pictures()->errors());
        return std::any_of(texts.begin(), texts.end(),
                           [&](const std::string& text) { return text.find(part) != std::string::npos; });
    };
    ASSERT_TRUE(pictures()->errors());
    EXPECT_TRUE(says("up to percentile 99") && says("beyond:"));
    const QImage before = method(1).l1Picture;
    RangesState state{rangesOf(scenario())};
    state.ranges.set(RangeOf::CompareL1, ColorRange());
    workspace_->change(withState(scenario(), state), QStringLiteral("test"));
    settle();
    EXPECT_EQ(pane()->view()->scaleOf(relief::CompareMeasure::L1).range.ends, RangeEnds::All);
    EXPECT_NE(method(1).l1Picture, before);
    EXPECT_FALSE(says("beyond:") || says("percentile")) << "nothing is clipped";
    ASSERT_TRUE(method(1).rate) << "the measurement is kept";
    workspace_->undo();
    settle();
    EXPECT_EQ(method(1).l1Picture, before);
}

TEST_F(ComparePane, FlickerShowsOneAtATimeAndLettersChoose) {
    openPane();
    pane()->setMode(relief::CompareMode::Flicker);
    settle();
    const std::size_t first = pictures()->shown();
    ASSERT_TRUE(QTest::qWaitFor([&] { return pictures()->shown() != first; }, 5000));
    QTest::keyClick(pictures(), Qt::Key_B);
    EXPECT_EQ(pictures()->shown(), 1u);
    QTest::qWait(1200);
    EXPECT_EQ(pictures()->shown(), 1u) << "stands still";
    EXPECT_FALSE(pictures()->pixelIn(0, {10, 10}));
    EXPECT_TRUE(pictures()->pixelIn(1, {100, 75}));
}

TEST_F(ComparePane, MethodsAreAddedSwappedAndUndoneToTheSameBits) {
    openPane({});
    EXPECT_EQ(pane()->view(), nullptr) << "nothing to compare with";
    EXPECT_GT(colorsIn(grab(pictures())), 1) << "and it says so";
    pane()->addOther();
    settle();
    ASSERT_EQ(pane()->view()->pictures.size(), 2u);
    pane()->setChoice(1, QStringLiteral("offset"));
    settle();
    const relief::Scenario before = scenario();
    const QImage a = method(0).picture;
    const QImage b = method(1).picture;
    ASSERT_NE(a, b);
    pane()->swapWithA(1);
    settle();
    EXPECT_EQ(scenario().method.name, "offset");
    EXPECT_EQ(method(0).picture, b);
    EXPECT_EQ(method(1).picture, a);
    pane()->removeOther();
    settle();
    EXPECT_EQ(pane()->view(), nullptr);
    workspace_->undo();
    workspace_->undo();
    settle();
    EXPECT_EQ(scenario(), before);
    EXPECT_EQ(method(0).picture, a);
    EXPECT_EQ(method(1).picture, b);
    // After saving and opening, the pane is the same.
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("compared.json"));
    workspace_->save(file);
    pane()->removeOther();
    settle();
    workspace_->open(file);
    settle();
    EXPECT_EQ(scenario(), before);
    EXPECT_EQ(method(1).picture, b);
}

TEST_F(ComparePane, TheCameraIsTurnedFromHere) {
    openPane();
    const relief::Camera before = scenario().camera;
    const QPoint from = pictures()->pixelIn(1, {100, 75})->toPoint();
    QTest::mousePress(pictures(), Qt::LeftButton, {}, from);
    bool coarse = false;
    for (int n = 1; n <= 12; ++n) {
        QMouseEvent move(QEvent::MouseMove, from + QPoint(6 * n, 0), Qt::LeftButton, Qt::LeftButton, {});
        QApplication::sendEvent(pictures(), &move);
        QTest::qWait(30);
        coarse = coarse || (pane()->view() != nullptr && pane()->view()->coarse);
    }
    QTest::mouseRelease(pictures(), Qt::LeftButton, {}, from + QPoint(72, 0));
    settle();
    EXPECT_NE(scenario().camera, before);
    EXPECT_FALSE(pane()->view()->coarse);
    EXPECT_TRUE(pane()->view()->of(*snapshot()));
    EXPECT_EQ(method(0).frame, snapshot()->frame);
}

TEST_F(ComparePane, ShownDuringADragItFollowsTheDrag) {
    openPane({{"layers", {}}});
    auto* const dock = window_->findChild<QWidget*>(QStringLiteral("compare-pane"));
    dock->hide();
    relief::Scenario dragged = scenario();
    dragged.filter.name = relief::kSupersample;  // so slow that the full picture is not drawn meanwhile
    dragged.filter.samples = 48;
    const auto until = [&](const auto& reached) {
        for (int n = 0; n < 200 && !reached(); ++n) {
            dragged.camera.azimuth += 0.1;
            workspace_->change(dragged, QStringLiteral("test"), QStringLiteral("drag"), true);
            QTest::qWait(30);
        }
        return reached();
    };
    ASSERT_TRUE(until([&] { return snapshot()->coarse; }));
    ASSERT_EQ(pane()->view(), nullptr) << "hidden, it keeps nothing of an earlier picture";
    dock->show();
    dock->raise();
    EXPECT_TRUE(until([&] { return pane()->view() != nullptr; }));
}

TEST_F(ComparePane, ItIsExportedAsItIsShown) {
    openPane();
    const QTemporaryDir folder;
    const QString png = folder.filePath(QStringLiteral("compare.png"));
    saveFigure(pane(), png, 1234);
    const QImage image(png);
    EXPECT_NEAR(image.width(), 1234, 1);
    EXPECT_GT(colorsIn(image), 100);
    for (const char* const ending : {"svg", "pdf"}) {
        const QString file = folder.filePath(QStringLiteral("compare.") + QString::fromLatin1(ending));
        saveFigure(pane(), file);
        EXPECT_GT(QFileInfo(file).size(), 5000);
    }
    EXPECT_EQ(pane()->image(600).width(), 600);
}

// Each tile of an exported PNG equals the picture rendered at that size, pixel by pixel; the numbers are those of the
// pane.
TEST_F(ComparePane, ExportedTilesHaveThePixelsThatWereRendered) {
    openPane({{"layers", {{"layers", "8"}}}});
    relief::Scenario changed = scenario();
    changed.pixel.reset();
    workspace_->change(changed, QStringLiteral("test"));
    settle();
    constexpr int kWidth = 811;
    const QImage page = pane()->image(kWidth);
    // Two columns 6 points apart, with margins of 6 points, on a page of 160 mm.
    const double points = 160 / 25.4 * 72;
    const int side = static_cast<int>((points - 18) / 2 * kWidth / points);
    relief::Scenario large = scenario();
    large.comparison = {};
    large.height = static_cast<int>(std::lround(large.height * (static_cast<double>(side) / large.width)));
    large.width = side;
    relief::Work work;
    const QImage rendered = SnapshotMaker().make({large}, work)->picture;
    int found = 0;
    for (int y = 0; y < 60 && found == 0; ++y) {
        for (int x = 0; x < 20; ++x) {
            // Without the frame at its edge.
            const QRect inner(4, 4, side - 8, rendered.height() - 8);
            found += page.copy(inner.translated(x, y)).convertToFormat(QImage::Format_RGB32) ==
                             rendered.copy(inner).convertToFormat(QImage::Format_RGB32)
                         ? 1
                         : 0;
        }
    }
    EXPECT_EQ(found, 1);
}

// The program exports the figure without a display.
TEST(Compare, TheProgramExportsIt) {
    const QTemporaryDir folder;
    relief::Scenario scenario = smallScenario();
    scenario.comparison.others = {{"layers", {{"layers", "8"}}}};
    const auto run = [&](const QString& name, int status = 0) {
        const QString file = folder.filePath(QStringLiteral("s.json"));
        relief::saveScenario(file.toStdString(), scenario);
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove(QStringLiteral("DISPLAY"));
        environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(RELIEFSCOPE), {file, QStringLiteral("--export"), QStringLiteral("compare"),
                                                    QStringLiteral("-o"), folder.filePath(name)});
        process.waitForFinished(60000);
        EXPECT_EQ(process.exitCode(), status) << process.readAllStandardError().toStdString();
        return QImage(folder.filePath(name));
    };
    EXPECT_GT(colorsIn(run(QStringLiteral("two.png"))), 100);
    scenario.comparison.others.clear();
    EXPECT_TRUE(run(QStringLiteral("none.png"), 2).isNull()) << "there is nothing to compare with";
}

}  // namespace

}  // namespace reliefui
