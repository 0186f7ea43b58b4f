#include "panes/figure.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <QPdfWriter>
#include <QSvgGenerator>

#include "painting/painter.h"
#include "relief/files.h"

namespace reliefui {

namespace {

using relief::InputError;
using relief::Message;
using relief::MessageId;

constexpr double kMmPerInch = 25.4;
constexpr double kPointsPerInch = 72;
// Units of a page of vectors: fine enough for text, whose sizes are whole numbers of them.
constexpr double kVectorDpi = 576;
constexpr double kLeastMm = 20;
constexpr double kMostMm = 2000;
constexpr double kLeastDpi = 20;
constexpr double kMostDpi = 2400;
constexpr double kMostPixels = 30000;  // a side

std::string endingOf(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

void paintPage(QPainter& painter, const Figure& figure, const FigurePage& page, const QSize& size,
               double unitsPerPoint) {
    Style style = page.style;
    style.projector = false;
    style.screenPixelsPerPoint = unitsPerPoint;
    const Box all{0, 0, static_cast<double>(size.width()), static_cast<double>(size.height())};
    painter.setClipRect(QRectF(0, 0, size.width(), size.height()));
    figure.paint(painter, all, style);
}

void writeSvg(const Figure& figure, const FigurePage& page, const std::string& file, const QSize& size) {
    QSvgGenerator svg;
    svg.setFileName(QString::fromStdString(file));
    svg.setResolution(static_cast<int>(kVectorDpi));
    svg.setSize(size);
    svg.setViewBox(QRect({0, 0}, size));
    svg.setTitle(QString::fromStdString(page.title));
    QPainter painter(&svg);
    paintPage(painter, figure, page, size, kVectorDpi / kPointsPerInch);
}

void writePdf(const Figure& figure, const FigurePage& page, const std::string& file, const QSizeF& mm) {
    QPdfWriter pdf(QString::fromStdString(file));
    pdf.setResolution(static_cast<int>(kVectorDpi));
    pdf.setPageSize(QPageSize(mm, QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
    pdf.setPageMargins(QMarginsF(0, 0, 0, 0));
    pdf.setTitle(QString::fromStdString(page.title));
    pdf.setCreator(QStringLiteral("Reliefscope"));
    QPainter painter(&pdf);
    paintPage(painter, figure, page, {pdf.width(), pdf.height()}, kVectorDpi / kPointsPerInch);
}

}  // namespace

void requireRange(const std::string& what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw InputError(what,
                     Message(MessageId::NumberOutOfRange, {{"value", value}, {"range", relief::rangeOf(low, high)}}));
}

void paintEmpty(QPainter& painter, MessageId why, const Box& page, const Style& style) {
    Drawing drawing;
    drawing.bounds = {0, 0, 300, 100};
    Label label;
    label.at = drawing.bounds.center();
    label.text = Message(why);
    label.anchor = Anchor::Center;
    drawing.add({}, Role::Label, std::move(label));
    paintFigure(painter, {&drawing}, {}, page, style);
}

QImage Figure::image(const FigurePage& page, const QSize& size) const {
    QImage image(size, QImage::Format_RGB32);
    const Rgba ground = page.style.background();
    image.fill(QColor(ground.r, ground.g, ground.b));
    const double dpi = size.width() / page.widthMm * kMmPerInch;
    const auto dots = static_cast<int>(std::lround(dpi / kMmPerInch * 1000));
    image.setDotsPerMeterX(dots);
    image.setDotsPerMeterY(dots);
    QPainter painter(&image);
    paintPage(painter, *this, page, size, dpi / kPointsPerInch);
    return image;
}

void checkPage(const FigurePage& page, const std::string& path, bool vectors) {
    const std::string ending = endingOf(path);
    if (ending != ".png" && (!vectors || (ending != ".svg" && ending != ".pdf"))) {
        const char* const known = vectors ? "svg, pdf, png" : "png";
        throw InputError(path, Message(MessageId::FormatUnknown, {{"extension", ending}, {"known", known}}));
    }
    requireRange("--width", page.widthMm, kLeastMm, kMostMm);
    requireRange("--dpi", page.dpi, kLeastDpi, kMostDpi);
    if (ending == ".png") {
        requireRange("--width", page.widthMm, kLeastMm, std::floor(kMostPixels / page.dpi * kMmPerInch));
    }
}

QImage figureImage(const Figure& figure, const FigurePage& page, int width) {
    return figure.image(page, {width, std::max(1, static_cast<int>(std::lround(width * figure.aspect(page))))});
}

void writeFigure(const Figure& figure, const FigurePage& page, const std::string& path) {
    checkPage(page, path, figure.vectors());
    relief::AtomicFile file(path);
    const std::string& target = file.temporaryPath();
    const std::string ending = endingOf(path);
    bool done = true;
    if (ending == ".png") {
        const int width = std::max(1, static_cast<int>(std::lround(page.widthMm / kMmPerInch * page.dpi)));
        done = figureImage(figure, page, width).save(QString::fromStdString(target), "PNG");
    } else {
        const QSizeF mm(page.widthMm, page.widthMm * figure.aspect(page));
        if (ending == ".svg") {
            writeSvg(figure, page, target, (mm / kMmPerInch * kVectorDpi).toSize());
        } else {
            writePdf(figure, page, target, mm);
        }
    }
    // Qt says nothing about a full disk; an empty file is no figure.
    std::error_code error;
    if (!done || std::filesystem::file_size(target, error) == 0 || error) {
        throw relief::WorkError(path, Message(MessageId::DiskFull));
    }
    file.commit();
}

}  // namespace reliefui
