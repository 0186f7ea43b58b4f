// Renders several pictures with one command: a list of scenarios, the frames of a camera path or of a sweep of an
// option, or both; shared by the ranks of an MPI run (parts_run.h), and resumable after the run was killed.
#pragma once

#include "options_common.h"
#include "part.h"
#include "relief/memory.h"
#include "rendering/frame.h"

namespace relief::app {

// Which rows of a picture are held in memory at once (empty: all), and whether they are written in tiles. hint: what a
// refusal advises.
struct PictureMemory {
    RowRange rows;
    bool tiled = false;
    MemoryHint hint = MemoryHint::SmallerSize;
};
// Throws MemoryError if these rows and the buffers for writing them do not fit into memory. layers: empty for the
// picture alone.
void requirePictureMemory(const FrameRequest& request, const std::vector<std::string>& layers, const PictureMemory& how,
                          Session& session);

struct ManyFrames {
    std::vector<std::string> more;  // scenarios after the first
    OptionText frames, to, sweep;
    RestartOptions restart;

    void add(CLI::App& parser);
    // Returns true if the options request more than one picture.
    bool requested() const { return !more.empty() || frames || to || sweep; }
    // Renders the pictures into `folder`, which is created if needed. layers: empty for pictures alone. part: restricts
    // the run to the pictures of that part. Returns the exit status.
    int run(const ScenarioOptions& options, const std::string& folder, const std::vector<std::string>& layers,
            const PartNumber& part, Session& session) const;
};

}  // namespace relief::app
