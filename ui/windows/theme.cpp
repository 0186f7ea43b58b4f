#include "windows/theme.h"

#include <algorithm>

#include <QFont>

namespace reliefui {

QPalette themePalette(Theme theme) {
    const bool dark = theme == Theme::Dark;
    const QColor window = dark ? QColor(0x2b, 0x2d, 0x31) : QColor(0xf2, 0xf2, 0xf2);
    const QColor base = dark ? QColor(0x1e, 0x20, 0x24) : QColor(Qt::white);
    const QColor text = dark ? QColor(0xec, 0xec, 0xec) : QColor(0x18, 0x18, 0x18);
    const QColor faint = dark ? QColor(0x8c, 0x90, 0x96) : QColor(0x80, 0x80, 0x80);
    QPalette palette(dark ? QColor(0x3a, 0x3d, 0x42) : QColor(0xe4, 0xe4, 0xe4), window);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, dark ? QColor(0x26, 0x28, 0x2c) : QColor(0xf6, 0xf6, 0xf6));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, text);
        palette.setColor(QPalette::Disabled, role, faint);
    }
    palette.setColor(QPalette::ToolTipBase, base);
    palette.setColor(QPalette::PlaceholderText, faint);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::Highlight, QColor(0x1f, 0x6f, 0xa8));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, dark ? QColor(0x56, 0xb4, 0xe9) : QColor(0x00, 0x5a, 0x9e));
    return palette;
}

QFont windowFont(double scale) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPointSizeF(Style::kTextPoints * scale);
    font.setStyleHint(QFont::SansSerif);
    return font;
}

double projectorScale(int height) {
    constexpr double kLeast = 1.3, kMost = 1.8;
    constexpr double kHigh = 1000;  // height of a screen, in points, from which the largest scale is used
    return std::clamp(kMost * height / kHigh, kLeast, kMost);
}

}  // namespace reliefui
