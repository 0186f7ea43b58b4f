// What a pane draws for a file: a page, in vectors or pixels, with the drawings of the screen. Needs no display and no
// window.
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
// Pixels along a side of a picture that is rendered anew for a figure: what fits into the memory of a large desktop.
inline constexpr int kMostRenderedPixels = 16384;

struct FigurePage {
    std::string title;     // of the file: the view's name
    double widthMm = 160;  // the height follows from the figure
    double dpi = 300;      // of pixels, and of pictures among lines and words
    bool caption = true;   // what the figure says of itself, below it
    Style style;           // theme and language; points are the page's
    int widthPixels = 0;   // of a PNG, and of pictures among lines and words; 0: as dpi says

    int pixels() const;
    // Of a picture that is so many points of the page wide, to have each pixel once; within kMostRenderedPixels.
    int picturePixels(double points) const;
};

inline constexpr double kFigureAspect = 0.56;

// Immutable. With vectors it may be painted on any thread; without, on the window's alone (OpenGL).
class Figure {
  public:
    virtual ~Figure() = default;
    // The same with all that has to be computed for this page, which may take long; null: nothing has. Its aspect,
    // caption and paint are what goes onto the page. Any thread. Throws Cancelled, InputError.
    virtual std::shared_ptr<const Figure> prepared(const FigurePage&, relief::Work&) const { return nullptr; }
    // Whether it is made of lines and words, and so can be an SVG or a PDF.
    virtual bool vectors() const { return true; }
    // Height over width.
    virtual double aspect(const FigurePage&) const { return kFigureAspect; }
    virtual void paint(QPainter& painter, const Box& page, const Style& style) const = 0;
    // What it shows of what: pictures, method, pixel. Empty: nothing.
    virtual std::string caption(relief::Language) const { return {}; }
    // In pixels; without the caption.
    virtual QImage image(const FigurePage& page, const QSize& size) const;
};

using PagePainter = std::function<void(QPainter&, const Box& page, const Style&)>;
using PageAspect = std::function<double(const FigurePage&)>;
using FigureCaption = std::function<std::string(relief::Language)>;
// Of lines and words. aspect: empty: as Figure::aspect().
std::shared_ptr<const Figure> paintedFigure(PagePainter paint, FigureCaption caption, PageAspect aspect = {});
// Of what takes long to compute: `make` does it for a page, see Figure::prepared().
using FigureMaker = std::function<std::shared_ptr<const Figure>(const FigurePage&, relief::Work&)>;
std::shared_ptr<const Figure> computedFigure(FigureMaker make);

// Charts with a legend below them. legend: in so many points of width; layers: in the room that it leaves, points.
struct ChartMaker {
    std::function<Drawing(double width, relief::Language)> legend;
    std::function<std::vector<Drawing>(double width, double height, const Style&)> layers;
    double aspect = kFigureAspect;  // of the page; higher where a long legend would leave less than
    double leastRoom = 0.42;        // of its width
};
std::shared_ptr<const Figure> chartFigure(ChartMaker maker, FigureCaption caption);

inline constexpr double kFigureMargins = 2 * kFigureMargin;  // both sides

// There is nothing to draw. The line says what to give in a command; a window says it in its own words.
class EmptyFigure : public relief::InputError {
  public:
    EmptyFigure(const char* name, relief::MessageId why)
        : InputError(std::string("--export ") + name, relief::Message(why)) {}
};

// InputError naming `what` if the value lies outside.
void requireRange(const std::string& what, double value, double low, double high);

// SVG, PDF or PNG, by the ending of the path. Throws InputError for an unknown ending, width or resolution, and where a
// figure without vectors would be an SVG or a PDF.
void checkPage(const FigurePage& page, const std::string& path, bool vectors);
// Checks as well, and prepares; WorkError if it cannot be drawn or written. Throws Cancelled: then the file is as it
// was.
void writeFigure(const Figure& figure, const FigurePage& page, const std::string& path, relief::Work& work);
// The same as pixels, `width` of them wide, with the caption below.
QImage figureImage(const Figure& figure, const FigurePage& page, int width, relief::Work& work);

}  // namespace reliefui
