// relief compare A B [-o ERROR.png] [--json] [--max-flip X]
#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "measuring/compare/picture_error.h"
#include "options_common.h"
#include "output.h"
#include "relief/files.h"

namespace relief::app {

namespace {

struct CompareOptions {
    OptionText reference, test, output, pixelsPerDegree, maxPixels, maxFlip;
    bool json = false;
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

// Writes the error map as a grey picture: 0 black, 1 white.
void writeErrors(const std::string& path, const FloatImage& errors) {
    if (fileEnding(path) == "exr") {
        writePlanes(path, {{"Y", errors}});
        return;
    }
    ColorImage grey(errors.width(), errors.height());
    for (std::size_t i = 0; i < errors.size(); ++i) grey.pixels()[i] = Color(linearFromSrgb(errors.pixels()[i]));
    writeColor(path, grey);
}

double within(const std::string& text, const std::string& option, double low, double high) {
    const double value = parseNumber(text, option);
    if (value >= low && value <= high) return value;
    throw InputError(option, Message(MessageId::NumberOutOfRange, {{"value", text}, {"range", rangeOf(low, high)}}));
}

// Notes which channels of the file are ignored: layers other than the picture itself.
void noteChannels(const std::string& path, std::int64_t maxPixels, Session& session) {
    std::vector<std::string> left;
    for (const std::string& channel : readImageInfo(path, maxPixels).channels) {
        const std::vector<std::string> usual{"R", "G", "B", "A", "Y", "I"};
        if (std::find(usual.begin(), usual.end(), channel) == usual.end()) left.push_back(channel);
    }
    if (!left.empty()) session.note(path, Message(MessageId::ChannelsNotCompared, {{"left", commaList(left)}}));
}

// limit: the largest FLIP allowed, if one was given.
std::string comparisonText(const PictureError& error, const ColorImage& picture, std::optional<double> limit,
                           bool json) {
    if (!json) {
        return "RMSE " + numberText(error.rmse, 6) + "\nPSNR " + numberText(error.psnr, 6) + "\nFLIP " +
               numberText(error.flip, 6) + "\n";
    }
    nlohmann::ordered_json values{{"width", picture.width()}, {"height", picture.height()}, {"rmse", error.rmse}};
    // JSON has no infinity: equal pictures have no PSNR.
    values["psnr"] = std::isfinite(error.psnr) ? nlohmann::ordered_json(error.psnr) : nlohmann::ordered_json();
    values["flip"] = error.flip;
    if (limit) {
        values["max_flip"] = *limit;
        values["passed"] = error.flip <= *limit;
    }
    return values.dump(2) + "\n";
}

int runCompare(const CompareOptions& options, Session& session) {
    options.run.apply(session);
    const std::string& nameA = needed(options.reference, "A", "compare");
    const std::string& nameB = needed(options.test, "B", "compare");
    if (options.output) checkOutput(*options.output, {"png", "tif", "tiff", "bmp", "exr"});
    refuseOverwriting("--output", options.output.value_or(""), {nameA, nameB});
    const double pixelsPerDegree =
        options.pixelsPerDegree ? within(*options.pixelsPerDegree, "--ppd", 1, 1000) : kPixelsPerDegree;
    std::optional<double> limit;
    if (options.maxFlip) limit = within(*options.maxFlip, "--max-flip", 0, 1);
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
    for (const std::string& name : {nameA, nameB}) noteChannels(name, reading.maxPixels, session);
    FloatImage errors;
    const PictureError error = pictureError(a, b, pixelsPerDegree, errors, work);
    if (options.output) writeErrors(*options.output, errors);
    session.eraseBar();
    writeStandardOutput(comparisonText(error, a, limit, options.json), session.stop());
    if (!limit || error.flip <= *limit) return kDone;
    const Message above(MessageId::FlipAboveLimit, {{"flip", numberText(error.flip, 6)}, {"limit", *limit}});
    sayLine(nameB + ": " + sentence(above, session.language()));
    return kFailed;
}

}  // namespace

void addCompareCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* parser = addCommand(
        program, "compare", "compute RMSE, PSNR and FLIP of two pictures",
        "Measures the difference of two pictures of the same size, as shown on a screen (sRGB values clamped to [0, "
        "1]). RMSE is 0 to 1. PSNR is in decibels, inf if the pictures are equal. FLIP (Andersson et al. 2020) is 0 to "
        "1, the mean difference that a viewer notices when flipping between the pictures.\n"
        "Exit status: 1 if --max-flip is exceeded.",
        "  relief compare exact.png pyramid.png -o error.png\n"
        "  relief compare exact.png pyramid.png --json --max-flip 0.02");
    addArgument(*parser, "A", options->reference, "the reference");
    addArgument(*parser, "B", options->test, "the other picture");
    addOutput(*parser, options->output,
              "picture of the FLIP error, grey, black 0 to white 1: .png, .tif, .bmp, or .exr with linear values");
    addFlag(*parser, "--json", options->json,
            "JSON instead of text: width, height, rmse, psnr (null if the pictures are equal), flip, and with "
            "--max-flip max_flip and passed",
            "Output");
    addText(*parser, "--max-flip", options->maxFlip, "X",
            "largest allowed FLIP, 0 to 1; exit status 1 if it is exceeded", "Output");
    addText(*parser, "--ppd,--pixels-per-degree", options->pixelsPerDegree, "N",
            "pixels per degree of the viewer's field, for FLIP, 1 to 1000; default " + numberText(kPixelsPerDegree) +
                " (a 3840-pixel screen 0.7 m wide, seen from 0.7 m)",
            "Viewer");
    addText(*parser, "--max-pixels", options->maxPixels, "N",
            "largest number of pixels of a picture; larger ones are refused before memory is allocated. Default " +
                std::to_string(kDefaultMaxPixels),
            "General");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runCompare(*options, session); }});
}

}  // namespace relief::app
