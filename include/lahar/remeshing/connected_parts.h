// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_connected_parts_h
#define lahar_remeshing_connected_parts_h

#include <boost/pending/disjoint_sets.hpp>

#include <lahar/remeshing/migration.h>

#include <vector>

namespace Lahar
{
  /**
   * Parts of the fluid that hang together, also over several ranks, and sums over them.
   *
   * On each rank particles are joined to sets. Sets of different ranks that have a particle in common belong to one part:
   * a part is known by the smallest number of its particles, of which the ranks tell each other until all have heard.
   */
  template <int dim>
  class ConnectedParts
  {
  public:
    explicit ConnectedParts(const unsigned int n_particles);

    void join(const unsigned int a, const unsigned int b)
    {
      sets.union_set(a, b);
    }

    /// After the last join(): find out what belongs together. Collective.
    void connect(const ParticleCloud<dim> &cloud, const Migration<dim> &migration);

    /**
     * By particle the sum over its part of all ranks' @p contributions by particle, which may stand at copies. Ranks are
     * added up in their order. Collective.
     */
    std::vector<double> sum(const std::vector<double> &contributions, const Migration<dim> &migration);

  private:
    boost::disjoint_sets_with_storage<> sets;
    std::vector<double> label;   ///< by particle
    std::vector<bool> is_shared; ///< by particle: whether other ranks may know particles of its set
  };
} // namespace Lahar

#endif
