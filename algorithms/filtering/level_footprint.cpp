#include "filtering/level_footprint.h"

#include <algorithm>
#include <cmath>

namespace relief {

namespace {

// Texels. There is nothing to average below a major semi-axis of kBilinearMajor (with the covariance of texels) or of
// kCoveringRadius over the radius (without it).
constexpr double kBilinearMajor = 0.4;
constexpr double kCoveringRadius = 0.7072;
// Variance of a box of one texel, and of bilinear reconstruction taken as the texel's own, in texels^2.
constexpr double kBoxVariance = 1.0 / 12;
constexpr double kReconstructionVariance = 0.25;

// Singular values and directions: J = sum sigma_k u_k v_k^T, u in texels, v in pixels. The sign of v2 is chosen so that
// both sigmas are positive.
struct Axes {
    double major, minor;
    glm::dvec2 majorTexel, majorPixel;
    double handed;
};

Axes axesOf(const Jacobian& j) {
    const SemiAxes<double> semi = ellipseOf(j).semiAxes();
    Axes axes{semi.major, semi.minor, {semi.majorU, semi.majorV}, {1, 0}, j.determinant() < 0 ? -1.0 : 1.0};
    const glm::dvec2 along{j.ux * semi.majorU + j.vx * semi.majorV, j.uy * semi.majorU + j.vy * semi.majorV};
    const double length = std::hypot(along.x, along.y);
    if (length > 0) axes.majorPixel = along / length;
    return axes;
}

// The Jacobian with these directions and other semi-axes.
Jacobian withAxes(const Axes& axes, double major, double minor) {
    const glm::dvec2 u = axes.majorTexel;
    const glm::dvec2 v = axes.majorPixel;
    const double m = minor * axes.handed;
    return {major * u.x * v.x + m * u.y * v.y, major * u.y * v.x - m * u.x * v.y, major * u.x * v.y - m * u.y * v.x,
            major * u.y * v.y + m * u.x * v.x};
}

int chosenLevel(double minor, const EllipticalSettings& settings, int top) {
    if (settings.exhaustive || !(minor > settings.floor)) return 0;
    return static_cast<int>(std::min<double>(top, std::floor(std::log2(minor / settings.floor))));
}

// A semi-axis on level l in texels of the level, including the covariance of texels.
double onLevel(double axis, int l, const EllipticalSettings& settings) {
    const double scaled = std::ldexp(axis, -l);
    if (!settings.texelSize) return scaled;
    return std::sqrt(std::max(0.0, scaled * scaled + texelVariance(l, settings)));
}

}  // namespace

double largestMajor(int width, int height) {
    return 4.0 * std::max(width, height);
}

double bilinearMajor(const EllipticalSettings& settings) {
    return settings.texelSize ? kBilinearMajor : kCoveringRadius / settings.radius;
}

double texelVariance(int l, const EllipticalSettings& settings) {
    if (!settings.texelSize) return 0;
    const double texels = std::ldexp(kReconstructionVariance, -2 * l) - kBoxVariance;
    return texels / (settings.sigma * settings.sigma);
}

LevelFootprint levelFootprint(const Jacobian& j, glm::dvec2 centre, const EllipticalSettings& settings,
                              const ColorLevels& levels, Address address) {
    LevelFootprint out;
    out.radius = settings.radius;
    out.seen = j;
    const Axes axes = axesOf(j);
    out.major = axes.major;
    out.minor = axes.minor;
    const double largest = largestMajor(levels.width(), levels.height());
    const bool finite = std::isfinite(axes.major) && std::isfinite(centre.x) && std::isfinite(centre.y);
    const double major = finite ? std::min(axes.major, largest) : largest;
    const double seen = std::isfinite(axes.minor) ? std::min(axes.minor, major) : major;
    // The bound on the ratio of axes limits the number of texels at the cost of width. It applies to the pyramid only.
    const double minor = settings.exhaustive ? seen : std::max(seen, major / settings.anisotropy);
    out.level = finite ? chosenLevel(minor, settings, levels.top()) : levels.top();
    const LevelAxis across = levels.across(out.level, address);
    const LevelAxis down = levels.down(out.level, address);
    if (out.level == levels.top()) {
        out.kind = FootprintKind::Top;
        return out;
    }
    out.centre = {across.reduced(std::ldexp(centre.x, -out.level)), down.reduced(std::ldexp(centre.y, -out.level))};
    if (address != Address::Repeat) {
        // Farther out only the rim is visible, whatever the distance.
        const double far = 2 * largest;
        out.centre = {std::clamp(out.centre.x, -far, across.extent + far),
                      std::clamp(out.centre.y, -far, down.extent + far)};
    }
    const bool small = major < bilinearMajor(settings);
    const double least = settings.smallestMinor();
    double levelMinor = onLevel(minor, out.level, settings);
    double levelMajor = onLevel(major, out.level, settings);
    if (settings.shaped() && levelMinor < least) {
        out.kind = FootprintKind::Shape;
    } else if (out.level == 0 && small && !settings.shaped()) {
        out.kind = FootprintKind::Bilinear;
    } else {
        levelMinor = std::max(levelMinor, least);
        levelMajor = std::max(levelMajor, levelMinor);
    }
    out.widened = withAxes(axes, levelMajor, levelMinor);
    out.ellipse = ellipseOf(out.widened);
    return out;
}

}  // namespace relief
