// Golden figures, which were checked by eye: tests/files/figures/NAME.png. With RELIEF_GOLDEN=write in the environment
// they are stored instead of compared.
#pragma once

#include <functional>
#include <string>

#include <QString>

#include "painting/style.h"

class QPainter;

namespace reliefui {

// Permits differences between processors in the antialiasing of lines; a letter moved by one pixel gives 0.1 or more.
inline constexpr double kGoldenBound = 0.05;

// The mean FLIP of the block of 16 x 16 pixels that differs most, so that a single moved number or mark is detected.
struct GoldenDifference {
    double flip = 0;
    int x = 0, y = 0;  // of the block
};

// Returns an infinite difference if the sizes differ.
GoldenDifference goldenDifference(const QString& picture, const std::string& name);
// Fails the test if the picture differs by more than the bound, and saves the picture in the folder for temporary
// files.
void expectGolden(const QString& picture, const std::string& name);

// Compares what the function paints on a page of this size, in pixels: in Ukrainian and light with NAME, in English and
// dark with NAME-english.
using PaintsPage = std::function<void(QPainter& painter, const Box& page, const Style& style)>;
void expectGoldens(const PaintsPage& paint, int width, int height, const std::string& name);

}  // namespace reliefui
