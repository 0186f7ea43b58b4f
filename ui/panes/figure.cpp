#include "panes/figure.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <QPdfWriter>
#include <QSvgGenerator>

#include "painting/painter.h"
#include "relief/files.h"
#include "relief/memory.h"

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

// pictureDpi: as Style::pictureDpi.
Style pageStyle(const FigurePage& page, double unitsPerPoint, double pictureDpi = 0) {
    Style style = page.style;
    style.projector = false;
    style.screenPixelsPerPoint = unitsPerPoint;
    style.pictureDpi = pictureDpi;
    return style;
}

// Where the caption stands below a figure; its font and height.
struct Caption {
    static constexpr double kPoints = 7;

    QString text;
    QFont font{QStringLiteral("DejaVu Sans")};
    QRectF room;        // of the words
    double height = 0;  // with what is left free around them; 0: there is none

    // In units of which so many are a point; the page is `width` of them wide.
    Caption(const Figure& figure, const FigurePage& page, double width, double unitsPerPoint) {
        if (page.caption) text = QString::fromStdString(figure.caption(page.style.language));
        if (text.isEmpty()) return;
        font.setPixelSize(std::max(1, static_cast<int>(std::lround(kPoints * unitsPerPoint))));
        const double margin = kFigureMargin * unitsPerPoint;
        const QRectF most(margin, margin / 2, std::max(1.0, width - 2 * margin), 1e6);
        room = QFontMetricsF(font).boundingRect(most, Qt::TextWordWrap, text);
        height = std::ceil(room.height() + margin * 1.5);
    }
    void paint(QPainter& painter, double top, double width, const Style& style) const {
        if (height <= 0) return;
        const QRectF all(0, top, width, height);
        painter.fillRect(all, toColor(style.background()));
        painter.setFont(font);
        painter.setPen(toColor(style.text()));
        // Letters may be a little wider in the file than they were measured.
        const QRectF words(room.x(), top + room.y(), width - 2 * room.x(), height);
        painter.drawText(words, Qt::TextWordWrap, text);
    }
};

void paintPage(QPainter& painter, const Figure& figure, const FigurePage& page, const QSize& size,
               double unitsPerPoint) {
    painter.setRenderHint(QPainter::LosslessImageRendering);
    const Style style = pageStyle(page, unitsPerPoint, page.pixels() / page.widthMm * kMmPerInch);
    const Caption caption(figure, page, size.width(), unitsPerPoint);
    const double below = size.height() - caption.height;
    painter.save();
    painter.setClipRect(QRectF(0, 0, size.width(), below));
    figure.paint(painter, {0, 0, static_cast<double>(size.width()), below}, style);
    painter.restore();
    caption.paint(painter, below, size.width(), style);
}

// Millimetres.
QSizeF pageSize(const Figure& figure, const FigurePage& page) {
    constexpr double kUnits = kVectorDpi / kPointsPerInch;
    const double width = page.widthMm / kMmPerPoint * kUnits;
    const Caption caption(figure, page, width, kUnits);
    return {page.widthMm, page.widthMm * figure.aspect(page) + caption.height / kUnits * kMmPerPoint};
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

void emptyFigure(const char* name, MessageId why) {
    throw InputError(std::string("--export ") + name, Message(why));
}

namespace {

class PaintedFigure : public Figure {
  public:
    PaintedFigure(PagePainter paint, FigureCaption caption, PageAspect aspect)
        : paint_(std::move(paint)), caption_(std::move(caption)), aspect_(std::move(aspect)) {}
    double aspect(const FigurePage& page) const override { return aspect_ ? aspect_(page) : Figure::aspect(page); }
    void paint(QPainter& painter, const Box& page, const Style& style) const override { paint_(painter, page, style); }

    std::string caption(relief::Language language) const override {
        return caption_ ? caption_(language) : std::string();
    }

  private:
    PagePainter paint_;
    FigureCaption caption_;
    PageAspect aspect_;
};

}  // namespace

std::shared_ptr<const Figure> paintedFigure(PagePainter paint, FigureCaption caption, PageAspect aspect) {
    return std::make_shared<PaintedFigure>(std::move(paint), std::move(caption), std::move(aspect));
}

std::shared_ptr<const Figure> chartFigure(ChartMaker maker, FigureCaption caption) {
    const auto paint = [maker](QPainter& painter, const Box& page, const Style& style) {
        const double unit = style.pixelsPerPoint();
        const Drawing legend = maker.legend(page.width() / unit - kFigureMargins, style.language);
        const Box room = figureRoom(legend, page, style);
        const std::vector<Drawing> layers = maker.layers(room.width() / unit, room.height() / unit, style);
        std::vector<const Drawing*> all;
        for (const Drawing& layer : layers) all.push_back(&layer);
        paintFigure(painter, all, legend, page, style);
    };
    const auto aspect = [maker](const FigurePage& page) {
        const double points = page.widthMm / kMmPerPoint;
        const Drawing legend = maker.legend(points - kFigureMargins, page.style.language);
        return std::max(maker.aspect, maker.leastRoom + (legend.bounds.height() + 1.5 * kFigureMargins) / points);
    };
    return paintedFigure(paint, std::move(caption), aspect);
}

QImage Figure::image(const FigurePage& page, const QSize& size) const {
    QImage image(size, QImage::Format_RGB32);
    image.fill(toColor(page.style.background()));
    const double dpi = size.width() / page.widthMm * kMmPerInch;
    const auto dots = static_cast<int>(std::lround(dpi / kMmPerInch * 1000));
    image.setDotsPerMeterX(dots);
    image.setDotsPerMeterY(dots);
    QPainter painter(&image);
    paint(painter, {0, 0, static_cast<double>(size.width()), static_cast<double>(size.height())},
          pageStyle(page, dpi / kPointsPerInch));
    return image;
}

int FigurePage::pixels() const {
    if (widthPixels > 0) return widthPixels;
    return std::max(1, static_cast<int>(std::lround(widthMm / kMmPerInch * dpi)));
}

void checkPage(const FigurePage& page, const std::string& path, bool vectors) {
    const std::string ending = endingOf(path);
    if (ending != ".png" && (!vectors || (ending != ".svg" && ending != ".pdf"))) {
        const char* const known = vectors ? "svg, pdf, png" : "png";
        throw InputError(path, Message(MessageId::FormatUnknown, {{"extension", ending}, {"known", known}}));
    }
    requireRange("--width", page.widthMm, kLeastMm, kMostMm);
    if (page.widthPixels == 0) requireRange("--dpi", page.dpi, kLeastDpi, kMostDpi);
    if (page.widthPixels == 0 && ending == ".png") {
        requireRange("--width", page.widthMm, kLeastMm, std::floor(kMostPixels / page.dpi * kMmPerInch));
    }
}

QImage figureImage(const Figure& figure, const FigurePage& wanted, int width) {
    FigurePage page = wanted;
    page.widthPixels = width;
    const int height = std::max(1, static_cast<int>(std::lround(width * figure.aspect(page))));
    constexpr std::uint64_t kTwo = 8;  // bytes a pixel: the figure, and the page with its caption
    relief::requireMemory(
        relief::byteProduct({kTwo, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height)}),
        std::to_string(width) + "x" + std::to_string(height), relief::MemoryHint::SmallerPicture);
    QImage body = figure.image(page, {width, height});
    const double pixelsPerPoint = width / (page.widthMm / kMmPerPoint);
    const Caption caption(figure, page, width, pixelsPerPoint);
    if (caption.height <= 0) return body;
    QImage whole(width, body.height() + static_cast<int>(caption.height), body.format());
    whole.setDotsPerMeterX(body.dotsPerMeterX());
    whole.setDotsPerMeterY(body.dotsPerMeterY());
    QPainter painter(&whole);
    painter.drawImage(0, 0, body);
    caption.paint(painter, body.height(), width, pageStyle(page, pixelsPerPoint));
    return whole;
}

void writeFigure(const Figure& figure, const FigurePage& page, const std::string& path) {
    checkPage(page, path, figure.vectors());
    relief::AtomicFile file(path);
    const std::string& target = file.temporaryPath();
    const std::string ending = endingOf(path);
    bool done = true;
    if (ending == ".png") {
        done = figureImage(figure, page, page.pixels()).save(QString::fromStdString(target), "PNG");
    } else {
        const QSizeF mm = pageSize(figure, page);
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
