// What every chart is made of: scales, their ticks and numbers, axes with titles. Text is measured in the font that the
// painter sets it in, so that the numbers of an axis neither touch each other nor leave the drawing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "painting/drawing.h"
#include "painting/text_width.h"

namespace reliefui::chart {

// Points.
inline constexpr double kTextSize = kChartText;
inline constexpr double kTick = 3;
inline constexpr double kLeft = 34;       // room left of a plot for its numbers,
inline constexpr double kRight = 12;      // right of it for half a number,
inline constexpr double kBottom = 29;     // below it for numbers and the title of the axis,
inline constexpr double kLowBottom = 16;  // of a low drawing: for both in one row
inline constexpr double kTitleLine = 11;

// 1, 2 or 5 times a power of ten, so that at most `most` of them fit into the range.
double niceStep(double range, double most);
// With the decimals that the step needs.
std::string tickText(double value, double step);
// The multiples of a step between two values, at most 200 of them.
std::vector<double> multiples(double low, double high, double step);
// "10⁻³".
std::string powerOfTen(int n);

// Plain: linear. Powers: logarithmic, numbered by powers of ten. Decades: logarithmic, with plain numbers, between
// powers of ten 2 and 5 times these where there is room.
enum class Numbers : std::uint8_t { Plain, Powers, Decades };

// Values along one side of a plot, in drawing units.
struct Scale {
    double low = 0;   // the value at `from`; of a logarithmic scale its decimal logarithm
    double high = 1;  // at `to`
    double from = 0;
    double to = 1;
    Numbers numbers = Numbers::Plain;
    double leastStep = 0;  // between numbers: 1 of what is counted

    // Of a logarithmic scale for values above 0.
    double at(double value) const;
    double valueAt(double place) const;
};

struct Tick {
    double at = 0;  // drawing units
    std::string text;
};
enum class Side : std::uint8_t { Left, Below };
// As many as can be read. unit: drawing units a point.
std::vector<Tick> ticks(const Scale& scale, Side side, double unit = 1);

// The plot in a room, within margins; never turned inside out.
struct Margins {
    double left = kLeft;
    double top = 0;
    double right = kRight;
    double bottom = kBottom;
};
Box plotIn(const Box& room, const Margins& margins);
// Below the plot of a drawing of this height; `low` ones have one row there.
inline double bottomOf(double height, double low = 150) {
    return height < low ? kLowBottom : kBottom;
}

// The axes of one plot, in a room that numbers and titles do not leave. unit: drawing units a point.
class Axes {
  public:
    Axes(Drawing& drawing, const Box& plot, const Box& room, double unit = 1)
        : drawing_(drawing), plot_(plot), room_(room), unit_(unit) {}

    // Ticks and numbers at the left; with lines across the plot where these are wanted.
    void left(const Scale& scale, bool lines = false) const;
    // Below the plot. The title stands below the numbers, or where the room has one row only, at its end, and numbers
    // give way to it.
    void below(const Scale& scale, const std::optional<relief::Message>& title = std::nullopt) const;
    // Above the upper left corner: what the numbers at the left are. It gives way to strong words there.
    void corner(relief::Message title) const;
    // The left and the lower side.
    void sides() const;

  private:
    void tick(Point from, Point to, Role role = Role::Frame) const;

    Drawing& drawing_;
    Box plot_;
    Box room_;
    double unit_;
};

void line(Drawing& drawing, Point from, Point to, Role role = Role::Frame);
void text(Drawing& drawing, Point at, relief::Message message, Anchor anchor, Point offset = {},
          Role role = Role::Legend, Emphasis emphasis = Emphasis::Normal);
// In either language; points, of text of the charts' size.
double widthOf(const relief::Message& message);
// The charts' size, or the part of it with which a text of this width fits into a room.
double fittingSize(double width, double room);
// At the upper left corner of a room, as large as fits into its width, in either language; a title of two parts
// (" · ") in two lines where one would be small. How many lines it takes.
int title(Drawing& drawing, relief::Message message, const Box& room, Role role = Role::Legend);

}  // namespace reliefui::chart
