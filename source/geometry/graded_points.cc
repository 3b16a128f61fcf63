// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/graded_points.h>

namespace Lahar
{
  namespace
  {
    /// Points of different lattices keep this distance, over h.
    constexpr double clearance = 0.65;
  } // namespace



  template <int dim>
  void append_graded_lattice(const SizeFunction<dim> &h, const std::vector<double> &levels,
                             const Lattice<dim> &lattice, std::vector<Point<dim>> &points)
  {
    if (levels.size() == 1)
    {
      for (const Point<dim> &p : lattice(levels[0], [](const Point<dim> &) { return true; }))
        points.push_back(p);
      return;
    }

    PointSet<dim> places;
    for (const Point<dim> &p : points)
      places.insert(p);
    for (unsigned int level = 0; level < levels.size(); ++level)
    {
      const auto is_wanted = [&](const Point<dim> &p) {
        const double size = h(p);
        return size >= levels[level] && (level + 1 == levels.size() || size < levels[level + 1]);
      };
      for (const Point<dim> &p : lattice(levels[level], is_wanted))
        if (places.insert_if_free(p, clearance * h(p)))
          points.push_back(p);
    }
  }



  template void append_graded_lattice(const SizeFunction<2> &, const std::vector<double> &,
                                      const Lattice<2> &, std::vector<Point<2>> &);
  template void append_graded_lattice(const SizeFunction<3> &, const std::vector<double> &,
                                      const Lattice<3> &, std::vector<Point<3>> &);
} // namespace Lahar
