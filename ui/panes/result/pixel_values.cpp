#include "panes/result/pixel_values.h"

#include <algorithm>
#include <cmath>

#include "painting/painter.h"
#include "panes/result/result_painting.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

// Smallest text, relative to the style's text size.
constexpr double kLeast = 0.8;
constexpr double kLargest = 1.8;
constexpr double kLine = 1.2;  // line height, relative to the text size

QString number(double value) {
    return QString::fromStdString(relief::numberText(value, 3));
}

QStringList errorOf(const relief::ErrorLayer& layer, std::size_t i) {
    switch (layer.kinds[i]) {
        case relief::ErrorKind::None:
            return {};
        case relief::ErrorKind::Right:
            return {QStringLiteral("0")};
        case relief::ErrorKind::Wrong:
            return {QStringLiteral("≠")};
        case relief::ErrorKind::Short:
            return {QStringLiteral("−") + number(static_cast<double>(layer.texels[i]))};
        case relief::ErrorKind::Past:
            return {QStringLiteral("+") + number(static_cast<double>(layer.texels[i]))};
    }
    return {};
}

// For rays that hit.
QStringList placeOf(const Snapshot& snapshot, int x, int y) {
    const relief::Frame& frame = *snapshot.frame;
    const std::size_t i = frame.index(x, y);
    switch (snapshot.layer.layer) {
        case Layer::Depth:
            return {number(frame.depth(x, y))};
        case Layer::Normals: {
            const glm::vec3 n = frame.normal(x, y, *snapshot.request);
            const auto part = [](float v) { return QString::number(static_cast<double>(v), 'f', 2); };
            return {QStringLiteral("x ") + part(n.x), QStringLiteral("y ") + part(n.y),
                    QStringLiteral("z ") + part(n.z)};
        }
        case Layer::TexturePlace:
            return {QStringLiteral("s %1").arg(frame.hits->hits.s[i], 0, 'f', 1),
                    QStringLiteral("t %1").arg(frame.hits->hits.t[i], 0, 'f', 1)};
        case Layer::Anisotropy:
            return snapshot.layer.planes ? QStringList{number(anisotropy(*snapshot.layer.planes, x, y))}
                                         : QStringList{};
        case Layer::Hidden:
            if (!snapshot.layer.planes) return {};
            return {number(100 * static_cast<double>((*snapshot.layer.planes)[0].plane(x, y))) + '%'};
        default:
            return {};
    }
}

}  // namespace

QStringList pixelValues(const Snapshot& snapshot, int x, int y) {
    const relief::Frame& frame = *snapshot.frame;
    const std::size_t i = frame.index(x, y);
    if (snapshot.layer.layer == Layer::Color) {
        const QColor color = snapshot.picture.pixelColor(x, y);
        return {QStringLiteral("R %1").arg(color.red()), QStringLiteral("G %1").arg(color.green()),
                QStringLiteral("B %1").arg(color.blue())};
    }
    if (frame.rays->polygon[i] == relief::kNoPolygon) return {};
    if (snapshot.layer.layer == Layer::Steps) return {QString::number(rayCounts(snapshot, i).steps)};
    if (snapshot.layer.layer == Layer::Error)
        return snapshot.layer.error ? errorOf(*snapshot.layer.error, i) : QStringList{};
    if (snapshot.layer.layer == Layer::Outcome) return {outcomeTitle(frame.hits->hits.outcome[i])};
    return frame.hits->hits.outcome[i] == relief::Outcome::Hit ? placeOf(snapshot, x, y) : QStringList{};
}

void paintPixelValues(QPainter& painter, const Snapshot& snapshot, const QRectF& picture, const QRectF& room,
                      const Style& style) {
    const relief::Frame& frame = *snapshot.frame;
    const QImage& image = snapshot.layer.image;
    if (snapshot.coarse || image.width() != frame.width || image.height() != frame.height) return;
    const double side = picture.width() / frame.width;
    // Room for three lines, or for one word.
    constexpr double kLines = 3.7;
    const double text = std::min(side / kLines / kLine, kLargest * style.textPixels());
    if (text < kLeast * style.textPixels()) return;
    QFont font = painter.font();
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(text))));
    painter.save();
    painter.setFont(font);
    const QRectF seen = picture.intersected(room);
    const auto first = [&](double from, double origin) {
        return std::max(0, static_cast<int>((from - origin) / side));
    };
    for (int y = first(seen.top(), picture.top()); y < frame.height && picture.top() + y * side < seen.bottom(); ++y) {
        for (int x = first(seen.left(), picture.left()); x < frame.width; ++x) {
            const QRectF pixel(picture.left() + x * side, picture.top() + y * side, side, side);
            if (pixel.left() >= seen.right()) break;
            const QRgb ground = image.pixel(x, y);
            const auto byte = [](int v) { return static_cast<std::uint8_t>(v); };
            painter.setPen(
                toColor(Style::textOn({byte(qRed(ground)), byte(qGreen(ground)), byte(qBlue(ground)), 255})));
            const QStringList values = pixelValues(snapshot, x, y);
            // At the edge of the view, the values are placed in the visible part of the pixel.
            const QRectF part = pixel.intersected(seen);
            if (part.height() < kLine * text * values.size() || part.width() < 4 * text) continue;
            painter.drawText(part, Qt::AlignCenter, values.join('\n'));
        }
    }
    painter.restore();
}

}  // namespace reliefui
