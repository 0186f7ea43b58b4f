#include "painting/tikz.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPainterPath>

#include "painting/style.h"
#include "painting/tex_text.h"

namespace reliefui {

namespace {

constexpr double kTexPointsPerPoint = 72.27 / kPointsPerInch;

// Names of the palette (style.cpp), so that a document can redefine its colours; other colours are named by their
// value.
struct NamedColor {
    const char* hex;
    const char* name;
};
constexpr std::array<NamedColor, 11> kNamedColors{{{"000000", "Black"},
                                                   {"FFFFFF", "White"},
                                                   {"E69F00", "Orange"},
                                                   {"56B4E9", "SkyBlue"},
                                                   {"009E73", "BlueGreen"},
                                                   {"F0E442", "Yellow"},
                                                   {"D55E00", "Vermilion"},
                                                   {"CC79A7", "ReddishPurple"},
                                                   {"0072B2", "Blue"},
                                                   {"999999", "Grey"},
                                                   {"181818", "Text"}}};

// At most two decimals (at 1/72 inch, finer than any printer), no locale.
std::string number(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, 2);
    std::string text(digits.data(), end.ptr);
    while (text.ends_with('0')) text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string hexOf(const QColor& color) {
    return color.name().mid(1).toUpper().toStdString();
}

}  // namespace

class TikzEngine : public QPaintEngine {
  public:
    TikzEngine(double unitsPerPoint, std::string stem)
        : QPaintEngine(QPaintEngine::AllFeatures), unit_(1 / unitsPerPoint), stem_(std::move(stem)) {}

    bool begin(QPaintDevice*) override { return true; }
    bool end() override {
        endClip();
        return true;
    }
    Type type() const override { return QPaintEngine::User; }
    void updateState(const QPaintEngineState& state) override {
        constexpr QPaintEngine::DirtyFlags kClip = DirtyClipPath | DirtyClipRegion | DirtyClipEnabled | DirtyTransform;
        if (state.state() & kClip) clipChanged_ = true;
    }

    void drawPath(const QPainterPath& path) override {
        paintPath(pathText(path), path.fillRule() == Qt::OddEvenFill, true);
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        std::string path;
        for (int k = 0; k < count; ++k) path += (k > 0 ? "--" : "") + place(points[k]);
        if (mode != PolylineMode) path += "--cycle";
        paintPath(path, mode == OddEvenMode, mode != PolylineMode);
    }
    void drawPolygon(const QPoint* points, int count, PolygonDrawMode mode) override {
        QPolygonF exact;
        for (int k = 0; k < count; ++k) exact << QPointF(points[k]);
        drawPolygon(exact.constData(), count, mode);
    }
    void drawRects(const QRectF* rects, int count) override {
        for (int k = 0; k < count; ++k) {
            if (state->transform().type() > QTransform::TxScale) {
                QPainterPath path;
                path.addRect(rects[k]);
                drawPath(path);
            } else {
                paintPath(place(rects[k].topLeft()) + " rectangle " + place(rects[k].bottomRight()), false, true);
            }
        }
    }
    void drawRects(const QRect* rects, int count) override {
        for (int k = 0; k < count; ++k) {
            const QRectF exact(rects[k]);
            drawRects(&exact, 1);
        }
    }
    void drawEllipse(const QRectF& box) override {
        if (state->transform().type() > QTransform::TxScale) {
            QPainterPath path;
            path.addEllipse(box);
            return drawPath(path);
        }
        const QRectF mapped = state->transform().mapRect(box);
        const std::string x = number(mapped.width() / 2 * unit_);
        const std::string y = number(mapped.height() / 2 * unit_);
        paintPath(place(box.center()) +
                      (x == y ? " circle[radius=" + x + "]" : " ellipse[x radius=" + x + ",y radius=" + y + "]"),
                  false, true);
    }
    void drawEllipse(const QRect& box) override { drawEllipse(QRectF(box)); }

    // Text that was not painted by paintWords(): centred at the middle of what was measured.
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        node({at.x() + item.width() / 2, at.y()}, "base", item.font(), texText(item.text().toStdString()));
    }
    void drawPixmap(const QRectF& box, const QPixmap& pixmap, const QRectF& part) override {
        drawImage(box, pixmap.toImage(), part, Qt::AutoColor);
    }
    void drawImage(const QRectF& box, const QImage& image, const QRectF& part, Qt::ImageConversionFlags) override {
        pictures_.push_back({stem_ + "-" + std::to_string(pictures_.size() + 1) + ".png", image.copy(part.toRect())});
        const QRectF mapped = state->transform().mapRect(box);
        line("\\node[anchor=north west] at " + place(box.topLeft()) +
             " {\\includegraphics[width=" + number(mapped.width() * unit_) +
             "bp,height=" + number(mapped.height() * unit_) + "bp]{\\reliefscopepath " + pictures_.back().name + "}};");
    }

    void node(const QPointF& at, const char* anchor, const QFont& font, const std::string& text,
              const std::string& more = {}) {
        syncState();  // also for words, which QPainter does not draw itself
        const double size = font.pixelSize() > 0 ? font.pixelSize() * pixel() : font.pointSizeF();
        const double points = size * kTexPointsPerPoint;
        std::string options = std::string("anchor=") + anchor + ",text=" + color(state->pen().color());
        const double opacity = state->pen().color().alphaF() * state->opacity();
        if (opacity < 1) options += ",opacity=" + number(opacity);
        options += ",font=\\reliefscopefont{" + number(points) + "}{" + number(1.2 * points) + "}" +
                   (font.bold() ? "\\bfseries" : "") + more;
        line("\\node[" + options + "] at " + place(at) + " {" + text + "};");
    }
    // Size of a unit of the painter's coordinates, in points.
    double pixel() const { return std::sqrt(std::abs(state->transform().determinant())) * unit_; }

    const std::string& body() const { return body_; }
    const std::vector<std::pair<std::string, std::string>>& colors() const { return colors_; }
    const std::vector<TikzDevice::Picture>& pictures() const { return pictures_; }

  private:
    std::string place(const QPointF& p) const {
        const QPointF at = state->transform().map(p);
        return "(" + number(at.x() * unit_) + "," + number(at.y() * unit_) + ")";
    }
    std::string pathText(const QPainterPath& path) const {
        std::string text;
        QPointF start;
        for (int k = 0; k < path.elementCount(); ++k) {
            const QPainterPath::Element e = path.elementAt(k);
            if (e.isMoveTo()) {
                text += (k > 0 ? " " : "") + place(e);
                start = e;
            } else if (e.isLineTo()) {
                const bool last = k + 1 == path.elementCount() || path.elementAt(k + 1).isMoveTo();
                text += last && QPointF(e) == start ? "--cycle" : "--" + place(e);
            } else {
                text += " .. controls " + place(e) + " and " + place(path.elementAt(k + 1)) + " .. " +
                        place(path.elementAt(k + 2));
                k += 2;
            }
        }
        return text;
    }

    // The name of a colour, without its opacity.
    std::string color(const QColor& color) {
        const std::string hex = hexOf(color);
        for (const auto& [name, value] : colors_) {
            if (value == hex) return name;
        }
        const auto known = std::find_if(kNamedColors.begin(), kNamedColors.end(),
                                        [&](const NamedColor& named) { return hex == named.hex; });
        colors_.emplace_back("rs" + (known != kNamedColors.end() ? std::string(known->name) : hex), hex);
        return colors_.back().first;
    }

    std::string penOptions() {
        const QPen& pen = state->pen();
        const double width = std::max(pen.widthF() * (pen.isCosmetic() ? unit_ : pixel()), 0.01);
        std::string options = color(pen.color()) + ",line width=" + number(width) + "bp";
        const double opacity = pen.color().alphaF() * state->opacity();
        if (opacity < 1) options += ",draw opacity=" + number(opacity);
        if (pen.capStyle() == Qt::SquareCap) options += ",line cap=rect";
        if (pen.capStyle() == Qt::RoundCap) options += ",line cap=round";
        if (pen.joinStyle() == Qt::BevelJoin) options += ",line join=bevel";
        if (pen.joinStyle() == Qt::RoundJoin) options += ",line join=round";
        const QVector<qreal> dashes = pen.style() == Qt::SolidLine ? QVector<qreal>() : pen.dashPattern();
        if (dashes.isEmpty()) return options;
        options += ",dash pattern=";
        for (int k = 0; k < dashes.size(); ++k) {
            options += std::string(k % 2 == 0 ? "on " : "off ") + number(dashes[k] * width) + "bp ";
        }
        if (pen.dashOffset() != 0) options += ",dash phase=" + number(pen.dashOffset() * width) + "bp";
        return options;
    }

    void paintPath(const std::string& path, bool evenOdd, bool fills) {
        const QBrush& brush = state->brush();
        const bool fill = fills && brush.style() != Qt::NoBrush;
        const bool draw = state->pen().style() != Qt::NoPen;
        if (path.empty() || (!fill && !draw)) return;
        std::string options;
        if (draw) options = penOptions();
        if (fill) {
            options += std::string(draw ? ",fill=" : "") + color(brush.color());
            const double opacity = brush.color().alphaF() * state->opacity();
            if (opacity < 1) options += ",fill opacity=" + number(opacity);
            if (evenOdd) options += ",even odd rule";
        }
        line(std::string(draw ? "\\draw[" : "\\fill[") + options + "] " + path + ";");
    }

    // Opens a scope for the painter's clip if it changed.
    void takeClip() {
        if (!clipChanged_) return;
        clipChanged_ = false;
        const std::string clip = painter()->hasClipping() ? pathText(painter()->clipPath()) : std::string();
        if (clip == clip_) return;
        endClip();
        clip_ = clip;
        if (!clip_.empty()) body_ += "\\begin{scope}\\clip " + clip_ + ";\n";
    }
    void endClip() {
        if (!clip_.empty()) body_ += "\\end{scope}\n";
        clip_.clear();
    }
    void line(const std::string& text) {
        takeClip();
        body_ += text + "\n";
    }

    double unit_;  // points per unit of the device
    std::string stem_;
    std::string body_;
    std::vector<std::pair<std::string, std::string>> colors_;  // name and value, in the order of their first use
    std::vector<TikzDevice::Picture> pictures_;
    bool clipChanged_ = false;
    std::string clip_;
};

TikzDevice::TikzDevice(const QSize& size, double unitsPerPoint, std::string stem)
    : size_(size),
      unitsPerPoint_(unitsPerPoint),
      engine_(std::make_unique<TikzEngine>(unitsPerPoint, std::move(stem))) {}

TikzDevice::~TikzDevice() = default;

QPaintEngine* TikzDevice::paintEngine() const {
    return engine_.get();
}

const std::vector<TikzDevice::Picture>& TikzDevice::pictures() const {
    return engine_->pictures();
}

void TikzDevice::words(const QPainter& painter, const QRectF& box, Qt::Alignment side, const QString& text,
                       bool formula) {
    const QFontMetricsF metrics(painter.font());
    const double base = box.center().y() + (metrics.ascent() - metrics.descent()) / 2;
    const std::string tex = formula ? texFormula(text.toStdString()) : texText(text.toStdString());
    if (side & Qt::AlignLeft) return engine_->node({box.left(), base}, "base west", painter.font(), tex);
    if (side & Qt::AlignRight) return engine_->node({box.right(), base}, "base east", painter.font(), tex);
    engine_->node({box.center().x(), base}, "base", painter.font(), tex);
}

void TikzDevice::paragraph(const QPainter& painter, const QRectF& box, const QString& text) {
    engine_->node(box.topLeft(), "north west", painter.font(), texText(text.toStdString()),
                  ",align=left,text width=" + number(box.width() * engine_->pixel()) + "bp");
}

std::string TikzDevice::file(const std::string& name, const std::string& title) const {
    std::string text =
        "% " + title + ", by Reliefscope. In the preamble: \\usepackage{tikz}; in the text: \\input{" + name +
        "}.\n"
        "% Ukrainian words need fonts with these letters: with pdflatex \\usepackage[T2A]{fontenc} and\n"
        "% \\usepackage[ukrainian]{babel}, with lualatex a font chosen with fontspec.\n"
        "% Redefine a colour by \\definecolor, and the size of the texts by \\newcommand\\reliefscopefont[2]{...},\n"
        "% before \\input.\n";
    if (!pictures().empty()) {
        text +=
            "% Needs the pictures beside it; from another folder: \\newcommand\\reliefscopepath{figures/}.\n"
            "\\providecommand\\reliefscopepath{}%\n";
    }
    text += "\\providecommand\\reliefscopefont[2]{\\fontsize{#1}{#2}\\selectfont}%\n";
    for (const auto& [color, value] : engine_->colors())
        text += "\\providecolor{" + color + "}{HTML}{" + value + "}%\n";
    text +=
        "\\begin{tikzpicture}[x=1bp,y=-1bp,every node/.style={inner sep=0pt,outer sep=0pt}]\n\\useasboundingbox (0,0) "
        "rectangle (" +
        number(size_.width() / unitsPerPoint_) + "," + number(size_.height() / unitsPerPoint_) + ");\n";
    return text + engine_->body() + "\\end{tikzpicture}%\n";
}

int TikzDevice::metric(PaintDeviceMetric metric) const {
    const double dpi = unitsPerPoint_ * kPointsPerInch;
    constexpr double kMm = 25.4;
    switch (metric) {
        case PdmWidth:
            return size_.width();
        case PdmHeight:
            return size_.height();
        case PdmWidthMM:
            return qRound(size_.width() / dpi * kMm);
        case PdmHeightMM:
            return qRound(size_.height() / dpi * kMm);
        case PdmNumColors:
            return 1 << 24;
        case PdmDepth:
            return 32;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return qRound(dpi);
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return qRound(devicePixelRatioFScale());
    }
    return 0;
}

void paintWords(QPainter& painter, const QRectF& box, int flags, const QString& text) {
    if (auto* const tikz = dynamic_cast<TikzDevice*>(painter.device())) {
        if (flags & Qt::TextWordWrap) return tikz->paragraph(painter, box, text);
        return tikz->words(painter, box, Qt::Alignment(flags), text, false);
    }
    painter.drawText(box, flags, text);
}

}  // namespace reliefui
