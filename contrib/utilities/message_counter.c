// SPDX-License-Identifier: GPL-3.0-or-later

/*
 * Counts what a program's ranks tell each other: calls and bytes at the MPI interface, the mean over the ranks.
 *
 *     mpicc -shared -fPIC -O2 -o message_counter.so contrib/utilities/message_counter.c
 *     mpirun -np 4 -x LD_PRELOAD=$PWD/message_counter.so lahar case.prm
 *
 * Bytes are those that a rank sends, of a message to one rank or of its share in a gathering on all ranks. What one step
 * takes is the difference between two runs of different length.
 */
#include <mpi.h>
#include <stdio.h>

static double n_reductions, n_messages, message_bytes, n_gathers, gather_bytes;

static double size_of(int count, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  return (double)count * size;
}

static void sent(int count, MPI_Datatype type)
{
  ++n_messages;
  message_bytes += size_of(count, type);
}

static void gathered(int count, MPI_Datatype type)
{
  ++n_gathers;
  gather_bytes += size_of(count, type);
}

int MPI_Send(const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c)
{
  sent(n, t);
  return PMPI_Send(b, n, t, to, tag, c);
}

int MPI_Rsend(const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c)
{
  sent(n, t);
  return PMPI_Rsend(b, n, t, to, tag, c);
}

int MPI_Ssend(const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c)
{
  sent(n, t);
  return PMPI_Ssend(b, n, t, to, tag, c);
}

int MPI_Isend(const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request *r)
{
  sent(n, t);
  return PMPI_Isend(b, n, t, to, tag, c, r);
}

int MPI_Issend(const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request *r)
{
  sent(n, t);
  return PMPI_Issend(b, n, t, to, tag, c, r);
}

int MPI_Irsend(const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request *r)
{
  sent(n, t);
  return PMPI_Irsend(b, n, t, to, tag, c, r);
}

int MPI_Allreduce(const void *a, void *b, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c)
{
  ++n_reductions;
  return PMPI_Allreduce(a, b, n, t, o, c);
}

int MPI_Reduce(const void *a, void *b, int n, MPI_Datatype t, MPI_Op o, int root, MPI_Comm c)
{
  ++n_reductions;
  return PMPI_Reduce(a, b, n, t, o, root, c);
}

int MPI_Scan(const void *a, void *b, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c)
{
  ++n_reductions;
  return PMPI_Scan(a, b, n, t, o, c);
}

int MPI_Bcast(void *b, int n, MPI_Datatype t, int root, MPI_Comm c)
{
  ++n_reductions;
  return PMPI_Bcast(b, n, t, root, c);
}

int MPI_Barrier(MPI_Comm c)
{
  ++n_reductions;
  return PMPI_Barrier(c);
}

int MPI_Ibarrier(MPI_Comm c, MPI_Request *r)
{
  ++n_reductions;
  return PMPI_Ibarrier(c, r);
}

int MPI_Allgather(const void *a, int n, MPI_Datatype t, void *b, int m, MPI_Datatype u, MPI_Comm c)
{
  gathered(n, t);
  return PMPI_Allgather(a, n, t, b, m, u, c);
}

int MPI_Allgatherv(const void *a, int n, MPI_Datatype t, void *b, const int *m, const int *d, MPI_Datatype u,
                   MPI_Comm c)
{
  gathered(n, t);
  return PMPI_Allgatherv(a, n, t, b, m, d, u, c);
}

int MPI_Alltoall(const void *a, int n, MPI_Datatype t, void *b, int m, MPI_Datatype u, MPI_Comm c)
{
  int n_ranks;
  PMPI_Comm_size(c, &n_ranks);
  gathered(n * n_ranks, t);
  return PMPI_Alltoall(a, n, t, b, m, u, c);
}

int MPI_Alltoallv(const void *a, const int *n, const int *d, MPI_Datatype t, void *b, const int *m, const int *e,
                  MPI_Datatype u, MPI_Comm c)
{
  int n_ranks, sum = 0;
  PMPI_Comm_size(c, &n_ranks);
  for (int r = 0; r < n_ranks; ++r)
    sum += n[r];
  gathered(sum, t);
  return PMPI_Alltoallv(a, n, d, t, b, m, e, u, c);
}

int MPI_Finalize(void)
{
  double own[5] = {n_reductions, n_messages, message_bytes, n_gathers, gather_bytes}, all[5];
  int n_ranks, rank;
  PMPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  PMPI_Reduce(own, all, 5, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  if (rank == 0)
    fprintf(stderr, "A rank: %.0f reductions, %.0f messages of %.0f bytes, %.0f gatherings of %.0f bytes\n",
            all[0] / n_ranks, all[1] / n_ranks, all[2] / n_ranks, all[3] / n_ranks, all[4] / n_ranks);
  return PMPI_Finalize();
}
