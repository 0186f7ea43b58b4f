#include "team.h"

#include <dlfcn.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "../mpi/relief_mpi.h"
#include "installed.h"
#include "relief/errors.h"
#include "relief/work.h"

namespace relief::app {

namespace {

// Returns the variable's value, or -1 if it is not set or not a number.
int environmentNumber(const char* name) {
    const char* const value = std::getenv(name);
    const std::string text = value == nullptr ? "" : value;
    int number = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? number : -1;
}

}  // namespace

int launchedProcesses() {
    for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
        const int size = environmentNumber(name);
        if (size > 0) return size;
    }
    return 1;
}

int launchedRank() {
    for (const char* const name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "SLURM_PROCID"}) {
        const int rank = environmentNumber(name);
        if (rank >= 0) return launchedProcesses() > 1 ? rank : 0;
    }
    return 0;
}

bool leadsRun(bool withoutOthers) {
    return withoutOthers || launchedRank() == 0;
}

std::unique_ptr<Team> Team::join() {
    if (launchedProcesses() < 2) return nullptr;
    const std::string path = pluginPath("relief_mpi.so");
    const Message missing(MessageId::MpiMissing, {{"processes", launchedProcesses()}});
    if (access(path.c_str(), R_OK) != 0) throw InputError("", missing);
    // Open MPI's own plug-ins resolve its symbols in the global scope.
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr) throw InputError(path, Message(MessageId::MpiBroken, {{"why", dlerror()}}));
    ReliefMpiJoin join = nullptr;
    void* const symbol = dlsym(library, RELIEF_MPI_JOIN);
    std::memcpy(&join, &symbol, sizeof join);
    const ReliefMpi* const mpi = join == nullptr ? nullptr : join();
    if (mpi == nullptr) throw InputError(path, Message(MessageId::MpiBroken, {{"why", "MPI_Init_thread"}}));
    if (mpi->size != launchedProcesses()) {
        // The launcher belongs to another MPI than the plug-in: each process would take itself for the only one, and
        // all would write the same file.
        throw InputError("mpirun",
                         Message(MessageId::MpiOther, {{"processes", launchedProcesses()}, {"joined", mpi->size}}));
    }
    return std::unique_ptr<Team>(new Team(mpi));
}

Team::Team(const ReliefMpi* mpi) : mpi_(mpi) {
    for (int rank = 0; rank < mpi_->size; ++rank) hosts_.emplace_back(mpi_->host(rank));
}

Team::~Team() {
    if (!finished_) mpi_->abort(status_);
}

int Team::rank() const {
    return mpi_->rank;
}

void Team::send(int to, const std::string& text) {
    ++letters_;
    mpi_->send(to, text.data(), text.size());
}

std::optional<Team::Letter> Team::poll() {
    Letter letter;
    unsigned long long bytes = 0;
    if (mpi_->probe(&letter.from, &bytes) == 0) return std::nullopt;
    ++letters_;
    letter.text.resize(bytes);
    mpi_->receive(letter.text.data());
    return letter;
}

Team::Letter Team::wait(const std::stop_token& stop) {
    Backoff backoff;
    while (true) {
        if (std::optional<Letter> letter = poll()) return *std::move(letter);
        if (stop.stop_requested()) throw Cancelled();
        backoff.sleep();
    }
}

void Backoff::sleep() {
    constexpr auto kLongest = std::chrono::microseconds(2000);
    std::this_thread::sleep_for(next_);
    next_ = std::min(2 * next_, kLongest);
}

void Team::finish() {
    finished_ = true;
    mpi_->finish();
}

}  // namespace relief::app
