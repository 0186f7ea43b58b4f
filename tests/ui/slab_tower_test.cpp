// The levels of a pyramid in space: slabs as large as their texels over the same ground, and the ray's path through
// them.
#include <cmath>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkRenderer.h>
#include <QCoreApplication>
#include <QPainter>

#include "painting/painter.h"
#include "panes/pyramid/pyramid_figure.h"
#include "panes/pyramid/slab_scene.h"
#include "panes/pyramid/slab_tower.h"
#include "panes/ray_geometry.h"
#include "window_fixture.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {
namespace {

std::shared_ptr<const Snapshot> snapshotOf(const relief::Scenario& scenario) {
    SnapshotMaker maker;
    relief::Work work;
    SnapshotOrder order;
    order.scenario = scenario;
    return maker.make(order, work);
}

relief::Scenario walked() {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"max-pyramid", {}};
    scenario.camera.elevation = 25;
    scenario.pixel = relief::PixelChoice{scenario.width / 2, scenario.height / 2};
    return scenario;
}

PyramidParts partsOf(const Snapshot& snapshot, relief::PyramidKind kind, bool nearRay) {
    PyramidOptions options;
    options.kind = kind;
    options.nearRay = nearRay;
    return pyramidParts(snapshot, options, 800, 500);
}

double area(const Box& box) {
    return box.width() * box.height();
}

// Checks that slabs are as large as their texels, cut at the edge of the visible part, stand on their level's base
// height and end below the next level.
void expectSlabs(const SlabTower& tower, const PyramidParts& parts) {
    ASSERT_FALSE(tower.slabs().empty());
    for (const Slab& slab : tower.slabs()) {
        const Box& domain = tower.domain(slab.part);
        const double side = std::ldexp(1.0, tower.drawnAs(slab.part, slab.level));
        const bool inside = slab.ground.x0 > domain.x0 && slab.ground.x1 < domain.x1;
        EXPECT_LE(slab.ground.width(), side + 1e-6);
        if (inside) {
            EXPECT_NEAR(slab.ground.width(), side, 1e-6) << slab.level;
        }
        EXPECT_EQ(slab.foot, slab.level * tower.apart());
        EXPECT_GE(slab.top, slab.foot);
        EXPECT_LE(slab.top, slab.foot + tower.apart());
        const PyramidSource& source = parts.parts[slab.part].source;
        if (source.overCells) continue;  // values that the ray fetched are checked below
        const relief::FloatImage& level = source.pyramid->level(tower.drawnAs(slab.part, slab.level));
        const auto index = [&](double at, int period) {
            return static_cast<int>((at - std::floor(at / period) * period) / side);
        };
        const Point middle = slab.ground.center();
        EXPECT_EQ(slab.value, level(index(middle.x, source.field->width()), index(middle.y, source.field->height())));
    }
    EXPECT_EQ(std::exp2(std::round(std::log2(tower.factor()))), tower.factor());
    EXPECT_LE(tower.factor(), 1);
}

TEST(SlabTower, withoutATraversalAllSlabsOfEachLevelCoverTheGround) {
    const auto snapshot = snapshotOf(walked());
    for (const relief::PyramidKind kind : {relief::PyramidKind::Mean, relief::PyramidKind::Min}) {
        for (const bool nearRay : {false, true}) {
            const PyramidParts parts = partsOf(*snapshot, kind, nearRay);
            const SlabTower tower(parts);
            expectSlabs(tower, parts);
            std::vector<double> covered(static_cast<std::size_t>(tower.top()) + 1);
            for (const Slab& slab : tower.slabs()) covered[static_cast<std::size_t>(slab.level)] += area(slab.ground);
            for (const double of : covered) EXPECT_NEAR(of, area(tower.domain(0)), 1e-6 * of);
        }
    }
}

// For a traversal of the maxima: level 0 is complete; above it there are the texels that the ray visited and those with
// the same parent.
TEST(SlabTower, aTraversalShowsVisitedTexelsAndTheirSiblings) {
    const auto snapshot = snapshotOf(walked());
    const auto& steps = snapshot->trace.steps;
    for (const bool nearRay : {false, true}) {
        const PyramidParts parts = partsOf(*snapshot, relief::PyramidKind::Max, nearRay);
        const SlabTower tower(parts);
        expectSlabs(tower, parts);
        double ground = 0;
        std::size_t above = 0;
        for (const Slab& slab : tower.slabs()) {
            if (slab.level == 0) ground += area(slab.ground);
            if (slab.level == 0) continue;
            ++above;
            const bool known = std::any_of(steps.begin(), steps.end(), [&](const relief::Step& step) {
                if (step.level != slab.level && step.level != slab.level + 1) return false;
                for (const Box& box :
                     wrapped(stepBox(snapshot->request->field, step), tower.domain(0), parts.parts[0].picture.wraps)) {
                    if (box.contains(slab.ground.center())) return true;
                }
                return false;
            });
            EXPECT_TRUE(known) << slab.level;
        }
        EXPECT_NEAR(ground, area(tower.domain(0)), 1e-6 * ground);
        EXPECT_GT(above, 3U);
        // Each texel on the ray exists, with its maximum.
        int found = 0;
        for (const relief::Step& step : steps) {
            const auto* const texel = step.as<relief::subject::Texel>();
            if (texel == nullptr || step.level < 1 || step.level > tower.top()) continue;
            for (const Box& box :
                 wrapped(stepBox(snapshot->request->field, step), tower.domain(0), parts.parts[0].picture.wraps)) {
                const auto at = std::find_if(tower.slabs().begin(), tower.slabs().end(), [&](const Slab& slab) {
                    return slab.level == step.level && slab.ground.contains(box.center());
                });
                ASSERT_NE(at, tower.slabs().end());
                const relief::FloatImage& maxima = snapshot->maxima->pyramid.level(step.level);
                EXPECT_EQ(at->value, maxima(static_cast<int>(texel->i), static_cast<int>(texel->j)));
                ++found;
            }
        }
        EXPECT_GT(found, 3);
    }
}

// The path is a connected line from the entry to the hit: on a level it follows the ray, between levels it is vertical.
// It passes above skipped slabs, and not above those into which it descends.
TEST(SlabTower, theWayIsConnectedAndPassesAboveWhatIsSkipped) {
    const auto snapshot = snapshotOf(walked());
    const auto& steps = snapshot->trace.steps;
    ASSERT_EQ(snapshot->trace.hit.outcome, relief::Outcome::Hit);
    const PyramidParts parts = partsOf(*snapshot, relief::PyramidKind::Max, true);
    ASSERT_FALSE(parts.parts[0].picture.wraps);
    const SlabTower tower(parts);
    const auto rayPath = tower.rayPath(0, steps.size() - 1);
    ASSERT_GT(rayPath.size(), 5U);
    int upright = 0;
    for (std::size_t k = 0; k < rayPath.size(); ++k) {
        if (k > 0) {
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rayPath[k].from[c], rayPath[k - 1].to[c], 1e-9) << k;
        }
        const double along = std::hypot(rayPath[k].to[0] - rayPath[k].from[0], rayPath[k].to[1] - rayPath[k].from[1]);
        if (std::abs(rayPath[k].to[2] - rayPath[k].from[2]) > tower.apart() / 2) {
            ++upright;
            EXPECT_NEAR(along, 0, 1e-9);
        } else {
            EXPECT_LE(rayPath[k].to[2], rayPath[k].from[2] + 1e-9) << "the ray goes down";
        }
    }
    EXPECT_GT(upright, 2);
    ASSERT_TRUE(tower.end(0));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR((*tower.end(0))[c], rayPath.back().to[c], 1e-6);
    int skipped = 0;
    for (const relief::Step& step : steps) {
        const auto* const texel = step.as<relief::subject::Texel>();
        if (texel == nullptr || step.level > tower.top()) continue;
        const double top = tower.heightOver(step.level, texel->maximum);
        const double ray = tower.heightOver(step.level, 1 - step.lambdaOut);
        if (step.decision == relief::Decision::Skip) {
            EXPECT_GE(ray, top);
        }
        if (step.decision == relief::Decision::Descend) {
            EXPECT_LE(ray, top + 1e-6);
        }
        skipped += step.decision == relief::Decision::Skip ? 1 : 0;
    }
    EXPECT_GT(skipped, 0);
    // Later steps are marked.
    const auto half = tower.rayPath(0, steps.size() / 2);
    EXPECT_FALSE(half.front().later);
    EXPECT_TRUE(half.back().later);
}

// A vertical line from above meets the uppermost slab at its position.
TEST(SlabTower, aLineFromAboveMeetsTheUppermostSlab) {
    const auto snapshot = snapshotOf(walked());
    const PyramidParts parts = partsOf(*snapshot, relief::PyramidKind::Max, true);
    const SlabTower tower(parts);
    for (const Slab& slab : tower.slabs()) {
        const Point middle = slab.ground.center();
        const auto met = tower.intersect(tower.at(0, middle, 1e4), tower.at(0, middle, -1e4));
        ASSERT_NE(met.slab, nullptr);
        EXPECT_GE(met.slab->level, slab.level);
        EXPECT_TRUE(met.slab->ground.contains(middle));
        EXPECT_NEAR(met.texel.x, middle.x, 1e-6);
        EXPECT_NEAR(met.texel.y, middle.y, 1e-6);
    }
    EXPECT_EQ(tower.intersect(tower.at(0, {-1e3, -1e3}, 1e4), tower.at(0, {-1e3, -1e3}, -1e4)).slab, nullptr);
}

// Slabs, frames and the lines of texels without slabs end where the ground does. Frames reach up to the level above the
// slabs.
TEST(SlabScene, everythingLiesOverTheGround) {
    const auto snapshot = snapshotOf(walked());
    const PyramidParts parts = partsOf(*snapshot, relief::PyramidKind::Max, false);
    SlabScene scene;
    scene.show(parts, Style());
    const SlabTower& tower = scene.tower();
    const Box& d = tower.domain(0);
    const double top = tower.foot(std::min(tower.top() + 1, tower.levels() - 1));
    const auto low = tower.at(0, {d.x0, d.y1}, tower.foot(0)), high = tower.at(0, {d.x1, d.y0}, top);
    constexpr double kFloat = 1e-3;
    int frames = 0, shown = 0;
    vtkActorCollection* const actors = scene.renderer()->GetActors();
    actors->InitTraversal();
    while (vtkActor* const actor = actors->GetNextActor()) {
        const double* const b = actor->GetBounds();
        if (b == nullptr || b[0] > b[1]) continue;
        EXPECT_TRUE(b[0] > low[0] - kFloat && b[1] < high[0] + kFloat) << b[0] << " " << b[1];
        EXPECT_TRUE(b[2] > low[1] - kFloat && b[3] < high[1] + kFloat) << b[2] << " " << b[3];
        const bool whole = b[1] - b[0] > d.width() - kFloat && b[3] - b[2] > d.height() - kFloat;
        frames += whole && std::abs(b[4] - low[2]) < kFloat && std::abs(b[5] - high[2]) < kFloat ? 1 : 0;
        ++shown;
    }
    EXPECT_EQ(frames, 1);
    EXPECT_GT(shown, 2);
}

// In a view that is wider than the tower, only the height limits its size.
TEST(SlabScene, itsSizeFollowsFromTheHeightOfAWideView) {
    const auto snapshot = snapshotOf(walked());
    const PyramidParts parts = partsOf(*snapshot, relief::PyramidKind::Max, false);
    SlabScene scene;
    scene.show(parts, Style());
    constexpr double kHigh = 500;
    const auto viewHeight = [&](double width) {
        scene.lookFromHome();
        scene.showAll(width, kHigh);
        return scene.camera.viewHeight();
    };
    EXPECT_NEAR(viewHeight(kHigh), viewHeight(20 * kHigh), 1e-9);
    EXPECT_LT(viewHeight(kHigh), viewHeight(kHigh / 2));
}

TEST(PyramidFigure, isTheSameAtAnyResolution) {
    if (QCoreApplication::instance() == nullptr) GTEST_SKIP() << "no display, no fonts";
    const auto figure = pyramidFigure(snapshotOf(walked()), 0, {}, {});
    constexpr int kWide = 480, kHigh = 300;
    const auto drawn = [&](int unit) {
        Style style;
        style.theme = Theme::Light;
        style.screenPixelsPerPoint = unit;
        QImage image(kWide * unit, kHigh * unit, QImage::Format_RGB32);
        image.fill(toColor(style.background()));
        QPainter painter(&image);
        figure->paint(painter, {0, 0, static_cast<double>(image.width()), static_cast<double>(image.height())}, style);
        painter.end();
        return image.scaled(kWide, kHigh, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    const QImage coarse = drawn(1), fine = drawn(3);
    double off = 0;
    for (int y = 0; y < kHigh; ++y) {
        for (int x = 0; x < kWide; ++x) off += std::abs(qGray(coarse.pixel(x, y)) - qGray(fine.pixel(x, y)));
    }
    EXPECT_LT(off / (kWide * kHigh), 10);
}

}  // namespace
}  // namespace reliefui
