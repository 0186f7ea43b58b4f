// The command-line arguments of `reliefscope`.
#pragma once

#include <optional>
#include <string>

namespace relief::app {

struct Arguments {
    bool help = false;
    bool version = false;
    bool checkDisplay = false;
    bool anew = false;       // do not restore the last session
    bool log = false;        // when the window closes, print what blocked it
    std::string file;        // scenario or picture; empty: the start scenario
    int memory = 0;          // megabytes for a height map that is read by tiles; 0: as in the scenario
    std::string screenshot;  // output file; empty: none
    int width = 0;           // of the window, in pixels; 0: default
    int height = 0;
    std::string lesson;        // its name, "all", or a folder; empty: none
    bool check = false;        // check the lesson instead of opening it
    bool html = false;         // write a page instead of a figure, or of opening the lesson
    std::string paperFigures;  // names of figures of papers, "all", or files; empty: none
    std::string figure;        // the view to export; empty: open the window
    std::string output;        // output file of the export
    // Frames of a moving picture in place of one figure, as relief::parseSequence() has it; empty: one figure.
    std::string sequence;
    std::optional<int> frames;
    double widthMm = 160;
    double dpi = 300;
    bool dark = false;
    bool caption = true;
    std::string pixel;                       // "X,Y"; empty: the scenario's
    std::string tracers, filters, mappings;  // comma-separated; empty: the scenario's
    int pixelWidth = 0;                      // of the picture, in pixels; 0: the scenario's
    int pixelHeight = 0;
    // Of the view "result" (layer) and of the view "distance" (the others).
    std::string layer;
    std::string map;  // kind of map; empty: the method's
    std::string minus;
    std::string axis;  // "x", "y", "z"; empty: the ray's main axis
    int slice = -1;    // -1: the slice of the current step
    // Of the view "rows".
    std::string variants;         // comma-separated; empty: the view's default
    std::optional<int> rowWidth;  // in pixels; default: the picture's
    // Of the view "pareto".
    std::string relief;     // only rows of this relief; empty: all
    std::string elevation;  // only rows of this elevation; empty: all
    std::string error;      // error measure, also of "charts"; empty: the mean
};

// Throws InputError for unknown or invalid arguments.
Arguments parseArguments(int count, char** arguments);

// views: the lines of the help that list the values of --export.
std::string helpText(const std::string& views);

}  // namespace relief::app
