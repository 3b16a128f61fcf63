// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/simulator/slivers.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    /// Largest volume of a sliver over that of the regular tetrahedron with the same mean edge.
    constexpr double largest_volume = 0.2;

    constexpr long n_contacts_allowed = 1;
  } // namespace



  template <int dim>
  std::vector<bool> find_slivers(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud)
  {
    std::vector<bool> slivers(mesh.n_cells(), false);
    if constexpr (dim == 3)
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      {
        const Simplex<dim> &cell = mesh.particle_cells()[c];
        const auto x             = corners_of<dim>(cell, cloud.position);
        double mean_edge         = 0.;
        for (unsigned int a = 0; a <= dim; ++a)
          for (unsigned int b = 0; b < a; ++b)
            mean_edge += x[a].distance(x[b]) / 6.;
        const auto n_contacts = std::count_if(cell.begin(), cell.end(), [&](const unsigned int i) {
          return cloud.kind[i] != ParticleKind::fluid;
        });
        slivers[c]            = n_contacts <= n_contacts_allowed &&
                     signed_volume<dim>(x) < largest_volume * std::pow(mean_edge, 3) / (6. * std::sqrt(2.));
      }
    return slivers;
  }



  template std::vector<bool> find_slivers(const FluidMesh<2> &, const ParticleCloud<2> &);
  template std::vector<bool> find_slivers(const FluidMesh<3> &, const ParticleCloud<3> &);
} // namespace Lahar
