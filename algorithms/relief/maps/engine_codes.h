// How engines store maps in the channels of a picture: which channel holds what, in which unit, rounded how.
//
// A channel holds numbers x: codes of 8 or 16 bits stand for code / (2^bits - 1) (UNORM), 32 bits are floats. What must
// not grow by rounding is rounded outward: cones narrower, distances smaller, maxima higher.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "relief/height_field.h"

namespace relief {

// What a channel holds. Height: 1 is the top of the slab; depth: 0 is. Apex: height of the apex of a cell's cone. Cone:
// its width, in the unit of ConeCoding. Zero: nothing; the channel is 0.
enum class EngineRole : std::uint8_t { Zero, Height, Depth, Apex, Cone, Distance, NormalX, NormalY, NormalZ };
std::string_view engineRoleName(EngineRole role);
// Throws InputError naming `option`.
EngineRole parseEngineRole(std::string_view text, const std::string& option);

// Letters of the channels, in their order.
inline constexpr std::string_view kEngineLetters = "RGBA";
// Parses "R=height,G=cone": the channels up to the last one named; those not named are 0. Throws InputError naming
// `option`.
std::vector<EngineRole> parseEnginePack(const std::string& text, const std::string& option);
// Returns the text that parseEnginePack() parses.
std::string enginePackText(const std::vector<EngineRole>& channels);
bool packs(const std::vector<EngineRole>& channels, EngineRole role);

// What white, the number 1, stands for in a height map: the top of the slab or its bottom.
enum class HeightWhite : std::uint8_t { High, Deep };
std::string_view heightWhiteName(HeightWhite white);
HeightWhite parseHeightWhite(std::string_view text, const std::string& option);

// Outward: to the safe side. Nearest: to the nearest code, as most tools do; not safe.
enum class EngineRounding : std::uint8_t { Outward, Nearest };
std::string_view engineRoundingName(EngineRounding rounding);
EngineRounding parseEngineRounding(std::string_view text, const std::string& option);

// Returns "8 bits", "16 bits" or, for 32, "float".
std::string engineBitsText(int bits);

// Returns x as a picture of this many bits stores it, as the float that a texture fetch gives: the nearest code, the
// next lower, or the next higher one. x is clamped to [0, 1] for codes.
float nearestCode(double x, int bits);
float lowerCode(double x, int bits);
float higherCode(double x, int bits);
// The codes next to a stored number, below and above.
float codeBelow(float stored, int bits);
float codeAbove(float stored, int bits);

// Unit of cones. A cone widens by `ratio` per unit of height (the slab is 1 high); slope = 1 / ratio. Ratio: x = ratio
// / scale (Policarpo & Oliveira 2007; Ban et al. 2024); SqrtRatio: x = sqrt(ratio / scale) (Dummer 2006); Slope: x =
// slope / scale.
enum class ConeUnit : std::uint8_t { Ratio, SqrtRatio, Slope };
std::string_view coneUnitName(ConeUnit unit);
ConeUnit parseConeUnit(std::string_view text, const std::string& option);
// Unit of length of a ratio. Uv: texture coordinates, so that on pictures that are not square a cone is an ellipse; the
// ratio is that of the longer side's unit, which is safe on both axes. Width: texture widths on both axes.
enum class ConeLength : std::uint8_t { Uv, Width };
std::string_view coneLengthName(ConeLength length);
ConeLength parseConeLength(std::string_view text, const std::string& option);

struct ConeCoding {
    ConeUnit unit = ConeUnit::Ratio;
    ConeLength length = ConeLength::Uv;
    double scale = 1;

    // Returns the ratio of a stored number, in units of length per height.
    double ratio(double stored) const;
    // Returns true for a stored cone that has no width: a ray stops there.
    bool stalls(float stored) const { return ratio(static_cast<double>(stored)) == 0; }
    // Returns the stored number of the cone with this slope, heights per texel, of a level of that size: rounded
    // outward, the cone that it decodes to is not wider. Ratios above `scale` become narrower.
    float encode(double slope, int width, int height, int bits, EngineRounding rounding) const;
    // Texels of a level of that size per unit of length along each axis, and the larger of both.
    double texelsAlong(int width, int height, bool down) const;
    double texels(int width, int height) const;
    // Returns the slope, heights per texel, of a stored number: of the ellipse's longer axis, the wider side.
    double slope(double stored, int width, int height) const;

    bool operator==(const ConeCoding&) const = default;
};

// Cones are stored narrower by this share, so that the rounding of a shader's 32-bit floats does not widen them.
inline constexpr double kEngineMargin = 1e-6;

}  // namespace relief
