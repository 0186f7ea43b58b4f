// Sequences of scenarios that differ in one value, the frames of a moving picture: the steps of the ray, the camera
// around its target, an option from one value to another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/errors.h"
#include "scenario/scenario.h"

namespace relief {

inline constexpr int kSequenceFrames = 36;  // an orbit in steps of 10 degrees
inline constexpr int kMostSequenceFrames = 100'000;

struct Sequence {
    enum class Kind : std::uint8_t { Steps, Orbit, Sweep };
    Kind kind = Kind::Steps;
    std::string option;               // Sweep: the name of what changes
    std::vector<std::string> values;  // Sweep: one per frame; empty: from `from` to `to`
    double from = 0;
    double to = 0;
    std::optional<int> frames;  // of an orbit, or from `from` to `to`; std::nullopt: kSequenceFrames
};

// Parses "steps", "orbit", "sweep:OPTION=FROM..TO" or "sweep:OPTION=A,B,...". frames: refused where the number of
// frames follows from the rest. Throws InputError naming `subject`, the option of the command line.
Sequence parseSequence(const std::string& text, std::optional<int> frames, const std::string& subject);
// Parses what follows "sweep:".
Sequence parseSweep(const std::string& text, std::optional<int> frames, const std::string& subject);

struct SequenceFrame {
    Scenario scenario;
    // What changes, and its value: "light-azimuth", "45°"; in no language, because the first is the name of an option.
    std::string option;
    std::string value;

    std::string changed() const { return option + " = " + value; }
};
// Returns the frames of an orbit or a sweep of the scenario. An orbit leads around the target once, so that the frame
// after the last is the first; in front of a wall the camera swings by 60 degrees to both sides and back. A sweep of
// whole numbers has each number once. Throws InputError naming `subject` for an option that the scenario does not have,
// and for values out of range.
std::vector<SequenceFrame> framesOf(const Sequence& sequence, const Scenario& scenario, const std::string& subject);

// An option that framesOf() can change: a number of the scenario, an option of its method, its filter or its way to
// compute coordinates. values: proposed, around the present one: "FROM..TO" or "A,B,...".
struct SweptOption {
    std::string name;
    std::string help;
    std::string values;
};
std::vector<SweptOption> sweptOptions(const Scenario& scenario);

// The faults of what shows a sequence: a view that is the same at all steps; a frame's file that an earlier, longer
// sequence of the same name has left.
InputError stepsNotShown(const std::string& view, const std::string& subject);
InputError longerSequence(const std::string& file);

// Returns the name of a frame's file, without ending: "frame_00012".
std::string frameName(const std::string& stem, std::size_t number);

}  // namespace relief
