#include "panes/coefficient_text.h"

#include <QCoreApplication>

#include "relief/messages.h"

namespace reliefui {

QStringList coefficientLines(const relief::PixelCoefficients& pixel) {
    constexpr int kFigures = 4;
    const auto named = [](const char* name, double value) {
        // The sum has no negative zero.
        return QStringLiteral("%1 %2").arg(QLatin1String(name),
                                           QString::fromStdString(relief::numberText(value + 0.0, kFigures)));
    };
    const auto line = [](const QStringList& parts) { return parts.join(QStringLiteral(", ")); };
    const relief::Homography& f = pixel.map;
    const relief::Jacobian& j = pixel.derivatives;
    const relief::Ellipse& e = pixel.ellipse;
    const QString ellipse = QCoreApplication::translate("CoefficientText", "ellipse: ");
    return {line({named("A", f.sx), named("B", f.sy), named("C", f.s1), named("D", f.tx), named("E", f.ty),
                  named("F", f.t1), named("G", f.qx), named("H", f.qy), named("I", f.q1)}),
            named("q", pixel.q), line({named("u_x", j.ux), named("u_y", j.uy), named("v_x", j.vx), named("v_y", j.vy)}),
            line({named("M", pixel.m), named("N", pixel.n), named("O", pixel.o), named("P", pixel.p)}),
            ellipse + line({named("A", e.a), named("B", e.b), named("C", e.c), named("F", e.f)})};
}

}  // namespace reliefui
