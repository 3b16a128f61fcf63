// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/interface_faces.h>

#include <algorithm>
#include <tuple>

namespace Lahar
{
  template <int dim>
  std::vector<InterfaceFace<dim>> find_interface_faces(const FluidMesh<dim> &mesh)
  {
    std::vector<InterfaceFace<dim>> result;
    if (mesh.cell_fluids().empty())
      return result;
    struct Side
    {
      std::array<unsigned int, dim> sorted; // corners
      unsigned int fluid, cell, opposite;
    };
    std::vector<Side> sides;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      for (unsigned int opposite = 0; opposite <= dim; ++opposite)
      {
        Side side{{}, mesh.fluid(c), c, opposite};
        for (unsigned int k = 0; k < dim; ++k)
          side.sorted[k] = mesh.particle_cells()[c][(opposite + 1 + k) % (dim + 1)];
        std::sort(side.sorted.begin(), side.sorted.end());
        sides.push_back(side);
      }
    std::sort(sides.begin(), sides.end(), [](const Side &a, const Side &b) {
      return std::tie(a.sorted, a.fluid) < std::tie(b.sorted, b.fluid);
    });
    for (unsigned int s = 0; s + 1 < sides.size(); ++s)
      if (const Side &a = sides[s], &b = sides[s + 1]; a.sorted == b.sorted && a.fluid != b.fluid)
      {
        InterfaceFace<dim> face;
        const Simplex<dim> &cell = mesh.particle_cells()[a.cell];
        for (unsigned int k = 0; k < dim; ++k)
          face.corners[k] = cell[(a.opposite + 1 + k) % (dim + 1)];
        face.cells    = {{a.cell, b.cell}};
        face.opposite = {{cell[a.opposite], mesh.particle_cells()[b.cell][b.opposite]}};
        face.fluids   = fluid_set(a.fluid) | fluid_set(b.fluid);
        result.push_back(face);
      }
    return result;
  }



  template std::vector<InterfaceFace<2>> find_interface_faces<2>(const FluidMesh<2> &);
  template std::vector<InterfaceFace<3>> find_interface_faces<3>(const FluidMesh<3> &);
} // namespace Lahar
