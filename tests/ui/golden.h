// Figures held against stored ones.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <QDir>
#include <QImage>

#include "images/image.h"
#include "measuring/flip.h"

namespace reliefui {

inline relief::ColorImage linearColors(const QImage& image) {
    relief::ColorImage colors(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor color = image.pixelColor(x, y);
            const auto linear = [](double v) {
                return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
            };
            colors(x, y) = {linear(color.redF()), linear(color.greenF()), linear(color.blueF())};
        }
    }
    return colors;
}

// FOLDER/NAME.png is what the figure looked like when somebody last looked at it and found it right.
// Bound: the mean FLIP of a block of 16 x 16 pixels, so that one number or mark that is elsewhere counts. It leaves
// room for how processors round the smoothing of lines in 3-D; a letter that moves by a pixel is 0.1 and more.
// RELIEF_GOLDEN=write stores the figures anew: look at them before they are committed.
inline void expectGolden(const QImage& image, const QString& folder, const std::string& name) {
    constexpr int kBlock = 16;
    constexpr double kBound = 0.05, kPixelsPerDegree = 67;
    const QString file = folder + QString::fromStdString("/" + name + ".png");
    if (const char* wish = std::getenv("RELIEF_GOLDEN"); wish != nullptr && std::string(wish) == "write") {
        ASSERT_TRUE(image.save(file)) << file.toStdString();
        return;
    }
    const QImage golden(file);
    ASSERT_EQ(golden.size(), image.size()) << file.toStdString();
    relief::Work work(1);
    const relief::FloatImage errors =
        relief::flipErrors(linearColors(golden), linearColors(image), kPixelsPerDegree, work);
    for (int y0 = 0; y0 < image.height(); y0 += kBlock) {
        for (int x0 = 0; x0 < image.width(); x0 += kBlock) {
            const int x1 = std::min(x0 + kBlock, image.width()), y1 = std::min(y0 + kBlock, image.height());
            double sum = 0;
            for (int y = y0; y < y1; ++y) {
                for (int x = x0; x < x1; ++x) sum += static_cast<double>(errors(x, y));
            }
            const double mean = sum / ((x1 - x0) * (y1 - y0));
            if (mean <= kBound) continue;
            const QString seen = QDir::temp().filePath(QString::fromStdString("relief-" + name + ".png"));
            image.save(seen);
            FAIL() << name << " is not as stored: FLIP " << mean << " at " << x0 << ", " << y0 << "; it is in "
                   << seen.toStdString();
        }
    }
}

}  // namespace reliefui
