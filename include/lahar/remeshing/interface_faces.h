// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_interface_faces_h
#define lahar_remeshing_interface_faces_h

#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <array>
#include <vector>

namespace Lahar
{
  /// A face between two cells of different fluids, by its corners' particles: in the plane with the fluid of the smaller
  /// number on the left of the way from the first to the second.
  template <int dim>
  struct InterfaceFace
  {
    std::array<unsigned int, dim> corners;
    std::array<unsigned int, 2> cells;    ///< that of the smaller number's fluid first
    std::array<unsigned int, 2> opposite; ///< the cells' other corners, of the smaller number's first
    FluidSet fluids;
  };

  /// All of them.
  template <int dim>
  std::vector<InterfaceFace<dim>> find_interface_faces(const FluidMesh<dim> &mesh);
} // namespace Lahar

#endif
