#include "filtering/tangent_footprint.h"

#include <algorithm>
#include <cmath>

namespace relief {

namespace {

// Smallest 1 + r . g: at more grazing angles the projection of the surface is not reliably one-to-one. Far above
// rounding.
constexpr double kLeastFacing = 1e-3;
// Factor by which the box around the footprint exceeds its ellipse, because of the surface's deviation from the plane.
constexpr double kBeyondEllipse = 1.25;
// Intervals of the back-traced segment, each twice as long as the last, before the proof gives up.
constexpr int kStretches = 10;

struct Box {
    glm::dvec2 low, high;

    Box moved(glm::dvec2 from, glm::dvec2 to) const {
        return {low + glm::dvec2(std::min(from.x, to.x), std::min(from.y, to.y)),
                high + glm::dvec2(std::max(from.x, to.x), std::max(from.y, to.y))};
    }
};

class Bounder {
  public:
    Bounder(const TangentTools& tools, const ViewRay& ray) : tools_(tools), run_(ray.a, ray.b) {}

    SurfaceBounds of(const Box& box) const {
        return surfaceBounds(tools_.bounds, tools_.field, box.low.x, box.low.y, box.high.x, box.high.y);
    }
    // The smallest 1 + r . g.
    double facing(const SurfaceBounds& b) const {
        return 1 + run_.x * (run_.x > 0 ? b.lowS : b.highS) + run_.y * (run_.y > 0 ? b.lowT : b.highT);
    }

    // Returns true if no point of the surface over the box is hidden. A back-traced ray rises above the surface as long
    // as all of the surface on its way faces the viewer; farther on it must be above all heights.
    bool clear(const Box& box, const SurfaceBounds& under) const {
        const auto& levels = tools_.bounds.surface;
        const double highest = levels.back()(0, 0).high;
        double top = highest;
        for (int n = 0; n < 2; ++n) {
            top = of(box.moved({0, 0}, -std::max(0.0, top - under.low) * run_)).high;
            if (top <= under.low) return true;
        }
        const double room = top - under.low;
        const double length = std::max(std::abs(run_.x), std::abs(run_.y));
        const glm::dvec2 size = box.high - box.low;
        double done = 0;
        double next = std::min(room, std::max(size.x, size.y) / std::max(length, 1e-9));
        bool facingAll = true;
        for (int n = 0; n < kStretches; ++n) {
            const SurfaceBounds way = of(box.moved(-done * run_, -next * run_));
            facingAll = facingAll && facing(way) > kLeastFacing;
            if (!facingAll && way.high > under.low + done) return false;
            if (next >= room) return true;
            done = next;
            next = n + 2 == kStretches ? room : std::min(room, 2 * next);
        }
        return false;
    }

  private:
    const TangentTools& tools_;
    glm::dvec2 run_;
};

// Half extents of a box that contains what the filter samples with this Jacobian: its widened ellipse, on any level.
glm::dvec2 halfExtents(const TangentTools& tools, const Jacobian& j) {
    const EllipticalSettings& settings = tools.settings;
    const double uu = j.ux * j.ux + j.uy * j.uy, vv = j.vx * j.vx + j.vy * j.vy;
    const double major = std::sqrt(uu + vv);
    const double widest = settings.exhaustive ? 0 : major / settings.anisotropy;
    const double least = std::min(tools.perColor.x, tools.perColor.y);
    const double most = std::max(tools.perColor.x, tools.perColor.y);
    const double side = std::sqrt(std::max(uu, vv));
    const double minor = std::max(side > 0 ? std::abs(j.determinant()) / side : 0, widest);
    const double texel = settings.exhaustive ? most : most * std::max(1.0, minor / least / settings.floor);
    const double margin = texel * (settings.radius * std::max(0.5 / settings.sigma, settings.smallestMinor()) + 1);
    const double r = kBeyondEllipse * settings.radius;
    return {r * (std::sqrt(uu) + widest) + margin, r * (std::sqrt(vv) + widest) + margin};
}

// |J^-1 r|, in pixels per unit of height, including the size of texels.
double runPixels(const TangentTools& tools, const Jacobian& j, const ViewRay& ray) {
    const double texel = 0.5 * std::min(tools.perColor.x, tools.perColor.y) / tools.settings.sigma;
    const double uu = j.ux * j.ux + j.uy * j.uy + texel * texel, vv = j.vx * j.vx + j.vy * j.vy + texel * texel;
    const double uv = j.ux * j.vx + j.uy * j.vy;
    const double square = ray.a * ray.a * vv - 2 * ray.a * ray.b * uv + ray.b * ray.b * uu;
    return std::sqrt(std::max(0.0, square) / (uu * vv - uv * uv));
}

}  // namespace

TangentFootprint tangentFootprint(const TangentTools& tools, const Jacobian& j, glm::dvec2 hit, const ViewRay& ray,
                                  double lambda) {
    TangentFootprint out;
    const HeightField& field = tools.field;
    if (field.surface() != Surface::Bilinear || tools.bounds.surface.empty() || !(lambda >= 0)) return out;
    const double largest = 4.0 * std::max(field.width(), field.height());
    const double size = std::abs(j.ux) + std::abs(j.uy) + std::abs(j.vx) + std::abs(j.vy);
    if (!(size < largest) || !std::isfinite(hit.x + hit.y)) return out;
    const Bounder bounder(tools, ray);
    const auto boxOf = [&](const Jacobian& of) {
        const glm::dvec2 half = halfExtents(tools, of);
        return Box{hit - half, hit + half};
    };
    // Starts with the plane's box, then uses the slopes found under it; these must be valid for the box of their own
    // Jacobian.
    Box box = boxOf(j);
    SurfaceBounds under = bounder.of(box);
    for (int n = 0; n < 2; ++n) {
        const glm::dvec2 slope{0.5 * (double{under.lowS} + under.highS), 0.5 * (double{under.lowT} + under.highT)};
        const double facing = 1 + ray.a * slope.x + ray.b * slope.y;
        if (!(bounder.facing(under) > kLeastFacing)) return out;
        const double alongX = (slope.x * j.ux + slope.y * j.vx) / facing;
        const double alongY = (slope.x * j.uy + slope.y * j.vy) / facing;
        out.jacobian = {j.ux - ray.a * alongX, j.vx - ray.b * alongX, j.uy - ray.a * alongY, j.vy - ray.b * alongY};
        if (n == 1) {
            // The last box must contain that of this Jacobian.
            const glm::dvec2 half = halfExtents(tools, out.jacobian), has = 0.5 * (box.high - box.low);
            if (half.x > has.x * kBeyondEllipse || half.y > has.y * kBeyondEllipse) return out;
            const double off =
                0.5 * (has.x * (double{under.highS} - under.lowS) + has.y * (double{under.highT} - under.lowT));
            out.planar = off * runPixels(tools, j, ray) <= kPlanarSpread;
            break;
        }
        box = boxOf(out.jacobian);
        under = bounder.of(box);
    }
    const bool outside = field.address() == Address::Border &&
                         (box.low.x < 0 || box.low.y < 0 || box.high.x > field.width() || box.high.y > field.height());
    out.planar = out.planar && !outside;
    out.clear = bounder.clear(box, under);
    return out;
}

}  // namespace relief
