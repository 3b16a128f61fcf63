// SPDX-License-Identifier: GPL-3.0-or-later

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
    MeshSize<dim>::declare_parameters(prm);
    DomainLimit<dim>::declare_parameters(prm);
  }



  template <int dim>
  void Case<dim>::parse_parameters(Parameters &prm, const CaseStructure &structure)
  {
    run.parse_parameters(prm);
    mesh_size.parse_parameters(prm, run.mesh_size);
    gravity = prm.get_vector<dim>("Gravity");
    geometry.parse_parameters(prm, structure);
    for (const Boundary<dim> &boundary : geometry.all_boundaries())
    {
      boundary.check_start(run.start_time);
      if (const Inflow *inflow = boundary.inflow())
        inflow->check_times(run.start_time, run.end_time);
    }
    domain_limit.parse_parameters(prm);
  }



  template struct Case<2>;
  template struct Case<3>;
} // namespace Lahar
