#include "views/figure.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <QPdfWriter>
#include <QSvgGenerator>

#include "drawings/painter.h"
#include "measuring/bench/bench_rows.h"
#include "relief/files.h"
#include "relief/tracers/map_choice.h"
#include "views/distance_maps.h"
#include "views/figure_parts.h"
#include "views/point_asker.h"
#include "views/result_painting.h"

namespace reliefui {

namespace {

using relief::InputError;
using relief::Message;
using relief::MessageId;

constexpr double kMmPerInch = 25.4;
constexpr double kPointsPerInch = 72;
// Units of a page of vectors: fine enough for text, whose sizes are whole numbers of them.
constexpr double kVectorDpi = 576;
constexpr double kRowsAspect = 0.78;    // two plots, and what they cost
constexpr double kParetoAspect = 0.68;  // names beside their marks
constexpr double kChartsAspect = 0.95;  // and histograms below
constexpr double kTraceAspect = 0.75;
constexpr double kSlabsAspect = 0.5;
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

// Drawn by OpenGL: pixels alone.
bool inSpace(const FigureRequest& request) {
    return request.view == "trace" || request.view == "slabs";
}

double aspectOf(const Snapshot& snapshot, const FigureRequest& request) {
    if (request.view == "rows") return kRowsAspect;
    if (request.view == "pareto") return kParetoAspect;
    if (request.view == "charts") return kChartsAspect;
    if (request.view == "compare" && request.compare)
        return compareAspect(*request.compare, snapshot.scenario.comparison.mode);
    if (request.view == "pyramid") return pyramidAspect(snapshot, request);
    if (request.view == "trace") return kTraceAspect;
    if (request.view == "slabs") return kSlabsAspect;
    if (request.view == "steps" || request.view == "skipped") return tableAspect(snapshot, request);
    if (request.view != "result") return kDrawingAspect;
    return resultAspect(snapshot, request);
}

void paintProfile(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
                  const Style& style) {
    const ProfileOptions& options = request.profile;
    ProfileSource source = profileSource(snapshot);
    if (!source.hasRay) {
        const Drawing empty = emptyDrawing(snapshot.scenario.pixel ? MessageId::DrawNoRelief : MessageId::DrawNoRay);
        paintFigure(painter, {&empty}, {}, page, style);
        return;
    }
    relief::Work work;
    source.point = pointOf(snapshot, request.query, work);
    const double unit = style.pixelsPerPoint();
    const Drawing legend = profileLegend(source, options, page.width() / unit - 12, style.language);
    const Box room = figureRoom(legend, page, style);
    const ProfileFrame frame = profileFrame(source, options, room.width() / unit, room.height() / unit);
    const Drawing relief = profileRelief(source, options, frame);
    const Drawing marks = profileMarks(source, options, frame, snapshot.scenario.step);
    const Drawing axes = profileAxes(source, frame);
    paintFigure(painter, {&relief, &axes, &marks}, legend, page, style);
}

void paintDistance(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
                   const Style& style) {
    const DistanceOptions& options = request.distance;
    relief::Work work;
    const DistanceMaps maps = distanceMaps(snapshot, options, {}, work);
    DistanceSource source = distanceSource(snapshot, maps);
    source.point = pointOf(snapshot, request.query, work);
    const double unit = style.pixelsPerPoint();
    const int step = snapshot.scenario.step;
    const auto pictureIn = [&](const Box& room) {
        return distancePicture(source, options, step, room.width() / unit, room.height() / unit, style.language);
    };
    // What the legend names does not depend on the room.
    const Drawing legend =
        distanceLegend(source, pictureIn(figureRoom({}, page, style)), page.width() / unit - 12, style.language);
    const DistancePicture picture = pictureIn(figureRoom(legend, page, style));
    const Drawing marks = distanceMarks(source, picture.frame, step);
    paintFigure(painter, {&picture.drawing, &marks}, legend, page, style);
}

void paintRows(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
               const Style& style) {
    const std::optional<RowsPlace> place = rowsPlace(snapshot);
    const std::vector<relief::RowMethod> methods = rowMethods(request.rows, "--variants");
    if (!place || methods.empty()) {
        const Drawing empty = emptyDrawing(place                     ? MessageId::DrawRowNoVariant
                                           : snapshot.scenario.pixel ? MessageId::DrawNoRelief
                                                                     : MessageId::DrawNoRow);
        paintFigure(painter, {&empty}, {}, page, style);
        return;
    }
    const RowsData data = rowsData(widened(*place, request.rows.pixels), methods, request.rows.inDouble);
    const double unit = style.pixelsPerPoint();
    const Drawing legend = rowsLegend(data, page.width() / unit - 12, style.language);
    const Box room = figureRoom(legend, page, style);
    const RowsFrame frame = rowsFrame(data, request.rows, request.rowsRange, room.width() / unit, room.height() / unit);
    const Drawing axes = rowsAxes(data, frame);
    const Drawing plots = rowsPlots(data, frame);
    paintFigure(painter, {&axes, &plots}, legend, page, style);
}

void paintCharts(QPainter& painter, const ChartsSource& source, const Box& page, const Style& style) {
    const double unit = style.pixelsPerPoint();
    const Drawing legend = chartsLegend(source, page.width() / unit - 12, style.language);
    const Box room = figureRoom(legend, page, style);
    const ChartsPicture picture = chartsPicture(source, room.width() / unit, room.height() / unit);
    paintFigure(painter, {&picture.drawing}, legend, page, style);
}

void paintFootprint(QPainter& painter, const Snapshot& snapshot, const FootprintOptions& options, const Box& page,
                    const Style& style) {
    if (!snapshot.footprint) {
        const bool hit = snapshot.trace.onRelief;
        const MessageId why = hit ? MessageId::DrawFootprintNoHit : MessageId::DrawNoRelief;
        const Drawing empty = emptyDrawing(snapshot.scenario.pixel ? why : MessageId::DrawFootprintNoPixel);
        paintFigure(painter, {&empty}, {}, page, style);
        return;
    }
    const PixelFootprint& footprint = *snapshot.footprint;
    const double width = page.width() / style.pixelsPerPoint() - 12;
    FootprintOptions named = options;
    named.numbers = true;
    Drawing legend = footprintLegend(footprint, named, true, width, style.language);
    const Box room = figureRoom(legend, page, style);
    const Drawing texture = footprintTexture(footprint, room.width() / room.height());
    const double scale = ViewMap::fitting(texture.bounds, room).scale / style.pixelsPerPoint();
    const FootprintMarks marks = footprintMarks(footprint, options, texture.bounds, scale);
    if (!marks.weights) legend = footprintLegend(footprint, named, false, width, style.language);
    painter.save();
    painter.setClipRect(QRectF(page.x0, page.y0, page.width(), page.height()));
    paintFigure(painter, {&texture, &marks.drawing}, legend, page, style);
    painter.restore();
}

void paintView(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
               double unitsPerPoint) {
    Style style = request.style;
    style.projector = false;
    style.screenPixelsPerPoint = unitsPerPoint;
    painter.setClipRect(QRectF(page.x0, page.y0, page.width(), page.height()));
    if (request.view == "result") {
        paintResult(painter, snapshot, page, style);
    } else if (request.view == "pyramid") {
        paintPyramid(painter, snapshot, request.pyramid, page, style);
    } else if (request.view == "distance") {
        paintDistance(painter, snapshot, request, page, style);
    } else if (request.view == "rows") {
        paintRows(painter, snapshot, request, page, style);
    } else if (request.view == "pareto" || request.view == "charts") {
        paintCharts(painter, *request.charts, page, style);
    } else if (request.view == "compare") {
        paintComparison(painter, snapshot, request, page, style);
    } else if (request.view == "drawn") {
        paintByHand(painter, snapshot, page, style);
    } else if (request.view == "duel") {
        paintDuel(painter, snapshot, request, page, style);
    } else if (request.view == "steps" || request.view == "skipped") {
        paintTable(painter, snapshot, request, page, style);
    } else if (request.view == "footprint") {
        paintFootprint(painter, snapshot, request.footprint, page, style);
    } else {
        paintProfile(painter, snapshot, request, page, style);
    }
}

void writeSvg(const Snapshot& snapshot, const FigureRequest& request, const std::string& file, const QSize& size) {
    QSvgGenerator svg;
    svg.setFileName(QString::fromStdString(file));
    svg.setResolution(static_cast<int>(kVectorDpi));
    svg.setSize(size);
    svg.setViewBox(QRect({0, 0}, size));
    svg.setTitle(QString::fromStdString(request.view));
    QPainter painter(&svg);
    paintView(painter, snapshot, request, {0, 0, double(size.width()), double(size.height())},
              kVectorDpi / kPointsPerInch);
}

void writePdf(const Snapshot& snapshot, const FigureRequest& request, const std::string& file, const QSizeF& mm) {
    QPdfWriter pdf(QString::fromStdString(file));
    pdf.setResolution(static_cast<int>(kVectorDpi));
    pdf.setPageSize(QPageSize(mm, QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
    pdf.setPageMargins(QMarginsF(0, 0, 0, 0));
    pdf.setTitle(QString::fromStdString(request.view));
    pdf.setCreator(QStringLiteral("Reliefscope"));
    QPainter painter(&pdf);
    paintView(painter, snapshot, request, {0, 0, double(pdf.width()), double(pdf.height())},
              kVectorDpi / kPointsPerInch);
}

void requireRange(const std::string& what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    const std::string range = relief::numberText(low) + " to " + relief::numberText(high);
    throw InputError(what, Message(MessageId::NumberOutOfRange, {{"value", value}, {"range", range}}));
}

}  // namespace

PyramidSource pyramidSource(const Snapshot& s, const PyramidOptions& options) {
    PyramidSource source;
    source.field = &s.request->field;
    source.overCells = options.kind == relief::PyramidKind::Max;
    source.pyramid = source.overCells ? std::shared_ptr<const relief::Pyramid>(s.maxima, &s.maxima->pyramid)
                                      : (options.kind == relief::PyramidKind::Mean ? s.means : s.minima);
    source.hasRay = s.trace.onRelief;
    source.ray = s.trace.ray;
    source.hit = s.trace.hit;
    source.steps = &s.trace.steps;
    source.baseLevel = s.trace.baseLevel;
    source.nearRay = options.nearRay;
    return source;
}

ProfileSource profileSource(const Snapshot& s) {
    ProfileSource source;
    source.field = &s.request->field;
    source.maxima = s.maxima;
    source.hasRay = s.trace.onRelief;
    source.ray = s.trace.ray;
    source.hit = s.trace.hit;
    if (!s.trace.hidden) source.exact = s.trace.exact;
    source.steps = &s.trace.steps;
    return source;
}

std::optional<RowsPlace> rowsPlace(const Snapshot& s) {
    if (!s.scenario.pixel || !s.frame || s.coarse) return std::nullopt;
    const relief::PixelChoice pixel = *s.scenario.pixel;
    const relief::VisiblePolygons visible = s.frame->visible(*s.request);
    const relief::VisiblePolygon* polygon = visible.at(pixel.x, pixel.y, s.frame->width);
    if (polygon == nullptr) return std::nullopt;
    RowsPlace place;
    place.map = polygon->texelFromScreen;
    place.y = pixel.y + 0.5;
    place.line = pixel.y;
    place.span = polygon->span(pixel.y, s.frame->width);
    place.width = s.frame->width;
    place.chosen = pixel.x;
    return place;
}

const std::vector<std::string>& figureViews() {
    static const std::vector<std::string> kViews{"charts",    "compare", "distance", "drawn",   "duel",
                                                 "footprint", "pareto",  "profile",  "pyramid", "result",
                                                 "rows",      "skipped", "slabs",    "steps",   "trace"};
    return kViews;
}

void checkFigure(const FigureRequest& request, const std::string& path) {
    const std::vector<std::string>& views = figureViews();
    if (std::find(views.begin(), views.end(), request.view) == views.end()) {
        throw InputError("--export",
                         Message(MessageId::UnknownName,
                                 {{"what", "view"}, {"name", request.view}, {"known", relief::commaList(views)}}));
    }
    const std::string ending = endingOf(path);
    const bool solid = inSpace(request);
    if (ending != ".png" && (solid || (ending != ".svg" && ending != ".pdf"))) {
        const char* const known = solid ? "png" : "svg, pdf, png";
        throw InputError(path, Message(MessageId::FormatUnknown, {{"extension", ending}, {"known", known}}));
    }
    for (const std::string& kind : {request.distance.kind, request.distance.minus}) {
        if (!kind.empty()) relief::methodOfMap(kind);  // throws
    }
    if (request.view == "rows") {
        rowMethods(request.rows, "--variants");  // throws
        requireRange("--row-width", request.rows.pixels, 0, static_cast<double>(relief::kWidestRow));
    }
    requireRange("--width", request.widthMm, kLeastMm, kMostMm);
    requireRange("--dpi", request.dpi, kLeastDpi, kMostDpi);
    if (ending == ".png") {
        requireRange("--width", request.widthMm, kLeastMm, std::floor(kMostPixels / request.dpi * kMmPerInch));
    }
}

QImage figureImage(const Snapshot& snapshot, const FigureRequest& request, int width) {
    const int height = std::max(1, static_cast<int>(std::lround(width * aspectOf(snapshot, request))));
    if (request.view == "trace") return traceImage(snapshot, request, {width, height});
    if (request.view == "slabs") return slabsImage(snapshot, request, {width, height});
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(toColor(request.style.background()));
    const double dpi = width / request.widthMm * kMmPerInch;
    const auto dots = static_cast<int>(std::lround(dpi / kMmPerInch * 1000));
    image.setDotsPerMeterX(dots);
    image.setDotsPerMeterY(dots);
    QPainter painter(&image);
    paintView(painter, snapshot, request, {0, 0, double(width), double(height)}, dpi / kPointsPerInch);
    return image;
}

void writeFigure(const Snapshot& snapshot, const FigureRequest& request, const std::string& path) {
    checkFigure(request, path);
    relief::AtomicFile file(path);
    const std::string& target = file.temporaryPath();
    const std::string ending = endingOf(path);
    const QSizeF mm(request.widthMm, request.widthMm * aspectOf(snapshot, request));
    const QSize units = (mm / kMmPerInch * kVectorDpi).toSize();
    bool done = true;
    if (ending == ".svg") {
        writeSvg(snapshot, request, target, units);
    } else if (ending == ".pdf") {
        writePdf(snapshot, request, target, mm);
    } else {
        const int width = std::max(1, static_cast<int>(std::lround(request.widthMm / kMmPerInch * request.dpi)));
        done = figureImage(snapshot, request, width).save(QString::fromStdString(target), "PNG");
    }
    // Qt says nothing about a full disk; an empty file is no figure.
    std::error_code error;
    if (!done || std::filesystem::file_size(target, error) == 0 || error) {
        throw relief::WorkError(path, Message(MessageId::DiskFull));
    }
    file.commit();
}

}  // namespace reliefui
