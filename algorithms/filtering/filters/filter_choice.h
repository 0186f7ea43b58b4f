// A filter by name with its settings, as used by scenarios, the command line and the window.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "filtering/filter_description.h"
#include "filtering/pixel_model.h"

namespace relief {

// Largest number of samples along each side of a pixel.
inline constexpr int kMaxSamples = 64;

struct FilterChoice {
    std::string name = "bilinear";
    OptionValues options;                     // of the filter, name to text
    int samples = 8;                          // supersample: along each side of a pixel, 1 to kMaxSamples
    PixelModel pixelModel = PixelModel::Box;  // supersample
    bool operator==(const FilterChoice&) const = default;
};

const std::vector<FilterDescription>& filterList();
// Every filter with its default options, and those with an option `form` and a test of visibility in each form.
std::vector<FilterChoice> filterForms();
// Finds a filter by name. Throws InputError(subject, ...) with a list of the known names.
const FilterDescription& findFilter(std::string_view name, const std::string& subject = {});
// Checks the name, the options and their values. Throws InputError naming the subject.
void checkFilter(const FilterChoice& choice, const std::string& subject);
// Parses text such as "elliptical:weights=uniform:radius=0.6". Throws InputError naming the subject.
FilterChoice parseFilter(std::string_view text, const std::string& subject);
// The inverse of parseFilter(): the name, and the options that were given.
std::string filterText(const FilterChoice& choice);

}  // namespace relief
