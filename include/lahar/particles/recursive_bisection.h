// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_particles_recursive_bisection_h
#define lahar_particles_recursive_bisection_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <boost/serialization/vector.hpp>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Divides space among the ranks: across the longest side of the box around all points, in proportion to the numbers of
   * ranks on both sides, and so on in each half (Berger & Bokhari, IEEE Trans. Comput. C-36 (1987) 570–580). All ranks
   * know all cuts, of which there is one less than ranks.
   */
  template <int dim>
  class RecursiveBisection
  {
  public:
    /// All space is the first rank's.
    explicit RecursiveBisection(const MPI_Comm &communicator);

    /**
     * Divide space so that each rank's part holds the same weight of all ranks' points, to half a percent of what the
     * cut divides. Collective.
     * @param points of this rank, each with its weight in @p weights.
     */
    void divide(const std::vector<Point<dim>> &points, const std::vector<double> &weights);

    /// The rank whose part of space holds @p point.
    unsigned int rank_of(const Point<dim> &point) const;

    /// The cuts, which belong to one number of ranks.
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &parts;
    }

  private:
    /// Ranks first … first+number−1 and, if these are several, where they are divided: n/2 of them are below the cut.
    struct Part
    {
      unsigned int first, n_ranks;
      unsigned int direction = 0;
      double place           = 0.;
      unsigned int below     = 0; ///< index of the part below the cut, the one above it follows

      template <typename Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &first &n_ranks &direction &place &below;
      }
    };

    MPI_Comm communicator;
    std::vector<Part> parts; ///< a level after the other
  };
} // namespace Lahar

#endif
