// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_outlets_h
#define lahar_boundary_outlets_h

#include <lahar/assembly/face_pressure.h>
#include <lahar/boundary/outflow.h>
#include <lahar/geometry/walls.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <algorithm>
#include <functional>
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
   *
   * Where the outflow has a level the fluid behind it presses on what is left: with the part g_t of gravity along the
   * facet and a point x_0 of its plane at the level,
   *
   *   t = −p n,   p = max(0, ρ g_t·(x − x_0))
   *
   * on all faces of the free surface whose corners are within twice their spacing of the facet. It is the pressure of
   * fluid at rest behind the facet: that the mesh ends somewhere near it, in faces that lie askew, does not matter.
   */
  template <int dim>
  class Outlets
  {
  public:
    /// Add the facets of a boundary, whose law must outlive this object. @throws InputError for a direction of the wrong
    /// dimension or along the boundary.
    void add(const std::string &name, const Outflow &law, const std::vector<WallFacet<dim>> &facets);

    bool any() const
    {
      return !directions.empty();
    }

    bool any_level() const
    {
      return std::any_of(laws.begin(), laws.end(), [](const Outflow *law) { return law->has_level(); });
    }

    /// @throws InputError if there is fluid behind an outlet.
    void check_initial(const ParticleCloud<dim> &cloud) const;

    /// @throws InputError for a level where @p gravity (m/s²) does not say what it means, or fluids may have several densities.
    void check_levels(const Tensor<1, dim> &gravity, const unsigned int n_fluids) const;

    /**
     * What presses on the faces of @p mesh at outlets with a level, ascending by face.
     * @param cloud has the particles where they are at the start of the step.
     * @param time at its end, s. @param weight ρ g, N/m³.
     */
    std::vector<FacePressure<dim>> pressures(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                             const double time, const Tensor<1, dim> &weight) const;

    /// A run begins with @p n_boundaries boundaries and no force.
    void start_forces(const unsigned int n_boundaries)
    {
      forces.assign(any_level() ? n_boundaries : 0, Tensor<1, dim>());
    }

    /// A mean force from that at the end of a step and the last mean force.
    using Mean = std::function<Tensor<1, dim>(const Tensor<1, dim> &, const Tensor<1, dim> &)>;

    /// After a step: mean_forces() go on with the forces of the fluid on what presses on its faces. Collective.
    void take_forces(const std::vector<FacePressure<dim>> &pressures, const FluidMesh<dim> &mesh,
                     const ParticleCloud<dim> &cloud, const MPI_Comm &communicator, const Mean &mean);

    /// By boundary the mean force of the fluid on what stands behind it, N (N/m in 2D); empty if no outlet has a level.
    const std::vector<Tensor<1, dim>> &mean_forces() const
    {
      return forces;
    }

    template <typename Archive>
    void save_or_load_forces(Archive &archive)
    {
      for (Tensor<1, dim> &force : forces)
        archive &force;
    }

    /// Drop what has passed through. @return the number of this rank's own particles among it.
    unsigned int drop(ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh) const;

  private:
    /// The facet through which a particle has passed; numbers::invalid_unsigned_int for none.
    unsigned int passed(const unsigned int particle, const ParticleCloud<dim> &cloud) const;

    /// The part of a vector along a facet.
    Tensor<1, dim> tangential(const unsigned int facet, const Tensor<1, dim> &vector) const;

    Walls<dim> surface;
    std::vector<double> directions;    ///< by facet: 1 if fluid leaves to the side of its normal, else −1
    std::vector<std::string> names;    ///< of the boundaries, by facet
    std::vector<const Outflow *> laws; ///< by facet
    std::vector<Tensor<1, dim>> forces;
  };
} // namespace Lahar

#endif
