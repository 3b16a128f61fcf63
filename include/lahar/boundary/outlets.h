// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_outlets_h
#define lahar_boundary_outlets_h

#include <lahar/boundary/outflow.h>
#include <lahar/geometry/walls.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * Boundaries whose law is Outflow: fluid particles that have passed through one of them are dropped, and with them the
   * cells that they are corners of. What is left has a free surface there.
   *
   * A particle has passed through a facet if it lies behind it, seen in the direction of the outflow, by no more than five
   * times its spacing, and its foot in the facet, enlarged by half of its spacing.
   */
  template <int dim>
  class Outlets
  {
  public:
    /// Add the facets of a boundary. @throws InputError for a direction of the wrong dimension or along the boundary.
    void add(const std::string &name, const Outflow &law, const std::vector<WallFacet<dim>> &facets);

    bool any() const
    {
      return !directions.empty();
    }

    /// @throws InputError if there is fluid behind an outlet.
    void check_initial(const ParticleCloud<dim> &cloud) const;

    /// Drop what has passed through. @return the number of this rank's own particles among it.
    unsigned int drop(ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh) const;

  private:
    /// The facet through which a particle has passed; numbers::invalid_unsigned_int for none.
    unsigned int passed(const unsigned int particle, const ParticleCloud<dim> &cloud) const;

    Walls<dim> surface;
    std::vector<double> directions; ///< by facet: 1 if fluid leaves to the side of its normal, else −1
    std::vector<std::string> names; ///< of the boundaries, by facet
  };
} // namespace Lahar

#endif
