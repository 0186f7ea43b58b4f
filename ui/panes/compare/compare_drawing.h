// Where the compared pictures lie beside each other, and what is written around them. The pictures
// themselves are pixels: whoever paints puts them into the rooms.
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
    bool reference = false;                   // of the others
    std::optional<relief::Message> missing;   // said instead of a picture
    std::string same;                         // letter of an earlier tile that shows the same thing; empty: none
    std::optional<relief::Message> pending;   // said instead of numbers: they are not there yet
    bool veiled = false;                      // what is seen is the picture of something else
    bool measuring = false;                   // how far it is off
    std::optional<relief::Message> progress;  // of measuring
    bool rating = false;                      // how fast it is
    std::optional<double> rmse, psnr, flip;
    bool equal = false;           // to the reference, in every bit
    std::optional<double> rate;   // 10^6 rays a second; of filters: 10^6 pixels
    std::optional<double> steps;  // mean of the rays
    std::optional<double> off;    // of a mapping: texels from direct, at most
    std::optional<int> samples;   // rays a pixel, of supersample
    bool traces = true;           // false: no rays are searched along, no rate is to be expected
};

struct CompareSource {
    relief::CompareSubject subject = relief::CompareSubject::Methods;
    relief::CompareMode mode = relief::CompareMode::Tiles;
    relief::CompareMeasure measure = relief::CompareMeasure::Flip;
    std::vector<CompareTile> tiles;
    std::vector<double> dividers;  // of swipe: one fewer than tiles
    std::size_t shown = 0;         // of flicker
    double aspect = 0.75;          // height over width of the pictures
    // The scale of differences; its name is the measure's. None: they are not measured yet.
    std::optional<RangedValues> errors;
    int columns = 0;        // of tiles; 0: as many as make them largest
    std::string reference;  // its name
    std::size_t rays = 0;   // or pixels, that the rates were measured on; 0: not yet
    int rounds = 0;
    std::size_t lines = 0;  // of numbers for which there is room at least, so that pictures stay where they were
};

struct CompareLayout {
    Box bounds;
    std::vector<Box> rooms;    // of each tile's picture; one for all of them where they share a place
    std::vector<Box> clips;    // what of the room shows this tile; empty: nothing
    std::vector<bool> veiled;  // which
    std::vector<double> dividers;
    std::size_t lines = 0;  // of numbers, that there is room for
    Drawing drawing;        // over the pictures: names, numbers, frames, dividers
};
// width, height: points.
CompareLayout compareLayout(const CompareSource& source, double width, double height, relief::Language language);
// The least height at which the pictures are large enough to be told apart, with all their numbers.
double compareLeastHeight(const CompareSource& source, double width, relief::Language language);
// What a measure is called on its scale.
relief::Message compareErrorName(relief::CompareMeasure measure);
// The height, points, in which the pictures fill this width, in so many columns.
double compareHeight(const CompareSource& source, double width, relief::Language language);
// The scale of differences alone, in few rows.
Drawing compareScale(const CompareSource& source, double width, relief::Language language);
Drawing compareLegend(const CompareSource& source, double width, relief::Language language);

// Its numbers as they stand below a tile, each by itself: "RMSE 0.0123", "PSNR 38.2 dB", ...
std::vector<std::string> compareNumbers(const CompareTile& tile, relief::Language language);

}  // namespace reliefui
