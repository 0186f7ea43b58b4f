#include "views/result_painting.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QFontMetrics>

#include "messages.h"

namespace reliefui {

namespace {

// The texts of these functions have a context to be translated in.
class ResultText {
    Q_DECLARE_TR_FUNCTIONS(reliefui::ResultText)
};

int scaled(double pixels, const Style& style) {
    return static_cast<int>(std::lround(pixels * style.pixelsPerPoint() * 0.75));
}

QString number(double value, int digits = 3) {
    return QString::fromStdString(relief::numberText(value, digits));
}

// One field of a legend: a patch of colour, hatched where it is hatched in the picture, and what it means.
struct Swatch {
    QColor color;
    bool hatched = false;
    QString text;
};

std::vector<Swatch> swatches(const LayerPicture& layer) {
    if (layer.layer == Layer::Normals) {
        return {{QColor(255, 128, 128), false, ResultText::tr("+x, right")},
                {QColor(128, 255, 128), false, ResultText::tr("+y, up")},
                {QColor(128, 128, 255), false, ResultText::tr("+z, to the front")}};
    }
    std::vector<Swatch> list;
    for (std::size_t i = layer.outcomes.size(); i-- > 0;) {
        if (layer.outcomes[i] == 0) continue;
        const auto outcome = static_cast<relief::Outcome>(i);
        const bool hatched = outcome == relief::Outcome::Miss || outcome == relief::Outcome::Limit;
        list.push_back({QColor(QRgb(kOutcomeColors[i])), hatched,
                        ResultText::tr("%1: %2 pixels").arg(outcomeTitle(outcome)).arg(layer.outcomes[i])});
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

QSize paintSwatches(QPainter* painter, const LayerPicture& layer, QPoint bottomLeft, const Style& style,
                    const QFontMetrics& metrics) {
    const std::vector<Swatch> list = swatches(layer);
    const int line = metrics.height() + scaled(4, style);
    const int patch = metrics.height();
    const int pad = scaled(8, style);
    int widest = 0;
    for (const Swatch& s : list) widest = std::max(widest, metrics.horizontalAdvance(s.text));
    const QSize size(3 * pad + patch + widest, 2 * pad + line * static_cast<int>(list.size()));
    if (painter == nullptr) return size;
    const QRect box(bottomLeft - QPoint(0, size.height()), size);
    panel(*painter, box, style);
    int y = box.top() + pad;
    for (const Swatch& s : list) {
        const QRect square(box.left() + pad, y, patch, patch);
        painter->fillRect(square, s.color);
        if (s.hatched) painter->fillRect(square, QBrush(QColor(0xd8, 0xd8, 0xd8), Qt::BDiagPattern));
        painter->drawText(QRect(square.right() + pad, y, widest + pad, patch), Qt::AlignVCenter | Qt::AlignLeft,
                          s.text);
        y += line;
    }
    return size;
}

QSize paintScale(QPainter* painter, const LayerPicture& layer, QPoint bottomLeft, const Style& style,
                 const QFontMetrics& metrics) {
    const bool steps = layer.layer == Layer::Steps;
    const QString title =
        steps ? ResultText::tr("steps of the ray") : ResultText::tr("distance to the hit, texture widths");
    const int pad = scaled(8, style);
    const int bar = std::max(scaled(180, style), metrics.horizontalAdvance(title));
    const int thick = metrics.height() * 2 / 3;
    const QSize size(bar + 2 * pad, 2 * pad + 2 * metrics.height() + thick + scaled(6, style));
    if (painter == nullptr) return size;
    const QRect box(bottomLeft - QPoint(0, size.height()), size);
    panel(*painter, box, style);
    const int x = box.left() + pad;
    int y = box.top() + pad;
    painter->drawText(QRect(x, y, bar, metrics.height()), Qt::AlignLeft | Qt::AlignVCenter, title);
    y += metrics.height() + scaled(3, style);
    for (int i = 0; i < bar; ++i) {
        painter->fillRect(x + i, y, 1, thick, toColor(style.mapped(ColorMap::Count, double(i) / (bar - 1))));
    }
    y += thick + scaled(3, style);
    const QRect labels(x, y, bar, metrics.height());
    const double middle = (layer.low + layer.high) / 2;
    painter->drawText(labels, Qt::AlignLeft, number(layer.low));
    painter->drawText(labels, Qt::AlignHCenter, number(middle));
    painter->drawText(labels, Qt::AlignRight, number(layer.high));
    return size;
}

}  // namespace

QColor toColor(const Rgba& color) {
    return {color.r, color.g, color.b, color.a};
}

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
    // Large enough to be read, small enough to leave the picture to be seen.
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

QSize paintLegend(QPainter* painter, const LayerPicture& layer, QPoint bottomLeft, const Style& style) {
    if (layer.layer == Layer::Color) return {};
    const QFontMetrics metrics = painter != nullptr ? painter->fontMetrics() : QFontMetrics(QFont());
    const bool scale = layer.layer == Layer::Steps || layer.layer == Layer::Depth;
    return scale ? paintScale(painter, layer, bottomLeft, style, metrics)
                 : paintSwatches(painter, layer, bottomLeft, style, metrics);
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
        if (!brief) lines << ResultText::tr("distance %1 texture widths").arg(number(frame.depth(x, y)));
    } else {
        lines << outcomeTitle(hit.outcome);
    }
    lines << ResultText::tr("steps: %1, reads: %2").arg(frame.hits->hits.steps[i]).arg(frame.hits->hits.reads[i]);
    return lines;
}

}  // namespace reliefui
