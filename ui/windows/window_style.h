// Qt's Fusion style with other buttons and tabs: a checked button is filled and one under the pointer has an outline,
// so that they cannot be confused; tabs are narrower, so that all panes of a stack are visible.
#pragma once

#include <QProxyStyle>

namespace reliefui {

class WindowStyle : public QProxyStyle {
  public:
    WindowStyle();

    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
};

}  // namespace reliefui
