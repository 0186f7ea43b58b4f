#include "arguments.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>
#include <vector>

#include "painting/drawing.h"
#include "panes/figure.h"
#include "panes/figure_formats.h"
#include "relief/describe.h"
#include "scenario/scenario.h"
#include "scenario/sequence.h"

namespace relief::app {

namespace {

using reliefui::plainText;

constexpr const char* kHelp = "reliefscope --help";

// Parses "WxH", or "N" for NxN. Returns false if the text is neither.
bool parseSize(std::string_view text, int& width, int& height) {
    const std::size_t x = text.find('x');
    const auto whole = [](std::string_view part, int& value) {
        const auto result = std::from_chars(part.data(), part.data() + part.size(), value);
        return result.ec == std::errc() && result.ptr == part.data() + part.size() && value > 0;
    };
    return whole(text.substr(0, x), width) && whole(x == std::string_view::npos ? text : text.substr(x + 1), height);
}

void checkAxis(const std::string& text) {
    if (text == "x" || text == "y" || text == "z") return;
    throw InputError("--axis", Message(MessageId::UnknownName,
                                       {{"what", MessageId::WordAxis}, {"name", text}, {"known", "x, y, z"}}));
}

int wholeNumber(const std::string& text, const std::string& subject) {
    constexpr double kMost = 1e6;
    const double number = parseNumber(text, subject);
    if (number >= 0 && number <= kMost && number == static_cast<int>(number)) return static_cast<int>(number);
    throw InputError(subject, Message(MessageId::NumberOutOfRange, {{"value", number}, {"range", "0, 1, 2, ..."}}));
}

// Width of a figure in millimetres: a number, "84mm", or the name of a journal's width.
double figureWidth(const std::string& text, const std::string& subject) {
    if (text == "column") return reliefui::kColumnMm;
    if (text == "page") return reliefui::kJournalPageMm;
    return parseNumber(text.ends_with("mm") ? text.substr(0, text.size() - 2) : text, subject);
}

// Returns all options that the help names.
std::vector<std::string> optionNames() {
    std::istringstream words(helpText({}));
    std::vector<std::string> names;
    for (std::string word; words >> word;) {
        if (word.ends_with(',')) word.pop_back();
        if (word.starts_with("--")) names.push_back(word);
    }
    return names;
}

InputError unknownArgument(const std::string& argument) {
    const std::string near = argument.starts_with("--") ? nearestName(argument, optionNames()) : "";
    if (near.empty()) return {argument, Message(MessageId::ArgumentUnknown, {{"help", kHelp}})};
    return {argument, Message(MessageId::ArgumentNear, {{"near", near}, {"help", kHelp}})};
}

}  // namespace

Arguments parseArguments(int count, char** arguments) {
    Arguments parsed;
    bool onlyFiles = false;
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        const auto value = [&] {
            const std::string text = i + 1 < count ? arguments[++i] : "";
            if (text.empty()) throw InputError(argument, Message(MessageId::ValueMissing, {{"help", kHelp}}));
            return text;
        };
        if (onlyFiles || argument.empty() || argument.front() != '-') {
            if (!parsed.file.empty())
                throw InputError(argument, Message(MessageId::ArgumentUnknown, {{"help", kHelp}}));
            parsed.file = argument;
            if (argument.empty()) throw InputError("", Message(MessageId::FileMissing));
        } else if (argument == "--") {
            onlyFiles = true;
        } else if (argument == "-h" || argument == "--help") {
            parsed.help = true;
        } else if (argument == "--version") {
            parsed.version = true;
        } else if (argument == "--check-display") {
            parsed.checkDisplay = true;
        } else if (argument == "--anew") {
            parsed.anew = true;
        } else if (argument == "--log") {
            parsed.log = true;
        } else if (argument == "--memory") {
            parsed.memory = wholeNumber(value(), argument);
            reliefui::requireRange(argument, parsed.memory, 1, kMostTileMemory);
        } else if (argument == "--lesson") {
            parsed.lesson = value();
        } else if (argument == "--check") {
            parsed.check = true;
        } else if (argument == "--html") {
            parsed.html = true;
        } else if (argument == "--paper-figures") {
            parsed.paperFigures = value();
        } else if (argument == "--screenshot") {
            parsed.screenshot = value();
        } else if (argument == "--export") {
            parsed.figure = value();
        } else if (argument == "--sequence") {
            parsed.sequence = value();
        } else if (argument == "--frames") {
            parsed.frames = wholeNumber(value(), argument);
            reliefui::requireRange(argument, *parsed.frames, 1, kMostSequenceFrames);
        } else if (argument == "-o") {
            parsed.output = value();
        } else if (argument == "--width") {
            parsed.widthMm = figureWidth(value(), argument);
        } else if (argument == "--dpi") {
            parsed.dpi = parseNumber(value(), argument);
        } else if (argument == "--layer") {
            parsed.layer = value();
        } else if (argument == "--map") {
            parsed.map = value();
        } else if (argument == "--minus") {
            parsed.minus = value();
        } else if (argument == "--axis") {
            parsed.axis = value();
            checkAxis(parsed.axis);
        } else if (argument == "--slice") {
            parsed.slice = wholeNumber(value(), argument);
        } else if (argument == "--variants") {
            parsed.variants = value();
        } else if (argument == "--row-width") {
            parsed.rowWidth = wholeNumber(value(), argument);
        } else if (argument == "--relief") {
            parsed.relief = value();
        } else if (argument == "--elevation") {
            parsed.elevation = value();
        } else if (argument == "--error") {
            parsed.error = value();
        } else if (argument == "--dark") {
            parsed.dark = true;
        } else if (argument == "--no-caption") {
            parsed.caption = false;
        } else if (argument == "--pixel") {
            parsed.pixel = value();
        } else if (argument == "--tracers") {
            parsed.tracers = value();
        } else if (argument == "--filters") {
            parsed.filters = value();
        } else if (argument == "--mappings") {
            parsed.mappings = value();
        } else if (argument == "--pixels" || argument == "--size") {
            const std::string size = value();
            const bool window = argument == "--size";
            if (!parseSize(size, window ? parsed.width : parsed.pixelWidth,
                           window ? parsed.height : parsed.pixelHeight)) {
                throw InputError(argument, Message(MessageId::NotASize, {{"text", size}}));
            }
            const int side =
                window ? std::max(parsed.width, parsed.height) : std::max(parsed.pixelWidth, parsed.pixelHeight);
            reliefui::requireRange(argument, side, 1, reliefui::kMostRenderedPixels);
        } else {
            throw unknownArgument(argument);
        }
    }
    const auto needs = [](bool missing, const char* option, const Message& other) {
        if (missing) throw InputError(option, Message(MessageId::NeedsArgument, {{"other", other}}));
    };
    const Message view(MessageId::WordExportOption);
    needs(!parsed.figure.empty() && parsed.output.empty(), "--export", Message(MessageId::WordOutputOption));
    const bool lesson = !parsed.lesson.empty();
    const Message lessonOption(MessageId::WordLessonOption);
    needs(parsed.check && !lesson, "--check", lessonOption);
    needs(parsed.html && !lesson && parsed.figure.empty(), "--html", lessonOption);
    needs(parsed.html && parsed.output.empty(), "--html", Message(MessageId::WordOutputOption));
    const bool papers = !parsed.paperFigures.empty();
    needs(!parsed.output.empty() && parsed.figure.empty() && !parsed.html && !papers, "-o", view);
    const auto excludes = [](bool both, const char* option, const char* other) {
        if (both) throw InputError(option, Message(MessageId::ArgumentsExclude, {{"other", other}}));
    };
    excludes(papers && lesson, "--paper-figures", "--lesson");
    excludes(papers && !parsed.figure.empty(), "--paper-figures", "--export");
    excludes(papers && !parsed.file.empty(), "--paper-figures", "SCENARIO.json");
    excludes(lesson && !parsed.figure.empty(), "--lesson", "--export");
    excludes(lesson && !parsed.file.empty(), "--lesson", "SCENARIO.json");
    excludes(parsed.check && parsed.html, "--check", "--html");
    needs(!parsed.layer.empty() && parsed.figure != "result", "--layer", plainText("--export result"));
    const bool figure = !parsed.figure.empty();
    needs(!parsed.sequence.empty() && !figure, "--sequence", view);
    needs(parsed.frames && parsed.sequence.empty(), "--frames", plainText("--sequence"));
    if (!parsed.sequence.empty()) parseSequence(parsed.sequence, parsed.frames, "--sequence");  // throws
    excludes(!parsed.sequence.empty() && parsed.figure == "pareto", "--sequence", "--export pareto");
    needs(parsed.memory > 0 && parsed.file.empty(), "--memory", plainText("SCENARIO.json | PICTURE"));
    needs(!parsed.pixel.empty() && !figure, "--pixel", view);
    needs(!parsed.tracers.empty() && !figure, "--tracers", view);
    needs(!parsed.filters.empty() && !figure, "--filters", view);
    needs(!parsed.mappings.empty() && !figure, "--mappings", view);
    needs(parsed.pixelWidth > 0 && !figure, "--pixels", view);
    const bool distance = parsed.figure == "distance";
    needs(!parsed.map.empty() && !distance, "--map", plainText("--export distance"));
    needs(!parsed.minus.empty() && !distance, "--minus", plainText("--export distance"));
    needs(!parsed.axis.empty() && !distance, "--axis", plainText("--export distance"));
    needs(parsed.slice >= 0 && !distance, "--slice", plainText("--export distance"));
    const bool rows = parsed.figure == "rows" || parsed.figure == "row-flow";
    needs(!parsed.variants.empty() && !rows, "--variants", plainText("--export rows"));
    needs(parsed.rowWidth && !rows, "--row-width", plainText("--export rows"));
    const bool pareto = parsed.figure == "pareto";
    needs(!parsed.relief.empty() && !pareto, "--relief", plainText("--export pareto"));
    needs(!parsed.elevation.empty() && !pareto, "--elevation", plainText("--export pareto"));
    needs(!parsed.error.empty() && !pareto && parsed.figure != "charts", "--error", plainText("--export pareto"));
    needs(pareto && parsed.file.empty(), "--export pareto", plainText("BENCH.json"));
    return parsed;
}

std::string helpText(const std::string& views) {
    return R"(reliefscope: a window that explains why a pixel of a relief-textured picture looks as it does.

Usage: reliefscope [SCENARIO.json | PICTURE] [options]

  SCENARIO.json         pictures, view and settings, as saved by the window
  PICTURE               a height map: PNG, JPEG, TIFF, EXR, HDR, ...
                        (without either, the last session is opened; the first time, the stone wall that
                        comes with the program)

Options, with defaults in parentheses
  --anew                start as the first time, not with the last session
  --memory MB           a height map written by relief tile is read by tiles, within this much memory; the panes
                        Pyramid and Distance map and the comparison of heights, which need all heights, say so
  --size WxH|N          size of the window, pixels; N: N x N
  --screenshot FILE     open the window, save it as a PNG, and exit
  --lesson NAME         open a lesson, such as 302, or the folder of one
  --lesson NAME|all --check
                        check what its texts say, without a window; a line per lesson; needs no display
  --lesson NAME --html -o FILE.html
                        write the lesson as one page for any browser; all: a folder of pages with contents
  --export VIEW --html -o FILE.html
                        write a view as a page with a slider over the steps of the ray
  --export VIEW -o FILE write one figure to an SVG, PDF, PNG or TikZ file (.tikz, .tex, .pgf: a tikzpicture for
                        \input into LaTeX), without a window; needs no display
  --paper-figures NAME,...|all [-o FOLDER]
                        list figures of the papers, such as MIP18 or DIST17-5, or write them into the folder:
                        SVG, PDF and PNG in English and Ukrainian, captions for LaTeX, and a JSON file each,
                        which is a NAME as well and from which the same bytes are written again
)" + views +
           R"(
  --sequence WHAT       with --export VIEW: write a moving picture in place of one figure; WHAT: steps (those of the
                        ray), orbit (the camera around its target), sweep:OPTION=FROM..TO or sweep:OPTION=A,B,...
                        (light-azimuth, relief-depth, layers, ...); -o FOLDER/NAME.png writes FOLDER/NAME_00000.png
                        and so on, --html -o FILE.html one page with a slider
  --frames N            number of frames of an orbit, or from FROM to TO ()" +
           std::to_string(kSequenceFrames) + R"()
  --pixel X,Y           pixel whose ray is shown, at its last step (that of the scenario)
  --pixels WxH|N        size of the rendered picture; a PNG figure is as wide
  --tracers A,B,...     the method, and methods to compare it with, spelled as for relief bench tracers
  --filters A,B,...     the filter, and filters to compare it with, such as
                        bilinear,trilinear,elliptical:radius=0.6,supersample:samples=16
  --mappings A,B,...    the method for coordinates along rows, and others to compare it with, such as
                        direct,affine,incremental:anchor=0
  --layer NAME          result: layer to show with its legend: color, steps, error, outcome, depth, normal, uv,
                        footprint, hidden
  --map KIND            distance: map to show: euclidean, euclidean-conservative, refined-sampled, refined, cone,
                        cone-dummer, cone-robust, relaxed-cone, relaxed-cone-robust (that of the method)
  --minus KIND          distance: map to subtract, which shows where the two differ
  --axis x|y|z          distance: slice at constant x, y or height (along the ray)
  --slice N             distance: number of the slice, from 0 (the one at the scenario's step)
  --variants LIST       rows, row-flow: up to four methods, spelled as for relief bench rows
                        (affine,direct,incremental:anchor=0,streams:streams=4)
  --row-width N         rows, row-flow: width of the row, pixels (that of the picture)
  --relief NAME         pareto, whose file is a table of relief bench tracers (JSON, CSV): show only this relief
  --elevation DEG       pareto: show only this elevation
  --error MEASURE       pareto, charts: mean, p95, p9999 or max (mean)
  --width MM|column|page
                        width of the figure; column: 84 mm, page: 174 mm, of a journal (160)
  --dpi N               pixels per inch of a PNG, and of the pictures in other files, up to )" +
           std::to_string(reliefui::kMostRenderedPixels) + R"( in all (300)
  --no-caption          omit the line that names height map, method, filter, pixel and step
  --dark                draw light on dark, as in the window
  --check-display       only check whether a window can be opened: exit status 0, or 2 if not
  --log                 when the window is closed, print the work that blocked it longest to stderr
  --version, --help

Exit status: 0 done, 1 the work failed or a lesson's claim does not hold, 2 wrong usage or input, or no display.
Examples: reliefscope datasets/gray_rocks/height.png
          reliefscope scenario.json --export profile -o profile.svg --width 120
          reliefscope scenario.json --export profile -o profile.tikz --width column
          reliefscope scenario.json --export result --sequence orbit --frames 72 -o orbit/frame.png
          reliefscope --lesson all --check
          reliefscope --paper-figures MIP18 -o figures
          reliefscope bench.json --export pareto --elevation 25 -o pareto.svg
)";
}

}  // namespace relief::app
