// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_domain_limit_h
#define lahar_remeshing_domain_limit_h

#include <lahar/geometry/box.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/utilities/parameters.h>

#include <vector>

namespace Lahar
{
  /**
   * A box that fluid may leave: particles outside are dropped, and with them the cells that they are corners of.
   *
   * Without it (the default) the domain has no limits, and fluid that falls beside the walls is followed for ever.
   */
  template <int dim>
  class DomainLimit
  {
  public:
    static void declare_parameters(Parameters &prm);

    /// @throws InputError
    void parse_parameters(Parameters &prm);

    /// Whether there is a box.
    bool is_set() const
    {
      return !boxes.empty();
    }

    /// @throws InputError if there are fluid particles outside.
    void check_initial(Parameters &prm, const ParticleCloud<dim> &cloud) const;

    /// Drop the fluid particles outside. @return their number.
    unsigned int drop_outside(ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh) const;

  private:
    /// By particle: whether it is a fluid particle outside.
    std::vector<bool> find_outside(const ParticleCloud<dim> &cloud) const;

    std::vector<Box<dim>> boxes; ///< one or none
  };
} // namespace Lahar

#endif
