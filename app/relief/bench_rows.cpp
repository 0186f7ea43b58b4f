// relief bench rows [-o FILE.csv|json]
#include "bench_rows.h"

#include "bench_output.h"
#include "measuring/bench/bench_rows.h"
#include "measuring/bench/bench_tracers.h"

namespace relief::app {

namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;
constexpr std::int64_t kMostRounds = 1000;

RowBenchOptions rowOptions(const RowBenchCommand& given, const OptionText& elevations, const OptionText& rounds) {
    RowBenchOptions options;
    if (given.variants) {
        options.methods.clear();
        for (const std::string& text : splitText(*given.variants, ',')) {
            options.methods.push_back(parseRowMethod(text, "--variants"));
        }
    }
    if (given.widths) {
        options.widths.clear();
        for (const std::string& text : splitText(*given.widths, ',')) {
            options.widths.push_back(parseWhole(text, "--widths", 1, kWidestRow));
        }
    }
    if (elevations) {
        options.elevations.clear();
        for (const std::string& text : splitText(*elevations, ',')) {
            const Elevation elevation = parseElevation(text, "--elevations");
            if (!elevation) {
                throw InputError("--elevations", Message(MessageId::NotANumber, {{"text", text}}));
            }
            options.elevations.push_back(*elevation);
        }
    }
    if (given.precisions) {
        options.precisions.clear();
        for (const std::string& text : splitText(*given.precisions, ',')) {
            if (text != "float" && text != "double") {
                throw InputError("--precisions",
                                 unknownName({"what", MessageId::WordPrecision}, text, "float, double"));
            }
            options.precisions.push_back(text == "float" ? RowPrecision::Float : RowPrecision::Double);
        }
    }
    if (given.pixels) options.pixels = parseWhole(*given.pixels, "--pixels", 1, kMostPixels);
    if (rounds) options.rounds = static_cast<int>(parseWhole(*rounds, "--rounds", 1, kMostRounds));
    return options;
}

}  // namespace

void RowBenchCommand::add(CLI::App& parser) {
    const char* group = "Measurement (rows)";
    addText(parser, "--variants", variants, "NAME,...",
            "row methods, each with options as NAME:OPTION=VALUE, such as streams:streams=4:anchor=0; default: all of "
            "relief list, some of them in two forms",
            group);
    addText(parser, "--widths", widths, "N,...",
            "numbers of pixels per row, up to 1048576, default 640,3840,16384,65536", group);
    addText(parser, "--precisions", precisions, "float,double", "number types, default both", group);
    addText(parser, "--rows", rows, "N,...",
            "heights of the blocks of rows into which the same number of pixels is divided; default: one block. Rows "
            "in parallel are slow for few long rows: --variants rows-parallel --widths 65536 --rows 1,2,64",
            group);
    addText(parser, "--pixels", pixels, "N", "number of pixels in one timing, default 4194304", group);
}

int RowBenchCommand::run(const OptionText& elevations, const OptionText& rounds, BenchRun to, Session& session) const {
    const RowBenchOptions options = rowOptions(*this, elevations, rounds);
    to.what["rounds"] = options.rounds;
    to.what["pixels"] = options.pixels;
    if (rows) to.what["rows"] = *rows;
    std::vector<std::int64_t> blocks{0};
    if (rows) {
        blocks.clear();
        for (const std::string& text : splitText(*rows, ','))
            blocks.push_back(parseWhole(text, "--rows", 1, kMostPixels));
    }
    to.what["variants"] = variants.value_or("");
    to.what["threads"] = session.threads();
    // Shared by all cells: copies of all widths in each of 100,000 cells would take a gigabyte.
    RowBenchOptions common = options;
    common.widths.clear();
    common.elevations.clear();
    common.precisions.clear();
    std::vector<BenchCell<RowBenchRow>> cells;
    for (const std::int64_t width : options.widths) {
        for (const double elevation : options.elevations) {
            for (const RowPrecision precision : options.precisions) {
                for (const std::int64_t block : blocks) {
                    RowBenchOptions one = common;
                    one.widths = {width};
                    one.elevations = {elevation};
                    one.precisions = {precision};
                    one.rows = block;
                    std::string name = std::to_string(width) + "," + numberText(elevation) + "," +
                                       std::string(precisionName(precision));
                    if (rows) name += "," + std::to_string(block);
                    cells.push_back({std::move(name), 0, [one = std::move(one)](Work& work, BenchPass pass) mutable {
                                         one.pass = pass;
                                         return benchRows(one, work);
                                     }});
                }
            }
        }
    }
    return runCells<RowBenchRow>(to, {rowBenchCsvHeader, rowBenchJson, rowBenchText}, cells, session);
}

}  // namespace relief::app
