// A bilinear height field as lanes read its slopes; pointers are not owned.
#pragma once

#include <cstdint>

#include "relief/height_field.h"

namespace relief {

struct SlopeScene {
    const float* heights = nullptr;
    std::int32_t width = 0, height = 0;
    bool repeat = true;  // else clamped, as border is

    SlopeScene() = default;
    explicit SlopeScene(const HeightField& field)
        : heights(field.heights().data()),
          width(field.width()),
          height(field.height()),
          repeat(field.address() == Address::Repeat) {}
};

}  // namespace relief
