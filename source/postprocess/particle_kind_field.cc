// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// What the particle is, see ParticleKind.
  template <int dim>
  class ParticleKindField : public OutputField<dim>
  {
  public:
    using Place = typename OutputField<dim>::Place;

    Place place() const override
    {
      return Place::vertices;
    }

    unsigned int position() const override
    {
      return 2;
    }

    Vector<double> evaluate(const Snapshot<dim> &snapshot) const override
    {
      Vector<double> values(snapshot.mesh.n_vertices());
      for (unsigned int v = 0; v < values.size(); ++v)
        values[v] = static_cast<double>(snapshot.cloud.kind[snapshot.mesh.particle(v)]);
      return values;
    }
  };



  static const Factory<OutputField<2>>::Registration<ParticleKindField<2>>
    particle_kind_2d("particle_kind", "0 for a particle of the fluid, 1 of a wall, 2 of a solid.");
  static const Factory<OutputField<3>>::Registration<ParticleKindField<3>>
    particle_kind_3d("particle_kind", "0 for a particle of the fluid, 1 of a wall, 2 of a solid.");
} // namespace Lahar
