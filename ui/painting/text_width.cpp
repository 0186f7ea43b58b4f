#include "painting/text_width.h"

#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>

#include "painting/style.h"

namespace reliefui {

double textWidth(const std::string& text, double size, bool bold) {
    const QString words = QString::fromStdString(text);
    // Without a QApplication, as in tests of drawings, no fonts are available; an average width is used.
    constexpr double kLetter = 6.1;  // average letter width in points, at the style's text size
    if (QCoreApplication::instance() == nullptr) return static_cast<double>(words.size()) * kLetter * size;
    constexpr int kPixels = 100;
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(kPixels);
    font.setBold(bold);
    return QFontMetricsF(font).horizontalAdvance(words) / kPixels * Style::kTextPoints * size;
}

}  // namespace reliefui
