// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/initial/axis.h>
#include <lahar/simulator/case.h>

namespace Lahar
{
  template <int dim>
  void Case<dim>::declare_parameters(Parameters &prm, const CaseStructure &structure)
  {
    RunParameters::declare_parameters(prm);
    prm.declare_vector("Gravity", dim == 2 ? "0, -9.81" : "0, 0, -9.81", dim,
                       "Gravity vector in m/s², its components separated by commas.");
    InitialGeometry<dim>::declare_parameters(prm, structure);
    SolidSurfaces::declare_parameters(prm, structure.solids);
    MeshSize<dim>::declare_parameters(prm);
    DomainLimit<dim>::declare_parameters(prm);
  }



  template <int dim>
  void Case<dim>::parse_parameters(Parameters &prm, const CaseStructure &structure)
  {
    run.parse_parameters(prm);
    mesh_size.parse_parameters(prm, run.mesh_size);
    gravity = prm.get_vector<dim>("Gravity");
    if (Symmetry::applies<dim>() && !structure.solids.empty())
      throw InputError("Parameter 'Solids' has '" + structure.solids[0] +
                       "'. Allowed: nothing, as 'Geometry' is 'rotational symmetry'.");
    geometry.parse_parameters(prm, structure);
    surfaces.parse_parameters(prm, structure.solids);
    for (const Boundary<dim> &boundary : geometry.all_boundaries())
    {
      boundary.check_start(run.start_time);
      if (const Inflow *inflow = boundary.inflow())
        inflow->check_times(run.start_time, run.end_time);
      if (const Outflow *outflow = boundary.outflow())
        outflow->check_times(run.start_time, run.end_time);
    }
    if (Symmetry::applies<dim>())
      check_symmetry(prm, structure);
    domain_limit.parse_parameters(prm);
  }



  template <int dim>
  void Case<dim>::check_symmetry(Parameters &prm, const CaseStructure &structure) const
  {
    if (gravity[0] != 0.)
      prm.throw_wrong_value("Gravity", "'0, g', along the axis, as 'Geometry' is 'rotational symmetry'");
    if constexpr (dim == 2)
      for (unsigned int b = 0; b < structure.boundaries.size(); ++b) // not of the axis
        check_boundary_about_axis(geometry.all_boundaries()[b], run.start_time, run.end_time);
  }



  template struct Case<2>;
  template struct Case<3>;
} // namespace Lahar
