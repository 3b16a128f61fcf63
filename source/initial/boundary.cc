// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/gmsh_file.h>
#include <lahar/initial/boundary.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  template <int dim>
  void Boundary<dim>::declare_parameters(Parameters &prm)
  {
    Factory<BoundaryShape<dim>>::declare_models(prm, "Shape", "", "Where the boundary is.");
    Factory<SurfaceLaw>::declare_models(prm, "Law", "no slip", "How fluid moves along the boundary.");
  }



  template <int dim>
  void Boundary<dim>::parse_parameters(Parameters &prm, const std::string &new_name)
  {
    name  = new_name;
    shape = Factory<BoundaryShape<dim>>::create_chosen(prm, "Shape");
    law   = Factory<SurfaceLaw>::create_chosen(prm, "Law");
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
      wall.slip     = law->slips();
      wall.boundary = number;
    }
    return result;
  }



  template <int dim>
  std::vector<std::string> Boundary<dim>::warnings(const double h) const
  {
    if (shape->scale_path().empty())
      return {};
    std::vector<Point<dim>> corners;
    for (const WallShape<dim> &wall : shape->walls())
      for (const WallFacet<dim> &facet : wall.facets())
        corners.insert(corners.end(), facet.corners.begin(), facet.corners.end());
    return warn_of_extent("the walls of boundary '" + name + "'", box_around(corners), h,
                          shape->scale_path());
  }



  template class Boundary<2>;
  template class Boundary<3>;
} // namespace Lahar
