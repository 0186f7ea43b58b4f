// Common parts of all charts: scales, ticks and their numbers, axes with titles. Text is measured in the font that the
// painter uses, so that the numbers of an axis neither overlap each other nor extend beyond the drawing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "painting/drawing.h"
#include "painting/text_width.h"

namespace reliefui::chart {

// Sizes in points.
inline constexpr double kTextSize = kChartText;
inline constexpr double kTick = 3;
inline constexpr double kLeft = 34;       // margin left of a plot, for the numbers of its axis
inline constexpr double kRight = 12;      // margin at the right, for half a number
inline constexpr double kBottom = 29;     // margin below, for the numbers and the title of the axis
inline constexpr double kLowBottom = 16;  // margin below a low drawing, where numbers and title share a row
inline constexpr double kTitleLine = 11;

// Smallest of 1, 2 or 5 times a power of ten with which the range holds at most `most` steps.
double niceStep(double range, double most);
// Text of a tick's value, with as many decimals as the step needs.
std::string tickText(double value, double step);
// Multiples of a step between two values; at most 200 are returned.
std::vector<double> multiples(double low, double high, double step);
// 10^n with a superscript exponent, e.g. "10⁻³".
std::string powerOfTen(int n);

// Plain: linear axis. Powers: logarithmic axis labelled with powers of ten. Decades: logarithmic axis labelled with
// plain numbers, at 1, 2 and 5 times each power of ten where there is room.
enum class Numbers : std::uint8_t { Plain, Powers, Decades };

// Maps values to positions along one side of a plot.
struct Scale {
    double low = 0;   // value at `from`; its decimal logarithm if the scale is logarithmic
    double high = 1;  // value at `to`
    double from = 0;
    double to = 1;
    Numbers numbers = Numbers::Plain;
    double leastStep = 0;  // smallest distance between numbers; 1 for counts

    // Position of a value, in drawing units. On a logarithmic scale the value must be positive.
    double at(double value) const;
    double valueAt(double place) const;
};

struct Tick {
    double at = 0;  // drawing units
    std::string text;
};
enum class Side : std::uint8_t { Left, Below };
// As many ticks as can be read without overlap. unit: drawing units per point.
std::vector<Tick> ticks(const Scale& scale, Side side, double unit = 1);

// Computes the plot's box from the available room and the margins; the box is never inverted.
struct Margins {
    double left = kLeft;
    double top = 0;
    double right = kRight;
    double bottom = kBottom;
};
Box plotIn(const Box& room, const Margins& margins);
// Bottom margin of a plot in a drawing of this height; drawings lower than `low` have a single row there.
inline double bottomOf(double height, double low = 150) {
    return height < low ? kLowBottom : kBottom;
}

// Draws the axes of one plot. Numbers and titles stay within `room`. unit: drawing units per point.
class Axes {
  public:
    Axes(Drawing& drawing, const Box& plot, const Box& room, double unit = 1)
        : drawing_(drawing), plot_(plot), room_(room), unit_(unit) {}

    // Ticks and numbers at the left; `lines` adds grid lines across the plot.
    void left(const Scale& scale, bool lines = false) const;
    // Ticks and numbers below the plot. The title stands below the numbers or, where there is only one row, at its end,
    // and numbers that would overlap it are left out.
    void below(const Scale& scale, const std::optional<relief::Message>& title = std::nullopt) const;
    // Title of the left axis, above the plot's upper left corner. It is left out where it would cover emphasised
    // labels. reserved: width, in points, that it leaves free at the right, for a text on the same line.
    void corner(relief::Message title, double reserved = 0) const;
    // Draws the left and lower sides of the plot's frame.
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
// Largest width of the message over both languages, in points, at the charts' text size.
double widthOf(const relief::Message& message);
// The charts' text size, or smaller, so that a text `width` points wide at that size fits into `room`.
double fittingSize(double width, double room);
// Adds a title at the upper left corner of a room, as large as fits its width in both languages. A title of two parts
// (separated by " · ") is split into two lines where one line would be too small. Returns the number of lines.
int title(Drawing& drawing, relief::Message message, const Box& room, Role role = Role::Legend);

}  // namespace reliefui::chart
