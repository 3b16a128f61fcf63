// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/data_out_base.h>

#include <deal.II/grid/reference_cell.h>

#include <lahar/geometry/symmetry.h>
#include <lahar/postprocess/wall_output.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  void write_walls_vtu(const Walls<dim> &walls, std::ostream &file)
  {
    std::vector<DataOutBase::Patch<dim - 1, dim>> patches;
    for (const WallFacet<dim> &facet : walls.facets())
    {
      // The axis of symmetry is far longer than what there is to see.
      if (Symmetry::applies<dim>() && walls.facets().size() > 1 && facet.corners[0][0] == 0. &&
          facet.corners[1][0] == 0.)
        continue;
      DataOutBase::Patch<dim - 1, dim> patch;
      patch.reference_cell = ReferenceCells::get_simplex<dim - 1>();
      patch.patch_index    = patches.size();
      patch.n_subdivisions = 1;
      patch.data.reinit(1, dim);
      for (unsigned int v = 0; v < dim; ++v)
      {
        patch.vertices[v] = facet.corners[v];
        patch.data(0, v)  = facet.lands && !facet.sticks;
      }
      patches.push_back(patch);
    }
    DataOutBase::write_vtu(patches, {"slip"}, {}, DataOutBase::VtkFlags(), file);
  }



  template <int dim>
  bool any_moves(const Walls<dim> &walls)
  {
    return std::any_of(walls.facets().begin(), walls.facets().end(),
                       [](const WallFacet<dim> &facet) { return facet.moves; });
  }



  template void write_walls_vtu(const Walls<2> &, std::ostream &);
  template void write_walls_vtu(const Walls<3> &, std::ostream &);
  template bool any_moves(const Walls<2> &);
  template bool any_moves(const Walls<3> &);
} // namespace Lahar
