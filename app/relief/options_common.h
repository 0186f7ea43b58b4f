// Options that several commands share. They are kept as text and turned into numbers without the locale, by the same
// descriptions that the window's sliders use.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "journal.h"
#include "scenario/scenario.h"
#include "session.h"

namespace relief::app {

using OptionText = std::optional<std::string>;

// --- declaring

// A command with its paragraph and an example line.
CLI::App* addCommand(CLI::App& program, const std::string& name, const std::string& summary,
                     const std::string& paragraph, const std::string& examples);

// An option that takes one value; nothing where it was not given.
CLI::Option* addText(CLI::App& parser, const std::string& names, OptionText& target, const std::string& kind,
                     const std::string& help, const std::string& group);
// One that is known by its place and cannot be left out.
void addArgument(CLI::App& parser, const std::string& name, OptionText& target, const std::string& help);
// One that may be repeated.
CLI::Option* addTexts(CLI::App& parser, const std::string& names, std::vector<std::string>& target,
                      const std::string& kind, const std::string& help, const std::string& group);
CLI::Option* addFlag(CLI::App& parser, const std::string& names, bool& target, const std::string& help,
                     const std::string& group);

// "X,Y,Z"; InputError naming the option.
std::array<double, 3> parseThree(const std::string& text, const std::string& option);

// "--language": accepted everywhere, read by main().
void addLanguage(CLI::App& parser);

// "-o, --output": where the result goes.
void addOutput(CLI::App& parser, OptionText& target, const std::string& help);

// --- reading

// The value, or InputError naming the option.
const std::string& needed(const OptionText& value, const std::string& option, const std::string& command);
// "800x600", or "512" for 512x512.
struct SizeText {
    int width;
    int height;
};
SizeText parseSize(const std::string& text, const std::string& option, int largest);
// The same of what is square: its side.
int parseSide(const std::string& text, const std::string& option, int largest);
// Whether the file is to be read as a scenario: by its ending .json, or because it begins as one. Anything else is a
// picture.
bool isScenarioFile(const std::string& path);
// "X,Y", whole numbers from 0.
PixelChoice parsePixel(const std::string& text, const std::string& option);
std::int64_t parseWhole(const std::string& text, const std::string& option, std::int64_t low, std::int64_t high);
std::uint64_t parseSeed(const std::string& text, const std::string& option);
// "bricks", "bricks:512", "bricks:512x256", "bricks:512x256:7" of --relief.
void applyRecipe(Pictures& pictures, const std::string& text, const std::string& option = "--relief");
std::vector<std::string> splitText(const std::string& text, char separator);

// --threads, --quiet, --verbose
class RunOptions {
  public:
    void add(CLI::App& parser, bool withThreads = true);
    // withoutOthers: this process does not share its work with others that were started with it; else rank 0 speaks.
    void apply(Session& session, bool withoutOthers = true) const;

  private:
    OptionText threads_;
    bool quiet_ = false;
    bool verbose_ = false;
};

// --resume, --anew: what becomes of FILE.part, which a run that was stopped has left.
class RestartOptions {
  public:
    // when: of what kind of command, "many pictures".
    void add(CLI::App& parser, const std::string& when, const std::string& group);
    bool given() const { return resume_ || anew_; }
    // Throws InputError where both are given.
    EarlierRun chosen() const;

  private:
    bool resume_ = false;
    bool anew_ = false;
};

// How a height file is read: --channel, --invert, --range, --max-pixels.
class ReadingOptions {
  public:
    void add(CLI::App& parser, const char* group = "Reading the height map");
    void apply(HeightReadOptions& reading) const;
    // An option that was given; empty where there is none.
    std::string given() const;

  private:
    OptionText channel_, range_, maxPixels_;
    bool invert_ = false;
};

// A scenario and everything that overrides it.
class ScenarioOptions {
  public:
    // Which groups a command takes beside scenario, height map and method.
    // Yes: the view, --color, --normal, --filter, --light. View: the view alone. No: none of them. Heights: nothing but
    // the height field, and the options of a method that the command chooses itself. Plain: nothing but the height
    // field.
    enum class Look { Yes, View, No, Heights, Plain };
    void add(CLI::App& parser, Look look);
    // The scenario (the file's, or the default one) with the options laid over it; checked. Throws InputError.
    Scenario scenario() const { return scenario(file_); }
    // The same over another file, a scenario or a height map; nothing: over the default one.
    Scenario scenario(const OptionText& file) const;
    const OptionText& file() const { return file_; }
    bool heightsGiven() const { return file_ || height_ || recipe_; }
    // The command chooses the method: no --tracer. argument: what says which, for messages.
    void chooseTracer(const std::string& method, const std::string& argument);
    // An option of the view that was given, such as "--camera"; empty where there is none.
    std::string viewOption() const;
    // --map: the stored map laid into the cache for the scenario's tracer, which gets the options it was built with.
    // follow: without --tracer and a scenario file the tracer that walks such maps is taken.
    void useStoredMap(Scenario& scenario, const Assets& assets, MapCache& maps, Work& work, bool follow = false) const;
    // " --map FILE" as it was given, quoted for a shell; empty without it.
    std::string mapArgument() const;
    // What tells the stored map's file from others by what is in it; empty where none is given. Throws InputError.
    std::string mapContent() const;

  private:
    void addPictures(CLI::App& parser, Look look);
    void addMethod(CLI::App& parser, Look look);
    void addView(CLI::App& parser, Look look);
    void applyPictures(Scenario& scenario) const;
    void applyMethod(Scenario& scenario) const;
    void applyTracer(MethodChoice& method) const;
    void applyFilter(Scenario& scenario) const;
    void applyView(Scenario& scenario) const;
    void applyCamera(Scenario& scenario) const;

    OptionText file_;
    OptionText height_, recipe_, color_, normal_;
    ReadingOptions reading_;
    OptionText reliefDepth_, address_, surface_;
    std::string tracerOption_ = "--tracer";  // for messages
    OptionText tracer_, map_, filter_, supersample_, pixelModel_;
    bool shadows_ = false;
    bool noSkip_ = false;
    std::vector<std::string> settings_, filterSettings_;
    OptionText scene_, camera_, eye_, target_, fov_, size_, light_, bounded_, mapping_;
};

// "elevation=20,azimuth=30": the camera becomes an orbit unless only the field of view is given. option: for messages.
void applyOrbit(Scenario& scenario, const std::string& text, const std::string& option);

// Says what was done to the heights on reading (once a file).
void noteHeights(Session& session, const Assets& assets, const Scenario& scenario);
// Says which level base=auto means in this view, where the method has it.
void noteBaseLevel(Session& session, const Scenario& scenario, const FrameRequest& request);

}  // namespace relief::app
