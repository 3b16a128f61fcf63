// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/gmsh_file.h>
#include <lahar/initial/boundary.h>
#include <lahar/utilities/factory.h>

#include <sstream>

namespace Lahar
{
  template <int dim>
  void Boundary<dim>::declare_parameters(Parameters &prm)
  {
    Factory<BoundaryShape<dim>>::declare_models(prm, "Shape", "", "Where the boundary is.");
    Factory<SurfaceLaw>::declare_models(prm, "Law", "no slip", "How fluid moves along the boundary.");
    prm.declare_bool(
      "Separates", false,
      "Whether fluid that has landed on the boundary leaves it where it would be pulled by more than "
      "'Tensile strength'; else it leaves over the rim only.");
    prm.declare_positive(
      "Tensile strength", "0",
      "Normal tension in Pa that fluid and boundary bear before they separate, zero or above.");
    Factory<BoundaryMotion<dim>>::declare_models(prm, "Motion", "fixed", "How the boundary moves.");
  }



  template <int dim>
  void Boundary<dim>::parse_parameters(Parameters &prm, const std::string &new_name)
  {
    name                  = new_name;
    path                  = prm.path("Motion");
    shape                 = Factory<BoundaryShape<dim>>::create_chosen(prm, "Shape");
    law                   = Factory<SurfaceLaw>::create_chosen(prm, "Law");
    motion                = Factory<BoundaryMotion<dim>>::create_chosen(prm, "Motion");
    const bool separates  = prm.get_bool("Separates");
    const double strength = prm.get_positive("Tensile strength", true);
    if (separates)
      tensile_strength = strength;
    if (separates && !law->lands())
      prm.throw_wrong_value("Separates", "false, as fluid does not land on a boundary of the law '" +
                                           prm.get("Law") + "'");
    if (strength > 0. && !separates)
      prm.throw_wrong_value("Tensile strength", "0, as 'Separates' is false");
    if (motion->moves() && (inflow() != nullptr || outflow() != nullptr))
      prm.throw_wrong_value("Motion", "fixed, as fluid comes in or leaves through the boundary");
  }



  template <int dim>
  void Boundary<dim>::check_start(const double start_time) const
  {
    if (!motion->moves())
      return;
    RigidMotion<dim> start;
    try
    {
      start = motion->at(start_time);
    }
    catch (const RunError &error)
    {
      throw InputError("Boundary '" + name + "': " + error.what() + ". Allowed: finite values.");
    }
    for (const WallShape<dim> &wall : shape->walls())
      for (const WallFacet<dim> &facet : wall.facets())
        for (const Point<dim> &corner : facet.corners)
          if (const Point<dim> moved = start(corner); moved.distance(corner) > 1e-12 * (1. + corner.norm()))
          {
            std::ostringstream message;
            message << "Boundary '" << name << "' is displaced by (" << moved - corner
                    << ") m at 'Start time', " << start_time << " s: see '" << path
                    << "'. Allowed: a motion that begins where the shape is drawn.";
            throw InputError(message.str());
          }
  }



  template <int dim>
  std::vector<WallShape<dim>> Boundary<dim>::walls(const unsigned int number) const
  {
    std::vector<WallShape<dim>> result = shape->walls();
    unsigned int n_named               = 0;
    for (WallShape<dim> &wall : result)
    {
      ++n_named;
      wall.name = (!wall.name.empty()   ? wall.name + " of "
                   : result.size() == 1 ? ""
                                        : "number " + std::to_string(n_named) + " of ") +
                  "'" + name + "'";
      wall.lands    = law->lands();
      wall.boundary = number;
      wall.moves    = motion->moves();
      wall.sticks   = law->sticks();
    }
    return result;
  }



  template <int dim>
  std::vector<std::string> Boundary<dim>::warnings(const double h) const
  {
    std::vector<std::string> result = shape->check_scale("boundary '" + name + "'", h);
    if (shape->scale_path().empty())
      return result;
    std::vector<Point<dim>> corners;
    for (const WallShape<dim> &wall : shape->walls())
      for (const WallFacet<dim> &facet : wall.facets())
        corners.insert(corners.end(), facet.corners.begin(), facet.corners.end());
    for (const std::string &text :
         warn_of_extent("the walls of boundary '" + name + "'", box_around(corners), h, shape->scale_path()))
      result.push_back(text);
    return result;
  }



  template class Boundary<2>;
  template class Boundary<3>;
} // namespace Lahar
