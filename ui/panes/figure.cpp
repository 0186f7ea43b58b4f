#include "panes/figure.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <list>
#include <string_view>

#include <QBuffer>
#include <QFile>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "painting/painter.h"
#include "painting/tikz.h"
#include "panes/figure_formats.h"
#include "panes/pdf_date.h"
#include "relief/files.h"
#include "relief/memory.h"

namespace reliefui {

namespace {

using relief::InputError;
using relief::Message;
using relief::MessageId;

// Resolution of vector pages: fine enough for text, whose sizes are whole numbers of these units.
constexpr double kVectorDpi = 576;
constexpr double kLeastDpi = 20;
constexpr double kMostDpi = 2400;
constexpr double kMostPixels = 30000;  // per side

constexpr std::array<std::string_view, 3> kTexEndings{".tikz", ".tex", ".pgf"};

bool isTex(const std::string& ending) {
    return std::find(kTexEndings.begin(), kTexEndings.end(), ending) != kTexEndings.end();
}

std::string endingOf(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

Style pageStyle(const FigurePage& page, double unitsPerPoint) {
    Style style = page.style;
    style.projector = false;
    style.screenPixelsPerPoint = unitsPerPoint;
    return style;
}

// Layout of the caption below a figure: its font and height.
struct Caption {
    static constexpr double kPoints = 7;

    QString text;
    QFont font{QStringLiteral("DejaVu Sans")};
    QRectF room;        // box of the text
    double height = 0;  // including the margins; 0: there is no caption

    // width and unitsPerPoint: width of the page in its units, and units per point.
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
        // Letters may be slightly wider in the file than measured, so the box leaves some room.
        const QRectF words(room.x(), top + room.y(), width - 2 * room.x(), height);
        paintWords(painter, words, Qt::TextWordWrap, text);
    }
};

void paintPage(QPainter& painter, const Figure& figure, const FigurePage& page, const QSize& size,
               double unitsPerPoint) {
    painter.setRenderHint(QPainter::LosslessImageRendering);
    const Style style = pageStyle(page, unitsPerPoint);
    const Caption caption(figure, page, size.width(), unitsPerPoint);
    const double below = size.height() - caption.height;
    painter.save();
    painter.setClipRect(QRectF(0, 0, size.width(), below));
    figure.paint(painter, {0, 0, static_cast<double>(size.width()), below}, style);
    painter.restore();
    caption.paint(painter, below, size.width(), style);
}

// Page size in millimetres.
QSizeF pageSize(const Figure& figure, const FigurePage& page) {
    constexpr double kUnits = kVectorDpi / kPointsPerInch;
    const double width = page.widthMm / kMmPerPoint * kUnits;
    const Caption caption(figure, page, width, kUnits);
    return {page.widthMm, page.widthMm * figure.aspect(page) + caption.height / kUnits * kMmPerPoint};
}

// A file that refuses further writes after cancellation, which also ends the compression of a large picture; and that
// remembers failed writes, which Qt's writers of SVG and PDF ignore and QFile::close() forgets.
class FigureOutput : public QFile {
  public:
    FigureOutput(const std::string& path, const relief::Work& work)
        : QFile(QString::fromStdString(path)), work_(work) {}

    // Writes what is buffered and closes the file. Returns false if anything could not be written.
    bool finish() {
        const bool flushed = flush();
        complete_ = complete_ && flushed && error() == QFileDevice::NoError;
        close();
        return complete_ && error() == QFileDevice::NoError;
    }

  protected:
    qint64 writeData(const char* data, qint64 size) override {
        const qint64 written = work_.stopped() ? -1 : QFile::writeData(data, size);
        complete_ = complete_ && written == size;
        return written;
    }

  private:
    const relief::Work& work_;
    bool complete_ = true;
};

void writeSvg(const Figure& figure, const FigurePage& page, QIODevice& file, const QSize& size) {
    QSvgGenerator svg;
    svg.setOutputDevice(&file);
    svg.setResolution(static_cast<int>(kVectorDpi));
    svg.setSize(size);
    svg.setViewBox(QRect({0, 0}, size));
    svg.setTitle(QString::fromStdString(page.title));
    QPainter painter(&svg);
    paintPage(painter, figure, page, size, kVectorDpi / kPointsPerInch);
}

void writePdf(const Figure& figure, const FigurePage& page, QIODevice& file, const QSizeF& mm) {
    QBuffer written;  // because the date of the file is known to Qt alone
    written.open(QIODevice::WriteOnly);
    QPdfWriter pdf(&written);
    pdf.setResolution(static_cast<int>(kVectorDpi));
    pdf.setPageSize(QPageSize(mm, QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
    pdf.setPageMargins(QMarginsF(0, 0, 0, 0));
    pdf.setTitle(QString::fromStdString(page.title));
    pdf.setCreator(QStringLiteral("Reliefscope"));
    QPainter painter(&pdf);
    paintPage(painter, figure, page, {pdf.width(), pdf.height()}, kVectorDpi / kPointsPerInch);
    painter.end();
    file.write(withSourceDate(written.data()));
}

// Writes the temporary file of `target`; `write` returns false if it fails. path: for messages.
void fill(const relief::AtomicFile& target, const std::string& path, const relief::Work& work,
          const std::function<bool(QIODevice&)>& write) {
    FigureOutput file(target.temporaryPath(), work);
    const bool done = file.open(QIODevice::WriteOnly) && write(file);
    const bool written = file.finish();
    work.throwIfStopped();
    if (!done || !written || file.size() == 0) throw relief::WorkError(path, Message(MessageId::DiskFull));
}

// Beginning of the names of a figure's pictures: its file's name without characters that TeX does not read in names.
std::string pictureStem(const std::string& path) {
    std::string stem = std::filesystem::path(path).stem().string();
    for (char& c : stem) {
        if (std::string_view(" #$%&\\^_{}~\"'`,;=").find(c) != std::string_view::npos) c = '-';
    }
    return stem;
}

// Writes the picture files beside `path`, and the figure to the temporary file of `target`.
void writeTikz(const Figure& figure, const FigurePage& page, const relief::AtomicFile& target, const std::string& path,
               const QSize& size, const relief::Work& work) {
    constexpr double kUnits = kVectorDpi / kPointsPerInch;
    const std::filesystem::path file(path);
    TikzDevice tikz(size, kUnits, pictureStem(path));
    QPainter painter(&tikz);
    paintPage(painter, figure, page, size, kUnits);
    painter.end();
    std::list<relief::AtomicFile> pictures;
    for (const TikzDevice::Picture& picture : tikz.pictures()) {
        const std::string name = (file.parent_path() / picture.name).string();
        pictures.emplace_back(name);
        fill(pictures.back(), name, work, [&](QIODevice& out) { return picture.image.save(&out, "PNG"); });
    }
    const std::string text = tikz.file(file.filename().string(), page.title);
    fill(target, path, work, [&](QIODevice& out) {
        const auto bytes = static_cast<qint64>(text.size());
        return out.write(text.data(), bytes) == bytes;
    });
    for (relief::AtomicFile& picture : pictures) picture.commit();
}

}  // namespace

void requireRange(const std::string& what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw InputError(what,
                     Message(MessageId::NumberOutOfRange, {{"value", value}, {"range", relief::rangeOf(low, high)}}));
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

class ComputedFigure : public Figure {
  public:
    explicit ComputedFigure(FigureMaker make) : make_(std::move(make)) {}
    std::shared_ptr<const Figure> prepared(const FigurePage& page, relief::Work& work) const override {
        return make_(page, work);
    }
    void paint(QPainter&, const Box&, const Style&) const override { assert(!"it is prepared first"); }

  private:
    FigureMaker make_;
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
        return std::max(maker.aspect, maker.leastRoom * page.taller() + legendRoom(legend) / points);
    };
    return paintedFigure(paint, std::move(caption), aspect);
}

std::shared_ptr<const Figure> computedFigure(FigureMaker make) {
    return std::make_shared<ComputedFigure>(std::move(make));
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

double FigurePage::taller() const {
    constexpr double kMost = 1.6;
    return std::clamp(kFullFigureMm / widthMm, 1.0, kMost);
}

int FigurePage::picturePixels(double points) const {
    constexpr double kRounding = 1e-6;  // tolerance, for widths that are a whole number of pixels
    const double own = points * pixels() / (widthMm / kMmPerPoint);
    return std::clamp(static_cast<int>(std::floor(own + kRounding)), 1, kMostRenderedPixels);
}

void checkPage(const FigurePage& page, const std::string& path, bool vectors) {
    const std::string ending = endingOf(path);
    if (ending != ".png" && (!vectors || (ending != ".svg" && ending != ".pdf" && !isTex(ending)))) {
        const char* const known = vectors ? kVectorFormats : "png";
        throw InputError(path, Message(MessageId::FormatUnknown, {{"extension", ending}, {"known", known}}));
    }
    requireRange("--width", page.widthMm, kLeastFigureMm, kMostFigureMm);
    if (page.widthPixels == 0) requireRange("--dpi", page.dpi, kLeastDpi, kMostDpi);
    if (page.widthPixels == 0 && ending == ".png") {
        requireRange("--width", page.widthMm, kLeastFigureMm, std::floor(kMostPixels / page.dpi * kMmPerInch));
    }
}

namespace {

// Renders a figure that is already prepared for the page.
QImage preparedImage(const Figure& figure, const FigurePage& page) {
    const int width = page.pixels();
    const int height = std::max(1, static_cast<int>(std::lround(width * figure.aspect(page))));
    constexpr std::uint64_t kTwo = 8;  // bytes per pixel: the figure, and the page with its caption
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

}  // namespace

QImage figureImage(const Figure& figure, const FigurePage& requested, int width, relief::Work& work) {
    FigurePage page = requested;
    page.widthPixels = width;
    const auto prepared = figure.prepared(page, work);
    work.throwIfStopped();
    return preparedImage(prepared ? *prepared : figure, page);
}

void writeFigure(const Figure& requested, const FigurePage& page, const std::string& path, relief::Work& work) {
    checkPage(page, path, requested.vectors());
    const auto prepared = requested.prepared(page, work);
    const Figure& figure = prepared ? *prepared : requested;
    work.throwIfStopped();
    relief::AtomicFile target(path);
    const std::string ending = endingOf(path);
    const QSizeF mm = ending == ".png" ? QSizeF() : pageSize(figure, page);
    const QSize units = (mm / kMmPerInch * kVectorDpi).toSize();
    if (isTex(ending)) {
        writeTikz(figure, page, target, path, units, work);
    } else {
        fill(target, path, work, [&](QIODevice& file) {
            if (ending == ".png") return preparedImage(figure, page).save(&file, "PNG");
            ending == ".svg" ? writeSvg(figure, page, file, units) : writePdf(figure, page, file, mm);
            return true;
        });
    }
    target.commit();
}

}  // namespace reliefui
