// The settings of the anisotropic filters, described once.
#pragma once

#include <string>
#include <vector>

#include "filtering/pixel_model.h"
#include "relief/describe.h"

namespace relief {

// How texels in a footprint are weighted. Uniform: all the same, as in the basic form of [TEX]. Gaussian: the Gaussian
// model of the pixel. TexelDistance: by distance in texels, which ignores the pixel's projection; for comparison. Box,
// Lcd, Crt: the shape of the pixel model itself, which needs a map of weights.
enum class WeightKind : std::uint8_t { Uniform, Gaussian, TexelDistance, Box, Lcd, Crt };
// Direct: the formula for each texel. Table: over r^2. Map: two-dimensional, over the pixel.
enum class WeightSource : std::uint8_t { Direct, Table, Map };
// Lanes: many pixels at once by SIMD where supported (elliptical_lanes.h), otherwise the reference. Scalar: the
// reference.
enum class Implementation : std::uint8_t { Lanes, Scalar };

struct EllipticalOptions {
    std::string weights = "gaussian";
    double sigma = 0.53;
    double radius = 0;
    std::string levels = "pyramid";
    double floor = 1.25;
    double anisotropy = 16;
    std::string texelSize = "on";
    std::string source = "direct";
    int resolution = 64;
    std::string implementation = "lanes";

    template <class Options>
    static std::vector<OptionField<Options>> fieldsOf() {
        return {
            {{"weights",
              OptionKind::Choice,
              "",
              0,
              1,
              1,
              {"uniform", "gaussian", "texel-distance", "box", "lcd", "crt"},
              "weight function of the texels in a footprint"},
             &Options::weights},
            {{"sigma", OptionKind::Real, "pixels", 0.1, 2, 0.01, {}, "standard deviation of the Gaussian pixel model"},
             &Options::sigma},
            {{"radius",
              OptionKind::Real,
              "pixels",
              0,
              4,
              0.05,
              {},
              "radius of the footprint (0: chosen to suit the weights)"},
             &Options::radius},
            {{"levels",
              OptionKind::Choice,
              "",
              0,
              1,
              1,
              {"pyramid", "exhaustive"},
              "pyramid: the level is chosen by the footprint's minor axis; exhaustive: always level 0"},
             &Options::levels},
            {{"floor",
              OptionKind::Real,
              "texels",
              0.5,
              8,
              0.05,
              {},
              "smallest minor semi-axis, on the chosen level, of the ellipse onto which a circle of radius 1 pixel "
              "projects"},
             &Options::floor},
            {{"anisotropy",
              OptionKind::Real,
              "",
              1,
              64,
              1,
              {},
              "largest ratio of the axes (longer footprints are widened)"},
             &Options::anisotropy},
            {{"texel-size",
              OptionKind::Choice,
              "",
              0,
              1,
              1,
              {"on", "off"},
              "whether the Gaussian accounts for the size of texels"},
             &Options::texelSize},
            {{"source",
              OptionKind::Choice,
              "",
              0,
              1,
              1,
              {"direct", "table", "map"},
              "source of the weights: the formula, a table over the distance, or a weight map of the pixel"},
             &Options::source},
            {{"resolution",
              OptionKind::Integer,
              "cells",
              8,
              1024,
              1,
              {},
              "cells along each side of the weight map (the table has as many cells as the whole map)"},
             &Options::resolution},
            {{"implementation",
              OptionKind::Choice,
              "",
              0,
              1,
              1,
              {"lanes", "scalar"},
              "lanes: many pixels at once with SIMD, from 16-bit levels, if source=direct; scalar: one pixel at a "
              "time, in double"},
             &Options::implementation},
        };
    }
    static std::vector<OptionField<EllipticalOptions>> fields() { return fieldsOf<EllipticalOptions>(); }

    bool operator==(const EllipticalOptions&) const = default;
};

// The parsed options, with the defaults that depend on the weights filled in.
struct EllipticalSettings {
    WeightKind weights = WeightKind::Gaussian;
    WeightSource source = WeightSource::Direct;
    double sigma = 0.53;      // pixels
    double radius = 1.325;    // pixels; weights are 0 beyond
    bool exhaustive = false;  // always level 0
    double floor = 1.25;      // texels; smallest minor semi-axis on the level chosen
    double anisotropy = 16;
    bool texelSize = true;  // add the covariance of texels; Gaussian weights only
    int resolution = 64;
    Implementation implementation = Implementation::Lanes;

    static EllipticalSettings of(const EllipticalOptions& options);
    // The smallest semi-axis of a footprint, in texels of its level, at which every channel covers a texel: a circle of
    // radius sqrt(1/2) contains a texel's centre wherever it lies.
    double smallestMinor() const;
    // shaped(): the weights have the shape of a pixel model, which model() returns.
    bool shaped() const { return weights >= WeightKind::Box; }
    PixelModel model() const;
};

}  // namespace relief
