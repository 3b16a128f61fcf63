// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The strain rate γ̇, 1/s.
  template <int dim>
  class StrainRateField : public OutputField<dim>
  {
  public:
    using Place = typename OutputField<dim>::Place;

    Place place() const override
    {
      return Place::cells;
    }

    unsigned int position() const override
    {
      return 3;
    }

    Vector<double> evaluate(const Snapshot<dim> &snapshot) const override
    {
      Vector<double> values(snapshot.mesh.n_cells());
      for_each_cell(snapshot,
                    [&](const unsigned int c, const CellFlow<dim> &cell) { values[c] = cell.strain_rate(); });
      return values;
    }
  };



  static const Factory<OutputField<2>>::Registration<StrainRateField<2>>
    strain_rate_2d("strain_rate", "Strain rate in 1/s.");
  static const Factory<OutputField<3>>::Registration<StrainRateField<3>>
    strain_rate_3d("strain_rate", "Strain rate in 1/s.");
} // namespace Lahar
