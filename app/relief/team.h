// The processes that a launcher (mpirun, srun) has started together on one piece of work, and their messages.
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

std::string hostName();

// How many processes the launcher's variables (Open MPI's, PMI's, Slurm's) speak of; 1 where there are none.
int launchedProcesses();
// Which of them this one is; 0 where it is alone.
int launchedRank();
// Whether this one writes and says what comes out: rank 0, or any that works without the others (--part).
bool leadsRun(bool withoutOthers);

// How long another rank than 0 waits before it reports an error: if rank 0 has met the same, it has reported it by then
// and the launcher has ended all.
inline constexpr auto kLastWords = std::chrono::seconds(2);

// Thrown where a rank ends and why has been said.
struct RunEnded {
    int status = 0;
};

// Waits between looks for a message: 100 us, doubled up to 2 ms. A blocking wait of Open MPI would take a processor.
class Backoff {
  public:
    void sleep();
    void wokenUp() { next_ = kFirst; }

  private:
    static constexpr std::chrono::microseconds kFirst{100};
    std::chrono::microseconds next_ = kFirst;
};

// This process among them. All calls from one thread at a time.
class Team {
  public:
    // Null: this process works alone. Loads the plug-in relief_mpi. Throws InputError where several processes were
    // started and there is no MPI to join them by.
    static std::unique_ptr<Team> join();
    // Ends all ranks, unless finish() was called: one that is lost ends the run.
    ~Team();
    // The status that all ranks end with, where finish() is not called.
    void failed(int status) { status_ = status; }
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    int rank() const;
    int size() const { return static_cast<int>(hosts_.size()); }
    const std::vector<std::string>& hosts() const { return hosts_; }  // of every rank

    struct Letter {
        int from = 0;
        std::string text;
    };
    void send(int to, const std::string& text);
    // The next message, if one is there.
    std::optional<Letter> look();
    // Waits for a message, asleep between looks (Backoff). Throws Cancelled.
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
