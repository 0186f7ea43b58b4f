// elliptical-visible:form=rays: what a pixel sees through a fixed number of rays, each with a small footprint. For each
// pixel the same work, whatever the relief, and all of it in lanes.
//
// Four rays round the pixel's centre first. Where their hits lie on a plane with the pixel's own hit, the pixel is
// plain filtering with that plane's Jacobian, which is the hits' differences. Elsewhere the others of `samples` rays
// follow; each hit is filtered with a footprint `blur` times the pixel's, on the surface's tangent plane there, and the
// pixel is their mean. Rays that meet nothing are left out. Nothing else is hidden or seen than what the rays meet.
//
// Places of the rays in the pixel: points that the weights take from equal parts of their mass, turned by the golden
// angle, the four first within six tenths of the mass. Their covariance and the small footprints' sum up to that of
// plain filtering, so that both see a plane alike. The same for all pixels; each pixel sums in the points' order: equal
// bits in any company and for any number of threads.
//
// The fan of rays: a ray entering d texels from the pixel's enters d on and runs spread * d further a unit of descent;
// d is linear in the place in the pixel, as everywhere in filtering.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "filtering/elliptical.h"
#include "relief/tracers.h"

namespace relief {

inline constexpr std::string_view kRaysForm = "rays";
inline constexpr int kProbes = 4;

// Where a pixel's rays go through it, pixels from its centre; the first kProbes: e, e turned by 90, 180, 270 degrees.
struct RayPattern {
    std::vector<glm::dvec2> places;
    double blur = 0;  // of each ray's footprint, as a part of the pixel's

    // samples: at least 2 kProbes. Weights uniform or Gaussian.
    static RayPattern of(const EllipticalSettings& settings, int samples);
};

// Variance of the weights along one axis, pixels^2, with what they cut off.
double weightVariance(const EllipticalSettings& settings);

// The rays of places in a pixel, in texels of the height map.
struct RayFan {
    glm::dvec2 entry{0};  // of the pixel's own ray
    glm::dvec2 run{0};
    Jacobian top;  // on the top plane
    double spread = 0;

    explicit RayFan(const FilterQuery& query);
    ViewRay ray(glm::dvec2 place) const;
    Jacobian jacobianAt(double lambda) const;
};

class RaysKernel {
  public:
    RaysKernel(EllipticalKernel plain, std::unique_ptr<const Tracer> tracer, int samples);

    // Weights without a direction of their own; others are left to the forms that sum the surface.
    static bool serves(const EllipticalSettings& settings) {
        return settings.weights == WeightKind::Uniform || settings.weights == WeightKind::Gaussian;
    }
    // scale: texels of the picture per texel of the height map. counts.tested: rays. log: null but for a block of one;
    // takes the texels of all rays' footprints. Throws Cancelled.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                Work& work, FootprintLog* log = nullptr) const;

  private:
    struct Scratch;
    bool usable(const FilterQuery& query) const;
    void probe(const FilterBlock& block, std::size_t first, std::size_t last, Scratch& scratch, Work& work) const;
    void sample(const FilterBlock& block, std::size_t first, std::size_t last, std::span<Color> colors,
                FootprintCounts& counts, Scratch& scratch, Work& work, FootprintLog* log) const;
    // Texels of the picture; nothing: no plane.
    bool planeThrough(const FilterQuery& query, const HitBlock& hits, std::size_t first, glm::dvec2 scale,
                      Jacobian& found) const;
    void addSample(const RayFan& fan, const ViewRay& ray, const Hit& hit, std::size_t slot, Scratch& scratch) const;
    void logSamples(const FilterQuery& query, const Scratch& scratch, std::size_t samples, FootprintLog& log) const;

    EllipticalKernel plain_;
    std::unique_ptr<const Tracer> tracer_;
    RayPattern pattern_;
    double smallest_;  // major semi-axis below which level 0 is read bilinearly, texels
};

}  // namespace relief
