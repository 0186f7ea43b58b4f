// The loop of cone step mapping as shaders run it over a picture: height and cone are fetched where the ray is, the ray
// advances to the edge of that cone, with any number of steps. Dummer 2006; Policarpo & Oliveira 2007.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "relief/height_field.h"
#include "relief/maps/engine_codes.h"
#include "relief/ray.h"
#include "relief/sampled_surface.h"

namespace relief {

// How a shader fetches cones; heights are interpolated by the field's surface.
enum class ConeFetch : std::uint8_t { Bilinear, Nearest };
std::string_view coneFetchName(ConeFetch fetch);
// Throws InputError naming `option`.
ConeFetch parseConeFetch(std::string_view text, const std::string& option);

class EngineMarch {
  public:
    // codes: the channel of cones, as large as the field. relaxed: the step that ends below the surface is bisected.
    // Keeps references to field and codes.
    EngineMarch(const HeightField& field, const FloatImage& codes, const ConeCoding& coding, bool relaxed,
                ConeFetch fetch)
        : field_(field), codes_(codes), coding_(coding), relaxed_(relaxed), fetch_(fetch) {}

    // Returns where the loop ends: on the surface up to kShortestStep, below it, or, under border, outside the picture.
    Hit trace(const ViewRay& ray) const;
    // Describes the step of the ray that leads past `truth`; empty if none does.
    std::string stepPast(const ViewRay& ray, double truth) const;

    // The stored number at a point, texels.
    double codeAt(double s, double t) const;

  private:
    struct Advance {
        double before = 0;  // lambda
        double after = 0;
        double height = 0;  // of the surface at `before`
        double ratio = 0;
    };
    // Calls step(Advance) for each step; step returns false to end the loop. Returns the end of the last step.
    template <class Step>
    Advance walk(const SampledSurface& surface, const ViewRay& ray, const Step& step) const;

    const HeightField& field_;
    const FloatImage& codes_;
    ConeCoding coding_;
    bool relaxed_;
    ConeFetch fetch_;
};

// A step this short, texels, ends the loop.
inline constexpr double kShortestStep = 1e-7;

}  // namespace relief
