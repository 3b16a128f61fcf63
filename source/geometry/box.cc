// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/box.h>
#include <lahar/geometry/point_lists.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  Box<dim>::Box(const Point<dim> &corner, const Point<dim> &opposite_corner)
  {
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d] = std::min(corner[d], opposite_corner[d]);
      upper[d] = std::max(corner[d], opposite_corner[d]);
    }
  }



  template <int dim>
  bool Box<dim>::contains(const Point<dim> &point, const double tolerance) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (point[d] < lower[d] - tolerance || point[d] > upper[d] + tolerance)
        return false;
    return true;
  }



  template <int dim>
  std::vector<Box<dim>> parse_boxes(const Parameters &prm, const std::string &entry)
  {
    const std::string allowed = std::string("boxes by opposite corners, ") +
                                (dim == 2 ? "'x, y : x, y'" : "'x, y, z : x, y, z'") +
                                ", separated by ';', lengths in m";
    std::vector<Box<dim>> boxes;
    for (const std::string &text : split_list(prm.get(entry), ';'))
    {
      const std::vector<Point<dim>> corners = parse_points<dim>(prm, entry, text, allowed);
      if (corners.size() != 2)
        prm.throw_wrong_value(entry, allowed);
      boxes.emplace_back(corners[0], corners[1]);
    }
    return boxes;
  }



  template struct Box<2>;
  template struct Box<3>;
  template std::vector<Box<2>> parse_boxes(const Parameters &, const std::string &);
  template std::vector<Box<3>> parse_boxes(const Parameters &, const std::string &);
} // namespace Lahar
