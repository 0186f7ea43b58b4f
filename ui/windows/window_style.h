// Qt's Fusion, but for buttons: one that is on is filled, one under the pointer has an outline; neither is taken for
// the other. Tabs are narrower, so that all panes of a stack are seen.
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
