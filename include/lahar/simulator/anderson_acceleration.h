// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_anderson_acceleration_h
#define lahar_simulator_anderson_acceleration_h

#include <deal.II/base/mpi.h>

#include <deal.II/lac/vector.h>

#include <deque>

namespace Lahar
{
  using namespace dealii;

  /**
   * Anderson's acceleration of a fixed-point iteration x ← g(x). With f_k = g(x_k) − x_k and the differences between
   * successive iterates Δf_j = f_{j+1} − f_j, Δg_j = g(x_{j+1}) − g(x_j) of the last few ones, the next iterate is
   *
   *   x_{k+1} = g(x_k) − Σ_j c_j Δg_j,   c minimises | W (f_k − Σ_j c_j Δf_j) |,   W diagonal.
   *
   * For a linear g this is GMRES, restricted to a few directions (Walker & Ni, SIAM J. Numer. Anal. 49 (2011)
   * 1715–1735).
   */
  class AndersonAcceleration
  {
  public:
    /// @param depth the number of differences to keep.
    explicit AndersonAcceleration(const unsigned int depth);

    /// Forget what was: a new iteration begins, of vectors that are shared out among the ranks of @p communicator.
    void restart(const MPI_Comm &communicator = MPI_COMM_SELF);

    /// @return the next iterate after @p x, for which g(x) is @p g. @param weights the diagonal of W. Collective; each
    /// rank gives its part of the vectors.
    Vector<double> next_iterate(const Vector<double> &x, const Vector<double> &g,
                                const Vector<double> &weights);

  private:
    double inner_product(const Vector<double> &a, const Vector<double> &b) const;

    unsigned int depth;
    MPI_Comm communicator = MPI_COMM_SELF;
    bool has_last         = false;
    Vector<double> last_f, last_g;
    std::deque<Vector<double>> delta_f, delta_g; ///< the latest first
  };
} // namespace Lahar

#endif
