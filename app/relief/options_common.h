// Options that several commands share. They are kept as text and converted to numbers independently of the locale, with
// the same option descriptions that the window's sliders use.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "journal.h"
#include "relief/describe.h"
#include "scenario/scenario.h"
#include "session.h"

namespace relief::app {

using OptionText = std::optional<std::string>;

// --- Declaring options

// Adds a command with its summary, a paragraph, and example lines.
CLI::App* addCommand(CLI::App& program, const std::string& name, const std::string& summary,
                     const std::string& paragraph, const std::string& examples);

// Adds an option that takes one value; `target` is std::nullopt if it is not given.
CLI::Option* addText(CLI::App& parser, const std::string& names, OptionText& target, const std::string& kind,
                     const std::string& help, const std::string& group);
// Adds a mandatory positional argument.
void addArgument(CLI::App& parser, const std::string& name, OptionText& target, const std::string& help);
// Adds an option that may be repeated.
CLI::Option* addTexts(CLI::App& parser, const std::string& names, std::vector<std::string>& target,
                      const std::string& kind, const std::string& help, const std::string& group);
// Adds an option without a value.
CLI::Option* addFlag(CLI::App& parser, const std::string& names, bool& target, const std::string& help,
                     const std::string& group);

// Returns the range of a number with its unit: "1 to 64 texels". Leaves out the unit "level", which is clear from the
// number's name.
std::string rangeText(const OptionDescription& number);

// Parses "X,Y,Z". Throws InputError naming the option.
std::array<double, 3> parseThree(const std::string& text, const std::string& option);

// Adds "--language", which every command accepts and main() evaluates.
void addLanguage(CLI::App& parser);

// Adds "-o, --output", the destination of the result.
void addOutput(CLI::App& parser, OptionText& target, const std::string& help);

// --- Reading options. The functions throw InputError naming `option`.

// Returns the value; throws InputError naming the option if it was not given.
const std::string& needed(const OptionText& value, const std::string& option, const std::string& command);
// Pixels or texels: "800x600", or "512" for 512x512.
struct SizeText {
    int width;
    int height;
};
// largest: of width and height.
SizeText parseSize(const std::string& text, const std::string& option, int largest);
// Parses the side of a square in the same spellings.
int parseSide(const std::string& text, const std::string& option, int largest);
// Returns true if the file is to be read as a scenario: its name ends in .json, or its content begins like JSON.
// Anything else is a picture.
bool isScenarioFile(const std::string& path);
// Parses "X,Y", integers from 0.
PixelChoice parsePixel(const std::string& text, const std::string& option);
// Parses an integer in [low, high].
std::int64_t parseWhole(const std::string& text, const std::string& option, std::int64_t low, std::int64_t high);
// Parses the megabytes within which a map is read by tiles.
int parseTileMemory(const std::string& text, const std::string& option = "--memory");
// Parses an integer from 0 to 2^64 - 1.
std::uint64_t parseSeed(const std::string& text, const std::string& option);
// Parses the value of --relief: "bricks", "bricks:512", "bricks:512x256", "bricks:512x256:7". Sides up to mostSide, and
// no more texels than reading.maxPixels.
void applyRecipe(Pictures& pictures, const std::string& text, const std::string& option = "--relief",
                 int mostSide = kMaxReliefSide);
// Splits the text at each separator; empty parts are kept.
std::vector<std::string> splitText(const std::string& text, char separator);

// --threads, --quiet, --verbose
class RunOptions {
  public:
    void add(CLI::App& parser, bool withThreads = true);
    // withoutOthers: this process does not share its work with other processes of the same launch. If it does, only
    // rank 0 prints notes.
    void apply(Session& session, bool withoutOthers = true) const;

  private:
    OptionText threads_;
    bool quiet_ = false;
    bool verbose_ = false;
};

// --resume, --anew: what to do with FILE.part of an interrupted run.
class RestartOptions {
  public:
    // when: the kind of command that has these options, such as "many pictures"; for the help.
    void add(CLI::App& parser, const std::string& when, const std::string& group);
    bool given() const { return resume_ || anew_; }
    // Throws InputError if both options are given.
    EarlierRun chosen() const;

  private:
    bool resume_ = false;
    bool anew_ = false;
};

// How a height file is read: --channel, --invert, --range, --max-pixels.
class ReadingOptions {
  public:
    void add(CLI::App& parser, const char* group = "Reading the height map");
    // The same without --max-pixels, for pictures that are not read into memory as a whole.
    void addForRows(CLI::App& parser, const char* group = "Reading the height map");
    void apply(HeightReadOptions& reading) const;
    // Returns the name of one of these options that was given; empty if none was.
    std::string given() const;

  private:
    OptionText channel_, range_, maxPixels_;
    bool invert_ = false;
};

// A scenario and all options that override parts of it.
class ScenarioOptions {
  public:
    // The groups of options that a command takes in addition to scenario, height map and method. All: the view,
    // --color,
    // --normal, --filter, --light. View: the view only. None: none of them. Heights: only the height field, and the
    // options of a method that the command itself chooses. HeightsOnly: only the height field.
    enum class OptionGroups { All, View, None, Heights, HeightsOnly };
    void add(CLI::App& parser, OptionGroups groups);
    // --memory, for commands that work with maps read by tiles; `name`: where that is the name of another option.
    void addMemory(CLI::App& parser, const std::string& name = "--memory");
    // Returns the scenario of the file, or the default one, with the options applied and validated. Throws InputError.
    Scenario scenario() const { return scenario(file_); }
    // The same for another file, a scenario or a height map; std::nullopt: for the default scenario.
    Scenario scenario(const OptionText& file) const;
    // The default scenario with the options of method and surface applied, for commands that need no heights.
    Scenario withoutHeights() const;
    const OptionText& file() const { return file_; }
    bool heightsGiven() const { return file_ || height_ || recipe_; }
    // Sets the method, instead of an option --tracer. argument: the argument that determined it, for messages.
    void chooseTracer(const std::string& method, const std::string& argument);
    // Returns the name of an option of the view that was given, such as "--camera"; empty if none was.
    std::string viewOption() const;
    // The same for options on which the colours alone depend, such as "--filter".
    std::string lookOption() const;
    // --map: puts the stored map into the cache for the scenario's tracer and sets the tracer's options to those that
    // the map was built with. follow: if neither --tracer nor a scenario file is given, selects the tracer that uses
    // such maps.
    void useStoredMap(Scenario& scenario, const Assets& assets, MapCache& maps, Work& work, bool follow = false) const;
    // The file of --map.
    const OptionText& map() const { return map_; }
    bool tracerGiven() const { return tracer_.has_value(); }
    // Sets those of --surface, --address and --relief-depth that were given.
    void applyRelief(Surface& surface, Address& address, double& reliefDepth) const;
    // Returns " --map FILE" as it was given, quoted for a shell; empty without it.
    std::string mapArgument() const;
    // Returns a hash of the stored map's file; empty without --map. Throws InputError.
    std::string mapContent() const;

  private:
    void addPictures(CLI::App& parser, OptionGroups groups);
    void addMethod(CLI::App& parser, OptionGroups groups);
    void addView(CLI::App& parser, OptionGroups groups);
    void applyPictures(Scenario& scenario) const;
    void applyMethod(Scenario& scenario) const;
    void applyRelief(Scenario& scenario) const;
    void applyTracer(MethodChoice& method) const;
    void applyFilter(Scenario& scenario) const;
    void applyView(Scenario& scenario) const;
    void applyCamera(Scenario& scenario) const;

    OptionText file_;
    OptionText height_, recipe_, color_, normal_, memory_;
    std::string memoryOption_ = "--memory";  // for messages
    ReadingOptions reading_;
    OptionText reliefDepth_, address_, surface_;
    std::string tracerOption_ = "--tracer";  // for messages
    OptionText tracer_, map_, filter_, supersample_, pixelModel_;
    bool shadows_ = false;
    bool noSkip_ = false;
    std::vector<std::string> settings_, filterSettings_;
    OptionText scene_, camera_, eye_, target_, fov_, size_, light_, bounded_, mapping_;
};

// Returns the files of a scenario with these options: its own, its pictures, the stored map; empty names for those that
// it does not have.
std::vector<std::string> inputFiles(const ScenarioOptions& options, const Scenario& scenario);

// Parses "elevation=20,azimuth=30". The camera becomes an orbit camera unless only the field of view is given. option:
// the option's name, for messages.
void applyOrbit(Scenario& scenario, const std::string& text, const std::string& option);

// Prints a note on how the heights were changed on reading, once per file.
void noteHeights(Session& session, const Assets& assets, const Scenario& scenario);
// Prints a note on the level that base=auto selects in this view, if the method has that option.
void noteBaseLevel(Session& session, const Scenario& scenario, const FrameRequest& request);

}  // namespace relief::app
