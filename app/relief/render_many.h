// Renders several pictures with one command: a list of scenarios, the frames of a camera path, or both; shared by the
// ranks of an MPI run (parts_run.h), and resumable after the run was killed.
#pragma once

#include "options_common.h"
#include "part.h"
#include "rendering/frame.h"

namespace relief::app {

// Throws MemoryError if the picture and the buffers for writing it do not fit into memory. layers: empty for the
// picture alone.
void requirePictureMemory(const FrameRequest& request, const std::vector<std::string>& layers, Session& session);

struct ManyFrames {
    std::vector<std::string> more;  // scenarios after the first
    OptionText frames, to;
    RestartOptions restart;

    void add(CLI::App& parser);
    // Returns true if the options request more than one picture, or restart such a run.
    bool requested() const { return !more.empty() || frames || to || restart.given(); }
    // Renders the pictures into `folder`, which is created if needed. layers: empty for pictures alone. part: restricts
    // the run to the pictures of that part. Returns the exit status.
    int run(const ScenarioOptions& options, const std::string& folder, const std::vector<std::string>& layers,
            const PartNumber& part, Session& session) const;
};

}  // namespace relief::app
