// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// Whether the fluid has yielded, see FluidLaw::is_yielded().
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
      for_each_cell(snapshot, [&](const unsigned int c, const FluidCell<dim> &cell) {
        values[c] = snapshot.law(c).is_yielded(cell.strain_rate);
      });
      return values;
    }
  };



  static const Factory<OutputField<2>>::Registration<YieldedField<2>>
    yielded_2d("yielded", "1 where the fluid has yielded, 0 where not.");
  static const Factory<OutputField<3>>::Registration<YieldedField<3>>
    yielded_3d("yielded", "1 where the fluid has yielded, 0 where not.");
} // namespace Lahar
