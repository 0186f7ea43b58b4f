// Seeded families of rays designed to find errors of maps.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "measuring/random_rays.h"
#include "measuring/verify/certificate_bounds.h"

namespace relief {

// Generates rays over a field, with a run of at most `longest` texels; all enter within the picture.
class CertificateRays {
  public:
    CertificateRays(HeightField field, double longest) : field_(std::move(field)), longest_(longest) {}

    // any direction; grazing; along walls; into walls; at edges. Ray n of a block is of family n % 5.
    static const std::vector<std::string_view>& families();
    // Returns a random ray of a family; `block` returns `count` rays of all families in turn.
    ViewRay ray(Random& random, std::size_t family) const;
    RayBlock block(std::uint64_t seed, std::size_t count) const;

    // Returns the ray through (s, t, z) with the run (a, b); std::nullopt if it would enter outside the picture.
    std::optional<ViewRay> through(double s, double t, double z, double a, double b) const;

    double longest() const { return longest_; }

  private:
    // A texel that is higher than its neighbour, with the direction to that neighbour.
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
    // Returns a random run, texels, with uniform logarithm.
    double run(Random& random) const;

    HeightField field_;
    double longest_;
};

}  // namespace relief
