// The profile as data: its content for every kind of ray, and in exported figures.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "chart_laws.h"
#include "scenario/step_sentence.h"
#include "traced_ray.h"

namespace reliefui {
namespace {

using relief::Address;
using relief::Surface;

constexpr double kWidth = 640;
constexpr double kHeight = 360;

int countOf(const Drawing& drawing, ItemKind kind) {
    return static_cast<int>(std::count_if(drawing.items.begin(), drawing.items.end(),
                                          [&](const Item& item) { return item.id.kind == kind; }));
}

bool finite(const Drawing& drawing) {
    const auto good = [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    for (const Item& item : drawing.items) {
        if (const auto* line = std::get_if<Polyline>(&item.primitive)) {
            if (!std::all_of(line->points.begin(), line->points.end(), good)) return false;
        } else if (const auto* area = std::get_if<Area>(&item.primitive)) {
            if (!std::all_of(area->line.begin(), area->line.end(), good)) return false;
        } else if (const auto* marker = std::get_if<Marker>(&item.primitive)) {
            if (!good(marker->at)) return false;
        } else if (const auto* label = std::get_if<Label>(&item.primitive)) {
            if (!good(label->at)) return false;
        }
    }
    return true;
}

// The 8 x 8 example with a ray along row 5 of columns: every border, maximum and step is known from the map alone.
TEST(ProfileDrawing, plateausOfTheExampleStandAtTheirMaxima) {
    Traced t("paper8x8", 8, 8, Surface::Columns, Address::Repeat);
    t.trace({0, 5.5, 8, 0}, {"max-pyramid-paper", {}});
    ProfileOptions options;
    options.levels = LevelsShown::All;
    const ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
    const Drawing drawing = profileRelief(t.source, options, frame);
    std::map<int, int> found;
    for (const Item& item : drawing.items) {
        if (item.role != Role::Plateau) continue;
        ASSERT_EQ(item.id.kind, ItemKind::Texel);
        const auto& line = std::get<Polyline>(item.primitive).points;
        ASSERT_EQ(line.size(), 2u);
        const int side = 1 << item.id.level;
        float highest = 0;
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                highest = std::max(highest, t.field.texel(item.id.i * side + i, item.id.j * side + j));
            }
        }
        EXPECT_EQ(item.id.j, 5 >> item.id.level);
        EXPECT_NEAR(line[0].y, frame.yAt(static_cast<double>(highest)), kRounding) << idText(item.id);
        EXPECT_NEAR(line[1].y, line[0].y, kRounding);
        // Eight texels per unit of lambda.
        EXPECT_NEAR(line[0].x, frame.xAt(static_cast<double>(item.id.i * side) / 8), 1e-6) << idText(item.id);
        const double end = std::min(static_cast<double>((item.id.i + 1) * side) / 8, frame.lambdaEnd);
        EXPECT_NEAR(line[1].x, frame.xAt(end), 1e-6) << idText(item.id);
        ++found[item.id.level];
    }
    for (int level = 0; level <= 3; ++level) {
        EXPECT_EQ(found[level], static_cast<int>(std::ceil(8 * frame.lambdaEnd / (1 << level)))) << level;
    }
}

TEST(ProfileDrawing, everyStepHasItsMarkNearItsPlaceOnTheRay) {
    Traced t("paper8x8", 8, 8, Surface::Bilinear, Address::Repeat);
    t.trace({1.2, 5.1, 5, -2}, {"max-pyramid-paper", {}});
    const ProfileOptions options;
    const ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
    ASSERT_GT(t.log.steps.size(), 5u);
    std::vector<ItemId> first;
    for (const int step : {0, 3, static_cast<int>(t.log.steps.size()) - 1}) {
        const Drawing marks = profileMarks(t.source, options, frame, step);
        std::set<std::int64_t> found;
        int rings = 0;
        for (const Item& item : marks.items) {
            rings += std::holds_alternative<Ring>(item.primitive) ? 1 : 0;
            if (!std::holds_alternative<Marker>(item.primitive)) continue;
            ASSERT_EQ(item.id.kind, ItemKind::Step);
            const relief::Step& s = t.log.steps[static_cast<std::size_t>(item.id.i)];
            EXPECT_TRUE(found.insert(item.id.i).second) << "once each";
            EXPECT_EQ(item.role, roleOf(s.decision));
            // In the middle of the step's texel, or slightly beside it if there is no room.
            const double lambda = frame.lambdaAt(std::get<Marker>(item.primitive).at.x);
            const double aside = 3 * 30 / frame.plot.width() * frame.lambdaEnd;
            EXPECT_GE(lambda, std::min(s.lambdaIn, s.lambdaAfter) - aside);
            EXPECT_LE(lambda, std::max(s.lambdaOut, s.lambdaAfter) + aside);
        }
        ASSERT_EQ(t.source.hit.outcome, relief::Outcome::Hit);
        EXPECT_EQ(found.size(), t.log.steps.size() - 1) << "the last one is the ring";
        EXPECT_EQ(rings, 1);
        // The same items have the same ids, whichever step is chosen.
        std::vector<ItemId> ids;
        for (const Item& item : marks.items) {
            if (std::holds_alternative<Marker>(item.primitive)) ids.push_back(item.id);
        }
        std::sort(ids.begin(), ids.end());
        if (first.empty()) first = ids;
        EXPECT_EQ(ids, first);
    }
}

// Marks with their numbers, and names of levels, do not overlap.
TEST(ProfileDrawing, numbersAndMarksDoNotOverlap) {
    for (const char* const recipe : {"bricks", "city", "fractal"}) {
        Traced t(recipe, 128, 128, Surface::Bilinear, Address::Repeat);
        t.trace({12, 40, 60, -39}, {"max-pyramid-paper", {}});
        const ProfileOptions options;
        const ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
        const Drawing marks = profileMarks(t.source, options, frame, 2);
        std::vector<Box> boxes;
        for (const Item& item : marks.items) {
            constexpr double kMark = 3.9;  // half the size of a mark
            if (const auto* marker = std::get_if<Marker>(&item.primitive)) {
                boxes.push_back(
                    {marker->at.x - kMark, marker->at.y - kMark, marker->at.x + kMark, marker->at.y + kMark});
            } else if (const auto* label = std::get_if<Label>(&item.primitive); label != nullptr && label->plate) {
                const double x = label->at.x + label->offset.x;
                boxes.push_back({x, label->at.y - kMark, x + 5, label->at.y + kMark});
            }
        }
        ASSERT_GT(boxes.size(), 8u);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            for (std::size_t m = k + 1; m < boxes.size(); ++m) {
                EXPECT_FALSE(boxes[k].overlaps(boxes[m])) << recipe << ": " << k << " and " << m;
            }
        }
    }
}

// A level's name is next to the longest of its plateaus that leaves room for it.
TEST(ProfileDrawing, everyLevelIsNamedOnceWhereThereIsRoom) {
    for (const char* const recipe : {"city", "hills"}) {
        Traced t(recipe, 128, 128, Surface::Bilinear, Address::Repeat);
        t.trace({12, 40, 60, -39}, {"max-pyramid-paper", {}});
        ProfileOptions options;
        options.levels = LevelsShown::All;
        const ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
        std::vector<int> named;
        for (const Item& item : profileMarks(t.source, options, frame, 2).items) {
            if (item.id.kind == ItemKind::Level) named.push_back(item.id.level);
        }
        std::sort(named.begin(), named.end());
        std::vector<int> levels = profileLevels(t.source, options);
        std::sort(levels.begin(), levels.end());
        EXPECT_EQ(levels.size(), 8u) << recipe;
        EXPECT_EQ(named, levels) << recipe;
    }
}

// Numbers of steps at the edge of the drawing are inside it, and so is that of the hit.
TEST(ProfileDrawing, numbersAtTheRimAreWhole) {
    for (const char* const recipe : {"bricks", "city", "fractal"}) {
        Traced t(recipe, 128, 128, Surface::Bilinear, Address::Repeat);
        t.trace({12, 40, 60, -39}, {"max-pyramid-paper", {}});
        ASSERT_EQ(t.source.hit.outcome, relief::Outcome::Hit);
        const ProfileOptions options;
        ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
        // The visible part ends at various positions behind the hit, as after zooming.
        for (double behind = 7; behind < 200; behind += 1.5) {
            frame.visible.x1 = frame.onRay(t.source.hit.lambda).x + behind;
            if (frame.visible.x1 > frame.whole.x1) break;
            int hits = 0;
            const Drawing drawing = profileMarks(t.source, options, frame, 2);
            for (const Item& item : drawing.items) {
                const auto* label = std::get_if<Label>(&item.primitive);
                if (label == nullptr || !label->plate) continue;
                hits += item.role == Role::Hit ? 1 : 0;
                constexpr double kDigit = 5;  // points
                const auto text = relief::sentence(label->text, relief::Language::English);
                const double end = label->at.x + label->offset.x +
                                   (label->anchor == Anchor::Left ? kDigit * static_cast<double>(text.size()) : 0);
                EXPECT_LE(end, frame.visible.x1) << recipe << ", " << behind << " behind the hit: " << text;
            }
            EXPECT_EQ(hits, 1);
        }
    }
}

// A mark that is moved from its place on the ray, for lack of room, is inside the visible part of the plot.
TEST(ProfileDrawing, movedMarksAreWhole) {
    constexpr double kHalf = 3.5;  // of a mark
    int moved = 0;
    Traced t("city", 128, 128, Surface::Bilinear, Address::Repeat);
    t.trace({12, 40, 60, -39}, {"max-pyramid-paper", {}});
    ProfileFrame frame = profileFrame(t.source, {}, kWidth, kHeight);
    for (const double part : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
        frame.visible.y0 = frame.onRay(part * t.source.hit.lambda).y - 7;
        const Box seen = frame.seen();
        const Drawing drawing = profileMarks(t.source, {}, frame, 2);
        for (std::size_t k = 1; k < drawing.items.size(); ++k) {
            // A line joins a moved mark to its place.
            const auto* const marker = std::get_if<Marker>(&drawing.items[k].primitive);
            if (marker == nullptr || drawing.items[k - 1].role != Role::Frame) continue;
            EXPECT_GE(marker->at.y - kHalf, seen.y0) << part << ": " << drawing.items[k].id.i;
            EXPECT_LE(marker->at.x + kHalf, seen.x1) << part << ": " << drawing.items[k].id.i;
            ++moved;
        }
    }
    EXPECT_GT(moved, 5);
}

// The distance from the exact hit, and a guess with its answer, are inside the visible part wherever they belong.
TEST(ProfileDrawing, wordsAtTheRimAreWhole) {
    Traced t("city", 128, 128, Surface::Bilinear, Address::Repeat);
    const relief::ViewRay ray{12, 40, 60, -39};
    t.trace(ray, {"exact", {}});
    t.source.exact = t.source.hit;
    t.trace(ray, {"layers", {{"layers", "5"}}});
    ASSERT_GT(relief::answerError(t.source.hit, t.source.exact, ray), relief::kSameAnswer);
    ProfileOptions options;
    options.guess = t.source.hit.lambda + 0.01;
    ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
    const std::set<relief::MessageId> words{relief::MessageId::DrawExactOff, relief::MessageId::DrawGuess,
                                            relief::MessageId::DrawGuessAnswer};
    int seen = 0;
    for (double behind = 7; behind < 200; behind += 4) {
        frame.visible.x1 = frame.onRay(t.source.exact.lambda).x + behind;
        if (frame.visible.x1 > frame.whole.x1) break;
        for (const Item& item : profileMarks(t.source, options, frame, 2).items) {
            const auto* const label = std::get_if<Label>(&item.primitive);
            if (label == nullptr || !words.contains(label->text.id)) continue;
            ++seen;
            for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
                const double width = textWidth(relief::sentence(label->text, language), label->size);
                const Box box = labelBox(*label, {}, width, 10 * label->size, 1);
                EXPECT_LE(box.x1, frame.visible.x1) << behind << relief::sentence(label->text, language);
                EXPECT_GE(box.x0, frame.visible.x0) << behind << relief::sentence(label->text, language);
            }
        }
    }
    EXPECT_GT(seen, 3);
}

TEST(ProfileDrawing, layersAndSamplesOfTheLayerMethod) {
    Traced t("bricks", 64, 64, Surface::Bilinear, Address::Repeat);
    t.trace({12, 40, 9, -4}, {"layers", {{"layers", "10"}}});
    ProfileOptions options;
    const ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
    EXPECT_TRUE(profileLevels(t.source, options).empty());
    const Drawing relief = profileRelief(t.source, options, frame);
    EXPECT_EQ(countOf(relief, ItemKind::Layer), 11);
    for (const Item& item : relief.items) {
        if (item.id.kind != ItemKind::Layer) continue;
        const auto& line = std::get<Polyline>(item.primitive).points;
        EXPECT_NEAR(line[0].y, frame.yAt(1 - static_cast<double>(item.id.i) / 10), kRounding);
    }
    const Drawing marks = profileMarks(t.source, options, frame, 0);
    int samples = 0;
    for (const Item& item : marks.items) {
        const auto* marker = std::get_if<Marker>(&item.primitive);
        if (marker == nullptr || item.role != Role::Sample) continue;
        const double lambda = frame.lambdaAt(marker->at.x);
        EXPECT_NEAR(frame.heightAt(marker->at.y), surfaceAt(t.field, t.source.ray, lambda), 1e-6);
        ++samples;
    }
    const auto read = std::count_if(t.log.steps.begin(), t.log.steps.end(), [](const relief::Step& s) {
        return s.decision == relief::Decision::Advance || s.decision == relief::Decision::Hit;
    });
    EXPECT_EQ(samples, read);
}

TEST(ProfileDrawing, theOffsetMethodShowsItsOneSample) {
    Traced t("bricks", 64, 64, Surface::Bilinear, Address::Repeat);
    for (const char* const method : {"offset", "offset-limited"}) {
        t.trace({12, 40, 9, -4}, {method, {}});
        const ProfileFrame frame = profileFrame(t.source, {}, kWidth, kHeight);
        const Drawing marks = profileMarks(t.source, {}, frame, 1);
        std::vector<Point> dots;
        for (const Item& item : marks.items) {
            const auto* marker = std::get_if<Marker>(&item.primitive);
            if (marker != nullptr && item.role == Role::Sample) dots.push_back(marker->at);
        }
        ASSERT_EQ(dots.size(), 1u) << method;
        EXPECT_NEAR(dots[0].x, frame.plot.x0, kRounding);
        EXPECT_NEAR(frame.heightAt(dots[0].y), surfaceAt(t.field, t.source.ray, 0), kRounding);
    }
}

// Vertical rays, address border, the step limit, a single texel, distant starts: all are drawn, with finite coordinates
// and something visible.
TEST(ProfileDrawing, raysOfEveryKindAreDrawn) {
    struct Case {
        int size;
        Address address;
        relief::ViewRay ray;
        relief::Outcome outcome;
    };
    const std::vector<Case> cases{
        {64, Address::Repeat, {20.5, 30.5, 0, 0}, relief::Outcome::Hit},
        {64, Address::Border, {-3, 5, 20, 4}, relief::Outcome::Miss},
        {64, Address::Border, {62, 30, 500, 0}, relief::Outcome::Miss},
        {64, Address::Repeat, {1e6 + 0.3, -1e6, 40, 11}, relief::Outcome::Hit},
        {64, Address::Clamp, {10, 10, -60, 3}, relief::Outcome::Hit},
        {1, Address::Repeat, {0.2, 0.7, 5, 3}, relief::Outcome::Hit},
        {1, Address::Clamp, {0.2, 0.7, 0, 0}, relief::Outcome::Hit},
        {64, Address::Repeat, {3, 4, 3e6, 1e6}, relief::Outcome::Unset},
    };
    for (const Case& c : cases) {
        for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
            Traced t("bricks", c.size, c.size, surface, c.address);
            for (const char* const method : {"max-pyramid", "exact", "layers", "offset"}) {
                t.trace(c.ray, {method, {}});
                if (c.outcome != relief::Outcome::Unset && std::string(method) == "exact") {
                    EXPECT_EQ(t.source.hit.outcome, c.outcome) << c.ray.s0;
                }
                for (const bool trueAspect : {false, true}) {
                    ProfileOptions options;
                    options.levels = LevelsShown::All;
                    options.trueAspect = trueAspect;
                    options.nearRay = trueAspect;
                    const ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
                    EXPECT_EQ(frame.vertical, c.ray.a == 0 && c.ray.b == 0);
                    const Drawing relief = profileRelief(t.source, options, frame);
                    const Drawing axes = profileAxes(t.source, frame);
                    const int last = static_cast<int>(t.log.steps.size()) - 1;
                    for (const int step : {0, last / 2, last}) {
                        const Drawing marks = profileMarks(t.source, options, frame, step);
                        EXPECT_TRUE(finite(marks)) << method;
                        EXPECT_GE(countOf(marks, ItemKind::Ray), 1) << method;
                    }
                    EXPECT_TRUE(finite(relief) && finite(axes)) << method;
                    EXPECT_EQ(countOf(relief, ItemKind::Surface), 1);
                    EXPECT_GT(axes.items.size(), 6u);
                    expectWordsInside(axes);
                    expectWordsInside(profileAxes(t.source, profileFrame(t.source, options, 226, 120)));
                }
            }
        }
    }
}

// The drawn ray ends where the tracer gave up.
TEST(ProfileDrawing, aGivenUpRayEndsWhereItWasGivenUp) {
    Traced t(relief::FloatImage(16, 16, 0.25F), Surface::Bilinear, Address::Repeat);
    t.trace({3, 4, 3e6, 1e6}, {"exact", {}});
    ASSERT_EQ(t.source.hit.outcome, relief::Outcome::Limit);
    const ProfileFrame frame = profileFrame(t.source, {}, kWidth, kHeight);
    const Drawing marks = profileMarks(t.source, {}, frame, 0);
    double end = -1;
    for (const Item& item : marks.items) {
        if (item.id.kind != ItemKind::Ray || item.role != Role::Ray) continue;
        end = std::max(end, frame.lambdaAt(std::get<Polyline>(item.primitive).points.back().x));
    }
    EXPECT_NEAR(end, t.log.steps.back().lambdaAfter, 1e-9);
}

TEST(ProfileDrawing, aTexelIsAsLongAcrossAsUpwards) {
    Traced t("bricks", 64, 64, Surface::Bilinear, Address::Repeat);
    t.trace({12, 40, 9, -4}, {"max-pyramid", {}});
    ProfileOptions options;
    options.trueAspect = true;
    const ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
    const double across = frame.plot.width() / (frame.lambdaEnd * frame.run);
    const double upwards = (frame.yAt(0) - frame.yAt(1)) / t.field.slabTexels();
    EXPECT_NEAR(across, upwards, 1e-9 * across);
    // A short ray under a high slab is not drawn as a narrow strip: its surroundings fill the pane.
    t.trace({12, 40, 200, 0}, {"max-pyramid", {}});
    t.source.hit = relief::Hit::at(t.source.ray, 0.01);
    t.source.steps = nullptr;
    const ProfileFrame wide = profileFrame(t.source, options, kWidth, kHeight);
    EXPECT_GT(wide.plot.width(), 0.8 * kWidth);
    EXPECT_NEAR(wide.plot.width() / (wide.lambdaEnd * wide.run), (wide.yAt(0) - wide.yAt(1)) / t.field.slabTexels(),
                1e-9);
    for (const ProfileFrame& shown : {frame, wide}) EXPECT_EQ(shown.plot.cut(shown.whole), shown.plot);
}

// When zoomed in, all visible items are made, and only these.
TEST(ProfileDrawing, aZoomShowsCellsThatWereThinnedOut) {
    Traced t("fractal", 256, 256, Surface::Bilinear, Address::Repeat);
    t.trace({3.3, 7.1, 8000, 6000}, {"max-pyramid", {}});
    t.source.hit = relief::Hit::none(relief::Outcome::Limit);  // the whole ray is shown
    t.source.steps = nullptr;
    const ProfileOptions options;
    ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
    ASSERT_EQ(frame.lambdaEnd, 1);
    const auto thinned = [](const Drawing& drawing) {
        return std::any_of(drawing.items.begin(), drawing.items.end(), [](const Item& item) {
            const auto* label = std::get_if<Label>(&item.primitive);
            return label != nullptr && label->text.id == relief::MessageId::DrawThinned;
        });
    };
    EXPECT_TRUE(thinned(profileRelief(t.source, options, frame)));
    frame.zoom = 400;
    const Point middle = frame.plot.center();
    frame.visible = {middle.x - 0.8, middle.y - 0.4, middle.x + 0.8, middle.y + 0.4};
    const Drawing near = profileRelief(t.source, options, frame);
    EXPECT_FALSE(thinned(near));
    for (const Item& item : near.items) {
        if (item.id.kind != ItemKind::Surface) continue;
        for (const Point& p : std::get<Polyline>(item.primitive).points) {
            EXPECT_TRUE(p.x >= frame.visible.x0 - kRounding && p.x <= frame.visible.x1 + kRounding);
        }
    }
}

// Drawing time is not tested; the number of items, which determines it, is.
TEST(ProfileDrawing, aRayThroughTenThousandCellsIsFewThings) {
    Traced t("fractal", 256, 256, Surface::Bilinear, Address::Repeat);
    for (const char* const method : {"exact", "max-pyramid-paper"}) {
        t.trace({3.3, 7.1, 60000, 40000}, {method, {}});
        ProfileOptions options;
        options.levels = LevelsShown::All;
        ProfileFrame frame = profileFrame(t.source, options, kWidth, kHeight);
        frame.lambdaEnd = 0.1;  // ten thousand cells
        const auto start = std::chrono::steady_clock::now();
        const Drawing relief = profileRelief(t.source, options, frame);
        const Drawing marks = profileMarks(t.source, options, frame, 0);
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        RecordProperty(std::string("milliseconds-") + method, std::to_string(took.count()));
        std::printf("%s: %zu steps, %zu + %zu things, %.1f ms\n", method, t.log.steps.size(), relief.items.size(),
                    marks.items.size(), took.count());
        EXPECT_LT(relief.items.size(), 9 * 2 * kWidth);
        EXPECT_LT(marks.items.size(), 3000u);
    }
}

// A sphere or cone is drawn as violated exactly if the ray's first hit lies inside it; only then the legend explains
// it.
TEST(ProfileDrawing, brokenPromisesAreDrawnAsSuch) {
    constexpr double kLong = 0.005;  // in lambda; more than the tolerance within which results count as equal
    for (const char* method : {"distance", "cone"}) {
        Traced t("hills", 64, 64, Surface::Bilinear, Address::Repeat);
        t.trace({12, 40, 4, -1}, {method, {}});
        const auto claims = std::find_if(t.log.steps.begin(), t.log.steps.end(), [](const relief::Step& s) {
            return s.trustsMap() && s.lambdaAfter > stepBody(s).lambda + kLong;
        });
        ASSERT_NE(claims, t.log.steps.end()) << method;
        const auto k = static_cast<int>(claims - t.log.steps.begin());
        const relief::Message row(relief::MessageId::DrawPromiseBroken);
        const std::string words = relief::sentence(row, relief::Language::English);
        const double start = stepBody(*claims).lambda;
        const double middle = (start + claims->lambdaAfter) / 2;
        for (const double met : {middle, 1.0}) {
            t.source.exact = relief::Hit::at(t.source.ray, met);
            const ProfileFrame frame = profileFrame(t.source, {}, kWidth, kHeight);
            const Drawing marks = profileMarks(t.source, {}, frame, k);
            const bool broken = std::any_of(marks.items.begin(), marks.items.end(), [&](const Item& item) {
                return item.role == Role::Overshoot && item.id.kind == ItemKind::Step && item.id.i == k;
            });
            EXPECT_EQ(broken, met == middle) << method;
            const Drawing legend = profileLegend(t.source, {}, kWidth, relief::Language::English);
            const bool explained = std::any_of(legend.items.begin(), legend.items.end(), [&](const Item& item) {
                const auto* const label = std::get_if<Label>(&item.primitive);
                return label != nullptr && labelText(*label, relief::Language::English) == words;
            });
            EXPECT_EQ(explained, met == middle) << method;
        }
    }
}

// With little room: all levels in one entry, text in either language, and half the rows.
TEST(ProfileDrawing, theBriefLegendNamesWhatIsDrawnInFewRows) {
    Traced t("bricks", 64, 64, Surface::Bilinear, Address::Repeat);
    t.trace({12, 40, 19, -4}, {"max-pyramid-paper", {}});
    const auto text = [&](const Drawing& legend, relief::Language language) {
        std::string all;
        for (const Item& item : legend.items) {
            if (const auto* const label = std::get_if<Label>(&item.primitive))
                all += labelText(*label, language) + "\n";
        }
        return all;
    };
    constexpr double kNarrow = 330;
    for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
        const Drawing whole = profileLegend(t.source, {}, kNarrow, language);
        const Drawing brief = profileLegend(t.source, {}, kNarrow, language, true);
        EXPECT_GT(whole.bounds.height(), 1.4 * brief.bounds.height());
        EXPECT_LE(brief.bounds.width(), kNarrow);
        const std::vector<int> levels = profileLevels(t.source, {});
        ASSERT_GT(levels.size(), 2U);
        const std::string range = std::to_string(levels.front()) + " – " + std::to_string(levels.back());
        EXPECT_NE(text(brief, language).find(range), std::string::npos) << text(brief, language);
    }
}

TEST(ProfileDrawing, theReadingIsTheSurfaceUnderThePointer) {
    Traced t("bricks", 64, 64, Surface::Columns, Address::Repeat);
    t.trace({12, 40, 19, -4}, {"max-pyramid", {}});
    const ProfileFrame frame = profileFrame(t.source, {}, kWidth, kHeight);
    for (const double part : {0.05, 0.4, 0.9}) {
        const double lambda = part * frame.lambdaEnd;
        const ProfileReading at = profileReading(t.source, frame, frame.at(lambda, 0.5));
        ASSERT_TRUE(at.inside);
        EXPECT_NEAR(at.lambda, lambda, kRounding);
        EXPECT_NEAR(at.across, lambda * std::hypot(19, 4), 1e-6);
        EXPECT_EQ(at.i, static_cast<std::int64_t>(std::floor(12 + lambda * 19)));
        EXPECT_EQ(at.j, static_cast<std::int64_t>(std::floor(40 - lambda * 4)));
        EXPECT_EQ(at.surface, static_cast<double>(t.field.texel(at.i, at.j)));
        if (at.step >= 0) {
            const relief::Step& s = t.log.steps[static_cast<std::size_t>(at.step)];
            EXPECT_TRUE(s.lambdaIn <= lambda && lambda < s.lambdaOut);
        }
    }
    EXPECT_FALSE(profileReading(t.source, frame, {1, 1}).inside);
}

}  // namespace
}  // namespace reliefui
