#include "views/figure_parts.h"

#include <algorithm>

#include "drawings/cell_image.h"
#include "drawings/painter.h"
#include "views/compare_painting.h"
#include "views/drawn_view.h"
#include "views/duel_data.h"
#include "views/pyramid_parts.h"
#include "views/result_painting.h"
#include "views/table_figures.h"

namespace reliefui {

using relief::MessageId;

namespace {

constexpr double kMmPerPoint = 25.4 / 72;
constexpr double kMargins = 12;  // points, of a figure

// The legend of the result's layer, for a page so many points wide: pixels of a screen, of which there are 96 an inch.
constexpr double kPixelsPerPoint = 96.0 / 72;

// The same on every page, and where it is measured.
QFont legendFont() {
    constexpr int kPixels = 13;
    QFont font;
    font.setPixelSize(kPixels);
    return font;
}

// What the legend measures by are pixels of a screen.
Style onScreen(Style style) {
    style.projector = false;
    style.screenPixelsPerPoint = kPixelsPerPoint;
    return style;
}

QSizeF legendOf(const Snapshot& snapshot, const Style& style) {
    QImage nothing(1, 1, QImage::Format_RGB32);
    QPainter painter(&nothing);
    painter.setFont(legendFont());
    const QSize size = paintLegend(&painter, snapshot.layer, {}, onScreen(style));
    return size.isValid() ? QSizeF(size) / kPixelsPerPoint : QSizeF(0, 0);
}

TableSource tableOf(const Snapshot& snapshot, const FigureRequest& request) {
    return request.view == "steps" ? stepTable(snapshot, request.style.language)
                                   : skippedTable(snapshot, request.style.language);
}

struct PyramidFigure {
    Drawing legend;
    Box room;
    PyramidParts parts;
};

PyramidFigure pyramidFigure(const Snapshot& snapshot, const PyramidOptions& options, const Box& page,
                            const Style& style) {
    const double unit = style.pixelsPerPoint();
    PyramidFigure figure;
    figure.legend = pyramidLegend(pyramidSource(snapshot, options), page.width() / unit - kMargins, style.language);
    figure.room = figureRoom(figure.legend, page, style);
    figure.parts = pyramidParts(snapshot, options, figure.room.width() / unit, figure.room.height() / unit);
    return figure;
}

bool everyValueIsWritten(const PyramidFigure& figure, const Style& style) {
    const double scale = ViewMap::fitting(figure.parts.levels.bounds, figure.room).scale;
    return std::all_of(figure.parts.levels.items.begin(), figure.parts.levels.items.end(), [&](const Item& item) {
        const auto* const cells = std::get_if<Cells>(&item.primitive);
        return cells == nullptr || cellText(*cells, visibleCells(*cells, cells->clip), scale, style).pixels > 0;
    });
}

}  // namespace

// Nothing to draw: says so.
Drawing emptyDrawing(MessageId why) {
    Drawing drawing;
    drawing.bounds = {0, 0, 300, 100};
    Label label;
    label.at = drawing.bounds.center();
    label.text = relief::Message(why);
    label.anchor = Anchor::Center;
    drawing.add({}, Role::Label, std::move(label));
    return drawing;
}

double pyramidAspect(const Snapshot& snapshot, const FigureRequest& request) {
    constexpr double kFiner = 8;  // pixels a point: letters are whole pixels high
    constexpr double kHigher = 0.04;
    Style style = request.style;
    style.projector = false;
    style.screenPixelsPerPoint = kFiner;
    const double width = request.widthMm / kMmPerPoint * kFiner;
    for (double aspect = kDrawingAspect; aspect <= 1; aspect += kHigher) {
        const Box page{0, 0, width, width * aspect};
        if (everyValueIsWritten(pyramidFigure(snapshot, request.pyramid, page, style), style)) return aspect;
    }
    return kDrawingAspect;
}

void paintPyramid(QPainter& painter, const Snapshot& snapshot, const PyramidOptions& options, const Box& page,
                  const Style& style) {
    const PyramidFigure figure = pyramidFigure(snapshot, options, page, style);
    const Drawing marks = partsMarks(figure.parts, snapshot.scenario.step);
    paintFigure(painter, {&figure.parts.levels, &marks}, figure.legend, page, style);
}

double resultAspect(const Snapshot& snapshot, const FigureRequest& request) {
    const double picture =
        static_cast<double>(snapshot.layer.image.height()) / std::max(1, snapshot.layer.image.width());
    return picture + legendOf(snapshot, request.style).height() / (request.widthMm / kMmPerPoint);
}

// The legend of its layer, if it has one, stands below the picture.
void paintResult(QPainter& painter, const Snapshot& snapshot, const Box& page, const Style& style) {
    const QImage& image = snapshot.layer.image;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, true);
    const double high = page.width() * image.height() / std::max(1, image.width());
    painter.drawImage(QRectF(page.x0, page.y0, page.width(), high), image);
    if (page.y0 + high < page.y1 - 1) {
        painter.save();
        painter.translate(page.x0, page.y1);
        const double unit = style.screenPixelsPerPoint / kPixelsPerPoint;
        painter.scale(unit, unit);
        painter.setFont(legendFont());
        paintLegend(&painter, snapshot.layer, QPoint(0, 0), onScreen(style));
        painter.restore();
    }
    if (snapshot.scenario.pixel) {
        const double side = page.width() / std::max(1, snapshot.scenario.width);
        const Point at{page.x0 + (snapshot.scenario.pixel->x + 0.5) * side,
                       page.y0 + (snapshot.scenario.pixel->y + 0.5) * side};
        Drawing ring;
        ring.add({}, Role::Hit, Ring{at, 5});
        paint(painter, ring, ViewMap{}, style, page);
    }
}

// Pictures in two columns where there are more than three, with their numbers.
double compareAspect(const ComparedView& view, relief::CompareMode mode) {
    const double picture = static_cast<double>(view.scenario.height) / view.scenario.width;
    const std::size_t count = view.methods.size();
    constexpr double kText = 0.12;
    const bool beside = mode == relief::CompareMode::Tiles || mode == relief::CompareMode::Difference;
    if (!beside) return picture + kText;
    const double columns = count == 4 ? 2 : static_cast<double>(count);
    return picture * (count == 4 ? 2 : 1) / columns + kText;
}

double tableAspect(const Snapshot& snapshot, const FigureRequest& request) {
    const double points = request.widthMm / kMmPerPoint - kMargins;
    const Drawing table = tableDrawing(tableOf(snapshot, request), points);
    // A table that wants more room is fitted into the page.
    const double height = table.bounds.height() * points / std::max(table.bounds.width(), 1.0);
    return (height + kMargins) / (points + kMargins);
}

void paintComparison(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
                     const Style& style) {
    if (!request.compare) {
        const Drawing empty = emptyDrawing(MessageId::DrawCompareOne);
        paintFigure(painter, {&empty}, {}, page, style);
        return;
    }
    const relief::Comparison& how = snapshot.scenario.comparison;
    const ComparePage parts = comparePage(compareSource(*request.compare, how, request.compareShown), page, style);
    paintCompare(painter, *request.compare, how, parts, page, style, snapshot.scenario.pixel, {});
}

void paintByHand(QPainter& painter, const Snapshot& snapshot, const Box& page, const Style& style) {
    const DrawnSource source = drawnSource(snapshot);
    if (source.relief.empty()) {
        const Drawing empty = emptyDrawing(MessageId::DrawDrawnNone);
        paintFigure(painter, {&empty}, {}, page, style);
        return;
    }
    paintDrawn(painter, source, page, style);
}

void paintDuel(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
               const Style& style) {
    if (!request.duel) {
        const bool pixel = snapshot.scenario.pixel.has_value();
        const Drawing empty = emptyDrawing(pixel ? MessageId::DrawNoRelief : MessageId::DrawDuelNoRay);
        paintFigure(painter, {&empty}, {}, page, style);
        return;
    }
    const Duel& duel = *request.duel;
    DuelSource source = duel.source();
    source.upTo = request.duelUpTo;
    const double unit = style.pixelsPerPoint();
    const Drawing legend = duelLegend(source, page.width() / unit - kMargins, style.language);
    const Box room = figureRoom(legend, page, style);
    ProfileOptions options = request.profile;
    options.levels = LevelsShown::None;
    const ProfileFrame frame = duelFrame(source, options, room.width() / unit, room.height() / unit);
    const Drawing relief = profileRelief(source.profile, options, frame);
    const Drawing axes = profileAxes(source.profile, frame);
    const auto& moments = duel.steps.moments;
    const std::size_t at = std::min(request.duelMoment, moments.empty() ? 0 : moments.size() - 1);
    const Drawing marks = duelMarks(source, frame, moments.empty() ? std::vector<std::size_t>{} : moments[at]);
    paintFigure(painter, {&relief, &axes, &marks}, legend, page, style);
}

void paintTable(QPainter& painter, const Snapshot& snapshot, const FigureRequest& request, const Box& page,
                const Style& style) {
    const double points = page.width() / style.pixelsPerPoint() - kMargins;
    const Drawing table = tableDrawing(tableOf(snapshot, request), points);
    paintFigure(painter, {&table}, {}, page, style);
}

}  // namespace reliefui
