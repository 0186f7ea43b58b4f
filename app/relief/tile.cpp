// relief tile PICTURE -o FILE.tif [--resume | --anew]
#include "installed.h"
#include "options_common.h"
#include "output.h"
#include "tiles_output.h"

namespace relief::app {

namespace {

struct TileOptions {
    OptionText file, height, output;
    ReadingOptions reading;
    RestartOptions restart;
    RunOptions run;
};

const std::string& chosenPicture(const TileOptions& options) {
    if (!options.height) return needed(options.file, "FILE", "tile");
    if (options.file) throw InputError("--height", Message(MessageId::ArgumentsExclude, {{"other", *options.file}}));
    return needed(options.height, "--height", "tile");
}

int runTile(const TileOptions& options, Session& session) {
    options.run.apply(session);
    const std::string picture = shippedFile(chosenPicture(options));
    const std::string& output = needed(options.output, "--output", "tile");
    checkOutput(output, kTiledEndings);
    refuseOverwriting("--output", output, {picture});
    HeightReadOptions reading;
    options.reading.apply(reading);
    const auto rows = pictureHeightRows(picture, reading);
    writeTiles(*rows, output, options.restart, session);
    for (const Message& message : rows->notes()) session.note(picture, message);
    return kDone;
}

}  // namespace

void addTileCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<TileOptions>();
    CLI::App* parser = addCommand(
        program, "tile", "write a height map larger than memory in tiles",
        "Reads a height map row by row and writes it as a tiled TIFF (BigTIFF) together with its pyramid of maxima, "
        "minima and means, without holding the map in memory. relief info reads only the tiles of such a file that it "
        "needs; bench tracers, render, trace and the window do so with --memory, recommend with --resident; other "
        "commands read its heights as a whole, as those of any TIFF. 8- and 16-bit heights keep their numbers; what is "
        "scaled, inverted or of another type becomes 32-bit floats. The file takes "
        "2 (floats), 2.4 (16 bits) or 3 times (8 bits) the space of the heights. A run that is stopped goes on from "
        "FILE.part with --resume. TIFF, OpenEXR, HDR and BMP are read in pieces; the file of a PNG or JPEG is held in "
        "memory; other formats are decoded as a whole.",
        "  relief tile terrain.exr --range 0,4810 -o terrain.tif\n"
        "  relief tile terrain.exr --range 0,4810 -o terrain.tif --resume\n"
        "  relief info terrain.tif\n"
        "  relief render terrain.tif --memory 512 -o picture.png");
    addText(*parser, "FILE", options->file, "", "the height map (TIFF, OpenEXR, PNG, ...)", "Arguments");
    addText(*parser, "--height", options->height, "FILE", "height map: the same as FILE", "Pictures");
    addOutput(*parser, options->output, "the tiled height map: .tif");
    options->restart.add(*parser, "a map that takes long", "Output");
    options->reading.addForRows(*parser);
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runTile(*options, session); }});
}

}  // namespace relief::app
