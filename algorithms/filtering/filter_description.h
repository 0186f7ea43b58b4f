// A filter and its options, described once. The command line, the window, tables and help are derived from this.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "relief/describe.h"

namespace relief {

// Name of the filter whose samples are rays; the renderer makes them.
inline constexpr std::string_view kSupersample = "supersample";

struct FilterDescription {
    std::string name;
    std::string title;  // human-readable, a few words
    std::string help;
    std::string source;
    bool footprint = false;                       // uses the pixel's projection onto the texture, and the mean pyramid
    bool ellipse = false;                         // sums the texels of an ellipse: footprints are counted and logged
    bool visible = false;                         // also leaves out what the relief hides
    std::vector<OptionDescription> options;       // of Filter::Options
    std::map<std::string, std::string> defaults;  // of the options, as text
};

// Options of filters without options.
struct NoFilterOptions {
    static std::vector<OptionField<NoFilterOptions>> fields() { return {}; }
};

// Filter::describe() together with the filter's options.
template <class Filter>
const FilterDescription& filterDescriptionOf() {
    static const FilterDescription description = [] {
        FilterDescription filter = Filter::describe();
        MethodDescription options;
        describeOptions<typename Filter::Options>(options);
        filter.options = std::move(options.options);
        filter.defaults = std::move(options.defaults);
        return filter;
    }();
    return description;
}

}  // namespace relief
