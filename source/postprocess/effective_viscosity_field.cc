// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_structure.h>
#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The effective viscosity μ_eff of the law, Pa s.
  template <int dim>
  class EffectiveViscosityField : public OutputField<dim>
  {
  public:
    using Place = typename OutputField<dim>::Place;

    Place place() const override
    {
      return Place::cells;
    }

    unsigned int position() const override
    {
      return 4;
    }

    Vector<double> evaluate(const Snapshot<dim> &snapshot) const override
    {
      Vector<double> values(snapshot.mesh.n_cells());
      const std::vector<double> structure = FluidStructure<dim>::of_cells(snapshot.mesh, snapshot.materials,
                                                                          snapshot.cloud);
      for_each_cell(snapshot, [&](const unsigned int c, const CellFlow<dim> &cell) {
        const FluidLaw &law = snapshot.law(c);
        values[c]           = law
                      .effective_viscosity(cell.strain_rate(), cell.confining_pressure(law, snapshot.gravity),
                                           structure.empty() ? 0. : structure[c])
                      .value;
      });
      return values;
    }
  };



  static const Factory<OutputField<2>>::Registration<EffectiveViscosityField<2>>
    effective_viscosity_2d("effective_viscosity", "Effective viscosity in Pa s.");
  static const Factory<OutputField<3>>::Registration<EffectiveViscosityField<3>>
    effective_viscosity_3d("effective_viscosity", "Effective viscosity in Pa s.");
} // namespace Lahar
