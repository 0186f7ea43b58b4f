// The 3-D trace as vectors: cells are painted from behind, places lie where VTK puts them, and what the relief hides is
// not drawn.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <QFile>
#include <QTemporaryDir>

#include "panes/figure.h"
#include "panes/trace/trace_eye.h"
#include "panes/trace/trace_figure.h"
#include "panes/trace/trace_mesh.h"
#include "panes/trace/trace_vectors.h"
#include "panes/trace/visible_region.h"
#include "window_fixture.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

constexpr Box kPage{0, 0, 900, 600};

std::shared_ptr<const Snapshot> snapshotOf(relief::Surface surface, const char* recipe = "bricks") {
    relief::Scenario scenario = smallScenario();
    scenario.surface = surface;
    scenario.pictures.recipe = recipe;
    relief::Work work;
    return SnapshotMaker().make({scenario}, work);
}

Turntable cameraFrom(const TraceScene& scene, double azimuth, double elevation) {
    Turntable camera;
    camera.lookAlong(std::cos(azimuth), std::sin(azimuth));
    camera.turn(0, (elevation - Turntable::kElevation) / 3 * kPage.height(), kPage.height());
    scene.fit(camera, kPage.width() / kPage.height());
    return camera;
}

// Returns true if the point lies in the polygon (even-odd rule).
bool isInside(const std::vector<Point>& polygon, Point at) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point& a = polygon[k];
        const Point& b = polygon[(k + 1) % polygon.size()];
        if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

// Distance from the eye at which a line through the page's point meets the face; std::nullopt if it passes by.
std::optional<double> depthAt(const TraceMesh::Face& face, const TraceEye& eye, Point at) {
    // A cut side of the block is a plane with many corners; its last two are those of its bottom.
    const std::size_t corners = face.corners.size();
    const bool side = corners > 5;
    if (side) {
        std::vector<Point> outline;
        for (const Place& corner : face.corners) outline.push_back(eye.project(corner));
        if (!isInside(outline, at)) return std::nullopt;
    }
    for (std::size_t k = side ? corners - 1 : 2; k < corners; ++k) {
        const Place* const p[3] = {&face.corners[0], &face.corners[k - 1], &face.corners[k]};
        Point q[3];
        double inverse[3];  // 1 / depth is linear on the page
        for (std::size_t c = 0; c < 3; ++c) {
            q[c] = eye.project(*p[c]);
            inverse[c] = 1 / eye.depth(*p[c]);
        }
        const auto cross = [](Point a, Point b, Point c) {
            return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        };
        const double area = cross(q[0], q[1], q[2]);
        if (std::abs(area) < 1e-9) continue;
        const double w[3] = {cross(at, q[1], q[2]) / area, cross(q[0], at, q[2]) / area, cross(q[0], q[1], at) / area};
        if (!side && (w[0] < 0 || w[1] < 0 || w[2] < 0)) continue;
        return 1 / (w[0] * inverse[0] + w[1] * inverse[1] + w[2] * inverse[2]);
    }
    return std::nullopt;
}

class TraceMeshLaw : public ::testing::TestWithParam<relief::Surface> {};

// From many sides, also from below and from straight above the patch.
TEST_P(TraceMeshLaw, aNearerCellIsPaintedLater) {
    const auto snapshot = snapshotOf(GetParam());
    const TraceScene scene(*snapshot, 2);
    const TraceMesh mesh(scene);
    EXPECT_GT(mesh.columns() * mesh.rows(), 100);
    EXPECT_LE(mesh.columns() * mesh.rows(), kMostMeshCells);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(kPage.x0, kPage.x1), y(kPage.y0, kPage.y1);
    int compared = 0;
    for (const double elevation : {0.15, 0.55, 1.5}) {
        for (const double azimuth : {0.0, 0.7, 2.0, 3.5, 5.1}) {
            const TraceEye eye(cameraFrom(scene, azimuth, elevation), kPage);
            const auto faces = mesh.faces(eye, Theme::Light);
            for (int n = 0; n < 30; ++n) {
                const Point at{x(random), y(random)};
                double before = 1e300;
                for (const TraceMesh::Face& face : faces) {
                    const auto depth = depthAt(face, eye, at);
                    if (!depth) continue;
                    compared += before < 1e300 ? 1 : 0;
                    // Faces may touch; the bilinear cells are drawn flat.
                    ASSERT_LE(*depth, before + 0.02 * scene.diagonal()) << elevation << " " << azimuth;
                    before = *depth;
                }
            }
        }
    }
    EXPECT_GT(compared, 100) << "cells that hide each other";
}

// A face of the mesh that is seen lies on no visible line behind it: places on top are visible, those below are hidden.
TEST_P(TraceMeshLaw, theReliefHidesWhatLiesBelowIt) {
    const auto snapshot = snapshotOf(GetParam());
    const TraceScene scene(*snapshot, 1);
    const TraceMesh mesh(scene);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> s(scene.patch.x0, scene.patch.x1);
    std::uniform_real_distribution<double> t(scene.patch.y0, scene.patch.y1);
    std::uniform_real_distribution<double> z(scene.bottom, scene.scale * 1.1);
    int hidden = 0, seen = 0;
    for (const double azimuth : {0.4, 2.0, 3.5, 5.1}) {
        const TraceEye eye(cameraFrom(scene, azimuth, 0.6), kPage);
        const auto faces = mesh.faces(eye, Theme::Light);
        for (int n = 0; n < 300; ++n) {
            const Place place{s(random), -t(random), z(random)};
            const double clearance = mesh.clearance(place, eye);
            double nearest = 1e300;
            for (const TraceMesh::Face& face : faces) {
                nearest = std::min(nearest, depthAt(face, eye, eye.project(place)).value_or(1e300));
            }
            // What the painted faces hide, apart from places close to them.
            const double behind = eye.depth(place) - nearest;
            if (std::abs(behind) < 0.03 * scene.diagonal() || std::abs(clearance) < 0.5 * mesh.tolerance()) continue;
            EXPECT_EQ(clearance<0, behind> 0) << place[0] << " " << place[1] << " " << place[2] << ": " << clearance;
            ++(clearance < 0 ? hidden : seen);
        }
    }
    EXPECT_GT(hidden, 20);
    EXPECT_GT(seen, 20);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, TraceMeshLaw, ::testing::Values(relief::Surface::Bilinear, relief::Surface::Columns),
                         [](const auto& each) { return std::string(relief::surfaceName(each.param)); });

// The projection is VTK's, so hit, ray and relief lie where the pane shows them.
TEST(TraceEye, isTheCameraOfThePane) {
    const auto snapshot = snapshotOf(relief::Surface::Bilinear);
    ASSERT_EQ(snapshot->trace.hit.outcome, relief::Outcome::Hit);
    const TraceScene scene(*snapshot, 1.5);
    const Turntable camera = traceCamera(scene, kPage.width(), kPage.height());
    const TraceEye eye(camera, kPage);
    const vtkNew<vtkCamera> vtk;
    camera.apply(vtk);
    const double aspect = kPage.width() / kPage.height();
    vtkMatrix4x4* const matrix = vtk->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
    for (const double lambda : {-0.2, 0.0, 0.3, scene.end}) {
        const Place at = scene.onRay(lambda);
        const double world[4] = {at[0], at[1], at[2], 1};
        double view[4];
        matrix->MultiplyPoint(world, view);
        const Point vtkAt{(view[0] / view[3] + 1) / 2 * kPage.width(), (1 - view[1] / view[3]) / 2 * kPage.height()};
        const Point own = eye.project(at);
        EXPECT_NEAR(own.x, vtkAt.x, 1e-6);
        EXPECT_NEAR(own.y, vtkAt.y, 1e-6);
        EXPECT_TRUE(kPage.contains(own) || lambda < 0);
    }
}

TEST(VisibleRegion, isBoundedByTheZeros) {
    constexpr double kRadius = 0.3;
    const auto polygons = positiveRegion(40, 40, [](double u, double v) {
        const double r = std::hypot(u - 0.5, v - 0.5);
        return r < 0.1 ? r - 0.1 : kRadius - r;  // a ring
    });
    ASSERT_EQ(polygons.size(), 2U);
    double area = 0;
    for (const auto& polygon : polygons) {
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Point& a = polygon[k];
            const Point& b = polygon[(k + 1) % polygon.size()];
            area += (a.x * b.y - b.x * a.y) / 2;
        }
    }
    EXPECT_NEAR(std::abs(area), std::numbers::pi * (kRadius * kRadius - 0.01), 0.01) << "the hole is subtracted";
    EXPECT_TRUE(positiveRegion(8, 8, [](double, double) { return -1; }).empty());
    const auto all = positiveRegion(8, 8, [](double, double) { return 1; });
    ASSERT_EQ(all.size(), 1U);
    for (const Point& p : all[0]) EXPECT_TRUE(p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1);
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// The files hold vectors and no pixels, for each kind of body that a step draws, and stay small.
TEST(TraceVectors, areSmallFilesWithoutPixels) {
    struct Shown {
        relief::MethodChoice method;
        relief::PixelChoice pixel;
        int step;
    };
    const std::vector<Shown> all{{{"max-pyramid", {}}, {60, 70}, 3},
                                 {{"distance-conservative", {}}, {60, 70}, 3},
                                 {{"cone", {{"layout", "texel"}}}, {60, 70}, 3},
                                 {{"layers", {{"layers", "8"}}}, {60, 70}, 2}};
    const QTemporaryDir folder;
    relief::Work work;
    for (const Shown& shown : all) {
        SCOPED_TRACE(shown.method.name);
        relief::Scenario scenario = smallScenario();
        scenario.method = shown.method;
        scenario.pixel = shown.pixel;
        scenario.step = shown.step;
        const auto snapshot = SnapshotMaker().make({scenario}, work);
        const auto figure = traceFigure(snapshot, shown.step, {});
        for (const char* const ending : {"svg", "pdf", "tikz"}) {
            const QString path = folder.filePath(QStringLiteral("trace.") + QLatin1String(ending));
            writeFigure(*figure, {}, path.toStdString(), work);
            const QByteArray bytes = contents(path);
            EXPECT_LT(bytes.size(), 4000000) << ending;
            EXPECT_GT(bytes.size(), 20000) << ending;
            for (const char* const pixels : {"<image", "/Subtype /Image", "includegraphics"}) {
                EXPECT_FALSE(bytes.contains(pixels)) << ending << " " << pixels;
            }
            EXPECT_FALSE(bytes.contains("nan")) << ending;
            if (QLatin1String(ending) == QLatin1String("svg")) {
                EXPECT_GT(bytes.count("<path"), 1000) << "cells of the relief";
                EXPECT_TRUE(bytes.contains("texels around the ray"));
            }
        }
    }
}

}  // namespace

}  // namespace reliefui
