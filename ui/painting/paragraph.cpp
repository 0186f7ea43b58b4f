#include "painting/paragraph.h"

#include "painting/text_width.h"

namespace reliefui {

void addParagraph(Drawing& drawing, Point middle, const relief::Message& words, double room, relief::Language language,
                  double size) {
    constexpr double kLine = 14;  // line height in points
    const auto lines = wrappedText(relief::sentence(words, language), room,
                                   [size](const std::string& line) { return textWidth(line, size); });
    double y = -kLine * size * (static_cast<double>(lines.size()) - 1) / 2;
    for (const std::string& line : lines) {
        Label label;
        label.at = middle;
        label.text = plainText(line);
        label.anchor = Anchor::Center;
        label.offset = {0, y};
        label.size = size;
        drawing.add({}, Role::Label, std::move(label));
        y += kLine * size;
    }
}

}  // namespace reliefui
