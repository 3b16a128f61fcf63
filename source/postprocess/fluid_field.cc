// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The fluid of the cell.
  template <int dim>
  class FluidField : public OutputField<dim>
  {
  public:
    using Place = typename OutputField<dim>::Place;

    Place place() const override
    {
      return Place::cells;
    }

    unsigned int position() const override
    {
      return 6;
    }

    bool is_there(const Snapshot<dim> &snapshot) const override
    {
      return snapshot.materials.n_fluids() > 1;
    }

    Vector<double> evaluate(const Snapshot<dim> &snapshot) const override
    {
      Vector<double> values(snapshot.mesh.n_cells());
      for (unsigned int c = 0; c < values.size(); ++c)
        values[c] = snapshot.mesh.fluid(c);
      return values;
    }
  };



  static const Factory<OutputField<2>>::Registration<FluidField<2>>
    fluid_2d("fluid",
             "Where there are several fluids, which one: 0 for the first in 'Fluids', 1 for the second …");
  static const Factory<OutputField<3>>::Registration<FluidField<3>>
    fluid_3d("fluid",
             "Where there are several fluids, which one: 0 for the first in 'Fluids', 1 for the second …");
} // namespace Lahar
