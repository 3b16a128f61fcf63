// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/utilities/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Lahar
{
  namespace
  {
    std::string kind_of_group(const unsigned int dimension)
    {
      return dimension == 1 ? "physical curve" : (dimension == 2 ? "physical surface" : "physical volume");
    }
  } // namespace



  template <int dim>
  long GmshFile<dim>::find_group(const unsigned int dimension, const std::string &group) const
  {
    const std::string kind  = kind_of_group(dimension);
    const auto has_elements = [&](const long tag) {
      return dimension == dim ? cells.count(tag) > 0 : facets.count(tag) > 0;
    };
    const auto found = groups.find({dimension, group});
    long tag         = 0;
    if (found != groups.end())
      tag = found->second;
    else if (group.size() < 10 && group.find_first_not_of("0123456789") == std::string::npos &&
             !group.empty())
      tag = std::stol(group);
    if (found == groups.end() && !has_elements(tag))
    {
      std::string names;
      std::set<long> without_name;
      for (const auto &entry : cells)
        if (dimension == dim)
          without_name.insert(entry.first);
      for (const auto &entry : facets)
        if (dimension != dim)
          without_name.insert(entry.first);
      for (const auto &entry : groups)
        if (entry.first.first == dimension)
        {
          names += (names.empty() ? "'" : ", '") + entry.first.second + "'";
          without_name.erase(entry.second);
        }
      for (const long other : without_name)
        names += (names.empty() ? "" : ", ") + std::to_string(other) + " (has no name)";
      throw InputError(file_name + " has no " + kind + " '" + group +
                       "'. Allowed: " + (names.empty() ? "none, the file has no " + kind : names) + "." +
                       (dim == 3 && is_flat ? " Its mesh is plane, and 'Dimension' is 3." : ""));
    }
    if (!has_elements(tag))
      throw InputError(file_name + ": the " + kind + " '" + group +
                       "' has no elements. Allowed: a group that is meshed (gmsh -" + std::to_string(dim) +
                       "; in format 2.2 without Mesh.SaveAll).");
    return tag;
  }



  template <int dim>
  std::vector<Point<dim>> GmshFile<dim>::nodes_of(const std::string &group) const
  {
    std::set<std::size_t> tags;
    for (const auto &cell : cells.at(find_group(dim, group)))
      tags.insert(cell.begin(), cell.end());
    std::vector<Point<dim>> result;
    for (const std::size_t tag : tags)
      result.push_back(nodes.at(tag));
    return result;
  }



  template <int dim>
  void GmshFile<dim>::cells_of(const std::string &group, std::vector<Point<dim>> &points,
                               std::vector<std::array<unsigned int, dim + 1>> &simplices) const
  {
    points = nodes_of(group);
    simplices.clear();
    const auto &group_cells = cells.at(find_group(dim, group));
    std::map<std::size_t, unsigned int> numbers;
    for (const auto &cell : group_cells)
      for (const std::size_t tag : cell)
        numbers[tag] = 0;
    unsigned int number = 0;
    for (auto &entry : numbers)
      entry.second = number++;

    for (const auto &cell : group_cells)
    {
      auto &simplex = simplices.emplace_back();
      std::string tags;
      SimplexCorners<dim> corners;
      double size = 0.;
      for (unsigned int c = 0; c <= dim; ++c)
      {
        simplex[c] = numbers.at(cell[c]);
        corners[c] = points[simplex[c]];
        size       = std::max(size, corners[c].distance(corners[0]));
        tags += (c == 0 ? "" : (c == dim ? " and " : ", ")) + std::to_string(cell[c]);
      }
      if (!(std::abs(signed_volume<dim>(corners)) > 1e-12 * std::pow(size, dim)))
        throw InputError(file_name + ": the " + (dim == 2 ? "triangle" : "tetrahedron") + " of the nodes " +
                         tags + " has no " + (dim == 2 ? "area" : "volume") + ". Allowed: " +
                         (dim == 2 ? "triangles with an area." : "tetrahedra with a volume."));
    }
  }



  template <int dim>
  double GmshFile<dim>::mean_edge(const std::string &group) const
  {
    const auto &group_cells = cells.at(find_group(dim, group));
    double sum              = 0.;
    for (const auto &cell : group_cells)
      for (unsigned int a = 0; a <= dim; ++a)
        for (unsigned int b = 0; b < a; ++b)
          sum += nodes.at(cell[a]).distance(nodes.at(cell[b]));
    return sum / (group_cells.size() * (dim + 1) * dim / 2.);
  }



  template <int dim>
  const std::vector<std::array<Point<dim>, dim>> &GmshFile<dim>::facets_of(const std::string &group) const
  {
    return facets.at(find_group(dim - 1, group));
  }



  template <int dim>
  std::vector<std::string> warn_of_extent(const std::string &what, const Box<dim> &box, const double h,
                                          const std::string &entry)
  {
    double extent = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      extent = std::max(extent, box.upper[d] - box.lower[d]);
    if (extent > h && extent < 1e4 * h)
      return {};
    std::ostringstream text;
    text << "Warning: " << what << (extent > h ? " are " : " are only ") << extent
         << " m long, and 'Mesh size' is " << h << " m. '" << entry << "' is 1e-3 for a mesh in mm.";
    return {text.str()};
  }



  template std::vector<std::string> warn_of_extent(const std::string &, const Box<2> &, const double,
                                                   const std::string &);
  template std::vector<std::string> warn_of_extent(const std::string &, const Box<3> &, const double,
                                                   const std::string &);
  template class GmshFile<2>;
  template class GmshFile<3>;
} // namespace Lahar
