// Compile-time loop over an explicit list of types.
#pragma once

#include <tuple>

namespace relief {

// Calls visit.operator()<T>() for each T of List, a std::tuple, in order. No object of these types is constructed.
template <class List, class Visit>
void forEachType(const Visit& visit) {
    [&]<class... Types>(std::tuple<Types...>*) {
        (visit.template operator()<Types>(), ...);
    }(static_cast<List*>(nullptr));
}

}  // namespace relief
