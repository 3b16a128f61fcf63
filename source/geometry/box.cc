#include <lahar/geometry/box.h>

#include <algorithm>
#include <stdexcept>

namespace Lahar
{
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
      const std::vector<std::string> corners = split_list(text, ':');
      if (corners.size() != 2)
        prm.throw_wrong_value(entry, allowed);
      const auto first = split_list(corners[0], ','), second = split_list(corners[1], ',');
      if (first.size() != dim || second.size() != dim)
        prm.throw_wrong_value(entry, allowed);
      Box<dim> box;
      for (unsigned int d = 0; d < dim; ++d)
        try
        {
          box.lower[d] = std::min(to_number(first[d]), to_number(second[d]));
          box.upper[d] = std::max(to_number(first[d]), to_number(second[d]));
        }
        catch (const std::invalid_argument &)
        {
          prm.throw_wrong_value(entry, allowed);
        }
      boxes.push_back(box);
    }
    return boxes;
  }



  template struct Box<2>;
  template struct Box<3>;
  template std::vector<Box<2>> parse_boxes(const Parameters &, const std::string &);
  template std::vector<Box<3>> parse_boxes(const Parameters &, const std::string &);
} // namespace Lahar
