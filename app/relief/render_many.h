// Many pictures of one command: a list of scenarios, the frames of a camera's path, or both; shared by the ranks of
// an MPI run (parts_run.h), and gone on with after a run that was killed.
#pragma once

#include "options_common.h"
#include "part.h"
#include "rendering/frame.h"

namespace relief::app {

// Throws MemoryError where the picture, and what writing it takes, do not fit. layers: empty for the picture alone.
void requirePictureMemory(const FrameRequest& request, const std::vector<std::string>& layers, Session& session);

struct ManyFrames {
    std::vector<std::string> more;  // scenarios after the first
    OptionText frames, to;
    RestartOptions restart;

    void add(CLI::App& parser);
    // Whether the command asks for more than one picture.
    bool wanted() const { return !more.empty() || frames || to || restart.given(); }
    // folder: made where it is not there. layers: empty for pictures alone. part: only its pictures. Returns the exit
    // status.
    int run(const ScenarioOptions& options, const std::string& folder, const std::vector<std::string>& layers,
            const PartNumber& part, Session& session) const;
};

}  // namespace relief::app
