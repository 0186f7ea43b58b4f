/* Interface of the plug-in relief_mpi. The program `relief` loads it if a launcher (mpirun, srun) has started several
 * processes together, so that `relief` itself is not linked with MPI and starts without it. */
#ifndef RELIEF_MPI_H
#define RELIEF_MPI_H

#ifdef __cplusplus
extern "C" {
#endif

/* One process of several. At most one thread may call the functions at a time. */
struct ReliefMpi {
    int rank;
    int size;
    /* Returns the name of the machine that a rank runs on; valid until the process ends. */
    const char* (*host)(int rank);
    /* Sends `bytes` bytes. On return the buffer may be changed. */
    void (*send)(int to, const char* text, unsigned long long bytes);
    /* Does not wait. Returns 1 if a message has arrived and sets its sender and size; it must be received next.
     * Returns 0 if there is none. */
    int (*probe)(int* from, unsigned long long* bytes);
    /* Copies the message found by probe() into a buffer of its size. */
    void (*receive)(char* into);
    /* Waits for the other ranks and ends MPI. */
    void (*finish)(void);
    /* Ends the processes of all ranks with this exit status. */
    void (*abort)(int status);
};

/* Starts MPI. Returns null if that fails. May be called once. */
typedef const struct ReliefMpi* (*ReliefMpiJoin)(void);
#define RELIEF_MPI_JOIN "relief_mpi_join"

#ifdef __cplusplus
}
#endif

#endif
