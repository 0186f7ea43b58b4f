#include "panes/result/result_painting.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QFontMetrics>

#include "painting/painter.h"
#include "relief/messages.h"

namespace reliefui {

namespace {

// Translation context for the texts of the functions in this file.
class ResultText {
    Q_DECLARE_TR_FUNCTIONS(reliefui::ResultText)
};

int scaled(double pixels, const Style& style) {
    return static_cast<int>(std::lround(pixels * style.pixelsPerPoint() * 0.75));
}

QString number(double value, int digits = 3) {
    return QString::fromStdString(relief::numberText(value, digits));
}

// An entry of a legend: a patch of colour, hatched if the picture is, and its meaning.
struct Swatch {
    QColor color;
    bool hatched = false;
    QString text;
    QColor hatch{0xd8, 0xd8, 0xd8};
};

std::vector<Swatch> errorSwatches(const LayerPicture& layer) {
    const auto count = [&](relief::ErrorKind kind) { return layer.error->counts[static_cast<std::size_t>(kind)]; };
    const auto some = [&](const QString& what, relief::ErrorKind kind) {
        return ResultText::tr("%1: %n pixels", nullptr, static_cast<int>(count(kind))).arg(what);
    };
    const auto side = [](double place) { return toColor(Style().mapped(ColorMap::Signed, place)); };
    return {{QColor(QRgb(kNoError)), false, some(ResultText::tr("exact"), relief::ErrorKind::Right)},
            {side(0.2), false, some(ResultText::tr("too early"), relief::ErrorKind::Short)},
            {side(0.8), false, some(ResultText::tr("overshoot"), relief::ErrorKind::Past)},
            {QColor(QRgb(kWrongOutcome)), true, some(ResultText::tr("wrong outcome"), relief::ErrorKind::Wrong),
             Qt::black}};
}

std::vector<Swatch> swatches(const LayerPicture& layer) {
    if (layer.layer == Layer::TexturePlace) {
        return {{QColor(255, 0, 64), false, ResultText::tr("u, texture widths, 0 to 1")},
                {QColor(0, 255, 64), false, ResultText::tr("v, texture heights, 0 to 1")},
                {QColor(0, 0, 64), false, ResultText::tr("a corner of the texture")}};
    }
    if (layer.layer == Layer::Error) return errorSwatches(layer);
    if (layer.layer == Layer::Hidden) {
        return {
            {QColor(0x2b, 0x30, 0x38), false,
             ResultText::tr("nothing to show: only the filter elliptical-visible determines what the relief hides")}};
    }
    std::vector<Swatch> list;
    for (std::size_t i = layer.outcomes.size(); i-- > 0;) {
        if (layer.outcomes[i] == 0) continue;
        const auto outcome = static_cast<relief::Outcome>(i);
        const bool hatched = outcome == relief::Outcome::Miss || outcome == relief::Outcome::Limit;
        list.push_back(
            {QColor(QRgb(kOutcomeColors[i])), hatched,
             ResultText::tr("%1: %n pixels", nullptr, static_cast<int>(layer.outcomes[i])).arg(outcomeTitle(outcome))});
    }
    std::reverse(list.begin(), list.end());
    return list;
}

void panel(QPainter& painter, const QRect& box, const Style& style) {
    QColor ground = toColor(style.background());
    ground.setAlpha(225);
    painter.fillRect(box, ground);
    painter.setPen(toColor(style.color(Role::Frame)));
    painter.drawRect(box.adjusted(0, 0, -1, -1));
    painter.setPen(toColor(style.text()));
}

// width: most pixels that the legend may take; longer texts are wrapped.
QSize paintSwatches(QPainter* painter, const LayerPicture& layer, QPoint bottomLeft, const Style& style,
                    const QFontMetrics& metrics, double width) {
    const std::vector<Swatch> list = swatches(layer);
    const int between = scaled(4, style);
    const int patch = metrics.height();
    const int pad = scaled(8, style);
    const int room = std::max(1, static_cast<int>(width) - 4 * pad - patch);
    const auto extent = [&](const Swatch& s) {
        return metrics.boundingRect(QRect(0, 0, room, 1 << 15), Qt::TextWordWrap, s.text).size();
    };
    int widest = 0, height = 0;
    for (const Swatch& s : list) {
        widest = std::max(widest, extent(s).width());
        height += std::max(patch, extent(s).height()) + between;
    }
    const QSize size(3 * pad + patch + widest, 2 * pad + height);
    if (painter == nullptr) return size;
    const QRect box(bottomLeft - QPoint(0, size.height()), size);
    panel(*painter, box, style);
    int y = box.top() + pad;
    for (const Swatch& s : list) {
        const QRect square(box.left() + pad, y, patch, patch);
        painter->fillRect(square, s.color);
        if (s.hatched) painter->fillRect(square, QBrush(s.hatch, Qt::BDiagPattern));
        const int high = std::max(patch, extent(s).height());
        painter->drawText(QRect(square.right() + pad, y, std::min(widest + pad, room), high),
                          Qt::AlignVCenter | Qt::AlignLeft | Qt::TextWordWrap, s.text);
        y += high + between;
    }
    return size;
}

QString scaleTitle(Layer layer) {
    if (layer == Layer::Error) return ResultText::tr("error against exact, texels: − too early, + overshoot");
    if (layer == Layer::Anisotropy) return ResultText::tr("footprint: major over minor axis");
    if (layer == Layer::Hidden) return ResultText::tr("texels of the footprint hidden by the relief, %");
    return layer == Layer::Steps ? ResultText::tr("steps of the ray")
                                 : ResultText::tr("distance to the hit, texture widths");
}

// In points; entries are placed side by side up to this width.
constexpr double kLegendWidth = 420;

QSize paintScale(QPainter* painter, const LayerPicture& layer, QPoint bottomLeft, const Style& style, double width) {
    // In large type the whole legend would cover much of a small picture.
    const Drawing legend = rangeLegend(layerValues(layer), std::min(width, kLegendWidth), style.projector);
    const double unit = style.pixelsPerPoint();
    const int pad = scaled(8, style);
    const QSize size(static_cast<int>(std::ceil(legend.bounds.width() * unit)) + 2 * pad,
                     static_cast<int>(std::ceil(legend.bounds.height() * unit)) + 2 * pad);
    if (painter == nullptr) return size;
    const QRect box(bottomLeft - QPoint(0, size.height()), size);
    panel(*painter, box, style);
    const Box room{double(box.left()), double(box.top()), double(box.right()), double(box.bottom())};
    painter->save();
    paint(*painter, legend, {unit, room.x0 + pad, room.y0 + pad}, style, room);
    painter->restore();
    return size;
}

// Explains normals by a picture of a sphere with the colours of its normals.
QSize paintSphere(QPainter* painter, QPoint bottomLeft, const Style& style, const QFontMetrics& metrics) {
    const int pad = scaled(8, style);
    const int side = scaled(64, style);
    const QString words = ResultText::tr("x right, y up, z to the front");
    const QString title = ResultText::tr("normal in the scene's axes");
    const int text = std::max(metrics.horizontalAdvance(words), metrics.horizontalAdvance(title));
    const QSize size(3 * pad + side + text, 2 * pad + side);
    if (painter == nullptr) return size;
    const QRect box(bottomLeft - QPoint(0, size.height()), size);
    panel(*painter, box, style);
    QImage ball(side, side, QImage::Format_ARGB32);
    ball.fill(Qt::transparent);
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const double nx = (i + 0.5) * 2 / side - 1;
            const double ny = 1 - (j + 0.5) * 2 / side;
            const double rest = 1 - nx * nx - ny * ny;
            if (rest < 0) continue;
            const auto code = [](double v) { return static_cast<int>(std::lround(127.5 + 127.5 * v)); };
            ball.setPixel(i, j, qRgb(code(nx), code(ny), code(std::sqrt(rest))));
        }
    }
    painter->drawImage(box.left() + pad, box.top() + pad, ball);
    const int x = box.left() + 2 * pad + side;
    painter->drawText(QRect(x, box.top() + pad, text + pad, side / 2), Qt::AlignLeft | Qt::AlignVCenter, title);
    painter->drawText(QRect(x, box.top() + pad + side / 2, text + pad, side / 2), Qt::AlignLeft | Qt::AlignVCenter,
                      words);
    return size;
}

}  // namespace

QString layerTitle(Layer layer) {
    switch (layer) {
        case Layer::Color:
            return ResultText::tr("Colour");
        case Layer::Steps:
            return ResultText::tr("Steps");
        case Layer::Outcome:
            return ResultText::tr("Outcome");
        case Layer::Depth:
            return ResultText::tr("Depth");
        case Layer::Error:
            return ResultText::tr("Error");
        case Layer::TexturePlace:
            return ResultText::tr("Texture place");
        case Layer::Anisotropy:
            return ResultText::tr("Footprint anisotropy");
        case Layer::Hidden:
            return ResultText::tr("Hidden by the relief");
        case Layer::Normals:
            break;
    }
    return ResultText::tr("Normals");
}

QString outcomeTitle(relief::Outcome outcome) {
    switch (outcome) {
        case relief::Outcome::Hit:
            return ResultText::tr("hit");
        case relief::Outcome::Miss:
            return ResultText::tr("miss");
        case relief::Outcome::Limit:
            return ResultText::tr("step limit");
        case relief::Outcome::Unset:
            break;
    }
    return ResultText::tr("sky");
}

void paintChosenPixel(QPainter& painter, QPointF at, double side, const Style& style) {
    const double line = style.projector ? 3 : 1;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const double radius = scaled(7, style);
    const bool outline = side > 2 * radius;
    for (const bool outer : {true, false}) {
        painter.setPen(QPen(outer ? Qt::black : Qt::white, line * (outer ? 4.0 : 2.0)));
        if (outline) {
            painter.drawRect(QRectF(at.x() - side / 2, at.y() - side / 2, side, side));
        } else {
            painter.drawEllipse(at, radius, radius);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

QSize magnifierSize(const Style& style, int viewWidth) {
    // Size of a magnified pixel: large enough to be recognised, small enough not to cover the picture.
    const int cell = std::clamp(viewWidth / (5 * kMagnified), 3, scaled(9, style));
    return {kMagnified * cell + 2, kMagnified * cell + 2};
}

void paintMagnifier(QPainter& painter, const QImage& image, QPoint pixel, const QRect& frame, const Style& style) {
    const int side = (frame.width() - 2) / kMagnified;
    painter.fillRect(frame, toColor(style.background()));
    for (int j = 0; j < kMagnified; ++j) {
        for (int i = 0; i < kMagnified; ++i) {
            const QPoint p = pixel + QPoint(i - kMagnified / 2, j - kMagnified / 2);
            if (!image.valid(p)) continue;
            painter.fillRect(frame.left() + 1 + i * side, frame.top() + 1 + j * side, side, side, image.pixelColor(p));
        }
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toColor(style.color(Role::Frame)), style.projector ? 3 : 1));
    painter.drawRect(frame.adjusted(0, 0, -1, -1));
    const int middle = 1 + kMagnified / 2 * side;
    const QRect center(frame.left() + middle, frame.top() + middle, side - 1, side - 1);
    painter.setPen(Qt::black);
    painter.drawRect(center.adjusted(-2, -2, 2, 2));
    painter.setPen(Qt::white);
    painter.drawRect(center.adjusted(-1, -1, 1, 1));
}

RangedValues layerValues(const LayerPicture& layer) {
    RangedValues values;
    values.of = *rangeOf(layer.layer);
    values.name = scaleTitle(layer.layer).toStdString();
    if (layer.layer == Layer::Error) values.unit = ResultText::tr("texels").toStdString();
    // Exact pixels are not part of the spread, but of the total.
    if (layer.error) {
        using Kind = relief::ErrorKind;
        for (const Kind kind : {Kind::Right, Kind::Short, Kind::Past, Kind::Wrong}) {
            values.whole += layer.error->counts[static_cast<std::size_t>(kind)];
        }
    }
    if (layer.layer == Layer::Hidden) values.unit = "%";
    values.map = colorMapOf(layer.layer);
    values.range = layer.range;
    values.scale = layer.scale;
    values.spread = layer.spread;
    return values;
}

QSize paintLegend(QPainter* painter, const LayerPicture& layer, QPoint bottomLeft, const Style& style, double width) {
    if (layer.layer == Layer::Color) return {};
    const QFontMetrics metrics = painter != nullptr ? painter->fontMetrics() : QFontMetrics(QFont());
    if (layer.layer == Layer::Normals) return paintSphere(painter, bottomLeft, style, metrics);
    const double points = (width - 2 * scaled(8, style)) / style.pixelsPerPoint();
    if (layer.layer == Layer::Error) {
        const QSize scale = paintScale(painter, layer, bottomLeft, style, points);
        const QSize kinds =
            paintSwatches(painter, layer, bottomLeft - QPoint(0, scale.height()), style, metrics, width);
        return {std::max(scale.width(), kinds.width()), scale.height() + kinds.height()};
    }
    return layer.values ? paintScale(painter, layer, bottomLeft, style, points)
                        : paintSwatches(painter, layer, bottomLeft, style, metrics, width);
}

QSize scaleSize(const LayerPicture& layer, const Style& style, double width) {
    return paintScale(nullptr, layer, {}, style, (width - 2 * scaled(8, style)) / style.pixelsPerPoint());
}

QImage withLegend(const QImage& picture, const LayerPicture& layer, const Style& style) {
    QImage out = picture.convertToFormat(QImage::Format_RGB32);
    if (layer.layer == Layer::Color) return out;
    const QSize legend = paintLegend(nullptr, layer, {}, style, out.width());
    // The legend is placed below, so that it does not cover the picture.
    QImage whole(std::max(out.width(), legend.width()), out.height() + legend.height(), QImage::Format_RGB32);
    whole.fill(toColor(style.background()));
    QPainter painter(&whole);
    painter.drawImage(0, 0, out);
    painter.setFont(QFont());
    paintLegend(&painter, layer, QPoint(0, whole.height()), style, out.width());
    return whole;
}

namespace {

// Adds the value of the shown layer, unless another line already contains it.
void addLayerValue(QStringList& lines, const Snapshot& snapshot, int x, int y) {
    const relief::Frame& frame = *snapshot.frame;
    const std::size_t i = frame.index(x, y);
    if (snapshot.layer.error) {
        switch (snapshot.layer.error->kinds[i]) {
            case relief::ErrorKind::None:
                return;
            case relief::ErrorKind::Right:
                lines << ResultText::tr("error: none");
                return;
            case relief::ErrorKind::Wrong:
                lines << ResultText::tr("wrong outcome");
                return;
            case relief::ErrorKind::Short:
            case relief::ErrorKind::Past:
                break;
        }
        const bool past = snapshot.layer.error->kinds[i] == relief::ErrorKind::Past;
        const QString kind = past ? ResultText::tr("overshoot") : ResultText::tr("too early");
        lines << ResultText::tr("error %1 texels, %2")
                     .arg(number(static_cast<double>(snapshot.layer.error->texels[i])), kind);
    }
    if (frame.hits->hits.outcome[i] != relief::Outcome::Hit) return;
    if (snapshot.layer.planes) {
        const std::vector<relief::NamedPlane>& planes = *snapshot.layer.planes;
        const auto value = [&](std::size_t plane) { return static_cast<double>(planes[plane].plane(x, y)); };
        if (snapshot.layer.layer == Layer::Hidden) {
            lines << ResultText::tr("%1% of the footprint hidden").arg(number(100 * value(0)));
        } else {
            lines << ResultText::tr("footprint: semi-axes %1 × %2 texels, ratio %3")
                         .arg(number(value(0)), number(value(1)), number(anisotropy(planes, x, y)));
        }
    }
    if (snapshot.layer.layer == Layer::Depth) {
        lines << ResultText::tr("distance %1 texture widths").arg(number(frame.depth(x, y)));
    }
    if (snapshot.layer.layer == Layer::Normals) {
        const glm::vec3 n = frame.normal(x, y, *snapshot.request);
        const auto part = [](float v) { return QString::number(static_cast<double>(v), 'f', 3); };
        lines << ResultText::tr("normal (%1, %2, %3)").arg(part(n.x), part(n.y), part(n.z));
    }
    if (snapshot.layer.layer == Layer::TexturePlace) {
        const auto part = [](double v) { return QString::number(v, 'f', 4); };
        lines << ResultText::tr("u %1, v %2")
                     .arg(part(frame.hits->hits.s[i] / snapshot.request->field.width()),
                          part(frame.hits->hits.t[i] / snapshot.request->field.height()));
    }
}

}  // namespace

RayCounts rayCounts(const Snapshot& snapshot, std::size_t pixel) {
    const relief::HitStage& hits = *snapshot.frame->hits;
    if (hits.counted()) return {hits.hits.steps[pixel], hits.hits.reads[pixel]};
    // The frame contains step counts only if the layer of steps is shown, so this ray is traced again.
    relief::RayBlock ray;
    ray.push(snapshot.frame->rays->rays[pixel]);
    relief::HitBlock again;
    relief::BlockCounts counts;
    relief::Work work(1);
    snapshot.tracer->trace(ray, again, counts, work);
    return {again.steps[0], again.reads[0]};
}

QStringList pixelReadout(const Snapshot& snapshot, relief::PixelChoice pixel, bool brief) {
    const relief::Frame& frame = *snapshot.frame;
    const int x = std::clamp(pixel.x * frame.width / snapshot.scenario.width, 0, frame.width - 1);
    const int y = std::clamp(pixel.y * frame.height / snapshot.scenario.height, 0, frame.height - 1);
    const std::size_t i = frame.index(x, y);
    QStringList lines{ResultText::tr("pixel (%1, %2)").arg(pixel.x).arg(pixel.y)};
    const QColor color = snapshot.picture.pixelColor(x, y);
    if (!brief)
        lines << ResultText::tr("colour %1 (%2, %3, %4)")
                     .arg(color.name())
                     .arg(color.red())
                     .arg(color.green())
                     .arg(color.blue());
    if (frame.rays->polygon[i] == relief::kNoPolygon) return lines << ResultText::tr("sky: no polygon here");
    const relief::Hit hit = frame.hits->hits[i];
    if (hit.outcome == relief::Outcome::Hit) {
        lines << ResultText::tr("hit at texel (%1, %2), λ %3")
                     .arg(hit.s, 0, 'f', 2)
                     .arg(hit.t, 0, 'f', 2)
                     .arg(hit.lambda, 0, 'f', 3);
        if (!brief && snapshot.layer.layer != Layer::Depth)
            lines << ResultText::tr("distance %1 texture widths").arg(number(frame.depth(x, y)));
    } else {
        lines << outcomeTitle(hit.outcome);
    }
    const RayCounts counts = rayCounts(snapshot, i);
    lines << ResultText::tr("steps: %1, reads: %2").arg(counts.steps).arg(counts.reads);
    addLayerValue(lines, snapshot, x, y);
    return lines;
}

}  // namespace reliefui
