// The quantities of lessons, a closed list: what texts and claims can name. FORMATS.md, "Lesson", describes each.
#pragma once

#include <string>
#include <vector>

#include "measuring/lesson/lesson.h"
#include "measuring/lesson/measured_scene.h"

namespace relief {

struct Quantity {
    using Measure = ExpressionValue (*)(const QuantityName& name, const Scenario& scenario, SceneCache& scenes,
                                        Work& work);

    std::string_view name;  // a name that ends in "." stands for all names that begin so
    std::size_t least = 0;  // number of arguments
    std::size_t most = 0;
    Measure measure = nullptr;
};
const std::vector<Quantity>& quantityList();
// Throws InputError for an unknown name, with the most similar one, and a wrong number of arguments.
const Quantity& findQuantity(const QuantityName& name);

// Returns a source that measures on `scenario`, and for @place on that page or variant of the lesson. The references
// are kept. Throws what the measurement throws; InputError for unknown names and places.
QuantitySource lessonSource(const Lesson& lesson, const Scenario& scenario, SceneCache& scenes, Work& work);

}  // namespace relief
