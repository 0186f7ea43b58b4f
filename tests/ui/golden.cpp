#include "golden.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <QPainter>
#include <QTemporaryDir>

#include "measuring/compare/flip.h"
#include "relief/files.h"

namespace reliefui {

namespace {

std::string storedFile(const std::string& name) {
    return RELIEF_SOURCE "/tests/files/figures/" + name + ".png";
}

void copyOver(const QString& from, const std::filesystem::path& to) {
    std::filesystem::copy_file(from.toStdString(), to, std::filesystem::copy_options::overwrite_existing);
}

}  // namespace

GoldenDifference goldenDifference(const QString& picture, const std::string& name) {
    constexpr int kBlock = 16;
    constexpr double kPixelsPerDegree = 67;
    relief::Work work(1);
    const relief::ColorImage expected = relief::readColor(storedFile(name), work);
    const relief::ColorImage seen = relief::readColor(picture.toStdString(), work);
    if (expected.width() != seen.width() || expected.height() != seen.height()) return {HUGE_VAL, 0, 0};
    const relief::FloatImage errors = relief::flipErrors(expected, seen, kPixelsPerDegree, work);
    GoldenDifference most;
    for (int y0 = 0; y0 < errors.height(); y0 += kBlock) {
        for (int x0 = 0; x0 < errors.width(); x0 += kBlock) {
            const int x1 = std::min(x0 + kBlock, errors.width()), y1 = std::min(y0 + kBlock, errors.height());
            double sum = 0;
            for (int y = y0; y < y1; ++y) {
                for (int x = x0; x < x1; ++x) sum += static_cast<double>(errors(x, y));
            }
            const double mean = sum / ((x1 - x0) * (y1 - y0));
            if (mean > most.flip) most = {mean, x0, y0};
        }
    }
    return most;
}

void expectGolden(const QString& picture, const std::string& name) {
    if (const char* wish = std::getenv("RELIEF_GOLDEN"); wish != nullptr && std::string(wish) == "write") {
        return copyOver(picture, storedFile(name));
    }
    const auto kept = std::filesystem::temp_directory_path() / ("relief-" + name + ".png");
    if (!std::filesystem::exists(storedFile(name))) {
        copyOver(picture, kept);
        ADD_FAILURE() << "there is no " << storedFile(name) << " yet; look at " << kept
                      << ", then run this test with RELIEF_GOLDEN=write, which stores it";
        return;
    }
    const GoldenDifference most = goldenDifference(picture, name);
    if (most.flip <= kGoldenBound) return;
    copyOver(picture, kept);
    ADD_FAILURE() << name << " is not as stored: FLIP " << most.flip << " at " << most.x << ", " << most.y
                  << "; it is in " << kept << " (with RELIEF_GOLDEN=write it is stored)";
}

void expectGoldens(const PaintsPage& paint, int width, int height, const std::string& name) {
    const QTemporaryDir folder;
    for (const bool english : {false, true}) {
        Style style;
        style.theme = english ? Theme::Dark : Theme::Light;
        style.language = english ? relief::Language::English : relief::Language::Ukrainian;
        style.screenPixelsPerPoint = 80.0 / 72;
        QImage image(width, height, QImage::Format_RGB32);
        QPainter painter(&image);
        paint(painter, {0, 0, double(width), double(height)}, style);
        painter.end();
        const QString file = folder.filePath(QStringLiteral("figure.png"));
        ASSERT_TRUE(image.save(file));
        expectGolden(file, english ? name + "-english" : name);
    }
}

}  // namespace reliefui
