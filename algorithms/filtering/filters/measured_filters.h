// The filters with the settings that are measured.
#pragma once

#include <vector>

#include "filtering/filters/filter_choice.h"

namespace relief {

// What `bench filters` and `recommend` try: Filter::benched() and Filter::advised(), settings as parseFilter() reads
// them behind the name. A filter without these functions is tried as it is by default.
std::vector<FilterChoice> benchedFilters();
std::vector<FilterChoice> advisedFilters();

}  // namespace relief
