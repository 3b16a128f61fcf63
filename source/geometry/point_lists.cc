// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/point_lists.h>

#include <stdexcept>

namespace Lahar
{
  template <int dim>
  std::vector<Point<dim>> parse_points(const Parameters &prm, const std::string &entry,
                                       const std::string &text, const std::string &allowed)
  {
    std::vector<Point<dim>> points;
    for (const std::string &piece : split_list(text, ':'))
    {
      const std::vector<std::string> numbers = split_list(piece, ',');
      if (numbers.size() == 5 - dim)
        prm.throw_wrong_value(entry, allowed + ", since 'Dimension' is " + std::to_string(dim));
      if (numbers.size() != dim)
        prm.throw_wrong_value(entry, allowed);
      points.emplace_back();
      for (unsigned int d = 0; d < dim; ++d)
        try
        {
          points.back()[d] = to_number(numbers[d]);
        }
        catch (const std::invalid_argument &)
        {
          prm.throw_wrong_value(entry, allowed);
        }
    }
    return points;
  }



  template <int dim>
  std::vector<std::vector<Point<dim>>> parse_point_lists(const Parameters &prm, const std::string &entry)
  {
    const std::string point = dim == 2 ? "x, y" : "x, y, z";
    std::vector<std::vector<Point<dim>>> lists;
    for (const std::string &text : split_list(prm.get(entry), ';'))
      lists.push_back(parse_points<dim>(prm, entry, text,
                                        "lists of points '" + point + " : " + point +
                                          " : ...' separated by ';', lengths in m (found '" + text + "')"));
    return lists;
  }



  template <int dim>
  std::vector<NamedPoints<dim>> parse_named_points(const Parameters &prm, const std::string &entry,
                                                   const unsigned int n_points)
  {
    const std::string point = dim == 2 ? "x, y" : "x, y, z";
    std::string allowed     = "'name: " + point;
    for (unsigned int i = 1; i < n_points; ++i)
      allowed += " : " + point;
    allowed += "' separated by ';'";

    std::vector<NamedPoints<dim>> result;
    for (const std::string &text : split_list(prm.get(entry), ';'))
    {
      const std::size_t end_of_name = text.find(':');
      if (end_of_name == std::string::npos)
        prm.throw_wrong_value(entry, allowed);
      const std::vector<std::string> name = split_list(text.substr(0, end_of_name), ':');
      if (name.size() != 1 || name[0].empty())
        prm.throw_wrong_value(entry, allowed);
      result.push_back({name[0], parse_points<dim>(prm, entry, text.substr(end_of_name + 1), allowed)});
      if (result.back().points.size() != n_points)
        prm.throw_wrong_value(entry, allowed);
    }
    return result;
  }



  template struct NamedPoints<2>;
  template struct NamedPoints<3>;
  template std::vector<Point<2>> parse_points(const Parameters &, const std::string &, const std::string &,
                                              const std::string &);
  template std::vector<Point<3>> parse_points(const Parameters &, const std::string &, const std::string &,
                                              const std::string &);
  template std::vector<NamedPoints<2>> parse_named_points(const Parameters &, const std::string &,
                                                          const unsigned int);
  template std::vector<NamedPoints<3>> parse_named_points(const Parameters &, const std::string &,
                                                          const unsigned int);
  template std::vector<std::vector<Point<2>>> parse_point_lists(const Parameters &, const std::string &);
  template std::vector<std::vector<Point<3>>> parse_point_lists(const Parameters &, const std::string &);
} // namespace Lahar
