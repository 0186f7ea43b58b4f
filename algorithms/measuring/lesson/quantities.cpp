#include "measuring/lesson/quantities.h"

#include <algorithm>

#include "measuring/lesson/quantity_query.h"

namespace relief {

const std::vector<Quantity>& quantityList() {
    static const std::vector<Quantity> list = [] {
        std::vector<Quantity> all;
        for (auto&& part : {sceneQuantities(), rayQuantities(), frameQuantities()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return list;
}

const Quantity& findQuantity(const QuantityName& name) {
    const auto& list = quantityList();
    const auto found = std::find_if(list.begin(), list.end(), [&](const Quantity& one) {
        return one.name.ends_with('.') ? name.name.starts_with(one.name) : one.name == name.name;
    });
    if (found == list.end()) {
        std::vector<std::string> known;
        for (const Quantity& one : list) known.emplace_back(one.name);
        throw InputError("", unknownName({"what", MessageId::WordQuantity}, name.name, commaList(known)));
    }
    if (name.arguments.size() < found->least || name.arguments.size() > found->most) {
        throw InputError(name.name,
                         Message(MessageId::LessonArguments,
                                 {{"count", name.arguments.size()}, {"range", rangeOf(found->least, found->most)}}));
    }
    return *found;
}

QuantitySource lessonSource(const Lesson& lesson, const Scenario& scenario, SceneCache& scenes, Work& work) {
    return [&lesson, scenario, &scenes, &work](const QuantityName& name) {
        const Quantity& quantity = findQuantity(name);
        if (name.place.empty()) return quantity.measure(name, scenario, scenes, work);
        const auto placed = lesson.scenarioAt(name.place, scenario);
        if (!placed) {
            std::vector<std::string> known;
            for (const auto& variant : lesson.variants) known.push_back(variant.first);
            for (const LessonPage& page : lesson.pages) known.push_back(page.name);
            throw InputError("", unknownName({"what", MessageId::WordPlace}, name.place, commaList(known)));
        }
        return quantity.measure(name, *placed, scenes, work);
    };
}

}  // namespace relief
