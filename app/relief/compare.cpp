// relief compare A B [-o ERROR.png]
#include <cmath>

#include "measuring/compare/picture_error.h"
#include "options_common.h"
#include "output.h"
#include "relief/files.h"

namespace relief::app {

namespace {

struct CompareOptions {
    OptionText reference, test, output, pixelsPerDegree, maxPixels;
    RunOptions run;
};

void refuseNan(const std::string& path, const ColorImage& picture) {
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Color& c = picture(x, y);
            if (!std::isnan(c.r) && !std::isnan(c.g) && !std::isnan(c.b)) continue;
            throw InputError(path, Message(MessageId::PixelNotANumber, {{"x", x}, {"y", y}}));
        }
    }
}

// Grey, as the file shows it: 0 black, 1 white.
void writeErrors(const std::string& path, const FloatImage& errors) {
    if (fileEnding(path) == "exr") {
        writePlanes(path, {{"Y", errors}});
        return;
    }
    ColorImage grey(errors.width(), errors.height());
    for (std::size_t i = 0; i < errors.size(); ++i) grey.pixels()[i] = Color(linearFromSrgb(errors.pixels()[i]));
    writeColor(path, grey);
}

int runCompare(const CompareOptions& options, Session& session) {
    options.run.apply(session);
    const std::string& nameA = needed(options.reference, "A", "compare");
    const std::string& nameB = needed(options.test, "B", "compare");
    if (options.output) checkOutput(*options.output, {"png", "tif", "tiff", "bmp", "exr"});
    double pixelsPerDegree = kPixelsPerDegree;
    if (options.pixelsPerDegree) {
        pixelsPerDegree = parseNumber(*options.pixelsPerDegree, "--ppd");
        if (pixelsPerDegree < 1 || pixelsPerDegree > 1000) {
            throw InputError("--ppd", Message(MessageId::NumberOutOfRange,
                                              {{"value", pixelsPerDegree}, {"range", rangeOf(1, 1000)}}));
        }
    }
    HeightReadOptions reading;
    if (options.maxPixels) {
        reading.maxPixels = parseWhole(*options.maxPixels, "--max-pixels", 1, std::int64_t{1} << 40);
    }
    Work& work = session.work();
    const ColorImage a = readColor(nameA, work, reading.maxPixels);
    const ColorImage b = readColor(nameB, work, reading.maxPixels);
    if (a.width() != b.width() || a.height() != b.height()) {
        throw InputError(nameB, Message(MessageId::SizesDiffer, {{"width", b.width()},
                                                                 {"height", b.height()},
                                                                 {"other", nameA},
                                                                 {"otherWidth", a.width()},
                                                                 {"otherHeight", a.height()}}));
    }
    refuseNan(nameA, a);
    refuseNan(nameB, b);
    FloatImage errors;
    const PictureError error = pictureError(a, b, pixelsPerDegree, errors, work);
    if (options.output) writeErrors(*options.output, errors);
    session.eraseBar();
    writeStandardOutput("RMSE " + numberText(error.rmse, 6) + "\nPSNR " + numberText(error.psnr, 6) + "\nFLIP " +
                            numberText(error.flip, 6) + "\n",
                        session.stop());
    return 0;
}

}  // namespace

void addCompareCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* parser = addCommand(
        program, "compare", "RMSE, PSNR and FLIP of two pictures",
        "Tells how far apart two pictures of one size are, as a screen shows them (sRGB values clamped to [0, 1]). "
        "RMSE is 0 to 1; PSNR is in decibel, inf where the pictures are equal; FLIP (Andersson et al. 2020) is 0 to 1, "
        "the mean of what a viewer notices who flips between the two.",
        "  relief compare exact.png pyramid.png -o error.png");
    addArgument(*parser, "A", options->reference, "the reference");
    addArgument(*parser, "B", options->test, "the other picture");
    addOutput(*parser, options->output,
              "picture of FLIP's error, grey, black 0, white 1: .png, .tif, .bmp, or .exr with the plain values");
    addText(*parser, "--ppd,--pixels-per-degree", options->pixelsPerDegree, "N",
            "of the viewer's field, for FLIP, 1 to 1000; default " + numberText(kPixelsPerDegree) +
                " (a 3840-pixel screen 0.7 m wide, seen from 0.7 m)",
            "Viewer");
    addText(*parser, "--max-pixels", options->maxPixels, "N",
            "refuse larger pictures before memory is taken; default " + std::to_string(kDefaultMaxPixels), "General");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runCompare(*options, session); }});
}

}  // namespace relief::app
