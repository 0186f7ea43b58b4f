// A scenario: everything that determines what is shown, as a plain value shared by the command line, the window,
// certificates and reproductions of the stress test. It is stored as JSON with a schema version; numbers do not depend
// on the locale, and paths are relative to the file.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "images/drawn_relief.h"
#include "relief/describe.h"
#include "relief/files.h"
#include "rendering/frame.h"
#include "scenario/breakpoint.h"
#include "scenario/comparison.h"

namespace relief {

inline constexpr int kScenarioVersion = 1;
// Of Pictures::memory, megabytes.
inline constexpr int kMostTileMemory = 1 << 22;

// The source of the heights: either a file, a procedural relief ("bricks", ...) or a relief drawn by hand. color and
// normal may be empty.
struct Pictures {
    std::string height;
    std::string recipe;
    int recipeWidth = 256;
    int recipeHeight = 256;
    std::uint64_t seed = 1;
    DrawnRelief drawn;
    std::string color;
    std::string normal;
    HeightReadOptions reading;
    // Megabytes within which a height map written by `relief tile` is read by tiles; 0: it is read as a whole.
    int memory = 0;
    bool operator==(const Pictures&) const = default;
};

// Returns the file's path, "bricks:256x256:1" or "drawn:8x8".
std::string heightsName(const Pictures& pictures);

struct PixelChoice {
    int x = 0;
    int y = 0;
    bool operator==(const PixelChoice&) const = default;
};

// A pixel to return to, with the camera from which it was seen.
struct Bookmark {
    std::string name;
    PixelChoice pixel;
    Camera camera;
    int step = 0;
    bool operator==(const Bookmark&) const = default;
};
inline constexpr std::size_t kMostBookmarks = 1000;

// Another program's tracer: a file of rays, a file of the steps that it took on them (ray_files.h), and the number of
// the ray to show, from 0. Empty paths: there is none. shown: the panes show its steps instead of the method's.
struct OtherTracer {
    std::string rays;
    std::string steps;
    int ray = 0;
    bool shown = true;
    bool operator==(const OtherTracer&) const = default;
    explicit operator bool() const { return !rays.empty() && !steps.empty(); }
};

struct Scenario {
    Pictures pictures;
    double reliefDepth = 0.1;
    Address address = Address::Repeat;
    Surface surface = Surface::Bilinear;
    MethodChoice method;
    FilterChoice filter;
    SceneKind scene = SceneKind::Floor;
    Camera camera;
    Light light;
    bool shadows = false;
    std::string mapping = "direct";  // coordinates along a row, as parseRowMethod() has it
    bool skip = true;                // whether work that cannot change a bit is skipped
    double bounded = 0;              // largest hit error, in texels, allowed to save work; 0: no approximations
    std::array<double, 3> sky{0.55, 0.65, 0.8};  // linear
    int width = 800;
    int height = 600;
    std::optional<PixelChoice> pixel;     // the selected pixel
    int step = 0;                         // the selected step of its ray, from 0
    std::vector<Breakpoint> breakpoints;  // conditions on which stepping stops
    std::vector<Bookmark> bookmarks;
    OtherTracer other;
    Comparison comparison;  // with other methods
    std::string ui;         // JSON of the window's state, which only ui/ reads; may be empty
    bool operator==(const Scenario&) const = default;
};

// An adjustable number of a scenario, described once: sliders, command-line options, help and checks derive from it.
// The numbers are "relief-depth", "elevation", "azimuth", "distance", "fov", "light-azimuth", "light-elevation",
// "ambient", "intensity", "bounded", "width", "height".
struct ScenarioNumber {
    OptionDescription description;
    double (*get)(const Scenario&);
    void (*set)(Scenario&, double);
};
// Returns all numbers; scenarioNumber() returns one by name and throws InputError, with the known names, for others.
const std::vector<ScenarioNumber>& scenarioNumbers();
const ScenarioNumber& scenarioNumber(std::string_view name);
// Sets the number. Throws InputError naming `subject` ("--relief-depth") if it is out of range.
void setScenarioNumber(Scenario& scenario, std::string_view name, double value, const std::string& subject);

// Returns a with the notes of b: step, breakpoints, bookmarks and the window's state. Notes affect neither the picture
// nor the ray, so that a change of notes renders and traces nothing again.
Scenario withNotesOf(const Scenario& a, const Scenario& b);

// Throws InputError for the first value that is out of its range or unknown; `subject` names the scenario.
void checkScenario(const Scenario& scenario, const std::string& subject);

// Returns the scenario as JSON. baseFolder: paths of pictures below it are written relative to it; empty: unchanged.
std::string scenarioText(const Scenario& scenario, const std::string& baseFolder = {});
// Parses a scenario. fileName: for messages and for resolving relative paths. Throws InputError with the line for
// invalid JSON, unknown keys, wrong types, values out of range and other versions.
Scenario parseScenario(const std::string& text, const std::string& fileName);
// Reads or writes a file with a scenario. Throws InputError; WorkError if the file cannot be written.
Scenario loadScenario(const std::string& path);
void saveScenario(const std::string& path, const Scenario& scenario);

// The loaded pictures of a scenario.
struct Assets {
    std::shared_ptr<const HeightImage> height;  // with information on how it was read and converted
    std::shared_ptr<const FloatImage> heights;  // null if the map is read by tiles
    std::shared_ptr<const TiledHeights> tiles;
    std::shared_ptr<const ColorImage> color;
    std::shared_ptr<const Image<glm::vec3>> normals;

    // The heights with the scenario's interpretation of them.
    HeightField field(const Scenario& scenario) const;
};

class AssetStore {
  public:
    // Loads the pictures whose path or reading options differ from the last call. Throws InputError; the store is then
    // unchanged. byTiles: whether the caller works with maps that are read by tiles; otherwise all are read as a whole.
    Assets load(const Pictures& pictures, Work& work, bool byTiles = false);

  private:
    Pictures last_;
    Assets assets_;
};

// Returns the request that renders the scenario with these pictures.
FrameRequest frameRequest(const Scenario& scenario, const Assets& assets);

// Returns the `relief trace` command of the scenario's selected pixel, quoted for a shell.
std::string traceCommand(const Scenario& scenario);
// Returns the command that traces this ray over the scenario's heights with its method, without a view.
std::string traceCommand(const Scenario& scenario, const ViewRay& ray);
// Returns the `relief render` command of the scenario's picture, which writes frame.exr, quoted for a shell.
std::string renderCommand(const Scenario& scenario);

}  // namespace relief
