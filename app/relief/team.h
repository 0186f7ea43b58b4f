// The processes that a launcher (mpirun, srun) has started together to share a run, and the messages between them.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

struct ReliefMpi;  // mpi/relief_mpi.h

namespace relief::app {

// Returns the number of processes according to the launcher's environment variables (Open MPI, PMI, Slurm); 1 if none
// is set.
int launchedProcesses();
// Returns this process's rank according to the same variables; 0 if it is the only process.
int launchedRank();
// Returns true if this process writes the results and prints notes: rank 0, or any process that works without the
// others (--part).
bool leadsRun(bool withoutOthers);

// How long a rank other than 0 waits before it reports an error. If rank 0 has met the same error, it has reported it
// by then, and the launcher has ended all ranks.
inline constexpr auto kErrorGracePeriod = std::chrono::seconds(2);

// Thrown when a rank must end and the reason has been printed.
struct RunEnded {
    int status = 0;
};

// Sleeps between polls for a message: 100 us, doubling up to 2 ms. Open MPI's blocking wait would occupy a processor.
class Backoff {
  public:
    void sleep();
    void wokenUp() { next_ = kFirst; }

  private:
    static constexpr std::chrono::microseconds kFirst{100};
    std::chrono::microseconds next_ = kFirst;
};

// All processes of the launch, including this one. Not thread-safe: at most one thread may call it at a time.
class Team {
  public:
    // Returns null if this process works alone. Otherwise loads the plug-in relief_mpi. Throws InputError if several
    // processes were started and MPI is not available.
    static std::unique_ptr<Team> join();
    // Ends all ranks unless finish() was called: the run cannot go on without this one.
    ~Team();
    // Sets the exit status with which the destructor ends all ranks.
    void failed(int status) { status_ = status; }
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    int rank() const;
    int size() const { return static_cast<int>(hosts_.size()); }
    const std::vector<std::string>& hosts() const { return hosts_; }  // host name of each rank

    struct Letter {
        int from = 0;
        std::string text;
    };
    // Sends a message to a rank; blocks until the text has been taken over.
    void send(int to, const std::string& text);
    // Returns the next message, or std::nullopt if none has arrived.
    std::optional<Letter> poll();
    // Waits for a message, sleeping between polls (Backoff). Throws Cancelled.
    Letter wait(const std::stop_token& stop);
    // Waits for the other ranks to end as well.
    void finish();
    bool finished() const { return finished_; }
    std::uint64_t letters() const { return letters_; }  // sent and received

  private:
    explicit Team(const ReliefMpi* mpi);

    const ReliefMpi* mpi_;
    std::vector<std::string> hosts_;
    std::uint64_t letters_ = 0;
    bool finished_ = false;
    int status_ = 1;
};

}  // namespace relief::app
