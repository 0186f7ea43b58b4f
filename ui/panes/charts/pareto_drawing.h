// The Pareto chart: run time against error of methods, both logarithmic, a mark a method with its name. Methods without
// any error have a row of their own below the scale.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measuring/bench/pareto.h"
#include "painting/chart.h"
#include "painting/legend_rows.h"

namespace reliefui {

struct ParetoSource {
    relief::ParetoTable table;
    relief::ErrorMeasure measure = relief::ErrorMeasure::Mean;
    relief::Message title;
    std::string current;  // name of the method that is marked as chosen; empty: none
    bool old = false;     // measured before the last change: all is drawn faintly
};
// The title of a table that was read from a file.
relief::Message paretoTitle(const relief::ParetoTable& table);

// Where what lies, in points.
struct ParetoFrame {
    Box whole;
    Box plot;            // of errors above 0
    double zero = 0;     // y of those of 0
    bool zeros = false;  // there are any
    double timeLow = 0;  // decimal logarithms of nanoseconds and texels at the sides
    double timeHigh = 1;
    double errorLow = 0;
    double errorHigh = 1;

    chart::Scale times() const { return {timeLow, timeHigh, plot.x0, plot.x1, chart::Numbers::Decades}; }
    chart::Scale errors() const { return {errorLow, errorHigh, plot.y1, plot.y0, chart::Numbers::Powers}; }
    double xAt(double nanoseconds) const { return times().at(nanoseconds); }
    double yAt(double texels) const;
};
ParetoFrame paretoFrame(const ParetoSource& source, const Box& room);

struct ParetoMark {
    std::size_t point = 0;  // of the table
    Point at;
    bool dominated = false;
    Box label;
};
struct ParetoPicture {
    ParetoFrame frame;
    std::vector<ParetoMark> marks;
    std::vector<Point> front;        // its line, from the fastest on
    std::vector<Point> scalarFront;  // where both forms were measured: that of the scalar one
    Drawing drawing;
};
ParetoPicture paretoPicture(const ParetoSource& source, const Box& room);

// What the marks are, and where it was measured.
void addParetoLegend(LegendRows& rows, const ParetoSource& source);

// The point whose mark or name is there.
std::optional<std::size_t> paretoPointAt(const ParetoPicture& picture, Point at);

}  // namespace reliefui
