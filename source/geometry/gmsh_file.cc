// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/gmsh_file.h>
#include <lahar/remeshing/simplex_geometry.h>
#include <lahar/utilities/exceptions.h>

#include <algorithm>
#include <cmath>

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
    const std::string kind = kind_of_group(dimension);
    const auto found       = groups.find({dimension, group});
    if (found == groups.end())
    {
      std::string names;
      for (const auto &entry : groups)
        if (entry.first.first == dimension)
          names += (names.empty() ? "'" : ", '") + entry.first.second + "'";
      throw InputError(file_name + " has no " + kind + " '" + group +
                       "'. Allowed: " + (names.empty() ? "none, the file names no " + kind : names) + "." +
                       (dim == 3 && is_flat ? " Its mesh is plane, and 'Dimension' is 3." : ""));
    }
    if (dimension == dim ? cells.count(found->second) == 0 : facets.count(found->second) == 0)
      throw InputError(file_name + ": the " + kind + " '" + group +
                       "' has no elements. Allowed: a group that is meshed (gmsh -" + std::to_string(dim) +
                       "; in format 2.2 without Mesh.SaveAll).");
    return found->second;
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
  const std::vector<std::array<Point<dim>, dim>> &GmshFile<dim>::facets_of(const std::string &group) const
  {
    return facets.at(find_group(dim - 1, group));
  }



  template class GmshFile<2>;
  template class GmshFile<3>;
} // namespace Lahar
