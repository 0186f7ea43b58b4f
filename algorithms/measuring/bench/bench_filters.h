// Benchmark of the texture filters, run time against error: filters x pixel models x scenes x elevations, each compared
// with the supersampled picture of the same view, traced exactly.
//
// Only the colour is measured, in linear light and without shading, so that the error is that of the filter alone.
// Pixels near the polygon's edge are excluded, because their reference would include samples beyond it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "measuring/bench/bench_columns.h"
#include "rendering/frame.h"

namespace relief {

// A test scene: a relief with its colours.
struct FilterScene {
    std::string name;
    HeightField field;
    std::shared_ptr<const ColorImage> color;
};
// Names of the procedural scenes: checker (a flat plane), bricks, city, hills; size x size texels, seeded.
std::vector<std::string> filterSceneNames();
// Makes the scene of this name, size x size texels. Throws InputError for unknown names.
FilterScene filterScene(const std::string& name, int size, std::uint64_t seed);
// Returns a picture of coloured patches of a few texels, dark where the heights are low, for height maps without a
// picture.
std::shared_ptr<const ColorImage> patchPicture(const FloatImage& heights, std::uint64_t seed);

// Rows of a view in which no pixel can be compared, because it shows too little of the relief, have NaN in all values.
struct FilterBenchRow {
    FilterChoice filter;
    PixelModel pixelModel = PixelModel::Box;
    std::string scene;
    double elevation = 0;
    int threads = 0;
    double rate = 0;    // pixels per second, median of the rounds
    double spread = 0;  // (p75 - p25) / median
    double rmse = 0;    // linear light
    double psnr = 0;    // decibels, from rmse
    double flip = 0;
    double texelsRead = 0, tested = 0, hidden = 0, skipped = 0;  // per pixel
};

// The columns:
// filter,weights,levels,pixel_model,implementation,map_size,scene,elevation,threads,rate,spread,rmse,psnr,flip,
// texels_read,tested,hidden,skipped. filter: the name, and the options given that have no column of their own.
std::string filterBenchCsvHeader();
std::string filterBenchCsvLine(const FilterBenchRow& row);
std::string filterBenchJson(std::span<const FilterBenchRow> rows);
std::string filterBenchText(std::span<const FilterBenchRow> rows);

struct FilterBenchOptions {
    std::vector<FilterScene> scenes;
    std::vector<FilterChoice> filters;
    std::vector<PixelModel> pixelModels{PixelModel::Box, PixelModel::Gaussian};
    std::vector<double> elevations{60, 25, 8};
    int width = 320;
    int height = 240;
    int samples = 16;  // of the reference, along each side of a pixel
    int rounds = 5;
    BenchPass pass = BenchPass::Both;
    double distance = 1.4;  // of the camera, texture widths
    std::function<void(const FilterBenchRow&)> onRow;
};

// Returns a row for each pixel model; all of them have the same rate. Throws InputError, Cancelled.
std::vector<FilterBenchRow> benchFilters(const FilterBenchOptions& options, Work& work);

}  // namespace relief
