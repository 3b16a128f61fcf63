// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_inlets_h
#define lahar_boundary_inlets_h

#include <lahar/boundary/inflow.h>
#include <lahar/boundary/wall_step.h>
#include <lahar/geometry/point_set.h>
#include <lahar/linear/node_constraint.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <map>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * Fluid that comes in through plane boundaries whose law is Inflow.
   *
   * The particles of such a boundary are wall particles, and start on it, at their home. They move at right angles to
   * it, into the fluid, each with the velocity v of its home, and are the fluid's edge; the fluid before them gives way
   * as before a piston. When a particle's travel reaches its spacing h it becomes fluid, with the velocity and the
   * acceleration that it has, and a new one takes its place at its travel less h. So no time is lost, and the cells
   * between the two, which the mesh gets at once, hold what has come in.
   *
   * The layer between the boundary and its particles is fluid, too, for the account of the volume: Σ A_k s_k, with the
   * travel s_k of particle k and A_k its share of the boundary, that of the mesh's faces, projected on the boundary's
   * plane and divided evenly among their corners. In a step the volume grows by Δt Σ A_k v_k, which is the discharge Q if
   * that is given, v_k = Q φ_k / Σ A φ. It does not change when particles are renewed, nor when the mesh joins others of
   * them by faces.
   *
   * Homes on walls to which fluid sticks, and at the rim of a hole in another one, stay where they are. A particle at a
   * home without fluid before it becomes a drop, which carries its volume A_k h until it lands, A_k its share of the
   * first mesh.
   */
  template <int dim>
  class Inlets
  {
  public:
    /// A boundary of a case.
    struct Source
    {
      std::string name;
      const Inflow *law  = nullptr; ///< none: no fluid comes in through it
      unsigned int fluid = 0;       ///< the number of the fluid that comes in
    };

    /**
     * Take the particles of the boundaries, of which @p cloud has a part on each rank, in the order of ranks, for the
     * homes; they touch the slip walls that they lie on. @param sources by boundary. Collective.
     * @throws InputError for a boundary that is not plane or without particles.
     */
    void start(const std::vector<Source> &sources, const Walls<dim> &walls, ParticleCloud<dim> &cloud,
               const MPI_Comm &communicator);

    /// Find the side of the fluid and the homes' shares of the first mesh. Collective. @throws InputError where no
    /// fluid touches a home, or something stands before it.
    void find_shares(const Walls<dim> &walls, const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                     const MPI_Comm &communicator);

    bool any() const
    {
      return !inlets.empty();
    }

    /// Find the velocities in the step from @p time by @p new_length (s), which the next functions are about. Collective.
    /// @throws RunError if a particle would move too far.
    void start_step(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh, const MPI_Comm &communicator,
                    const double time, const double new_length);

    /// Prescribe the mean velocities of those vertices that come in.
    void constrain(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                   std::vector<NodeConstraint<dim>> &constraints) const;

    /// Move the particles to where they are at the end of the step; they were at @p old_position.
    void carry(const std::vector<Point<dim>> &old_position, ParticleCloud<dim> &cloud) const;

    /// What comes in during the step, m^dim.
    double volume() const
    {
      return length * flux;
    }

    /// The same of one fluid.
    double volume(const unsigned int fluid) const;

    /// What has come in behind this rank's own particles, m^dim, by their numbers.
    std::map<std::uint64_t, double> layers(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh) const;

    /// The sum of these.
    double layer_volume(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh) const;

    /// The sum of those of one fluid.
    double layer_volume(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                        const unsigned int fluid) const;

    /// About the largest v/h in a step, 1/s.
    double fastest(const double time, const double step_length) const;

    /// Renew the particles that have come far enough. @return how many of all ranks. Collective.
    unsigned int renew(const Walls<dim> &walls, const MPI_Comm &communicator, ParticleCloud<dim> &cloud,
                       FluidMesh<dim> &mesh) const;

  private:
    struct Inlet
    {
      Source source;
      std::vector<Point<dim>> homes;
      PointSet<dim> places;              ///< of the homes
      std::vector<double> spacing, area; ///< h, m; A of the first mesh, m^(dim−1)
      std::vector<double> factor;        ///< φ of the homes
      Tensor<1, dim> direction;          ///< into the fluid
      double speed = 0.;                 ///< v/φ in the step, m/s
      double flux  = 0.;                 ///< in the step, m^dim/s

      /// The home of a particle.
      unsigned int home(const Point<dim> &position) const;
      double travel(const Point<dim> &position) const
      {
        return (position - homes[0]) * direction;
      }
    };

    /// A face of the mesh's boundary, as particles, without fluid but with a particle that comes in; @p inner is the other
    /// corner of its cell.
    struct Face
    {
      std::array<unsigned int, dim> corners;
      unsigned int inner;
    };

    bool comes_in(const unsigned int particle, const ParticleCloud<dim> &cloud) const
    {
      return cloud.kind[particle] == ParticleKind::wall && cloud.part[particle] < inlet_of.size() &&
             inlet_of[cloud.part[particle]] != numbers::invalid_unsigned_int;
    }

    const Inlet &inlet(const unsigned int particle, const ParticleCloud<dim> &cloud) const
    {
      return inlets[inlet_of[cloud.part[particle]]];
    }

    std::vector<Face> find_faces(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh) const;

    /// By particle the share of this rank's own particles in the boundary, A.
    std::vector<double> own_shares(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh) const;

    /// The law's mean in a step. @throws RunError
    static double mean(const Inlet &inlet, const double time, const double step_length);

    void check_space(const Walls<dim> &walls) const;

    /// Facets on which fluid lands and a particle lies.
    static std::array<int, dim> touched_facets(const Walls<dim> &walls, const Point<dim> &position,
                                               const double spacing);

    /// Put a particle that becomes fluid off the facets that it touches, on the side of an @p inner particle.
    static void put_beside_walls(const unsigned int particle, const unsigned int inner,
                                 const Walls<dim> &walls, ParticleCloud<dim> &cloud);

    std::vector<Inlet> inlets;
    std::vector<unsigned int> inlet_of; ///< by boundary
    double length = 0., flux = 0.;      ///< of the step: s, m^dim/s
  };
} // namespace Lahar

#endif
