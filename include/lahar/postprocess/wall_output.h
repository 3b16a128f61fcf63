// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_postprocess_wall_output_h
#define lahar_postprocess_wall_output_h

#include <lahar/geometry/walls.h>

#include <ostream>

namespace Lahar
{
  /**
   * Write the rigid walls as a VTU file for ParaView: segments in the plane, triangles in space, in the order of the
   * facets, with the field 'slip', 1 on slip walls and 0 on others.
   */
  template <int dim>
  void write_walls_vtu(const Walls<dim> &walls, std::ostream &file);

  /// Whether some of the walls move in the run.
  template <int dim>
  bool any_moves(const Walls<dim> &walls);
} // namespace Lahar

#endif
