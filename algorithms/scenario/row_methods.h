// The row variants and the derivatives' as lists, command lines and tables take them: name, options, counts.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "mapping/rows/rows.h"
#include "relief/describe.h"

namespace relief {

// Settings of a row variant as texts know them; which of them a variant takes, its description says.
struct RowSettings {
    int streams = 16;
    int span = 16;
    double error = 0;
    int anchor = kRecommended;

    static std::vector<OptionField<RowSettings>> fields();
};

enum class DerivativeVariant : std::uint8_t { Direct, Iterative, Cached };
// Nothing computed, the same bytes written past the cache: the yardstick of rates.
struct RowFill {};

struct RowMethodDescription {
    std::string name;
    std::string title;
    std::string help;
    std::string counts;  // of a pixel, mul / add / div, without restarts
    std::string paper;   // the papers' own counts: mul / add / div, of derivatives mul / add / div / sub; empty: none
    std::string source;
    std::vector<OptionDescription> options;
    std::map<std::string, std::string> defaults;
    std::variant<RowVariant, DerivativeVariant, RowFill> kind;
};
// affine, direct, ... subspan, derivatives-direct, derivatives-iterative, derivatives-cached, fill.
const std::vector<RowMethodDescription>& rowMethodList();

struct RowMethod {
    const RowMethodDescription* description = nullptr;
    RowSettings settings;
    std::string text;  // as it was spelled

    // Of a row variant; span as given.
    RowOptions options() const;
};
// "streams", "streams:streams=4:anchor=0". Throws InputError naming `option`: unknown names, values out of range.
RowMethod parseRowMethod(const std::string& text, const std::string& option);
// Of the variants alone, as a picture's rows are made. error of subspan is the bench's: InputError.
RowOptions parseMapping(const std::string& text, const std::string& option);
// The names that parseMapping() knows.
std::vector<std::string> mappingNames();
// What `relief bench rows` measures by itself.
std::vector<RowMethod> defaultRowMethods();

// Operations a pixel, restarts in them: what one more pixel costs in the long run. By running the variant on a counting
// scalar. anchor: pixels, 0 for never; span as resolved.
struct PixelCounts {
    double mul = 0, add = 0, div = 0;
};
PixelCounts pixelCounts(const RowMethod& method, std::int64_t span, std::int64_t anchor);

}  // namespace relief
