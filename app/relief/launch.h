// Which of several processes this one is, where a launcher (mpirun, srun) has started them together on one sweep.
//
// Nothing is linked for it: launchers tell each process its rank in the environment, and the processes share the work
// through a file beside the output (shared_work.h), which all of them must see. So none waits for a message of another,
// and one that dies takes nothing with it.
#pragma once

#include <cstdint>
#include <string>

namespace relief::app {

struct Launch {
    int rank = 0;
    int size = 1;
    std::string job;  // the same in all processes of one start, another at the next
};

// What becomes of the file of work that an earlier run has left (shared_work.h): refused, or gone on with (--resume),
// or thrown away (--anew).
enum class EarlierRun : std::uint8_t { Refuse, Resume, Replace };

// From Open MPI's, PMI's or Slurm's variables; alone where there are none.
Launch launched();

}  // namespace relief::app
