// Cached images of large grids of values: of the visible part, at the resolution of the screen. An image is made anew
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
    // A painting: begin, any number of draw, end, which forgets what was not drawn.
    void begin();
    // The part of the cells that lies in `screen` (pixels of the painter).
    void draw(QPainter& painter, const Cells& cells, const ViewMap& map, const Style& style, const Box& screen);
    void end();

  private:
    struct Picture {
        std::shared_ptr<const relief::FloatImage> values;
        ColorMap map = ColorMap::Height;
        HeightColors heights = HeightColors::Grey;
        Theme theme = Theme::Dark;
        ColorScale scale;
        CellRange range;  // of the cells that the image shows; empty: it was not made yet
        int step = 1;     // cells a pixel
        QImage image;
        bool used = false;

        bool serves(const Cells& cells, const Style& style) const;
        void make(const Cells& cells, const Style& style, const CellRange& seen, int step);
    };
    std::vector<Picture> pictures_;
};

}  // namespace reliefui
