// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/drop_particles.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  unsigned int drop_particles(const std::vector<bool> &dropped, ParticleCloud<dim> &cloud,
                              FluidMesh<dim> &mesh)
  {
    unsigned int n_own = 0;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      n_own += (dropped[i] && cloud.is_own(i));
    if (std::find(dropped.begin(), dropped.end(), true) == dropped.end())
      return 0;

    std::vector<Simplex<dim>> cells;
    std::vector<unsigned int> fluids;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      if (const Simplex<dim> &cell = mesh.particle_cells()[c];
          std::none_of(cell.begin(), cell.end(), [&](const unsigned int i) { return dropped[i]; }))
      {
        cells.push_back(cell);
        fluids.push_back(mesh.fluid(c));
      }
    const std::vector<unsigned int> new_index = cloud.remove(dropped);
    for (Simplex<dim> &cell : cells)
      for (unsigned int &corner : cell)
        corner = new_index[corner];
    mesh.reinit(cloud, cells, fluids);
    return n_own;
  }



  template unsigned int drop_particles<2>(const std::vector<bool> &, ParticleCloud<2> &, FluidMesh<2> &);
  template unsigned int drop_particles<3>(const std::vector<bool> &, ParticleCloud<3> &, FluidMesh<3> &);
} // namespace Lahar
