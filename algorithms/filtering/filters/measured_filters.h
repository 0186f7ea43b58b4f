// The filters with the settings that are measured.
#pragma once

#include <vector>

#include "filtering/filters/filter_choice.h"

namespace relief {

// The settings that `bench filters` and `recommend` measure: Filter::benched() and Filter::advised() return them in the
// form that parseFilter() reads after the name. A filter without these functions is measured with its defaults.
std::vector<FilterChoice> benchedFilters();
std::vector<FilterChoice> advisedFilters();

}  // namespace relief
