// Pictures that somebody has looked at and found right: tests/files/figures/NAME.png. With RELIEF_GOLDEN=write in the
// environment they are stored instead of compared.
#pragma once

#include <functional>
#include <string>

#include <QString>

#include "painting/style.h"

class QPainter;

namespace reliefui {

// The bound leaves room for how processors round the smoothing of lines; a letter that moves by a pixel is 0.1 and
// more.
inline constexpr double kGoldenBound = 0.05;

// The mean FLIP of the block of 16 x 16 pixels that differs most, so that one number or mark that is elsewhere counts.
struct GoldenDifference {
    double flip = 0;
    int x = 0, y = 0;  // of the block
};

// Infinite where the sizes differ.
GoldenDifference goldenDifference(const QString& picture, const std::string& name);
// Fails the test where the picture differs by more than the bound, and keeps it in the folder for temporary files.
void expectGolden(const QString& picture, const std::string& name);

// What the function paints on a page of this size, pixels: in Ukrainian and light with the name, in English and dark
// with the name and "-english".
using PaintsPage = std::function<void(QPainter& painter, const Box& page, const Style& style)>;
void expectGoldens(const PaintsPage& paint, int width, int height, const std::string& name);

}  // namespace reliefui
