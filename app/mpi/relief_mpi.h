/* What the plug-in relief_mpi gives the program `relief`, which loads it where a launcher (mpirun, srun) has started
 * several processes together: so `relief` itself is not linked with MPI, starts without it and without its cost. */
#ifndef RELIEF_MPI_H
#define RELIEF_MPI_H

#ifdef __cplusplus
extern "C" {
#endif

/* One process of several. All functions are called by one thread at a time. */
struct ReliefMpi {
    int rank;
    int size;
    /* Name of the machine that a rank runs on. */
    const char* (*host)(int rank);
    /* Returns when the text may be changed. */
    void (*send)(int to, const char* text, unsigned long long bytes);
    /* 1: a message is there, of this size, from this rank; it is to be received next. 0: none. Does not wait. */
    int (*probe)(int* from, unsigned long long* bytes);
    void (*receive)(char* into);
    /* Waits for the other ranks. */
    void (*finish)(void);
    /* Ends all ranks. */
    void (*abort)(int status);
};

/* Null: MPI does not start. Called once. */
typedef const struct ReliefMpi* (*ReliefMpiJoin)(void);
#define RELIEF_MPI_JOIN "relief_mpi_join"

#ifdef __cplusplus
}
#endif

#endif
