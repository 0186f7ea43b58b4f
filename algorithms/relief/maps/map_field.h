// What a map states of the height field that it is built for.
#pragma once

#include "relief/height_field.h"

namespace relief {

// Sets surface, addressing and size of the field. Map: DistanceMap or ConeMap.
template <class Map>
void setField(Map& map, const HeightField& field) {
    map.surface = field.surface();
    map.address = field.address();
    map.fieldWidth = field.width();
    map.fieldHeight = field.height();
}

}  // namespace relief
