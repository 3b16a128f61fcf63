// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_assembly_stokes_h
#define lahar_tests_assembly_stokes_h

#include <lahar/assembly/fluid_assembler.h>
#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/polygon.h>
#include <lahar/linear/direct_solver.h>

#include "tests.h"

namespace Tests
{
  /// Triangles of the size @p h that fill a polygon. All points on its contour count as walls, so that no face is a free
  /// surface.
  inline void mesh_polygon(const Polygon &polygon, const double h, ParticleCloud<2> &cloud,
                           FluidMesh<2> &mesh)
  {
    for (const Point<2> &p : fill_polygon(polygon, h))
      cloud.append(p, distance_to_contour(polygon, p) < 1e-10 ? ParticleKind::wall : ParticleKind::fluid, h);
    std::vector<Simplex<2>> cells;
    for (const Simplex<2> &simplex : delaunay(cloud.position))
      if (is_inside(polygon, centroid<2>(corners_of<2>(simplex, cloud.position))) &&
          signed_volume<2>(corners_of<2>(simplex, cloud.position)) > 1e-8)
        cells.push_back(simplex);
    mesh.reinit(cloud, cells);
  }



  /**
   * Creeping flow without inertia on a mesh that moves so little in a step that its geometry stays, but for the cells'
   * volumes in the mass equation. The length given as time step enters the stabilisation parameter. On several ranks each
   * has a part of the mesh.
   */
  template <int dim>
  class Stokes
  {
  public:
    Stokes(const FluidMesh<dim> &whole, const ParticleCloud<dim> &cloud, const FluidLaw &law,
           const Tensor<1, dim> &gravity, const double time_step, const std::string &parameters)
      : law(law)
      , system(MPI_COMM_WORLD)
    {
      parse(assembler, parameters);
      parse(solver, "set Tolerance = 0\n");

      IndexVector<RegionNode, Point<dim>> positions;
      for (const unsigned int particle : whole.particles())
        positions.push_back(cloud.position[particle]);
      system.reinit(whole.n_vertices(), whole.cells(), {}, positions);
      std::vector<unsigned int> known;
      for (const RegionNode node : system.partition().nodes())
        known.push_back(node.value());
      mesh.reinit_part(whole, known, system.cells());
      const unsigned int n = mesh.n_vertices();
      for (unsigned int v = 0; v < n; ++v)
        state.position.push_back(cloud.position[mesh.particle(v)]);
      state.old_position = places = state.position;
      state.velocity = state.mean_velocity = state.acceleration = state.old_velocity =
        state.old_acceleration                                  = std::vector<Tensor<1, dim>>(n);
      state.pressure = state.old_pressure = state.old_pressure_rate = std::vector<double>(n, 0.);
      stabilization_step                                            = time_step;
      state.gravity                                                 = gravity;
      state.velocity_factor                                         = std::vector<double>(n, 1.);
      state.acceleration_factor                                     = std::vector<double>(n, 0.);
      constraints.resize(n);
      set_stabilization();
    }

    void set_stabilization()
    {
      state.time_step    = stabilization_step;
      state.old_position = state.position = places;
      assembler.set_stabilization(mesh, law, state);
      IndexVector<LocalNode, Tensor<1, dim>> projection(state.residual_projection);
      system.partition().update(projection);
      state.residual_projection = projection.raw();
    }

    /// Tell the system of the constraints.
    void prescribe()
    {
      system.set_constraints(IndexVector<LocalNode, NodeConstraint<dim>>(constraints));
    }

    /// Iterate (Picard or Newton) from the present state until the velocities change by less than @p tolerance. @return
    /// iterations.
    unsigned int solve(const ViscosityLinearization viscosity, const double tolerance,
                       const unsigned int max_iterations)
    {
      prescribe();
      auto solution = system.make_vector();
      for (unsigned int iteration = 1;; ++iteration)
      {
        assemble(viscosity);
        solver.solve(system, {}, solution);
        const auto velocity_increments = system.velocities(solution).raw();
        const auto pressure_increments = system.pressures(solution).raw();
        double largest                 = 0.;
        for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
        {
          largest = std::max(largest, velocity_increments[v].norm());
          state.velocity[v] += velocity_increments[v];
          state.pressure[v] += pressure_increments[v];
        }
        if (Utilities::MPI::max(largest, MPI_COMM_WORLD) < tolerance || iteration == max_iterations)
          return iteration;
      }
    }

    void assemble(const ViscosityLinearization viscosity, const double plastic_weight = 1.)
    {
      typename FluidAssembler<dim>::Linearization linearization;
      linearization.viscosity      = viscosity;
      linearization.plastic_weight = plastic_weight;
      linearization.motion         = false;
      // The nodes pass their places in the middle of the step: the volumes change by its length times the divergence
      // there, up to its third power, and nothing else sees so small a motion.
      state.time_step = motion_step;
      for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      {
        state.position[v]     = places[v] + 0.5 * state.time_step * state.velocity[v];
        state.old_position[v] = places[v] - 0.5 * state.time_step * state.velocity[v];
      }
      assembler.assemble(mesh, law, state, linearization, system);
      for (unsigned int v = 0; v < forces.size(); ++v)
        system.add_at_node(LocalNode(v), -forces[v], {}, {});
      state.position = state.old_position = places;
    }

    /// Time (s) in which the nodes pass their places. Places are rounded: velocities come out to the rounding over it.
    static constexpr double motion_step = 1e-6;

    FluidMesh<dim> mesh; ///< what this rank knows
    std::vector<Point<dim>> places;
    double stabilization_step = 0.;
    const FluidLaw &law;
    FluidAssembler<dim> assembler;
    BlockSystem<dim> system;
    DirectSolver<dim> solver;
    FluidState<dim> state;
    std::vector<NodeConstraint<dim>> constraints;
    std::vector<Tensor<1, dim>> forces; ///< on the nodes from outside, if there are any
  };
} // namespace Tests

#endif
