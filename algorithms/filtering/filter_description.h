// A filter and its options, described once: the command line, the window, tables and help derive from this.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "relief/describe.h"

namespace relief {

// The filter whose samples are rays: the renderer's, not the texture's.
inline constexpr std::string_view kSupersample = "supersample";

struct FilterDescription {
    std::string name;
    std::string help;
    std::string source;
    bool footprint = false;                  // reads the pixel's projection onto the texture, from the mean pyramid
    bool ellipse = false;                    // reads the texels of an ellipse: footprints are counted and logged
    bool visible = false;                    // and what the relief hides of it
    std::vector<OptionDescription> options;  // of Filter::Options
    std::map<std::string, std::string> defaults;  // of the options, as text
};

// Of filters without options.
struct NoFilterOptions {
    static std::vector<OptionField<NoFilterOptions>> fields() { return {}; }
};

// What Filter::describe() says, and its options.
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
