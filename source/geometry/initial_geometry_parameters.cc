// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/cone_body.h>
#include <lahar/geometry/convex_body.h>
#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/initial_geometry.h>
#include <lahar/geometry/mesh_body.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/geometry/polygon_body.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace Lahar
{
  namespace
  {
    /// "x, y : x, y : ..." as points.
    template <int dim>
    std::vector<Point<dim>> parse_list(const Parameters &prm, const std::string &entry,
                                       const std::string &text)
    {
      const std::string point = dim == 2 ? "x, y" : "x, y, z";
      return parse_points<dim>(prm, entry, text,
                               "lists of points '" + point + " : " + point +
                                 " : ...' separated by ';', lengths in m (found '" + text + "')");
    }

    std::string numbered(const Parameters &prm, const std::string &entry, const unsigned int number)
    {
      return "number " + std::to_string(number) + " of '" + prm.path(entry) + "'";
    }
  } // namespace



  template <int dim>
  void InitialGeometry<dim>::declare_parameters(Parameters &prm)
  {
    const std::string point = dim == 2 ? "x, y" : "x, y, z", line = point + " : " + point;
    prm.enter_subsection("Geometry");
    prm.declare_entry("Fluid boxes", "", Patterns::Anything(),
                      "Fluid boxes, each as two opposite corners '" + line +
                        "', separated by ';'. Lengths in m.");
    if (dim == 2)
      prm.declare_entry("Fluid polygons", "", Patterns::Anything(),
                        "Fluid polygons, each as its corners '" + line + " ...', separated by ';'.");
    else
    {
      prm.declare_entry("Fluid polyhedra", "", Patterns::Anything(),
                        "Convex fluid bodies, each as its corners '" + line +
                          " ...' in any order, separated by ';'.");
      prm.declare_entry("Fluid cones", "", Patterns::Anything(),
                        "Upright truncated cones and cylinders of fluid, each as the centre of the base, the "
                        "two radii and the height 'x, y, z : base radius, top radius, height', separated "
                        "by ';'. The top is not wider than the base.");
      prm.declare_entry("Fluid cylinders", "", Patterns::Anything(),
                        "Cylinders of fluid in any direction, each as the centres of its ends and the radius "
                        "'x, y, z : x, y, z : radius', separated by ';'.");
    }
    prm.declare_entry(
      "No-slip walls", "", Patterns::Anything(),
      dim == 2
        ? "Rigid walls without slip, each a polyline 'x, y : x, y ...', separated by ';'. A line "
          "whose last point is its first one is a closed body, or a tank if fluid lies wholly inside."
        : "Rigid walls without slip, each a convex polygon in a plane 'x, y, z : x, y, z : x, y, z ...', "
          "separated by ';'.");
    prm.declare_entry("Slip walls", "", Patterns::Anything(),
                      "Rigid walls with free slip, given as in 'No-slip walls'. Fluid slides along them and "
                      "does not leave them.");
    prm.declare_entry(
      "Largest number of particles", "10000000", Patterns::Anything(),
      "A case is refused if it asks for more particles than this at the start, 1 to 100000000, as "
      "estimated from the mesh size and the boxes around fluid bodies and walls.");
    prm.declare_file("Mesh file",
                     "A gmsh file (.msh) that gives fluid bodies and walls by physical groups; its name is "
                     "relative to the parameter file that gives it (on the command line: to the working "
                     "directory). The mesh gives the shape, 'Mesh size' the distance of particles. "
                     "Elements of second order count as straight ones.");
    prm.declare_entry("Mesh scale", "1", Patterns::Anything(),
                      "Factor for the mesh file's coordinates, above zero: 1e-3 for a mesh in mm.");
    const std::string list =
      ", by names or tags separated by commas; a name with a comma in it stands in double "
      "quotes.";
    const std::string cells  = std::string("physical ") + (dim == 2 ? "surfaces" : "volumes"),
                      facets = std::string("physical ") + (dim == 2 ? "curves" : "surfaces");
    prm.declare_entry("Fluid groups", "", Patterns::Anything(),
                      "The mesh file's " + cells + " that are fluid" + list);
    prm.declare_entry("No-slip wall groups", "", Patterns::Anything(),
                      "The mesh file's " + facets + " that are walls without slip" + list);
    prm.declare_entry("Slip wall groups", "", Patterns::Anything(),
                      "The mesh file's " + facets + " that are walls with free slip" + list);
    prm.leave_subsection();
  }



  template <int dim>
  void InitialGeometry<dim>::parse_parameters(Parameters &prm, const bool has_solids)
  {
    prm.enter_subsection("Geometry");
    max_particles = prm.get_count("Largest number of particles", 1, 100000000);
    parse_bodies(prm);
    parse_walls(prm, "No-slip walls", false);
    parse_walls(prm, "Slip walls", true);
    parse_mesh_file(prm);
    if (bodies.empty() && !has_solids)
      throw InputError(
        "There is no fluid: '" + prm.path("Fluid boxes") + "', '" +
        prm.path(dim == 2 ? "Fluid polygons" : "Fluid polyhedra") + "'" +
        (dim == 2 ? "" : ", '" + prm.path("Fluid cones") + "', '" + prm.path("Fluid cylinders") + "'") +
        " and '" + prm.path("Fluid groups") + "' are all empty.");
    prm.leave_subsection();
  }



  template <int dim>
  void InitialGeometry<dim>::parse_bodies(Parameters &prm)
  {
    unsigned int number = 0;
    for (const std::string &text : split_list(prm.get("Fluid boxes"), ';'))
    {
      const std::vector<Point<dim>> p = parse_list<dim>(prm, "Fluid boxes", text);
      bool has_volume                 = p.size() == 2;
      for (unsigned int d = 0; d < dim && has_volume; ++d)
        has_volume = p[0][d] != p[1][d];
      if (!has_volume)
        prm.throw_wrong_value("Fluid boxes", std::string("two opposite corners with different x") +
                                               (dim == 2 ? " and different y" : ", y and z") +
                                               " for each box");
      const Box<dim> box(p[0], p[1]);
      const std::string name = numbered(prm, "Fluid boxes", ++number);
      if constexpr (dim == 2)
        bodies.push_back(std::make_unique<PolygonBody>(
          name, Polygon{box.lower, {box.upper[0], box.lower[1]}, box.upper, {box.lower[0], box.upper[1]}}));
      else
      {
        std::vector<Point<3>> corners;
        for (unsigned int c = 0; c < 8; ++c)
          corners.emplace_back((c & 1 ? box.upper : box.lower)[0], (c & 2 ? box.upper : box.lower)[1],
                               (c & 4 ? box.upper : box.lower)[2]);
        bodies.push_back(std::make_unique<ConvexBody>(name, corners));
      }
    }

    number                      = 0;
    const std::string polytopes = dim == 2 ? "Fluid polygons" : "Fluid polyhedra";
    for (const std::string &text : split_list(prm.get(polytopes), ';'))
    {
      std::vector<Point<dim>> corners = parse_list<dim>(prm, polytopes, text);
      const std::string name          = numbered(prm, polytopes, ++number);
      if constexpr (dim == 2)
      {
        if (corners.size() < 3 || is_self_intersecting(corners) || signed_area(corners) == 0.)
          prm.throw_wrong_value(polytopes, "at least three corners and edges that do not meet each other");
        if (signed_area(corners) < 0.)
          std::reverse(corners.begin(), corners.end());
        bodies.push_back(std::make_unique<PolygonBody>(name, corners));
      }
      else
        try
        {
          bodies.push_back(std::make_unique<ConvexBody>(name, corners));
        }
        catch (const InputError &error)
        {
          prm.throw_wrong_value(polytopes, std::string(error.what()) + " (found '" + text + "')");
        }
    }

    if constexpr (dim == 3)
    {
      number = 0;
      for (const std::string &text : split_list(prm.get("Fluid cones"), ';'))
      {
        const std::string allowed =
          "'x, y, z : base radius, top radius, height' separated by ';', radii and height above 0, the top not "
          "wider than the base (found '" +
          text + "')";
        const std::vector<Point<3>> p = parse_points<3>(prm, "Fluid cones", text, allowed);
        if (p.size() != 2 || !(p[1][1] > 0. && p[1][1] <= p[1][0] && p[1][2] > 0.))
          prm.throw_wrong_value("Fluid cones", allowed);
        bodies.push_back(std::make_unique<ConeBody>(numbered(prm, "Fluid cones", ++number), p[0],
                                                    p[0] + Tensor<1, 3>({0., 0., p[1][2]}), p[1][0],
                                                    p[1][1]));
      }

      number = 0;
      for (const std::string &text : split_list(prm.get("Fluid cylinders"), ';'))
      {
        const std::string allowed =
          "'x, y, z : x, y, z : radius' separated by ';', the two ends apart, the radius "
          "above 0 (found '" +
          text + "')";
        const std::size_t end = text.rfind(':');
        std::vector<Point<3>> ends;
        double radius = 0.;
        if (end != std::string::npos)
          try
          {
            ends   = parse_points<3>(prm, "Fluid cylinders", text.substr(0, end), allowed);
            radius = to_number(text.substr(end + 1));
          }
          catch (const std::invalid_argument &)
          {}
        if (ends.size() != 2 || !(ends[0].distance(ends[1]) > 0.) || !(radius > 0.))
          prm.throw_wrong_value("Fluid cylinders", allowed);
        bodies.push_back(std::make_unique<ConeBody>(numbered(prm, "Fluid cylinders", ++number), ends[0],
                                                    ends[1], radius, radius));
      }
    }
  }



  template <int dim>
  void InitialGeometry<dim>::parse_walls(Parameters &prm, const std::string &entry, const bool slip)
  {
    unsigned int number = 0;
    for (const std::string &text : split_list(prm.get(entry), ';'))
    {
      WallShape<dim> wall{numbered(prm, entry, ++number), parse_list<dim>(prm, entry, text), false, slip, {}};
      if constexpr (dim == 2)
      {
        if (wall.corners.size() > 2 && wall.corners.front() == wall.corners.back())
        {
          wall.closed = true;
          wall.corners.pop_back();
        }
        bool has_length = wall.corners.size() >= 2;
        for (unsigned int i = 1; i < wall.corners.size(); ++i)
          has_length = has_length && wall.corners[i] != wall.corners[i - 1];
        if (!has_length)
          prm.throw_wrong_value(entry, "at least two different points for each wall, neighbours apart");
      }
      else
        try
        {
          wall.facets();
        }
        catch (const InputError &error)
        {
          prm.throw_wrong_value(entry, std::string(error.what()) + " for each wall (found '" + text + "')");
        }
      wall_shapes.push_back(wall);
    }
  }



  template <int dim>
  void InitialGeometry<dim>::parse_mesh_file(Parameters &prm)
  {
    const std::string file_name = prm.get("Mesh file");
    const auto fluid            = prm.get_names("Fluid groups");
    const auto no_slip          = prm.get_names("No-slip wall groups");
    const auto slip             = prm.get_names("Slip wall groups");
    if (file_name.empty())
    {
      if (!fluid.empty() || !no_slip.empty() || !slip.empty())
        prm.throw_wrong_value("Mesh file", "the name of a gmsh file, since groups of it are named");
      return;
    }

    mesh_scale = prm.get_positive("Mesh scale");
    const GmshFile<dim> file(file_name, mesh_scale);
    std::string names;
    std::vector<Point<dim>> nodes, of_group;
    std::vector<Simplex<dim>> simplices, cells;
    for (const std::string &group : fluid)
    {
      names += (names.empty() ? "'" : ", '") + group + "'";
      file.cells_of(group, of_group, cells);
      for (Simplex<dim> &cell : cells)
        for (unsigned int &corner : cell)
          corner += nodes.size();
      simplices.insert(simplices.end(), cells.begin(), cells.end());
      nodes.insert(nodes.end(), of_group.begin(), of_group.end());
    }
    if (!fluid.empty())
      bodies.push_back(std::make_unique<MeshBody<dim>>((fluid.size() == 1 ? "group " : "groups ") + names +
                                                         " of " + file_name,
                                                       nodes, simplices));
    for (const bool is_slip : {false, true})
      for (const std::string &group : is_slip ? slip : no_slip)
      {
        const std::string name = "group '" + group + "' of " + file_name;
        for (const auto &facet : file.facets_of(group))
          mesh_wall_corners.insert(mesh_wall_corners.end(), facet.begin(), facet.end());
        if constexpr (dim == 2)
          for (const auto &[a, b] : file.facets_of(group))
            wall_shapes.push_back({name, {a, b}, false, is_slip, {}});
        else
          wall_shapes.push_back({name, {}, false, is_slip, file.facets_of(group)});
      }
    for (const std::string &group : fluid)
      mesh_edges["group '" + group + "' of " + file_name] = file.mean_edge(group);
  }



  template <int dim>
  void InitialGeometry<dim>::check_mesh_scale(const double h) const
  {
    constexpr double largest = 100.;
    for (const auto &[group, edge] : mesh_edges)
      if (!(edge < largest * h && edge > h / largest))
      {
        std::ostringstream message;
        message << "Parameter 'Geometry/Mesh scale' is " << mesh_scale << ", with which the edges of "
                << group << " have a mean length of " << edge << " m; 'Mesh size' is " << h
                << " m. Allowed: a scale that makes metres of the file's unit (1e-3 for mm), and edges about "
                   "as long as 'Mesh size'.";
        throw InputError(message.str());
      }
  }



  template <int dim>
  std::vector<std::string> InitialGeometry<dim>::warnings(const double h) const
  {
    std::vector<std::string> result;
    if (!mesh_wall_corners.empty())
      result = warn_of_extent("the walls of 'Geometry/Mesh file'", box_around(mesh_wall_corners), h,
                              "Geometry/Mesh scale");
    return result;
  }



  template void InitialGeometry<2>::declare_parameters(Parameters &);
  template void InitialGeometry<2>::parse_parameters(Parameters &, const bool);
  template void InitialGeometry<2>::check_mesh_scale(const double) const;
  template std::vector<std::string> InitialGeometry<2>::warnings(const double) const;
  template void InitialGeometry<3>::declare_parameters(Parameters &);
  template void InitialGeometry<3>::parse_parameters(Parameters &, const bool);
  template void InitialGeometry<3>::check_mesh_scale(const double) const;
  template std::vector<std::string> InitialGeometry<3>::warnings(const double) const;
} // namespace Lahar
