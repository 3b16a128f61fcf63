// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/deviator.h>
#include <lahar/assembly/fluid_structure.h>
#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  namespace
  {
    /// Of |Λ|, which is one where a yield stress that is exact is reached.
    constexpr double rounding = 1e-12;
  } // namespace



  /// Whether the fluid has yielded, see FluidLaw::is_yielded(); where the yield stress is exact, whether |Λ| = 1.
  template <int dim>
  class YieldedField : public OutputField<dim>
  {
  public:
    using Place = typename OutputField<dim>::Place;

    Place place() const override
    {
      return Place::cells;
    }

    unsigned int position() const override
    {
      return 5;
    }

    Vector<double> evaluate(const Snapshot<dim> &snapshot) const override
    {
      Vector<double> values(snapshot.mesh.n_cells());
      const std::vector<double> structure = FluidStructure<dim>::of_cells(snapshot.mesh, snapshot.materials,
                                                                          snapshot.cloud);
      const auto &cells                   = snapshot.mesh.particle_cells();
      for_each_cell(snapshot, [&](const unsigned int c, const CellFlow<dim> &cell) {
        const FluidLaw &law = snapshot.law(c);
        values[c]         = law.is_yielded(cell.strain_rate(), cell.confining_pressure(law, snapshot.gravity),
                                   structure.empty() ? 0. : structure[c]);
        const auto *value = snapshot.multipliers != nullptr && law.has_exact_yield_stress()
                              ? snapshot.multipliers->find(CellTable<dim>::key(cells[c], snapshot.cloud))
                              : nullptr;
        if (value != nullptr)
          values[c] = deviator_norm<dim>(*value) > 1. - rounding;
      });
      return values;
    }
  };



  static const Factory<OutputField<2>>::Registration<YieldedField<2>>
    yielded_2d("yielded", "1 where the fluid has yielded, 0 where not.");
  static const Factory<OutputField<3>>::Registration<YieldedField<3>>
    yielded_3d("yielded", "1 where the fluid has yielded, 0 where not.");
} // namespace Lahar
