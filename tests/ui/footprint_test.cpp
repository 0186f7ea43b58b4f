// The footprint's pane shows what the filter logged; also the filter's options and the layers of footprints.
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <QComboBox>
#include <QDir>
#include <QTemporaryDir>
#include <QToolButton>

#include "panes/drawing_canvas.h"
#include "panes/figure.h"
#include "panes/footprint/footprint_drawing.h"
#include "panes/footprint/footprint_state.h"
#include "panes/footprint/footprint_view.h"
#include "panes/footprint/weight_drawing.h"
#include "panes/number_control.h"
#include "panes/result/result_painting.h"
#include "window_fixture.h"
#include "windows/filter_box.h"
#include "workspace/pane_store.h"

namespace reliefui {

namespace {

relief::Scenario filtered(const char* filter, relief::OptionValues options = {}) {
    relief::Scenario scenario = smallScenario();
    scenario.filter.name = filter;
    scenario.filter.options = std::move(options);
    return scenario;
}

// Walls that hide the streets behind them.
relief::Scenario city(const char* filter, relief::OptionValues options = {}) {
    relief::Scenario scenario = filtered(filter, std::move(options));
    scenario.pictures.recipe = "city";
    scenario.scene = relief::SceneKind::Floor;
    scenario.reliefDepth = 0.2;
    scenario.camera.elevation = 20;
    return scenario;
}

class FootprintTest : public WindowTest {
  protected:
    void openPane(const relief::Scenario& scenario) {
        openWindow(scenario);
        QTest::keyClick(window_.get(), Qt::Key_8);
        QTest::qWait(100);
        ASSERT_TRUE(view()->isVisible());
        ASSERT_NE(view()->shown(), nullptr);
    }
    FootprintView* view() { return window_->pane<FootprintView>(); }
    DrawingCanvas* canvas() { return view()->canvas(); }
    // Chooses a pixel whose footprint satisfies the condition. Returns false if there is none.
    template <class Condition>
    bool choose(const Condition& satisfies) {
        FilteredPicture picture;
        relief::Work work;
        const Snapshot& now = *snapshot();
        for (int y = 0; y < now.frame->height; y += 3) {
            for (int x = 0; x < now.frame->width; x += 3) {
                const auto footprint = pixelFootprint(*now.frame, *now.request, *now.tracer, x, y, 1, picture, work);
                if (!footprint || !satisfies(*footprint)) continue;
                workspace_->choosePixel(x, y);
                waitForFull();
                QTest::qWait(50);
                return true;
            }
        }
        return false;
    }
    // Returns the marks on the screen of this role and primitive.
    template <class Primitive>
    std::vector<const Item*> marksOf(Role role) {
        std::vector<const Item*> found;
        for (const Item& item : view()->marks()->items) {
            if (item.role == role && std::holds_alternative<Primitive>(item.primitive)) found.push_back(&item);
        }
        return found;
    }
};

int difference(QColor a, Rgba b) {
    return std::abs(a.red() - b.r) + std::abs(a.green() - b.g) + std::abs(a.blue() - b.b);
}

TEST_F(FootprintTest, DotsLieOnTheTexelsAndTheirAreasAreTheWeights) {
    openPane(filtered("elliptical"));
    const auto several = [](const PixelFootprint& f) { return f.log.texels.size() >= 6 && f.log.texels.size() <= 200; };
    ASSERT_TRUE(choose(several));
    const PixelFootprint& f = *view()->shown();
    const auto dots = marksOf<Circle>(Role::Weight);
    ASSERT_EQ(dots.size(), f.log.texels.size());
    const QImage shown = grab(canvas());
    EXPECT_GT(colorsIn(shown), 3);
    double areas = 0;
    double weights = 0;
    for (std::size_t n = 0; n < dots.size(); ++n) {
        const Circle& dot = std::get<Circle>(dots[n]->primitive);
        EXPECT_EQ(dot.center, (Point{f.log.texels[n].u, f.log.texels[n].v}));
        areas += dot.radius * dot.radius;
        weights += PixelFootprint::weightOf(f.log.texels[n]);
    }
    EXPECT_NEAR(weights, f.weightSum, 1e-5 * f.weightSum) << "of floats added in double";
    for (std::size_t n = 0; n < dots.size(); ++n) {
        const Circle& dot = std::get<Circle>(dots[n]->primitive);
        const double weight = PixelFootprint::weightOf(f.log.texels[n]);
        EXPECT_NEAR(dot.radius * dot.radius / areas, weight / weights, 1e-6);
    }
    // The texels with large weights are yellow, except for the lines through their middle.
    int yellow = 0;
    const Style& style = workspace_->style();
    for (const Item* item : dots) {
        const Circle& dot = std::get<Circle>(item->primitive);
        const double off = 0.5 * dot.radius;
        for (const Point p : {Point{-off, 0}, Point{off, 0}, Point{0, -off}, Point{0, off}}) {
            const QPoint at = canvas()->toWidget({dot.center.x + p.x, dot.center.y + p.y}).toPoint();
            if (shown.valid(at) && difference(shown.pixelColor(at), style.color(Role::Weight)) < 40) ++yellow;
        }
    }
    EXPECT_GE(yellow, 4);
}

TEST_F(FootprintTest, WeightsStandBesideItWhereThereIsRoom) {
    openPane(filtered("elliptical", {{"levels", "exhaustive"}}));
    ASSERT_TRUE(choose([](const PixelFootprint& f) { return hasWeights(f) && f.log.texels.size() >= 6; }));
    FootprintView wide(workspace_.get());
    wide.resize(1000, 400);
    wide.show();
    const DrawingCanvas* const weights = wide.weights();
    ASSERT_TRUE(QTest::qWaitFor([&] { return weights->isVisible() && weights->x() > wide.canvas()->x(); }, 5000));
    EXPECT_GT(colorsIn(grab(wide.weights())), 20);
    EXPECT_TRUE(wide.canvas()->isVisible());
    // The button hides and shows it; the setting is stored with the scenario.
    auto* const button = wide.findChild<QToolButton*>(QStringLiteral("footprint-weights"));
    button->click();
    EXPECT_TRUE(weights->isHidden());
    EXPECT_FALSE(stateOf<FootprintPane>(scenario()).weights);
    workspace_->undo();
    EXPECT_FALSE(weights->isHidden());
    // In a high pane the weights are below; in a small one only the footprint is shown.
    wide.resize(330, 800);
    ASSERT_TRUE(QTest::qWaitFor([&] { return weights->y() > wide.canvas()->y(); }, 5000));
    wide.resize(330, 250);
    EXPECT_TRUE(QTest::qWaitFor([&] { return weights->isHidden(); }, 5000));
}

// The numbers of two ellipses each say which one they describe, and a footprint that needed no test has no count of
// tests.
TEST_F(FootprintTest, TheLegendDoesNotContradictItself) {
    openPane(filtered("elliptical-visible"));
    const auto ids = [&](bool tests) {
        FilteredPicture picture;
        relief::Work work;
        const Snapshot& now = *snapshot();
        for (int y = 0; y < now.frame->height; y += 3) {
            for (int x = 0; x < now.frame->width; x += 3) {
                const auto f = pixelFootprint(*now.frame, *now.request, *now.tracer, x, y, 1, picture, work);
                if (!f || !f->bounded || f->counts.tested == 0 || f->log.skipped == tests) continue;
                FootprintOptions options;
                options.numbers = true;
                std::map<relief::MessageId, std::string> found;
                const relief::Language english = relief::Language::English;
                for (const Item& item : footprintLegend(*f, options, true, 2000, english).items) {
                    const auto* const label = std::get_if<Label>(&item.primitive);
                    if (label != nullptr) found[label->text.id] = labelText(*label, english);
                }
                return found;
            }
        }
        return std::map<relief::MessageId, std::string>();
    };
    auto skipped = ids(false);
    ASSERT_FALSE(skipped.empty());
    EXPECT_TRUE(skipped.contains(relief::MessageId::DrawFootprintSkipped));
    EXPECT_FALSE(skipped.contains(relief::MessageId::DrawFootprintTested));
    EXPECT_EQ(skipped[relief::MessageId::DrawFootprintAxes].find("at the hit: "), 0U);
    EXPECT_EQ(skipped[relief::MessageId::DrawFootprintForm].find("on the top plane: "), 0U);
    EXPECT_EQ(skipped[relief::MessageId::DrawFootprintDerivatives].find("on the top plane: "), 0U);
    EXPECT_TRUE(ids(true).contains(relief::MessageId::DrawFootprintTested));
}

TEST_F(FootprintTest, TexelsAreNumberedAtTwoSides) {
    openPane(filtered("bilinear"));
    const int side = view()->shown()->across.size;
    const Box seen = canvas()->visible();
    int columns = 0;
    int rows = 0;
    for (const Item* item : marksOf<Label>(Role::Background)) {
        const Label& label = std::get<Label>(item->primitive);
        const bool above = label.anchor == Anchor::Top;
        const double at = above ? label.at.x : label.at.y;
        const int texel = static_cast<int>(std::floor(at));
        EXPECT_EQ(labelText(label, relief::Language::English), std::to_string((texel % side + side) % side));
        EXPECT_EQ(above ? label.at.y : label.at.x, above ? seen.y0 : seen.x0);
        EXPECT_TRUE(seen.contains(label.at));
        ++(above ? columns : rows);
    }
    EXPECT_GT(columns, 1);
    EXPECT_GT(rows, 1);
    // Over the seam of the picture, near and from afar.
    for (const double reach : {3.0, 40.0}) {
        constexpr double kPoints = 700, kLeastApart = 20;
        const Box over{side - reach, side - reach, side + reach, side + reach};
        const double scale = kPoints / over.width();
        double before = -1;
        int found = 0;
        for (const Item& item : footprintMarks(*view()->shown(), {}, over, scale).drawing.items) {
            const auto* const label = std::get_if<Label>(&item.primitive);
            if (label == nullptr || item.role != Role::Background || label->anchor != Anchor::Top) continue;
            const int texel = static_cast<int>(std::floor(label->at.x));
            EXPECT_EQ(labelText(*label, relief::Language::English), std::to_string(texel % side));
            EXPECT_GE((label->at.x - before) * scale, kLeastApart);
            before = label->at.x;
            ++found;
        }
        EXPECT_GT(found, 4);
    }
}

TEST_F(FootprintTest, TheTextureIsThePictureTheFilterReads) {
    openPane(filtered("elliptical"));
    const PixelFootprint& f = *view()->shown();
    const QImage shown = grab(canvas());
    const Box seen = canvas()->visible();
    const double legendTop = canvas()->room().height() * workspace_->style().pixelsPerPoint();
    int probes = 0;
    int right = 0;
    // Probed in a corner of each texel, because dots are in the middle. Beyond the seam the picture continues.
    constexpr double kCorner = 0.12;
    for (double v = std::floor(seen.y0) + kCorner; v < seen.y1; v += 1) {
        for (double u = std::floor(seen.x0) + kCorner; u < seen.x1; u += 1) {
            const QPoint at = canvas()->toWidget({u, v}).toPoint();
            if (!shown.rect().adjusted(2, 2, -2, -2).contains(at) || at.y() > legendTop) continue;
            const auto wrapped = [](double x, int n) {
                return static_cast<int>(std::floor(x) - n * std::floor(x / n));
            };
            const int i = wrapped(u, f.across.size);
            const int j = wrapped(v, f.down.size);
            const float grey = (*f.colors)(i, j).r;
            const double code = grey <= 0.0031308F ? 12.92 * static_cast<double>(grey)
                                                   : 1.055 * std::pow(static_cast<double>(grey), 1 / 2.4) - 0.055;
            const auto byte = static_cast<std::uint8_t>(std::lround(255 * code));
            ++probes;
            if (difference(shown.pixelColor(at), {byte, byte, byte, 255}) <= 6) ++right;
        }
    }
    EXPECT_GT(probes, 20);
    EXPECT_GT(right, probes * 7 / 10) << "the rest lies under lines";
}

TEST_F(FootprintTest, HiddenTexelsAreCrossedOutWithALineToWhatHidesThem) {
    openPane(city("elliptical-visible", {{"form", "plane"}}));
    const auto mixed = [](const PixelFootprint& f) {
        return f.counts.hidden > 0 && f.counts.hidden < static_cast<std::int64_t>(f.log.texels.size());
    };
    ASSERT_TRUE(choose(mixed)) << "no wall hides a part of a footprint";
    const PixelFootprint& f = *view()->shown();
    const auto hidden = static_cast<std::size_t>(f.counts.hidden);
    EXPECT_EQ(marksOf<Polyline>(Role::Hidden).size(), 2 * hidden) << "two strokes each";
    const auto lines = marksOf<Polyline>(Role::Blocker);
    ASSERT_EQ(lines.size(), hidden);
    std::size_t n = 0;
    for (const relief::FootprintTexel& texel : f.log.texels) {
        if (!texel.hidden) continue;
        const Polyline& line = std::get<Polyline>(lines[n++]->primitive);
        EXPECT_EQ(line.points.front(), (Point{texel.u, texel.v}));
        const Point to = line.points.back();
        const Point place = blockerPlace(f, texel);
        EXPECT_EQ(to, place);
        // The blocker is higher and lies towards the viewer.
        const relief::HeightField& field = snapshot()->request->field;
        double highest = 0;
        for (const Point by : {Point{-0.5, -0.5}, Point{0.5, -0.5}, Point{-0.5, 0.5}, Point{0.5, 0.5}}) {
            highest = std::max(highest, field.at(place.x / f.perHeight.x + by.x, place.y / f.perHeight.y + by.y));
        }
        EXPECT_GT(highest, field.at(texel.u / f.perHeight.x, texel.v / f.perHeight.y));
        const relief::ViewRay& ray = snapshot()->trace.ray;
        EXPECT_LT((to.x - texel.u) * ray.a + (to.y - texel.v) * ray.b, 0);
        // Exactly backwards along the view ray, up to rounding; in texels.
        const double aside = (to.x - texel.u) * ray.b - (to.y - texel.v) * ray.a;
        EXPECT_LE(std::abs(aside), 1e-6 * std::hypot(ray.a, ray.b));
    }
    EXPECT_GT(colorsIn(grab(canvas())), 3);
    // The readout describes the texel under the pointer.
    for (const relief::FootprintTexel& texel : f.log.texels) {
        if (!texel.hidden) continue;
        QTest::mouseMove(canvas(), canvas()->toWidget({texel.u, texel.v}).toPoint());
        QTest::qWait(30);
        EXPECT_TRUE(view()->readout().contains(QStringLiteral("hidden"))) << view()->readout().toStdString();
        break;
    }
}

TEST_F(FootprintTest, ReadingsAtAPointHaveTheirTexelsAndWeights) {
    const std::vector<std::pair<const char*, std::size_t>> filters{{"nearest", 1}, {"bilinear", 4}, {"trilinear", 8}};
    for (const auto& [filter, most] : filters) {
        relief::Scenario scenario = filtered(filter);
        scenario.pictures.color = RELIEF_DATASETS "/brick_tiles037/color.jpg";
        openPane(scenario);
        const PixelFootprint& f = *view()->shown();
        const relief::FootprintTexel& first = f.log.texels.front();
        QTest::mouseMove(canvas(), canvas()->toWidget({first.u, first.v}).toPoint());
        QTest::qWait(30);
        EXPECT_TRUE(view()->readout().contains(QStringLiteral("weight"))) << view()->readout().toStdString();
        EXPECT_FALSE(view()->readout().contains(QStringLiteral("hidden"))) << view()->readout().toStdString();
        EXPECT_GE(f.log.texels.size(), 1U);
        EXPECT_LE(f.log.texels.size(), most) << filter;
        EXPECT_NEAR(f.weightSum, 1, 1e-6) << filter;
        glm::dvec2 mean{0};
        for (const relief::FootprintTexel& texel : f.log.texels) {
            mean += PixelFootprint::weightOf(texel) * glm::dvec2(texel.u, texel.v);
        }
        // For an interpolating filter the weighted mean of the centres is the sampled position; otherwise the texel
        // contains it.
        const double off = std::string_view(filter) == "nearest" ? 0.5 : 1e-4;
        EXPECT_LE(std::abs(mean.x - f.centre().x), off) << filter;
        EXPECT_LE(std::abs(mean.y - f.centre().y), off) << filter;
        TearDown();
        SetUp();
    }
}

// However a form logs its samples, the pane shows each texel once, at its centre, with its total weight.
TEST_F(FootprintTest, TexelsHaveTheirWholeWeightAndSumToAHundredPercent) {
    constexpr double kPercent = 1e-3;  // sums of floats
    constexpr double kPlaces = 1e-6;   // in texels
    for (const char* form : {"plane", "position", "position-area", "rays", "grid"}) {
        openPane(city("elliptical-visible", {{"form", form}}));
        const auto apart = [](const PixelFootprint& f) { return !f.log.skipped && f.log.texels.size() > 8; };
        ASSERT_TRUE(choose(apart)) << form;
        const PixelFootprint& f = *view()->shown();
        const Snapshot& now = *snapshot();
        const relief::PixelChoice pixel = *scenario().pixel;
        const relief::VisiblePolygons visible = now.frame->visible(*now.request);
        const auto query = relief::filterQuery(*now.frame, *now.request, visible, pixel.x, pixel.y);
        ASSERT_TRUE(query.has_value());
        relief::FootprintLog log;
        relief::FootprintCounts counts;
        relief::Work work;
        now.frame->filter->color(*query, counts, work, &log);
        using Name = std::tuple<int, int, int, bool>;
        std::map<Name, double> logged;
        std::map<Name, double> shown;
        for (const relief::FootprintTexel& t : log.texels) {
            logged[{t.level, t.i, t.j, t.hidden}] += PixelFootprint::weightOf(t);
        }
        std::set<std::tuple<int, double, double, bool>> places;
        std::set<std::tuple<int, double, double>> different;
        double percent = 0;
        for (const relief::FootprintTexel& t : f.log.texels) {
            EXPECT_TRUE(places.emplace(t.level, t.u, t.v, t.hidden).second) << form << ": shown twice";
            different.emplace(t.level, t.u, t.v);
            const double weight = PixelFootprint::weightOf(t);
            shown[{t.level, t.i, t.j, t.hidden}] += weight;
            if (!t.hidden) percent += 100 * weight / f.weightSum;
            // The centre of the texel, in any periodic copy of the picture.
            const int finer = f.level() - t.level;
            const double across = std::ldexp(t.u, finer) - (t.i + 0.5);
            const double down = std::ldexp(t.v, finer) - (t.j + 0.5);
            EXPECT_NEAR(std::remainder(across, std::ldexp(f.across.extent, finer)), 0, kPlaces) << form;
            EXPECT_NEAR(std::remainder(down, std::ldexp(f.down.extent, finer)), 0, kPlaces) << form;
            // For form=plane the visible texels lie in the drawn ellipse.
            const relief::LevelFootprint& e = f.log.footprint;
            if (std::string_view(form) != "plane" || t.hidden) continue;
            EXPECT_LE(relief::squaredRadius(e.ellipse, t.u - e.centre.x, t.v - e.centre.y),
                      e.radius * e.radius * (1 + kPlaces));
        }
        EXPECT_NEAR(percent, 100, kPercent) << form;
        EXPECT_EQ(f.texelCount, different.size()) << form << ": a texel hidden in part is one texel";
        // Dots off the curve are explained: texels of which parts were sampled.
        if (hasWeights(f)) {
            const relief::Message parts(relief::MessageId::DrawWeightParts);
            bool explained = false;
            for (const Item& item : weightLegend(f, 400, relief::Language::English).items) {
                const auto* const label = std::get_if<Label>(&item.primitive);
                if (label != nullptr && label->text.id == parts.id) explained = true;
            }
            EXPECT_EQ(explained, log.texels.size() > f.log.texels.size()) << form;
        }
        ASSERT_EQ(shown.size(), logged.size()) << form;
        for (const auto& [name, weight] : logged) {
            EXPECT_NEAR(100 * shown[name] / f.weightSum, 100 * weight / f.weightSum, kPercent) << form;
        }
        TearDown();
        SetUp();
    }
}

TEST_F(FootprintTest, RaysOfSupersampleAreShownWhereTheyHit) {
    constexpr double kRounding = 1e-5;  // sums of floats
    for (const int samples : {1, 4}) {
        relief::Scenario scenario = filtered("supersample");
        scenario.filter.samples = samples;
        openPane(scenario);
        const PixelFootprint& f = *view()->shown();
        ASSERT_EQ(f.rays.size(), static_cast<std::size_t>(samples * samples));
        EXPECT_EQ(marksOf<Marker>(Role::Sample).size(), f.rays.size());
        double share = 0;
        for (const RayHit& ray : f.rays) share += ray.share;
        EXPECT_NEAR(share, 1, kRounding);
        EXPECT_NEAR(f.weightSum, 1, kRounding) << "all texels that the rays sampled";
        if (samples == 1) {
            EXPECT_NEAR(f.rays[0].at.x, f.centre().x, kRounding);
            EXPECT_NEAR(f.rays[0].at.y, f.centre().y, kRounding);
        }
        QTest::mouseMove(canvas(), canvas()->toWidget({f.rays[0].at.x, f.rays[0].at.y}).toPoint());
        QTest::qWait(30);
        EXPECT_TRUE(view()->readout().contains(QStringLiteral("% of the pixel"))) << view()->readout().toStdString();
        TearDown();
        SetUp();
    }
}

TEST_F(FootprintTest, NeighboursAreShownOnRequest) {
    relief::Scenario far = filtered("elliptical");
    far.camera.distance *= 4;
    far.pictures.recipeWidth = far.pictures.recipeHeight = 512;
    openPane(far);
    ASSERT_TRUE(choose([](const PixelFootprint& f) { return f.level() > 0 && f.neighbours.size() == 8; }));
    EXPECT_EQ(marksOf<Polyline>(Role::Neighbour).size(), 0U);
    for (const int count : {4, 8}) {
        view()->setOptions({count});
        EXPECT_EQ(marksOf<Polyline>(Role::Neighbour).size(), static_cast<std::size_t>(count));
    }
    // Each around its own place, in the level's texels, in any periodic copy of the picture.
    const PixelFootprint& f = *view()->shown();
    for (std::size_t n = 0; n < f.neighbours.size(); ++n) {
        const auto& line = std::get<Polyline>(marksOf<Polyline>(Role::Neighbour)[n]->primitive);
        Box box;
        for (const Point& p : line.points) box = box.joined({p.x, p.y, p.x, p.y});
        const glm::dvec2 place = f.neighbours[n].centre * f.perHeight;
        EXPECT_NEAR(std::remainder(box.center().x - place.x, f.across.extent), 0, 1e-6);
        EXPECT_NEAR(std::remainder(box.center().y - place.y, f.down.extent), 0, 1e-6);
    }
}

TEST_F(FootprintTest, FilterOptionsChangeThePictureAndUndoGivesTheSameBits) {
    openPane(filtered("elliptical"));
    const QImage before = snapshot()->picture;
    auto* const box = window_->findChild<FilterBox*>();
    ASSERT_NE(box, nullptr);
    auto* const sigma = box->findChild<NumberControl*>(QStringLiteral("sigma"));
    ASSERT_NE(sigma, nullptr);
    sigma->box()->setValue(1.8);
    waitForFull();
    EXPECT_EQ(scenario().filter.options.at("sigma"), "1.8");
    EXPECT_NE(snapshot()->picture, before);
    EXPECT_EQ(view()->shown()->filter.options.at("sigma"), "1.8");
    workspace_->undo();
    waitForFull();
    EXPECT_TRUE(scenario().filter.options.empty());
    EXPECT_EQ(snapshot()->picture, before);
    EXPECT_NEAR(sigma->value(), 0.53, 1e-9);
    workspace_->redo();
    waitForFull();
    // The same filter, chosen again, keeps its options; another one has none of them.
    auto* const filter = window_->findChild<QComboBox*>(QStringLiteral("filter"));
    Q_EMIT filter->activated(filter->currentIndex());
    EXPECT_EQ(scenario().filter.options.count("sigma"), 1U);
    filter->setCurrentIndex(filter->findData(QStringLiteral("elliptical-visible")));
    Q_EMIT filter->activated(filter->currentIndex());
    waitForFull();
    EXPECT_TRUE(scenario().filter.options.empty());
    EXPECT_NE(box->findChild<QComboBox*>(QStringLiteral("form")), nullptr);
}

TEST_F(FootprintTest, StripesTakeThreeSamples) {
    relief::Scenario scenario = filtered("supersample");
    scenario.filter.samples = 1;
    openPane(scenario);
    auto* const model = window_->findChild<QComboBox*>(QStringLiteral("pixel-model"));
    ASSERT_NE(model, nullptr);
    model->setCurrentText(QStringLiteral("lcd"));
    Q_EMIT model->activated(model->currentIndex());
    QTest::qWait(20);
    waitForFull();
    EXPECT_EQ(workspace_->scenario().filter.pixelModel, relief::PixelModel::Lcd);
    EXPECT_EQ(workspace_->scenario().filter.samples, 3);
    // If there are enough samples, their number is kept.
    relief::Scenario many = workspace_->scenario();
    many.filter.samples = 16;
    workspace_->change(many, {}, {});
    QTest::qWait(20);
    auto* const again = window_->findChild<QComboBox*>(QStringLiteral("pixel-model"));
    ASSERT_NE(again, nullptr);
    again->setCurrentText(QStringLiteral("gaussian"));
    Q_EMIT again->activated(again->currentIndex());
    QTest::qWait(20);
    EXPECT_EQ(workspace_->scenario().filter.pixelModel, relief::PixelModel::Gaussian);
    EXPECT_EQ(workspace_->scenario().filter.samples, 16);
}

TEST_F(FootprintTest, LayersShowTheFootprintAndWhatIsHiddenOfIt) {
    openWindow(city("elliptical-visible", {{"form", "plane"}}));
    workspace_->setLayer(Layer::Hidden);
    waitForFull();
    ASSERT_TRUE(QTest::qWaitFor([&] { return snapshot()->layer.layer == Layer::Hidden; }, 20000));
    EXPECT_TRUE(snapshot()->layer.applies);
    EXPECT_GT(snapshot()->layer.ends.high, 0);
    EXPECT_LE(snapshot()->layer.ends.high, 100);
    EXPECT_GT(colorsIn(snapshot()->layer.image), 3);
    workspace_->setLayer(Layer::Anisotropy);
    ASSERT_TRUE(QTest::qWaitFor([&] { return snapshot()->layer.layer == Layer::Anisotropy; }, 20000));
    const LayerPicture& layer = snapshot()->layer;
    EXPECT_EQ(layer.ends.low, 1);
    // A floor seen at 20 degrees is foreshortened to about a third.
    EXPECT_GT(layer.ends.high, 2.5);
    const relief::PixelChoice pixel = *scenario().pixel;
    const auto& footprint = snapshot()->footprint;
    ASSERT_NE(footprint, nullptr);
    const double ratio = footprint->log.footprint.major / footprint->log.footprint.minor;
    EXPECT_NEAR(anisotropy(*layer.planes, pixel.x, pixel.y), ratio, 1e-4 * ratio) << "planes are floats";
    relief::Scenario plain = scenario();
    plain.filter = {};
    workspace_->change(plain, QStringLiteral("Filter"));
    workspace_->setLayer(Layer::Hidden);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return snapshot()->layer.layer == Layer::Hidden && snapshot()->scenario.filter.name == "bilinear"; },
        20000));
    EXPECT_FALSE(snapshot()->layer.applies);
}

TEST_F(FootprintTest, TheFigureIsThePane) {
    openPane(filtered("elliptical"));
    const QTemporaryDir folder;
    for (const char* name : {"f.png", "f.svg", "f.pdf"}) {
        const QString path = folder.filePath(QString::fromLatin1(name));
        saveFigure(view(), path);
        EXPECT_GT(QFileInfo(path).size(), 1000) << name;
    }
    const QImage picture = view()->image(900);
    EXPECT_GT(colorsIn(picture), 10);
    // It lists the derivatives, since a figure has no tool tips.
    QFile svg(folder.filePath(QStringLiteral("f.svg")));
    ASSERT_TRUE(svg.open(QIODevice::ReadOnly));
    EXPECT_TRUE(QString::fromUtf8(svg.readAll()).contains(QStringLiteral("on the top plane")));
    EXPECT_FALSE(QImage(folder.filePath(QStringLiteral("f.png"))).isNull());
    // While the hit is to be guessed, the pane says that it is hidden, not that there is none.
    workspace_->setGuessing(true);
    const QImage shown = grab(canvas());
    DrawingCanvas expected(view());
    expected.setStyle(workspace_->style());
    expected.resize(canvas()->size());
    expected.showText(relief::MessageId::DrawHidden);
    EXPECT_EQ(shown, grab(&expected));
    EXPECT_TRUE(view()->image(900).isNull());
}

}  // namespace

}  // namespace reliefui
