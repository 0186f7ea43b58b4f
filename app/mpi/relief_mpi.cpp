// The plug-in relief_mpi: wraps MPI in the few functions that `relief` needs.
#include "relief_mpi.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <mpi.h>

namespace {

constexpr int kSize = 1;  // message tags: the size comes first, then the pieces
constexpr int kPiece = 2;
constexpr unsigned long long kMostBytes = 1ULL << 30U;  // bytes per piece; MPI counts in int

std::vector<std::string> hosts;
unsigned long long waiting = 0;  // bytes of the message that receive() will read
int waitingFrom = 0;

const char* host(int rank) {
    return hosts[static_cast<std::size_t>(rank)].c_str();
}

void send(int to, const char* text, unsigned long long bytes) {
    MPI_Send(&bytes, 1, MPI_UNSIGNED_LONG_LONG, to, kSize, MPI_COMM_WORLD);
    for (unsigned long long at = 0; at < bytes; at += kMostBytes) {
        MPI_Send(text + at, static_cast<int>(std::min(kMostBytes, bytes - at)), MPI_CHAR, to, kPiece, MPI_COMM_WORLD);
    }
}

int probe(int* from, unsigned long long* bytes) {
    int there = 0;
    MPI_Status status;
    // Open MPI's MPI_Iprobe tests its queue before it polls the network, so only a second call finds a message that has
    // just arrived.
    for (int attempt = 0; attempt < 2 && there == 0; ++attempt) {
        MPI_Iprobe(MPI_ANY_SOURCE, kSize, MPI_COMM_WORLD, &there, &status);
    }
    if (there == 0) return 0;
    MPI_Recv(&waiting, 1, MPI_UNSIGNED_LONG_LONG, status.MPI_SOURCE, kSize, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    *from = waitingFrom = status.MPI_SOURCE;
    *bytes = waiting;
    return 1;
}

void receive(char* into) {
    for (unsigned long long at = 0; at < waiting; at += kMostBytes) {
        MPI_Recv(into + at, static_cast<int>(std::min(kMostBytes, waiting - at)), MPI_CHAR, waitingFrom, kPiece,
                 MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
}

void finish() {
    MPI_Finalize();
}

void abortAll(int status) {
    MPI_Abort(MPI_COMM_WORLD, status);
}

void learnHosts(int size) {
    char own[MPI_MAX_PROCESSOR_NAME] = {};
    int length = 0;
    MPI_Get_processor_name(own, &length);
    std::vector<char> all(static_cast<std::size_t>(size) * MPI_MAX_PROCESSOR_NAME);
    MPI_Allgather(own, MPI_MAX_PROCESSOR_NAME, MPI_CHAR, all.data(), MPI_MAX_PROCESSOR_NAME, MPI_CHAR, MPI_COMM_WORLD);
    for (int rank = 0; rank < size; ++rank) {
        hosts.emplace_back(all.data() + static_cast<std::size_t>(rank) * MPI_MAX_PROCESSOR_NAME);
    }
}

}  // namespace

extern "C" const ReliefMpi* relief_mpi_join(void) {
    static ReliefMpi mpi;
    int provided = 0;
    // Rank 0 serves the other ranks from a second thread; calls are serialised.
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) != MPI_SUCCESS ||
        provided < MPI_THREAD_SERIALIZED) {
        return nullptr;
    }
    MPI_Comm_rank(MPI_COMM_WORLD, &mpi.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &mpi.size);
    learnHosts(mpi.size);
    mpi.host = host;
    mpi.send = send;
    mpi.probe = probe;
    mpi.receive = receive;
    mpi.finish = finish;
    mpi.abort = abortAll;
    return &mpi;
}
