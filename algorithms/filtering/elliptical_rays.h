// elliptical-visible:form=rays: what a pixel sees through a fixed number of rays, each with a small footprint. The work
// per pixel is bounded, whatever the relief, and all of it runs in SIMD.
//
// First, four rays are traced around the pixel's centre. If their hits lie on a plane with the pixel's own hit, the
// pixel is filtered plainly with that plane's Jacobian, obtained from the differences of the hits. Otherwise the rest
// of `samples` rays is traced; each hit is filtered with a footprint `blur` times the pixel's, on the surface's tangent
// plane there, and the pixel is the mean of the results. Rays without a hit are left out. Visibility is decided by the
// rays' hits alone.
//
// Places of the rays in the pixel: points of equal shares of the weights' mass on a golden-angle spiral, with the first
// four inside the inner 60% of the mass. The covariance of the points plus that of the small footprints equals that of
// plain filtering, so both give the same result on a plane. The places are the same for all pixels, and each pixel sums
// in their order, so its bits depend neither on the other pixels of the block nor on the number of threads.
//
// The fan of rays: a ray that enters at an offset of d texels from the pixel's ray has a run that is spread * d longer
// per unit of descent; d is linear in the place in the pixel, as everywhere in filtering.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "filtering/elliptical.h"
#include "relief/tracers.h"

namespace relief {

inline constexpr std::string_view kRaysForm = "rays";
inline constexpr int kProbes = 4;

// Places of a pixel's rays, in pixels from its centre. The first kProbes are e and e turned by 90, 180 and 270 degrees.
struct RayPattern {
    std::vector<glm::dvec2> places;
    double blur = 0;  // size of each ray's footprint relative to the pixel's

    // samples: at least 2 kProbes. settings: serves() must be true.
    static RayPattern of(const EllipticalSettings& settings, int samples);
};

// Variance of the truncated weights along one axis, in pixels^2.
double weightVariance(const EllipticalSettings& settings);

// The rays through places in a pixel, in texels of the height map.
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

    // Returns true for weights without a shape of their own. Others need the forms that sum over the surface.
    static bool serves(const EllipticalSettings& settings) {
        return settings.weights == WeightKind::Uniform || settings.weights == WeightKind::Gaussian;
    }
    // Filters a block. scale: texels of the picture per texel of the height map. counts.tested: number of rays. log:
    // null unless the block has one pixel; receives the texels of all rays' footprints. Throws Cancelled.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                Work& work, FootprintLog* log = nullptr) const;

  private:
    struct Scratch;
    bool usable(const FilterQuery& query) const;
    void probe(const FilterBlock& block, std::size_t first, std::size_t last, Scratch& scratch, Work& work) const;
    void sample(const FilterBlock& block, std::size_t first, std::size_t last, std::span<Color> colors,
                FootprintCounts& counts, Scratch& scratch, Work& work, FootprintLog* log) const;
    // Tests whether the probes' hits lie on a plane with the pixel's own hit. If so, returns true and its Jacobian in
    // `found`, in texels of the picture.
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
