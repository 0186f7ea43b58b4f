// What a pane exports to a file: a page of vectors or pixels that reuses the drawings of the screen. Needs no display
// and no window.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <QImage>

#include "painting/painter.h"
#include "relief/work.h"

namespace reliefui {

inline constexpr double kMmPerInch = 25.4;
inline constexpr double kMmPerPoint = kMmPerInch / kPointsPerInch;
inline constexpr double kLeastFigureMm = 20;
inline constexpr double kMostFigureMm = 2000;
// Largest side, in pixels, of a picture rendered for a figure; fits in the memory of a large desktop.
inline constexpr int kMostRenderedPixels = 16384;

struct FigurePage {
    std::string title;     // title in the file's metadata: the view's name
    double widthMm = 160;  // the height follows from the figure's aspect
    double dpi = 300;      // resolution of PNG files, and of pictures inside vector files
    bool caption = true;   // add the figure's caption below it
    Style style;           // theme and language; its points are those of the page
    int widthPixels = 0;   // of a PNG, and of pictures inside vector files; 0: follows from dpi

    int pixels() const;
    // Factor by which figures are higher, relative to their width, on pages narrower than kFullFigureMm: text keeps its
    // size there, so that drawings need more room.
    double taller() const;
    // Width in pixels at which a picture that is `points` wide on the page has each pixel exactly once; at most
    // kMostRenderedPixels.
    int picturePixels(double points) const;
};

inline constexpr double kFigureAspect = 0.56;
inline constexpr double kFullFigureMm = 140;

// A figure. Immutable. Figures with vectors may be painted on any thread, others only on the window's (OpenGL).
class Figure {
  public:
    virtual ~Figure() = default;
    // Returns the figure with everything computed that this page needs, which may take long; null if nothing has to be
    // computed. Aspect, caption and paint of the returned figure are used for the page. May be called on any thread.
    // Throws Cancelled, InputError.
    virtual std::shared_ptr<const Figure> prepared(const FigurePage&, relief::Work&) const { return nullptr; }
    // Returns true if the figure consists of lines and text, so that it can be written as SVG or PDF.
    virtual bool vectors() const { return true; }
    // Height / width.
    virtual double aspect(const FigurePage&) const { return kFigureAspect; }
    virtual void paint(QPainter& painter, const Box& page, const Style& style) const = 0;
    // Caption: pictures, method, pixel. Empty: no caption.
    virtual std::string caption(relief::Language) const { return {}; }
    // Renders to pixels, without the caption.
    virtual QImage image(const FigurePage& page, const QSize& size) const;
};

using PagePainter = std::function<void(QPainter&, const Box& page, const Style&)>;
using PageAspect = std::function<double(const FigurePage&)>;
using FigureCaption = std::function<std::string(relief::Language)>;
// Creates a figure of lines and text. aspect: if empty, Figure::aspect() applies.
std::shared_ptr<const Figure> paintedFigure(PagePainter paint, FigureCaption caption, PageAspect aspect = {});
// Creates a figure that takes long to compute: `make` computes it for a page, see Figure::prepared().
using FigureMaker = std::function<std::shared_ptr<const Figure>(const FigurePage&, relief::Work&)>;
std::shared_ptr<const Figure> computedFigure(FigureMaker make);

// Creates charts with a legend below them. legend: makes the legend for a width in points; layers: makes the drawings
// for the remaining room, in points.
struct ChartMaker {
    std::function<Drawing(double width, relief::Language)> legend;
    std::function<std::vector<Drawing>(double width, double height, const Style&)> layers;
    // Aspect of a page that is not narrow; increased if a long legend would leave less than leastRoom.
    double aspect = kFigureAspect;
    double leastRoom = 0.42;  // height of the charts' room / its width, on a page that is not narrow
};
std::shared_ptr<const Figure> chartFigure(ChartMaker maker, FigureCaption caption);

inline constexpr double kFigureMargins = 2 * kFigureMargin;  // sum of both sides
// Height, in points, that a legend below a drawing and the margins above, between and below them take.
inline double legendRoom(const Drawing& legend) {
    return legend.bounds.height() + 1.5 * kFigureMargins;
}

// Thrown if there is nothing to draw. The message names the command line option to set; a window shows a text of its
// own.
class EmptyFigure : public relief::InputError {
  public:
    EmptyFigure(const char* name, relief::MessageId why)
        : InputError(std::string("--export ") + name, relief::Message(why)) {}
};

// Throws InputError that names `what` if the value is outside [low, high].
void requireRange(const std::string& what, double value, double low, double high);

// Checks the page's width and resolution and the file's extension (SVG, PDF or PNG). Throws InputError for invalid
// ones, and if a figure without vectors would be written as SVG or PDF.
void checkPage(const FigurePage& page, const std::string& path, bool vectors);
// Checks the page, prepares the figure and writes it. Throws WorkError if it cannot be drawn or written, and Cancelled;
// the file is then unchanged.
void writeFigure(const Figure& figure, const FigurePage& page, const std::string& path, relief::Work& work);
// Renders the figure to an image `width` pixels wide, with the caption below.
QImage figureImage(const Figure& figure, const FigurePage& page, int width, relief::Work& work);

}  // namespace reliefui
