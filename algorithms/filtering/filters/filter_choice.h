// The filter by name, and its settings: what scenarios, the command line and the window share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "filtering/filter_description.h"
#include "filtering/pixel_model.h"

namespace relief {

// Samples along each side of a pixel, at most.
inline constexpr int kMaxSamples = 64;

struct FilterChoice {
    std::string name = "bilinear";
    OptionValues options;                     // of the filter, name to text
    int samples = 8;                          // supersample: along each side of a pixel, 1 to kMaxSamples
    PixelModel pixelModel = PixelModel::Box;  // supersample
    bool operator==(const FilterChoice&) const = default;
};

const std::vector<FilterDescription>& filterList();
// Every filter as it is by default, and those that ask what is visible in each of their forms.
std::vector<FilterChoice> filterForms();
// Throws InputError(subject, ...) with the known names.
const FilterDescription& findFilter(std::string_view name, const std::string& subject = {});
// The name, the options and their values. Throws InputError; `subject` stands for what was given.
void checkFilter(const FilterChoice& choice, const std::string& subject);
// "elliptical:weights=uniform:radius=0.6". Throws InputError naming the subject.
FilterChoice parseFilter(std::string_view text, const std::string& subject);
// The same text back: the name, and the options that were given.
std::string filterText(const FilterChoice& choice);

}  // namespace relief
