// Figures that somebody has looked at and found right.
#pragma once

#include <functional>
#include <string>

#include <QString>

#include "painting/style.h"

class QPainter;

namespace reliefui {

// Compares an exported figure with tests/files/figures/NAME.png, which somebody has looked at and found right, by the
// mean FLIP of each block of 16 x 16 pixels, so that one number or mark that is elsewhere counts. The bound leaves room
// for how processors round the smoothing of lines; a letter that moves by a pixel is 0.1 and more.
void expectGolden(const QString& exported, const std::string& name);

// What the function paints on a page of this size, pixels: in Ukrainian and light with the name, in English and dark
// with the name and "-english".
using PaintsPage = std::function<void(QPainter& painter, const Box& page, const Style& style)>;
void expectGoldens(const PaintsPage& paint, int width, int height, const std::string& name);

}  // namespace reliefui
