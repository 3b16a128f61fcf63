// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The velocity v, m/s.
  template <int dim>
  class VelocityField : public OutputField<dim>
  {
  public:
    using Place = typename OutputField<dim>::Place;

    Place place() const override
    {
      return Place::vertices;
    }

    unsigned int n_components() const override
    {
      return dim;
    }

    unsigned int position() const override
    {
      return 0;
    }

    Vector<double> evaluate(const Snapshot<dim> &snapshot) const override
    {
      Vector<double> values(dim * snapshot.mesh.n_vertices());
      for (unsigned int v = 0; v < snapshot.mesh.n_vertices(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          values[dim * v + d] = snapshot.cloud.velocity[snapshot.mesh.particle(v)][d];
      return values;
    }
  };



  static const Factory<OutputField<2>>::Registration<VelocityField<2>> velocity_2d("velocity",
                                                                                   "Velocity in m/s.");
  static const Factory<OutputField<3>>::Registration<VelocityField<3>> velocity_3d("velocity",
                                                                                   "Velocity in m/s.");
} // namespace Lahar
