// Cached images of large grids of values: the visible part, at the resolution of the screen. An image is rendered again
// when another part comes into view.
#pragma once

#include <vector>

#include <QImage>
#include <QPainter>

#include "painting/style.h"
#include "painting/view_map.h"

namespace reliefui {

class CellPictures {
  public:
    // Starts one painting pass: begin(), any number of draw(), then end(), which drops images that were not drawn.
    void begin();
    // Draws the cells inside `screen` (pixels of the painter).
    void draw(QPainter& painter, const Cells& cells, const ViewMap& map, const Style& style, const Box& screen);
    void end();

  private:
    struct Picture {
        std::shared_ptr<const relief::FloatImage> values;
        ColorMap map = ColorMap::Height;
        HeightColors heights = HeightColors::Grey;
        Theme theme = Theme::Dark;
        ColorScale scale;
        CellRange range;  // cells covered by the image; empty before the first rendering
        int step = 1;     // cells per pixel
        QImage image;
        bool used = false;

        bool serves(const Cells& cells, const Style& style) const;
        void make(const Cells& cells, const Style& style, const CellRange& seen, int step);
    };
    std::vector<Picture> pictures_;
};

}  // namespace reliefui
