// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_sharp_edges_h
#define lahar_geometry_sharp_edges_h

#include <lahar/geometry/mesh_size.h>
#include <lahar/geometry/walls.h>

#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * Points that hold the sharp edges of walls to which fluid sticks: in the plane the corners and ends of lines, in space
   * points on the edges and rims of surfaces at the distance h. An edge is sharp where no other facet goes on from it
   * within 45 degrees, and where it does not lie in the middle of another facet.
   *
   * @return the points, half a mesh size apart at least, each with the number of its boundary.
   */
  template <int dim>
  std::vector<std::pair<Point<dim>, unsigned int>> points_on_sharp_edges(const Walls<dim> &walls,
                                                                         const MeshSize<dim> &h);
} // namespace Lahar

#endif
