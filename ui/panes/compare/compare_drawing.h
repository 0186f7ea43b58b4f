// Layout of the compared pictures, and the text around them. The pictures themselves are images, which the caller
// paints into the boxes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "painting/range_legend.h"
#include "scenario/comparison.h"

namespace reliefui {

struct CompareTile {
    std::string name;                         // "A max-pyramid"
    std::string title;                        // "Max pyramid"; empty: none
    bool reference = false;                   // reference for the other tiles
    std::optional<relief::Message> missing;   // message shown instead of a picture
    std::string same;                         // letter of an earlier tile with the same picture; empty: none
    std::optional<relief::Message> pending;   // message shown instead of numbers that are not available yet
    bool veiled = false;                      // the picture belongs to another scenario
    bool measuring = false;                   // errors are being measured
    std::optional<relief::Message> progress;  // progress of measuring
    bool rating = false;                      // rates are being measured
    std::optional<double> rmse, psnr, flip;
    bool equal = false;           // bitwise equal to the reference
    std::optional<double> rate;   // 10^6 rays per second; filters: 10^6 pixels per second
    double spread = 0;            // of the rate: interquartile range of the rounds, relative to the rate
    std::optional<double> steps;  // mean over the rays
    std::optional<double> off;    // mappings: largest deviation from direct, in texels
    std::optional<int> samples;   // supersample: rays per pixel
    bool traces = true;           // false: it does not trace rays, so no rate will follow
};

struct CompareSource {
    relief::CompareSubject subject = relief::CompareSubject::Methods;
    relief::CompareMode mode = relief::CompareMode::Tiles;
    relief::CompareMeasure measure = relief::CompareMeasure::Flip;
    std::vector<CompareTile> tiles;
    std::vector<double> dividers;  // swipe mode: positions, one fewer than tiles
    std::size_t shown = 0;         // flicker mode: index of the visible tile
    double aspect = 0.75;          // height / width of the pictures
    // The scale of differences; its name is that of the measure. Empty: not measured yet.
    std::optional<RangedValues> errors;
    int columns = 0;        // of tiles; 0: the number that makes them largest
    std::string reference;  // name of the reference
    std::size_t rays = 0;   // number of rays or pixels used for the rates; 0: not measured yet
    int rounds = 0;
    std::size_t lines = 0;  // minimum number of text lines to reserve, so that the pictures do not move
};

struct CompareLayout {
    Box bounds;
    std::vector<Box> rooms;    // box of each tile's picture; all equal if the tiles share a place
    std::vector<Box> clips;    // visible part of each tile's box; empty: hidden
    std::vector<bool> veiled;  // per tile: the picture is veiled
    std::vector<double> dividers;
    std::size_t lines = 0;  // number of text lines reserved
    Drawing drawing;        // drawn over the pictures: names, numbers, frames, dividers
};
// width, height: in points.
CompareLayout compareLayout(const CompareSource& source, double width, double height, relief::Language language);
// Smallest height, in points, at which the pictures are large enough to be distinguished, with all numbers.
double compareLeastHeight(const CompareSource& source, double width, relief::Language language);
// Name of a measure, shown at its scale.
relief::Message compareErrorName(relief::CompareMeasure measure);
// Height, in points, at which the pictures fill this width in source.columns columns.
double compareHeight(const CompareSource& source, double width, relief::Language language);
// Only the scale of differences, in a few rows.
Drawing compareScale(const CompareSource& source, double width, relief::Language language);
Drawing compareLegend(const CompareSource& source, double width, relief::Language language);

// A tile's numbers as single texts: "RMSE 0.0123", "PSNR 38.2 dB", ...
std::vector<std::string> compareNumbers(const CompareTile& tile, relief::Language language);

}  // namespace reliefui
