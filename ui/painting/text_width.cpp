#include "painting/text_width.h"

#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>

#include "painting/style.h"

namespace reliefui {

double textWidth(const std::string& text, double size, bool bold) {
    const QString words = QString::fromStdString(text);
    // Without an application, as in tests of what is drawn, there are no fonts.
    constexpr double kLetter = 6.1;  // points, of the style's size
    if (QCoreApplication::instance() == nullptr) return static_cast<double>(words.size()) * kLetter * size;
    constexpr int kPixels = 100;
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(kPixels);
    font.setBold(bold);
    return QFontMetricsF(font).horizontalAdvance(words) / kPixels * Style::kTextPoints * size;
}

}  // namespace reliefui
