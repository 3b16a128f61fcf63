// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_case_h
#define lahar_simulator_case_h

#include <lahar/geometry/mesh_size.h>
#include <lahar/initial/initial_geometry.h>
#include <lahar/initial/solid_surfaces.h>
#include <lahar/remeshing/domain_limit.h>
#include <lahar/simulator/run_parameters.h>
#include <lahar/utilities/case_structure.h>

namespace Lahar
{
  /// What is to be computed: for how long, the fluids and boundaries, and what they share. Solids have a state, see Solids.
  template <int dim>
  struct Case
  {
    RunParameters run;
    InitialGeometry<dim> geometry; ///< the fluids and boundaries
    SolidSurfaces surfaces;        ///< of the solids
    MeshSize<dim> mesh_size;
    DomainLimit<dim> domain_limit;
    Tensor<1, dim> gravity; ///< m/s²

    static void declare_parameters(Parameters &prm, const CaseStructure &structure);

    /// @throws InputError
    void parse_parameters(Parameters &prm, const CaseStructure &structure);

  private:
    /// @throws InputError for what rotational symmetry makes no sense of, or what is not there with it.
    void check_symmetry(Parameters &prm, const CaseStructure &structure) const;
  };
} // namespace Lahar

#endif
