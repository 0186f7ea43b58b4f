// Requirements on the text around every chart, in both languages.
#pragma once

#include <gtest/gtest.h>

#include "painting/text_width.h"
#include "painting/view_map.h"

namespace reliefui {

// Checks that all labels are inside the drawing, and that no two painted labels overlap. Labels that yield are left out
// where the painter does so. Labels on plates are marks, which may overlap.
inline void expectWordsInside(const Drawing& drawing) {
    for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
        std::vector<std::pair<Box, std::string>> taken;
        for (const bool strong : {true, false}) {
            for (const Item& item : drawing.items) {
                const auto* const label = std::get_if<Label>(&item.primitive);
                if (label == nullptr || label->plate || strong != (item.emphasis == Emphasis::Strong)) continue;
                const std::string text = labelText(*label, language);
                const double height = 10 * label->size;  // of the letters; the line height is larger
                const Box box = labelBox(*label, {}, textWidth(text, label->size, strong), height, 1);
                bool free = true;
                for (const auto& [other, words] : taken) {
                    const bool covers = other.grown(-0.5).overlaps(box);
                    free = free && !covers;
                    EXPECT_TRUE(label->yields || !covers) << text << " on " << words;
                }
                if (!free) continue;
                taken.emplace_back(box, text);
                const Box& all = drawing.bounds;
                EXPECT_GE(box.x0, all.x0 - 1) << text;
                EXPECT_LE(box.x1, all.x1 + 1) << text;
                EXPECT_GE(box.y0, all.y0 - 1) << text;
                EXPECT_LE(box.y1, all.y1 + 1) << text;
            }
        }
    }
}

}  // namespace reliefui
