// What is looked at and how: a plain value that the command line, the window, certificates and stress reproductions all
// speak. Stored as JSON with a schema version; numbers without the locale; paths relative to the file.
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

// Where the heights come from: a file, a procedural relief ("bricks", ...) or a relief drawn by hand, one of the
// three; color and normal may be empty.
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
    bool operator==(const Pictures&) const = default;
};

// The file; "bricks:256x256:1"; "drawn:8x8".
std::string heightsName(const Pictures& pictures);

struct PixelChoice {
    int x = 0;
    int y = 0;
    bool operator==(const PixelChoice&) const = default;
};

// A pixel worth coming back to, from where it was seen.
struct Bookmark {
    std::string name;
    PixelChoice pixel;
    Camera camera;
    int step = 0;
    bool operator==(const Bookmark&) const = default;
};
inline constexpr std::size_t kMostBookmarks = 1000;

// Somebody else's tracer: a file of rays and one of the steps that it took on them (ray_files.h), and which of the rays
// is looked at, from 0. Empty paths: there is none. shown: the panes show its steps instead of the method's.
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
    std::string mapping = "direct";              // coordinates along a row, as parseRowMethod() has it
    bool skip = true;                            // work that cannot change a bit is left out
    double bounded = 0;                          // texels: what hits may be wrong by where that spares work; 0: nothing
    std::array<double, 3> sky{0.55, 0.65, 0.8};  // linear
    int width = 800;
    int height = 600;
    std::optional<PixelChoice> pixel;     // the chosen one
    int step = 0;                         // the chosen step of its ray, from 0
    std::vector<Breakpoint> breakpoints;  // where stepping stops
    std::vector<Bookmark> bookmarks;
    OtherTracer other;
    Comparison comparison;  // with other methods
    std::string ui;         // JSON of the window's state, which only ui/ reads; may be empty
    bool operator==(const Scenario&) const = default;
};

// Every number of a scenario that a person turns, described once: sliders, flags, help and checks derive from it.
// "relief-depth", "elevation", "azimuth", "distance", "fov", "light-azimuth", "light-elevation", "ambient",
// "intensity", "bounded", "width", "height".
struct ScenarioNumber {
    OptionDescription description;
    double (*get)(const Scenario&);
    void (*set)(Scenario&, double);
};
const std::vector<ScenarioNumber>& scenarioNumbers();
const ScenarioNumber& scenarioNumber(std::string_view name);
// Sets the number; InputError naming `subject` ("--relief-depth") if it is out of range.
void setScenarioNumber(Scenario& scenario, std::string_view name, double value, const std::string& subject);

// What a scenario says beside its picture and its ray; nothing is rendered or traced anew when it changes.
// a with the notes of b: step, breakpoints, bookmarks, the window's state.
Scenario withNotesOf(const Scenario& a, const Scenario& b);

// Throws InputError for the first value that is out of its range or unknown; `subject` names the scenario.
void checkScenario(const Scenario& scenario, const std::string& subject);

// baseFolder: pictures below it are written relative to it (empty: as they are).
std::string scenarioText(const Scenario& scenario, const std::string& baseFolder = {});
// fileName: for messages and for relative paths. Unknown keys, wrong types, other versions: InputError; a fault of the
// JSON itself names the line.
Scenario parseScenario(const std::string& text, const std::string& fileName);
Scenario loadScenario(const std::string& path);
void saveScenario(const std::string& path, const Scenario& scenario);

// The pictures of a scenario, loaded. Kept by path and reading options, so that changing one picture loads only it.
struct Assets {
    std::shared_ptr<const HeightImage> height;  // what was read and done to it
    std::shared_ptr<const FloatImage> heights;
    std::shared_ptr<const ColorImage> color;
    std::shared_ptr<const Image<glm::vec3>> normals;
};

class AssetStore {
  public:
    // Loads what the last call did not. On an error nothing changes.
    Assets load(const Pictures& pictures, Work& work);

  private:
    Pictures last_;
    Assets assets_;
};

FrameRequest frameRequest(const Scenario& scenario, const Assets& assets);

// The relief trace command of the scenario's chosen pixel, quoted for a shell.
std::string traceCommand(const Scenario& scenario);
// The one that traces this ray over the scenario's heights with its method; the view does not matter.
std::string traceCommand(const Scenario& scenario, const ViewRay& ray);
// The relief render command of its picture, into frame.exr, quoted for a shell.
std::string renderCommand(const Scenario& scenario);

}  // namespace relief
