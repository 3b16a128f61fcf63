// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_lattice_h
#define lahar_geometry_lattice_h

#include <lahar/geometry/fluid_body.h>

namespace Lahar
{
  /**
   * @p contour, points on the contour of a body at the distance @p h of which some may lie nearly twice, and points
   * inside it: a body-centred cubic lattice, all of whose Delaunay tetrahedra are congruent and well-shaped, with the
   * edges 1.08 h and 0.94 h, smoothed towards the contour. The contour's points come first. With several levels of h
   * there are as many lattices (with_graded_lattice()), smoothed everywhere (smooth()). Collective.
   */
  DividedPoints<3> fill_inside(const FluidBody<3> &body, const std::vector<Point<3>> &contour,
                               const MeshSize<3> &h, const MPI_Comm &communicator);
} // namespace Lahar

#endif
