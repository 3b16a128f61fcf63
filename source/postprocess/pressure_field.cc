// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The pressure p, positive in tension, Pa.
  template <int dim>
  class PressureField : public OutputField<dim>
  {
  public:
    using Place = typename OutputField<dim>::Place;

    Place place() const override
    {
      return Place::vertices;
    }

    unsigned int position() const override
    {
      return 1;
    }

    Vector<double> evaluate(const Snapshot<dim> &snapshot) const override
    {
      Vector<double> values(snapshot.mesh.n_vertices());
      for (unsigned int v = 0; v < values.size(); ++v)
        values[v] = snapshot.cloud.pressure[snapshot.mesh.particle(v)];
      return values;
    }
  };



  static const Factory<OutputField<2>>::Registration<PressureField<2>>
    pressure_2d("pressure", "Pressure in Pa, positive in tension.");
  static const Factory<OutputField<3>>::Registration<PressureField<3>>
    pressure_3d("pressure", "Pressure in Pa, positive in tension.");
} // namespace Lahar
