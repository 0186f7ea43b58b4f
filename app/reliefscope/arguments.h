// What `reliefscope` is asked for.
#pragma once

#include <string>

namespace relief::app {

struct Arguments {
    bool help = false;
    bool version = false;
    bool checkDisplay = false;
    bool anew = false;       // not where the last window left off
    bool log = false;        // what held the window is told at its end
    std::string file;        // scenario or picture; empty: the start
    std::string screenshot;  // where to; empty: none
    int width = 0;           // of the window; 0: as it likes
    int height = 0;
    std::string figure;  // the view to export; empty: the window is opened
    std::string output;  // where to
    double widthMm = 160;
    double dpi = 300;
    bool dark = false;
    bool caption = true;
    std::string pixel;                       // "X,Y"; empty: the scenario's
    std::string tracers, filters, mappings;  // with commas between; empty: the scenario's
    int pixelWidth = 0;                      // of the picture; 0: the scenario's
    int pixelHeight = 0;
    // Of the view "distance".
    std::string layer;  // of result
    std::string map;    // the kind; empty: the method's
    std::string minus;
    std::string axis;  // "x", "y", "z"; empty: as the ray runs
    int slice = -1;    // -1: the one at the step
    // Of the view "rows".
    std::string variants;  // with commas between; empty: its own choice
    int rowWidth = 0;      // 0: the picture's
    // Of the view "pareto".
    std::string relief;     // rows of this relief only; empty: of all
    std::string elevation;  // and of this elevation
    std::string error;      // of "charts", too: the measure; empty: the mean
};

// Throws InputError for what is not understood.
Arguments parseArguments(int count, char** arguments);

// views: the lines that name what --export knows.
std::string helpText(const std::string& views);

}  // namespace relief::app
