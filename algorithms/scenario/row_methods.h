// The variants of rows and of derivatives by name, for lists, command lines and tables: names, options, operation
// counts.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "mapping/rows/rows.h"
#include "relief/describe.h"

namespace relief {

// The settings that a variant's text can give; its description lists those that it accepts.
struct RowSettings {
    int streams = 16;
    int span = 16;
    double error = 0;
    int anchor = kRecommended;

    static std::vector<OptionField<RowSettings>> fields();
};

enum class DerivativeVariant : std::uint8_t { Direct, Iterative, Cached };
// Computes nothing and writes the same number of bytes with non-temporal stores: the upper limit of rates.
struct RowFill {};

struct RowMethodDescription {
    std::string name;
    std::string title;
    std::string help;
    std::string counts;  // per pixel: mul / add / div, without restarts
    std::string paper;   // the papers' own counts: mul / add / div, for derivatives mul / add / div / sub; empty: none
    std::string source;
    std::vector<OptionDescription> options;
    std::map<std::string, std::string> defaults;
    std::variant<RowVariant, DerivativeVariant, RowFill> kind;
};
// affine, direct, ..., subspan, derivatives-direct, derivatives-iterative, derivatives-cached, fill.
const std::vector<RowMethodDescription>& rowMethodList();

struct RowMethod {
    const RowMethodDescription* description = nullptr;
    RowSettings settings;
    std::string text;  // the spelling that was parsed

    // Returns the options of a row variant, with the span as given.
    RowOptions options() const;
};
// Parses "streams" or "streams:streams=4:anchor=0". Throws InputError naming `option` for unknown names and values out
// of range.
RowMethod parseRowMethod(const std::string& text, const std::string& option);
// Parses a variant for the rows of a picture. Throws InputError also for the error of subspan, which only the benchmark
// plans.
RowOptions parseMapping(const std::string& text, const std::string& option);
// Returns the names that parseMapping() knows.
std::vector<std::string> mappingNames();
// Returns the variants that `relief bench rows` measures by default.
std::vector<RowMethod> defaultRowMethods();

// Operations per pixel including restarts: the asymptotic cost of one more pixel, determined by running the variant
// with a counting scalar type. anchor: restart interval, pixels, 0: never; span: as resolved for the row.
struct PixelCounts {
    double mul = 0, add = 0, div = 0;
};
PixelCounts pixelCounts(const RowMethod& method, std::int64_t span, std::int64_t anchor);

}  // namespace relief
