// The Pareto chart: run time against error of methods, both logarithmic, with one labelled mark per method. Methods
// without error have a row of their own below the scale.
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
    std::string current;  // name of the highlighted method; empty: none
    bool old = false;     // measured before the last change; everything is drawn faintly
};
// Title of a table that was read from a file.
relief::Message paretoTitle(const relief::ParetoTable& table);

// Layout of the chart, in points.
struct ParetoFrame {
    Box whole;
    Box plot;            // area of errors above 0
    double zero = 0;     // y of errors equal to 0
    bool zeros = false;  // there are methods without error
    double timeLow = 0;  // decimal logarithms of the times (ns) and errors (texels) at the plot's sides
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
    std::size_t point = 0;  // index in the table
    Point at;
    bool dominated = false;
    Box label;
};
struct ParetoPicture {
    ParetoFrame frame;
    std::vector<ParetoMark> marks;
    std::vector<Point> front;        // Pareto front, starting with the fastest method
    std::vector<Point> scalarFront;  // front of the scalar form, if both forms were measured
    Drawing drawing;
};
ParetoPicture paretoPicture(const ParetoSource& source, const Box& room);

// Adds the explanation of the marks, and on what was measured.
void addParetoLegend(LegendRows& rows, const ParetoSource& source);

// The point whose mark or name is at this place.
std::optional<std::size_t> paretoPointAt(const ParetoPicture& picture, Point at);

}  // namespace reliefui
