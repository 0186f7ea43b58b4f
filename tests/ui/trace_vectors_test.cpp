// The 3-D trace as vectors: cells are painted from behind, places lie where VTK puts them, and what the relief hides is
// not drawn.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <QBuffer>
#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QSvgGenerator>
#include <QTemporaryDir>

#include "painting/painter.h"
#include "panes/figure.h"
#include "panes/step_colors.h"
#include "panes/trace/trace3d_marks.h"
#include "panes/trace/trace3d_picture.h"
#include "panes/trace/trace_eye.h"
#include "panes/trace/trace_figure.h"
#include "panes/trace/trace_mesh.h"
#include "panes/trace/trace_vectors.h"
#include "panes/trace/tubes.h"
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

// Whatever its direction, the ray runs from left to right in the first view.
TEST(TraceEye, seesTheRayFromItsSide) {
    for (const double azimuth : {0.0, 50.0}) {
        relief::Scenario scenario = smallScenario();
        scenario.camera.elevation = 35;
        scenario.camera.azimuth = azimuth;
        relief::Work work;
        const auto snapshot = SnapshotMaker().make({scenario}, work);
        const TraceScene scene(*snapshot, 1);
        const Place right = traceCamera(scene, kPage.width(), kPage.height()).right();
        const Place from = scene.onRay(0), to = scene.onRay(1);
        const double run = std::hypot(to[0] - from[0], to[1] - from[1]);
        ASSERT_GT(run, 0);
        EXPECT_GT(right[0] * (to[0] - from[0]) + right[1] * (to[1] - from[1]), 0.8 * run) << azimuth;
    }
}

// Walls that face the same way are lit alike. Each has the colour of the column at its left or above it.
TEST(TraceMesh, wallsHaveTheColourOfTheirLeftColumn) {
    const auto snapshot = snapshotOf(relief::Surface::Columns, "city");
    ASSERT_EQ(snapshot->assets.color, nullptr);
    const TraceScene scene(*snapshot, 1);
    const TraceMesh mesh(scene);
    ASSERT_EQ(mesh.stride(), 1);
    for (const double azimuth : {0.4, 2.6}) {
        double low = 1e9, high = 0;
        int walls = 0;
        for (const TraceMesh::Face& face : mesh.faces(TraceEye(cameraFrom(scene, azimuth, 0.6), kPage), Theme::Light)) {
            const std::vector<Place>& c = face.corners;
            const bool across = std::all_of(c.begin(), c.end(), [&](const Place& p) { return p[0] == c[0][0]; });
            if (!across || c.size() != 4 || c[0][0] == scene.patch.x0 || c[0][0] == scene.patch.x1) continue;
            const double s = c[0][0] - 0.5, t = -(c[0][1] + c[1][1]) / 2;
            unsigned char own[3];
            scene.color(s, t, scene.heightAt(s, t) / scene.scale, own);
            low = std::min(low, (face.color.r - 0.5) / own[0]);
            high = std::max(high, (face.color.r + 0.5) / own[0]);
            ++walls;
        }
        EXPECT_GT(walls, 20);
        EXPECT_LT(high - low, 0.06) << azimuth;
    }
}

// The edges of a box that lies within the patch join its corners, three at each.
TEST(TraceMarks, aBoxHasTwelveEdges) {
    const auto snapshot = snapshotOf(relief::Surface::Bilinear);
    const TraceScene scene(*snapshot, 1);
    const Style style;
    const TraceMarks marks(scene, scene.field(), style);
    const Point m = scene.patch.center();
    const TraceMarks::Prism prism{{m.x - 1, m.y - 1, m.x + 1, m.y + 1}, 0.1, 0.2, {}};
    std::map<Place, int> ends;
    for (const auto& edge : marks.edges(prism)) {
        int differences = 0;
        for (std::size_t c = 0; c < 3; ++c) differences += edge[0][c] != edge[1][c] ? 1 : 0;
        EXPECT_EQ(differences, 1) << "parallel to an axis";
        for (const Place& end : edge) ++ends[end];
    }
    EXPECT_EQ(ends.size(), 8U);
    for (const auto& [corner, edges] : ends) EXPECT_EQ(edges, 3);
}

// A tube without a length has no direction, and is not drawn.
TEST(Tubes, withoutALengthAreNothing) {
    Tubes tubes;
    tubes.add({1, 2, 3}, {1, 2, 3}, 0.5, {});
    tubes.arrow({1, 2, 3}, {1, 2, 3}, 0.5, {});
    EXPECT_EQ(tubes.take()->GetNumberOfPoints(), 0);
    tubes.add({1, 2, 3}, {1, 2, 4}, 0.5, {});
    EXPECT_GT(tubes.take()->GetNumberOfPoints(), 0);
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

// The rectangle of the slab's top, which nothing hides from above.
TEST(TraceVectors, theTopOfTheSlabIsFramed) {
    if (QCoreApplication::instance() == nullptr) GTEST_SKIP() << "no display, no fonts";
    const auto snapshot = snapshotOf(relief::Surface::Bilinear);
    const TraceScene scene(*snapshot, 1);
    const Turntable camera = cameraFrom(scene, 2.0, 1.2);
    Style style;
    style.theme = Theme::Light;
    style.screenPixelsPerPoint = 4;
    QImage image(900, 600, QImage::Format_RGB32);
    QPainter painter(&image);
    paintTraceVectors(painter, kPage, style, *snapshot, 0, {1, StepColors::Decision, camera});
    painter.end();
    const PixelTrace& trace = snapshot->trace;
    const StepPaint paint{StepColors::Decision, snapshot->maxima->top() + 1};
    const Drawing legend = traceLegend(trace.steps, trace.ray, trace.hit, trace.exact, paint,
                                       kPage.width() / style.pixelsPerPoint() - 2 * kTraceLegendMargin, style.language);
    const TraceEye eye(camera, {0, 0, kPage.x1, kPage.y1 - traceLegendHeight(legend, kPage, style)});
    const Box& p = scene.patch;
    const std::array<Point, 5> corners{{{p.x0, p.y0}, {p.x1, p.y0}, {p.x1, p.y1}, {p.x0, p.y1}, {p.x0, p.y0}}};
    int framed = 0;
    for (std::size_t side = 0; side < 4; ++side) {
        for (const double part : {0.3, 0.45, 0.6, 0.75}) {
            const Point& a = corners[side];
            const Point& b = corners[side + 1];
            const Point at = eye.project({a.x + part * (b.x - a.x), -a.y - part * (b.y - a.y), scene.scale});
            const QPoint pixel(static_cast<int>(at.x), static_cast<int>(at.y));
            ASSERT_TRUE(image.valid(pixel));
            framed += image.pixelColor(pixel) == toColor(style.color(Role::Label)) ? 1 : 0;
        }
    }
    // Words may cover some of it.
    EXPECT_GE(framed, 14);
}

// The translucent surface of a step's sphere is as wide and as high as the sphere.
TEST(TraceVectors, aSphereIsFilledAsARoundBody) {
    if (QCoreApplication::instance() == nullptr) GTEST_SKIP() << "no display, no fonts";
    relief::Scenario scenario = smallScenario();
    scenario.method = {"distance", {}};
    scenario.pixel = relief::PixelChoice{60, 70};
    relief::Work work;
    const auto snapshot = SnapshotMaker().make({scenario}, work);
    const PixelTrace& trace = snapshot->trace;
    const auto step = std::find_if(trace.steps.begin(), trace.steps.end(), [](const relief::Step& each) {
        return stepBody(each).kind == StepBody::Kind::Sphere;
    });
    ASSERT_NE(step, trace.steps.end());
    const StepBody body = stepBody(*step);
    const TraceScene scene(*snapshot, 1);
    const Turntable camera = cameraFrom(scene, 2.0, 0.6);
    const Style style;
    QBuffer file;
    QSvgGenerator svg;
    svg.setOutputDevice(&file);
    svg.setResolution(72);
    QPainter painter(&svg);
    const auto chosen = static_cast<int>(step - trace.steps.begin());
    paintTraceVectors(painter, kPage, style, *snapshot, chosen, {1, StepColors::Decision, camera});
    painter.end();
    const QString color = toColor(style.color(bodyRole(*step, trace.ray, trace.exact))).name();
    const QRegularExpression paths(
        QStringLiteral("<g fill=\"%1\" fill-opacity=\"0.30[^>]*>\\s*<path[^>]* d=\"([^\"]*)").arg(color));
    const QRegularExpression pairs(QStringLiteral("([-0-9.]+),([-0-9.]+)"));
    QPolygonF points;
    for (auto path = paths.globalMatch(QString::fromUtf8(file.data())); path.hasNext();) {
        for (auto at = pairs.globalMatch(path.next().captured(1)); at.hasNext();) {
            const auto pair = at.next();
            points << QPointF(pair.captured(1).toDouble(), pair.captured(2).toDouble());
        }
    }
    const double diameter = 2 * body.radius * TraceEye(camera, kPage).unit(scene.onRay(body.lambda));
    const QRectF seen = points.boundingRect();
    for (const double side : {seen.width(), seen.height()}) {
        EXPECT_GT(side, 0.7 * diameter);
        EXPECT_LT(side, 1.2 * diameter);
    }
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
