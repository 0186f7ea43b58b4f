// Rays that look for a map's weak places: families with a name each, seeded.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "measuring/random_rays.h"
#include "measuring/verify/certificate_bounds.h"

namespace relief {

// Rays over a field, of a run of `longest` texels at most; all enter within the picture.
class CertificateRays {
  public:
    CertificateRays(HeightField field, double longest) : field_(std::move(field)), longest_(longest) {}

    // any direction; grazing; along walls; into walls; at edges. Ray n of a family: family n % 5.
    static const std::vector<std::string_view>& families();
    ViewRay ray(Random& random, std::size_t family) const;
    RayBlock block(std::uint64_t seed, std::size_t count) const;

    // A ray through (s, t, z) with the run (a, b); nothing if it would enter outside the picture.
    std::optional<ViewRay> through(double s, double t, double z, double a, double b) const;

    double longest() const { return longest_; }

  private:
    // A texel that stands higher than its neighbour, and on which side that lies.
    struct Wall {
        int i;
        int j;
        int dx;
        int dy;
        double low;
        double high;
    };
    Wall wall(Random& random) const;
    ViewRay anyDirection(Random& random) const;
    ViewRay grazing(Random& random) const;
    std::optional<ViewRay> alongWall(Random& random) const;
    std::optional<ViewRay> intoWall(Random& random) const;
    std::optional<ViewRay> atEdge(Random& random) const;
    // Texels, as many of each size.
    double run(Random& random) const;

    HeightField field_;
    double longest_;
};

}  // namespace relief
