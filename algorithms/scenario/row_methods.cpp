#include "scenario/row_methods.h"

#include <algorithm>

#include "mapping/rows/counting_scalar.h"
#include "mapping/rows/derivatives.h"
#include "mapping/rows/row_kernels.h"

namespace relief {

namespace {

constexpr const char* kPersp = "Romaniuk and Dudnyk, [PERSP]";
constexpr const char* kTex = "Romaniuk and Dudnyk, [TEX]";

RowMethodDescription described(RowVariant variant, std::string title, std::string help, std::string counts,
                               std::string paper, std::string source, const std::vector<std::string>& takes) {
    RowMethodDescription method{std::string(rowVariantName(variant)),
                                std::move(title),
                                std::move(help),
                                std::move(counts),
                                std::move(paper),
                                std::move(source),
                                {},
                                {},
                                variant};
    const RowSettings defaults;
    for (const auto& field : RowSettings::fields()) {
        if (std::find(takes.begin(), takes.end(), field.description.name) == takes.end()) continue;
        method.options.push_back(field.description);
        method.defaults[field.description.name] = optionText(field, defaults);
    }
    return method;
}

RowMethodDescription described(std::string name, DerivativeVariant variant, std::string title, std::string help,
                               std::string counts, std::string paper) {
    return {std::move(name), std::move(title), std::move(help), std::move(counts), std::move(paper), kTex, {}, {},
            variant};
}

std::vector<RowMethodDescription> makeList() {
    using R = RowVariant;
    using D = DerivativeVariant;
    const std::string anchored = " Restarts from an exact value every anchor pixels; otherwise the error accumulates.";
    return {
        described(R::Affine, "Affine", "u and v are linear along the row, without perspective; deliberately wrong.",
                  "0 / 2 / 0", "", "Heckbert 1989", {}),
        described(R::Direct, "Direct",
                  "(A x + B y + C) / (G x + H y + I); the denominator is computed separately for u and v.", "8 / 8 / 2",
                  "8 / 8 / 2", "Heckbert 1989", {}),
        described(R::RowConstant, "Row constants",
                  "(u_t + A n) / (u_b + G n); the terms that are constant along a row are computed once.", "4 / 4 / 2",
                  "4 / 4 / 2", kPersp, {}),
        described(R::Incremental, "Incremental", "w += A, q += G, with a separate denominator for u and v." + anchored,
                  "0 / 4 / 2", "0 / 4 / 2", kPersp, {"anchor"}),
        described(R::IncrementalShared, "Incremental, one denominator",
                  "As incremental, but with one q for u and v." + anchored, "0 / 3 / 2", "", kPersp, {"anchor"}),
        described(R::IncrementalReciprocal, "Incremental, one division",
                  "As incremental, but with one 1 / q for u and v." + anchored, "2 / 3 / 1", "", kPersp, {"anchor"}),
        described(
            R::Streams, "Interleaved streams",
            "Computes pixel n from pixel n - k, in k streams at once; 2, 4, 8, 16 and 32 streams use SIMD." + anchored,
            "0 / 3 / 2", "0 / 4 / 2", kPersp, {"streams", "anchor"}),
        described(R::Opposed, "Opposed streams", "Computes from both ends of the row towards its middle." + anchored,
                  "0 / 3 / 2", "0 / 4 / 2", kPersp, {"anchor"}),
        described(R::RowsParallel, "Rows in parallel",
                  "Interleaved streams; several threads share the rows." + anchored, "0 / 3 / 2", "0 / 4 / 2", kPersp,
                  {"streams", "anchor"}),
        described(R::Subspan, "Sub-spans",
                  "Divides every m pixels and interpolates u and v linearly in between; m is given, or the largest "
                  "that keeps a given error.",
                  "4/m / 2+3/m / 1/m", "", "common in games", {"span", "error", "anchor"}),
        described("derivatives-direct", D::Direct, "Footprint ellipse, direct",
                  "Computes the four derivatives at each pixel, and the ellipse from them.",
                  "17 / 10 / 4, of which 7 / 6 / 4 for the derivatives", "10 / 10 / 4 / 1"),
        described("derivatives-iterative", D::Iterative, "Footprint ellipse, iterative",
                  "q += G, c += O, d += P along a row, and the ellipse from them.",
                  "11 / 7 / 4, of which 1 / 3 / 4 for the derivatives", "2 / 6 / 4 / 0"),
        described("derivatives-cached", D::Cached, "Footprint ellipse, cached",
                  "Computes the ellipse times q^4 as the sum of row and column caches shared by a polygon.",
                  "1 / 4 / 1", ""),
        {"fill",
         "Fill",
         "Computes nothing; writes as many bytes past the cache, as a rate to compare with.",
         "0 / 0 / 0",
         "",
         "",
         {},
         {},
         RowFill{}},
    };
}

constexpr const char* kDefaults[] = {"affine",
                                     "direct",
                                     "row-constant",
                                     "incremental",
                                     "incremental:anchor=0",
                                     "incremental-shared",
                                     "incremental-reciprocal",
                                     "opposed",
                                     "streams:streams=2",
                                     "streams",
                                     "streams:anchor=0",
                                     "rows-parallel",
                                     "subspan",
                                     "subspan:error=0.5",
                                     "fill",
                                     "derivatives-direct",
                                     "derivatives-iterative",
                                     "derivatives-cached"};

const Homography kAnyMap{1, 0.25, 3, 0.5, 1, 7, 1e-9, 1e-9, 1};

// Counts the operations of a row of `count` pixels, without computing its terms.
OperationCounts counted(const RowMethod& method, std::int64_t span, std::int64_t anchor, std::int64_t count) {
    OperationCounts counts;
    const auto make = [&](double value) { return Counted(value, &counts); };
    const auto size = static_cast<std::size_t>(count);
    if (const auto* variant = std::get_if<RowVariant>(&method.description->kind)) {
        std::vector<Counted> u(size), v(size);
        const auto row = rowTerms<Counted>(kAnyMap, 0.5, 0, count, anchor, make, make);
        counts = {};
        variantRow(row, *variant, method.settings.streams, span, u.data(), v.data());
    } else if (const auto* derivative = std::get_if<DerivativeVariant>(&method.description->kind)) {
        std::vector<Counted> a(size), b(size), c(size), f(size);
        const EllipseRow<Counted> to{a.data(), b.data(), c.data(), f.data()};
        const auto terms = derivativeTerms<Counted>(kAnyMap, make);
        const EllipseCaches<Counted> caches(terms, {0, count}, {0, 1});
        counts = {};
        if (*derivative == DerivativeVariant::Direct) directEllipses(terms, 0, Counted(0.5), count, to);
        if (*derivative == DerivativeVariant::Iterative) {
            iterativeEllipses(terms, 0, Counted(0.5), count, anchor, to);
        }
        if (*derivative == DerivativeVariant::Cached) caches.ellipses(0, 0, count, to);
    }
    return counts;
}

}  // namespace

std::vector<OptionField<RowSettings>> RowSettings::fields() {
    return {
        {{"streams", OptionKind::Integer, "", 1, kMostStreams, 1, {}, "number of streams in a row"},
         &RowSettings::streams},
        {{"span", OptionKind::Integer, "pixels", 1, kLongestSpan, 1, {}, "pixels between two divisions"},
         &RowSettings::span},
        {{"error",
          OptionKind::Real,
          "texels",
          0,
          64,
          0.01,
          {},
          "largest error, which determines the span (0: the given span is used)"},
         &RowSettings::error},
        {{"anchor",
          OptionKind::Integer,
          "pixels",
          kRecommended,
          1 << 20,
          1,
          {},
          "pixels between exact restarts (0: never; -1: chosen to keep an error of 1/256 texel)"},
         &RowSettings::anchor},
    };
}

const std::vector<RowMethodDescription>& rowMethodList() {
    static const std::vector<RowMethodDescription> list = makeList();
    return list;
}

RowOptions RowMethod::options() const {
    RowOptions options;
    options.variant = std::get<RowVariant>(description->kind);
    options.streams = settings.streams;
    options.span = settings.span;
    options.anchor = settings.anchor;
    return options;
}

RowMethod parseRowMethod(const std::string& text, const std::string& option) {
    const MethodChoice choice = splitMethodChoice(text, option);
    RowMethod method;
    method.text = text;
    for (const RowMethodDescription& one : rowMethodList()) {
        if (one.name == choice.name) method.description = &one;
    }
    if (method.description == nullptr) {
        throw InputError(option,
                         unknownName({"what", MessageId::WordRowVariant}, choice.name, namesOf(rowMethodList())));
    }
    const std::string known = namesOf(method.description->options);
    for (const auto& [name, value] : choice.options) {
        if (method.description->defaults.count(name) == 0) {
            throw InputError(option, unknownName({"what", Message(MessageId::WordOptionOf, {{"method", choice.name}})},
                                                 name, known));
        }
    }
    method.settings = parseOptions<RowSettings>(choice.name, choice.options, option);
    return method;
}

RowOptions parseMapping(const std::string& text, const std::string& option) {
    const std::vector<std::string> names = mappingNames();
    const std::string name = splitMethodChoice(text, option).name;
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw InputError(option, unknownName({"what", MessageId::WordMapping}, name, commaList(names)));
    }
    const RowMethod method = parseRowMethod(text, option);
    if (method.settings.error > 0) {
        throw InputError(option, unknownName({"what", MessageId::WordSubspanOption}, "error", "span"));
    }
    return method.options();
}

std::vector<std::string> mappingNames() {
    std::vector<std::string> names;
    for (const RowMethodDescription& method : rowMethodList()) {
        if (std::holds_alternative<RowVariant>(method.kind)) names.push_back(method.name);
    }
    return names;
}

std::vector<RowMethod> defaultRowMethods() {
    std::vector<RowMethod> methods;
    for (const char* text : kDefaults) methods.push_back(parseRowMethod(text, ""));
    return methods;
}

PixelCounts pixelCounts(const RowMethod& method, std::int64_t span, std::int64_t anchor) {
    // The difference of two rows is counted, of which the second is longer by whole steps and restart intervals, in
    // both halves of opposed streams.
    const auto* variant = std::get_if<RowVariant>(&method.description->kind);
    const bool streams =
        variant != nullptr && (*variant == RowVariant::Streams || *variant == RowVariant::RowsParallel);
    const std::int64_t step = streams ? method.settings.streams : span;
    const std::int64_t period = 2 * (anchor > 0 ? anchor : step);
    const OperationCounts less = counted(method, span, anchor, period + 1);
    const OperationCounts more = counted(method, span, anchor, 2 * period + 1);
    const auto each = [&](std::int64_t a, std::int64_t b) {
        return static_cast<double>(b - a) / static_cast<double>(period);
    };
    return {each(less.mul, more.mul), each(less.add, more.add), each(less.div, more.div)};
}

}  // namespace relief
