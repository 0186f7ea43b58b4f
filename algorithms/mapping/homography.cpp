#include "mapping/homography.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "relief/errors.h"

namespace relief {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

bool isFinite(const glm::dvec2& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}
bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double cross2(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

[[noreturn]] void fail(MessageId id, std::vector<MessageValue> values = {}) {
    throw InputError("", Message(id, std::move(values)));
}

// An affine function of the pixel: x, y and constant part.
glm::dvec3 triangleArea(const glm::dvec2& a, const glm::dvec2& b) {
    return {a.y - b.y, b.x - a.x, cross2(a, b)};  // twice the area of (X, a, b)
}

// Four corners relative to their centroid, and the weight of each: twice the area of the triangle of the other three.
// Four points of a plane satisfy w0 p0 - w1 p1 + w2 p2 - w3 p3 = 0, as a square does with all weights 1; so the
// projective map of a square takes corner k to the homogeneous point w_k (p_k, 1).
struct Quad {
    glm::dvec2 centre{0.0, 0.0};
    std::array<glm::dvec2, 4> corner{};
    std::array<double, 4> weight{};  // all positive: multiplied by `sign`, divided by the largest
    double sign = 1.0;               // common sign of the original weights
};

// coordinates: "x, y" or "s, t", for the messages.
Quad checkedQuad(std::span<const glm::dvec2, 4> points, const char* coordinates) {
    Quad quad;
    double largest = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        if (!isFinite(points[k])) {
            fail(MessageId::MappingCornerNotFinite, {{"corner", k + 1}, {"coordinates", coordinates}});
        }
        largest = std::max({largest, std::abs(points[k].x), std::abs(points[k].y)});
        quad.centre += 0.25 * points[k];
    }
    double extent = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        quad.corner[k] = points[k] - quad.centre;
        extent = std::max({extent, std::abs(quad.corner[k].x), std::abs(quad.corner[k].y)});
    }
    // Upper bound on the error of twice an area if each coordinate is rounded once, with a safety margin.
    const double lost = 64.0 * kEpsilon * largest * extent;
    double heaviest = 0.0;
    int positive = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const glm::dvec2 a = points[(k + 1) % 4];
        const glm::dvec2 b = points[(k + 2) % 4];
        const glm::dvec2 c = points[(k + 3) % 4];
        const double area = cross2(b - a, c - a);
        if (!std::isfinite(area) || std::abs(area) <= lost) {
            fail(MessageId::MappingCornersOnLine, {{"first", (k + 1) % 4 + 1},
                                                   {"second", (k + 2) % 4 + 1},
                                                   {"third", (k + 3) % 4 + 1},
                                                   {"coordinates", coordinates}});
        }
        positive += area > 0.0 ? 1 : 0;
        quad.weight[k] = std::abs(area);
        heaviest = std::max(heaviest, quad.weight[k]);
    }
    if (positive != 0 && positive != 4) fail(MessageId::MappingNotConvex, {{"coordinates", coordinates}});
    quad.sign = positive == 4 ? 1.0 : -1.0;
    for (double& weight : quad.weight) weight /= heaviest;
    return quad;
}

// Assembles the map from its rows (A, B, C), (D, E, F), (G, H, I), given as affine functions of (x - centre.x, y -
// centre.y).
Homography assemble(const glm::dvec3& s, const glm::dvec3& t, const glm::dvec3& q, const glm::dvec2& centre) {
    const auto constant = [&centre](const glm::dvec3& row) { return row.z - (row.x * centre.x + row.y * centre.y); };
    Homography map{s.x, s.y, constant(s), t.x, t.y, constant(t), q.x, q.y, constant(q)};
    return map.normalised();
}

double signedUnit(double value) {
    return value < 0.0 ? -1.0 : 1.0;
}

Homography scaled(const Homography& m, double factor) {
    return {m.sx * factor, m.sy * factor, m.s1 * factor, m.tx * factor, m.ty * factor,
            m.t1 * factor, m.qx * factor, m.qy * factor, m.q1 * factor};
}

}  // namespace

double Homography::determinant() const {
    return sx * (ty * q1 - t1 * qy) - sy * (tx * q1 - t1 * qx) + s1 * (tx * qy - ty * qx);
}

Homography Homography::adjugate() const {
    return {ty * q1 - t1 * qy, s1 * qy - sy * q1, sy * t1 - s1 * ty, t1 * qx - tx * q1, sx * q1 - s1 * qx,
            s1 * tx - sx * t1, tx * qy - ty * qx, sy * qx - sx * qy, sx * ty - sy * tx};
}

Homography Homography::inverse() const {
    const double det = determinant();
    // The sum of the absolute values of the six products: the scale on which det, a difference of them, cancels.
    const double size = std::abs(sx) * (std::abs(ty * q1) + std::abs(t1 * qy)) +
                        std::abs(sy) * (std::abs(tx * q1) + std::abs(t1 * qx)) +
                        std::abs(s1) * (std::abs(tx * qy) + std::abs(ty * qx));
    if (!(std::abs(det) > 8.0 * kEpsilon * size)) fail(MessageId::MappingSingular);
    return scaled(adjugate(), signedUnit(det)).normalised();
}

Homography Homography::normalised() const {
    const double size = std::max({1024.0 * std::abs(qx), 1024.0 * std::abs(qy), std::abs(q1)});
    if (!(size > 0.0) || !std::isfinite(size)) fail(MessageId::MappingSingular);
    const int exponent = -std::ilogb(size);
    std::array<double, 9> c = coefficients<double>();
    for (double& value : c) {
        value = std::scalbn(value, exponent);
        if (!std::isfinite(value)) fail(MessageId::MappingSingular);
    }
    return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]};
}

glm::dvec3 PinholeCamera::projectDirection(const glm::dvec3& direction) const {
    const double depth = glm::dot(forward, direction);
    return {focal.x * glm::dot(right, direction) + principal.x * depth,
            principal.y * depth - focal.y * glm::dot(up, direction), depth};
}

glm::dvec3 PinholeCamera::rayThrough(double x, double y) const {
    return forward + ((x - principal.x) / focal.x) * right - ((y - principal.y) / focal.y) * up;
}

glm::dvec3 TexturedPlane::frontNormal() const {
    return glm::cross(perT, perS);
}

// With the weights of the screen's corners (w) and the texture's (v), the map takes w_k (p_k, 1) to v_k (r_k, 1) up to
// one common factor. Three of the four corners determine it, and the relation of the weights gives the fourth: in
// barycentric coordinates lambda of those three, (s q, t q, q)(X) = sum over k of lambda_k(X) (v_k / w_k) (r_k, 1). The
// corner with the greatest weight is left out, because the triangle of the other three is the largest.
Homography fromCorners(std::span<const glm::dvec2, 4> screen, std::span<const glm::dvec2, 4> texture) {
    const Quad from = checkedQuad(screen, "x, y");
    const Quad to = checkedQuad(texture, "s, t");
    const auto heaviest = std::max_element(from.weight.begin(), from.weight.end());
    const auto leftOut = static_cast<std::size_t>(heaviest - from.weight.begin());
    glm::dvec3 s{0.0};
    glm::dvec3 t{0.0};
    glm::dvec3 q{0.0};
    for (std::size_t step = 1; step < 4; ++step) {
        const std::size_t k = (leftOut + step) % 4;
        // The other two of the three corners, in the order that makes the area at corner k positive.
        const std::size_t a = (leftOut + step % 3 + 1) % 4;
        const std::size_t b = (leftOut + (step + 1) % 3 + 1) % 4;
        const glm::dvec3 lambda = from.sign * triangleArea(from.corner[a], from.corner[b]);
        const glm::dvec3 part = (to.weight[k] / from.weight[k]) * lambda;
        s += texture[k].x * part;
        t += texture[k].y * part;
        q += part;
    }
    return assemble(s, t, q, from.centre);
}

// The point of the plane at (s, t) is, in camera coordinates, K (s, t, 1) with the columns of K below; it lies on the
// ray r(x, y) = ((x - px) / fx, -(y - py) / fy, 1) at depth Z: K (s, t, 1) = Z r, so adj(K) r = (det K / Z) (s, t, 1).
Homography fromCameraAndPlane(const PinholeCamera& camera, const TexturedPlane& plane) {
    const double volume = glm::dot(glm::cross(camera.right, camera.up), camera.forward);
    const bool cameraGood = isFinite(camera.eye) && isFinite(camera.focal) && isFinite(camera.principal) &&
                            camera.focal.x > 0.0 && camera.focal.y > 0.0 && std::isfinite(volume) &&
                            std::abs(volume) > 1e-6;
    if (!cameraGood) fail(MessageId::MappingCameraInvalid);
    const double lengths = glm::length(plane.perS) * glm::length(plane.perT);
    const double area = glm::length(plane.frontNormal());
    const bool planeGood = isFinite(plane.origin) && std::isfinite(lengths) && area > 1e-12 * lengths;
    if (!planeGood) fail(MessageId::MappingPlaneInvalid);

    const auto inCamera = [&camera](const glm::dvec3& v) {
        return glm::dvec3(glm::dot(camera.right, v), glm::dot(camera.up, v), glm::dot(camera.forward, v));
    };
    const glm::dvec3 columnS = inCamera(plane.perS);
    const glm::dvec3 columnT = inCamera(plane.perT);
    const glm::dvec3 columnO = inCamera(plane.origin - camera.eye);
    const glm::dvec3 rowQ = glm::cross(columnS, columnT);
    const double det = glm::dot(columnO, rowQ);
    // Compares the eye's distance from the plane with the rounding error of the two positions.
    const double distance = std::abs(det) / area;
    const double positions = glm::length(plane.origin) + glm::length(camera.eye) + glm::length(columnO);
    if (!(distance > 64.0 * kEpsilon * positions)) fail(MessageId::MappingEdgeOn);

    const glm::dvec3 perPixel = signedUnit(det) * glm::dvec3(1.0 / camera.focal.x, -1.0 / camera.focal.y, 1.0);
    return assemble(glm::cross(columnT, columnO) * perPixel, glm::cross(columnO, columnS) * perPixel, rowQ * perPixel,
                    camera.principal);
}

}  // namespace relief
