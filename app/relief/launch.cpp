#include "launch.h"

#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>

namespace relief::app {

namespace {

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

// -1 where it is not there or no number.
int environmentNumber(const char* name) {
    const std::string text = environment(name);
    int value = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : -1;
}

struct Variables {
    const char* rank;
    const char* size;
    const char* job;
};

constexpr Variables kLaunchers[] = {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMIX_NAMESPACE"},
                                    {"PMI_RANK", "PMI_SIZE", "PMI_JOBID"},
                                    {"SLURM_PROCID", "SLURM_NTASKS", "SLURM_JOB_ID"}};

}  // namespace

Launch launched() {
    for (const Variables& names : kLaunchers) {
        const int rank = environmentNumber(names.rank);
        const int size = environmentNumber(names.size);
        if (rank < 0 || size < 2 || rank >= size) continue;
        std::string job = environment(names.job);
        // One allocation of Slurm starts many steps.
        if (std::strcmp(names.rank, "SLURM_PROCID") == 0) job.append(".").append(environment("SLURM_STEP_ID"));
        return {rank, size, job.empty() ? "job" : job};
    }
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    return {0, 1, std::to_string(getpid()) + "." + std::to_string(now)};
}

}  // namespace relief::app
