#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "measuring/verify/stress_part_checks.h"
#include "measuring/verify/stress_parts.h"
#include "rendering/pinhole.h"

namespace relief {

namespace {

// Allowance for terms of second order in the roundoff.
constexpr double kSecondOrder = 1.001;
// Rounding error of a texel with a relative error of one half in q, over the texel and the terms of its numerators
// (rows.h: smallestRowQ).
constexpr double kHalfOff = 1.01;

double qAt(const Homography& map, double y, std::int64_t pixel) {
    return map.denominator(static_cast<double>(pixel) + 0.5, y);
}

// Returns the error bound, texels, that rows.h states for the variant.
template <typename T>
double statedBound(const StressRow<T>& row, double largest) {
    const Homography& map = *row.map;
    const double roundoff = 0.5 * static_cast<double>(std::numeric_limits<T>::epsilon());
    const auto count = static_cast<double>(row.valid.size());
    const double smallest = std::min(qAt(map, row.y, row.valid.begin), qAt(map, row.y, row.valid.end - 1));
    const double terms =
        std::abs(map.qx) * static_cast<double>(row.valid.end) + std::abs(map.qy * row.y) + std::abs(map.q1);
    if (!drifts(row.options.variant)) return kSecondOrder * 8 * roundoff * largest * terms / smallest;
    const std::int64_t anchor = planRow<T>(map, row.y, row.span, row.options).anchor;
    const double stretch = anchor > 0 ? std::min(static_cast<double>(anchor), count) : count;
    const double ratio = (smallest + std::abs(map.qx) * stretch) / smallest;
    const double steps = std::ceil(stretch / pixelsPerStep(row.options));
    return kSecondOrder * largest * ((2 * steps + 3) * roundoff * ratio + 8 * 0x1p-53 * terms / smallest);
}

// Returns the sum of the numerators' terms over the largest q, texels, to which the rounding errors of the numerators
// are relative.
template <typename T>
double numeratorTexels(const StressRow<T>& row) {
    const Homography& map = *row.map;
    const double x = static_cast<double>(std::max(std::abs(row.span.begin), std::abs(row.span.end)));
    const double terms = std::max(std::abs(map.sx) * x + std::abs(map.sy * row.y) + std::abs(map.s1),
                                  std::abs(map.tx) * x + std::abs(map.ty * row.y) + std::abs(map.t1));
    return terms / std::max(qAt(map, row.y, row.valid.begin), qAt(map, row.y, row.valid.end - 1));
}

template <typename T>
std::string rowText(const StressRow<T>& row, std::int64_t pixel) {
    const RowOptions& o = row.options;
    std::string text = "; " + std::string(rowVariantName(o.variant)) + (sizeof(T) == 4 ? " in float" : " in double") +
                       ", streams " + std::to_string(o.streams) + ", span " + std::to_string(o.span) + ", anchor " +
                       std::to_string(o.anchor) + ", pixel " + std::to_string(pixel) + " of " +
                       std::to_string(row.span.begin) + " to " + std::to_string(row.span.end) + ", y " +
                       numberText(row.y) + ", map";
    for (const double c : row.map->template coefficients<double>()) text += " " + numberText(c);
    return text;
}

bool approximates(RowVariant variant) {
    return variant == RowVariant::Affine || variant == RowVariant::Subspan;
}

}  // namespace

LongTexel truthAt(const Homography& map, double y, std::int64_t pixel) {
    const long double x = static_cast<long double>(pixel) + 0.5L;
    const long double line = y;
    const long double q = map.qx * x + (map.qy * line + map.q1);
    return {(map.sx * x + (map.sy * line + map.s1)) / q, (map.tx * x + (map.ty * line + map.t1)) / q};
}

Homography rowOfRatio(double width, double lastQ, double texels, double firstV, double lastV) {
    Homography map;
    map.qx = (lastQ - 1) / width;
    map.q1 = 1;
    map.sx = texels * lastQ / width;
    map.s1 = 0;
    map.t1 = firstV;
    map.tx = (lastV * lastQ - firstV) / width;
    map.sy = map.qy = map.ty = 0;
    return map.normalised();
}

template <typename T>
StressRow<T> evaluatedRow(const Homography& map, double y, PixelSpan span, const RowOptions& options, bool stated,
                          const RowEvaluator<T>& evaluate) {
    const auto size = static_cast<std::size_t>(span.size());
    StressRow<T> row{&map, y, span, options, stated, {}, std::vector<T>(size), std::vector<T>(size)};
    row.valid = evaluate(map, y, span, options, row.u.data(), row.v.data());
    return row;
}

template <typename T>
std::optional<StressFault> rowFault(const StressRow<T>& row) {
    const PixelSpan valid = row.valid;
    if (valid.empty()) return std::nullopt;
    double largest = 0;
    for (std::int64_t i = valid.begin; i < valid.end; ++i) {
        const LongTexel truth = truthAt(*row.map, row.y, i);
        largest = std::max({largest, static_cast<double>(std::abs(truth.s)), static_cast<double>(std::abs(truth.t))});
    }
    const double bound = approximates(row.options.variant) || !row.stated ? 0 : statedBound(row, largest);
    const double terms = numeratorTexels(row);
    for (std::int64_t i = valid.begin; i < valid.end; ++i) {
        const auto n = static_cast<std::size_t>(i - row.span.begin);
        const T u = row.u[n];
        const T v = row.v[n];
        if (!(qAt(*row.map, row.y, i) > 0)) return StressFault{"horizon", "q is not positive" + rowText(row, i)};
        if (!std::isfinite(u) || !std::isfinite(v)) return StressFault{"not-finite", "not a number" + rowText(row, i)};
        if (approximates(row.options.variant)) continue;
        const LongTexel truth = truthAt(*row.map, row.y, i);
        const auto error = static_cast<double>(std::max(std::abs(u - truth.s), std::abs(v - truth.t)));
        const auto here = static_cast<double>(std::max(std::abs(truth.s), std::abs(truth.t)));
        const double allowed = row.stated ? bound : kHalfOff * (here + terms);
        if (error <= allowed) continue;
        return StressFault{"row",
                           "off by " + numberText(error) + " texels, allowed " + numberText(allowed) + rowText(row, i)};
    }
    return std::nullopt;
}

template StressRow<float> evaluatedRow<float>(const Homography&, double, PixelSpan, const RowOptions&, bool,
                                              const RowEvaluator<float>&);
template StressRow<double> evaluatedRow<double>(const Homography&, double, PixelSpan, const RowOptions&, bool,
                                                const RowEvaluator<double>&);
template std::optional<StressFault> rowFault<float>(const StressRow<float>&);
template std::optional<StressFault> rowFault<double>(const StressRow<double>&);

namespace stress_detail {

namespace {

constexpr int kLongestRow = 1500;
constexpr int kLines = 600;
// Limit on numerators, below which no quotient by an admissible q overflows in float.
constexpr double kLargestNumerator = 0x1p90;

bool fitsFloat(const Homography& map) {
    const std::array<double, 9> c = map.coefficients<double>();
    return std::all_of(c.begin(), c.end(),
                       [](double value) { return std::abs(value) * kLongestRow < kLargestNumerator; });
}

// Returns a row along which no numerator cancels.
Homography anyRowOfRatio(Random& random) {
    const double lastQ = std::exp2(random.between(-4.3, 4.3));
    const double texels = random.between(10, 5000);
    const double firstV = random.between(0, 4000);
    return rowOfRatio(kLongestRow, lastQ, texels, firstV, random.between(0, 4000));
}

RowOptions variantOptions(RowVariant variant, Random& random) {
    constexpr std::array<int, 6> kStreams{1, 2, 3, 16, 32, 33};
    constexpr std::array<int, 4> kAnchors{kRecommended, kNever, 1, 50};
    constexpr std::array<int, 4> kSpans{1, 2, 16, kLongestSpan};
    RowOptions options{variant};
    options.streams = kStreams[static_cast<std::size_t>(random.below(int{kStreams.size()}))];
    options.anchor = kAnchors[static_cast<std::size_t>(random.below(int{kAnchors.size()}))];
    options.span = kSpans[static_cast<std::size_t>(random.below(int{kSpans.size()}))];
    return options;
}

template <typename T>
std::optional<StressFault> variantFault(const Homography& map, double y, PixelSpan span, RowOptions options,
                                        bool stated, const RowEvaluator<T>& evaluate) {
    const StressRow<T> row = evaluatedRow<T>(map, y, span, options, stated, evaluate);
    if (auto fault = rowFault(row)) return fault;
    options.lanes = false;
    const StressRow<T> scalar = evaluatedRow<T>(map, y, span, options, stated, evaluate);
    // Pixels cut off at the horizon are not written; both results contain zeros there.
    if (scalar.valid == row.valid && scalar.u == row.u && scalar.v == row.v) return std::nullopt;
    return StressFault{"lanes", "SIMD and scalar differ" + rowText(row, row.valid.begin)};
}

// Lines of a block evaluated by several threads, which must have the bits of each line evaluated alone.
constexpr int kBlockLines = 5;
constexpr int kBlockThreads = 3;

std::optional<StressFault> blockFault(const StressSubjects& subjects, const Homography& map, double y, PixelSpan span,
                                      const RowOptions& options) {
    TexelRows<float> together(span.size(), kBlockLines);
    Work work(kBlockThreads);
    subjects.rowBlock(map, {span.size(), kBlockLines, y, 1}, options, together, work);
    for (int line = 0; line < kBlockLines; ++line) {
        const StressRow<float> alone = evaluatedRow<float>(map, y + line, span, options, false, subjects.floatRow);
        const PixelSpan valid = together.valid(line);
        bool same = valid == alone.valid;
        for (std::int64_t i = valid.begin; same && i < valid.end; ++i) {
            const auto n = static_cast<std::size_t>(i);
            same = together.u(line)[i] == alone.u[n] && together.v(line)[i] == alone.v[n];
        }
        if (!same) return StressFault{"threads", "a block's line differs" + rowText(alone, valid.begin)};
    }
    return std::nullopt;
}

void tryRow(const CaseRun& run, std::string_view family, const Homography& map, bool stated, Random& random) {
    const double y = stated ? 0.5 : random.below(kLines) + 0.5;
    const int width = stated ? kLongestRow : 1 + random.below(kLongestRow);
    for (int v = 0; v < kRowVariants; ++v) {
        const auto variant = static_cast<RowVariant>(v);
        const RowOptions options = variantOptions(variant, random);
        const std::string name(rowVariantName(variant));
        ++run.result.parts["rows"].tried[name];
        const PixelSpan span{0, width};
        const bool parallel = variant == RowVariant::RowsParallel;
        for (const auto& fault : {variantFault<float>(map, y, span, options, stated, run.subjects.floatRow),
                                  variantFault<double>(map, y, span, options, stated, run.subjects.doubleRow),
                                  parallel ? blockFault(run.subjects, map, y, span, options) : std::nullopt}) {
            if (fault) run.result.report({*fault, StressPart::Rows, {name, {}}, family, ViewRay{}, nullptr});
        }
    }
}

}  // namespace

void stressRows(const CaseRun& run) {
    const HeightField& field = run.of.field;
    const auto& families = run.subjects.cameras;
    Random random = partRandom(run, StressPart::Rows, run.of.number);
    tryRow(run, "stated", anyRowOfRatio(random), true, random);
    for (const StressCameraFamily& family : families) {
        run.work.throwIfStopped();
        const auto scene = static_cast<SceneKind>(random.below(3));
        const Camera camera = family.make(scene, random);
        const auto quads = makeScene(scene, field.width(), field.height());
        const TexturedQuad& quad = quads[static_cast<std::size_t>(random.below(static_cast<int>(quads.size())))];
        std::optional<Homography> map;
        try {
            map = fromCameraAndPlane(pinholeCamera(camera, kLongestRow, kLines), quad.plane);
        } catch (const InputError&) {
            map.reset();
        }
        if (!map || !fitsFloat(*map)) {
            ++run.result.parts["rows"].refused;
            continue;
        }
        tryRow(run, family.name, *map, false, random);
    }
}

}  // namespace stress_detail

}  // namespace relief
