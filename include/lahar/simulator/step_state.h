// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_step_state_h
#define lahar_simulator_step_state_h

#include <deal.II/base/mpi.h>

#include <lahar/assembly/fluid_state.h>
#include <lahar/linear/numbering.h>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * What an iteration of a step starts from and changes, and how large that is. By node, by the fluid's vertex and by its
   * cell,
   *
   *   w = w_0 + λ_I δw,   p = p_0 + λ δp,   Λ = Λ_0 + λ δΛ,
   *
   * λ the length that the iteration takes of its increments and λ_I what Safeguards leave of it at a node. Lengths count
   * from the start of the iteration, so that another one may follow the first.
   *
   * Increments are compared with ‖w‖ and ‖p‖, or with what counts as nothing if that is more.
   */
  template <int dim>
  class StepState
  {
  public:
    /// What counts as nothing.
    struct Floors
    {
      double velocity; ///< of ‖w‖, m/s
      /// The pressures that make a velocity in a step, over that, Pa s/m.
      double pressure_by_velocity;
    };

    /// Begin a step, in which there are no increments yet.
    void start_step(const unsigned int n_nodes, const unsigned int n_vertices, const Floors &floors);

    /// Begin an iteration from @p velocities of the nodes, the pressures of @p fluid and its cells' volumes, and with
    /// increments of velocities and pressures.
    void start_iteration(IndexVector<LocalNode, Tensor<1, dim>> velocities, const FluidState<dim> &fluid,
                         std::vector<double> volumes, IndexVector<LocalNode, Tensor<1, dim>> velocity_change,
                         IndexVector<Vertex, double> pressure_change);

    /// The same of the dual variable Λ, where fluid yields.
    void start_dual(std::vector<SymmetricTensor<2, dim>> base, std::vector<SymmetricTensor<2, dim>> change);

    /// Give the memory of Λ back: the linear solver needs it.
    void drop_dual();

    /// δw, by node, m/s.
    const IndexVector<LocalNode, Tensor<1, dim>> &velocity_change() const
    {
      return delta_w;
    }

    /// The cells' volumes at the start of the iteration.
    const std::vector<double> &base_volumes() const
    {
      return volumes;
    }

    /// w at @p lengths λ_I, by node.
    IndexVector<LocalNode, Tensor<1, dim>> velocities(const IndexVector<LocalNode, double> &lengths) const;

    /// Set pressures and Λ at the length λ; the velocities follow velocities().
    void advance(const double length, FluidState<dim> &fluid) const;

    /// Compute the norms of the present state. Collective.
    void set_norms(const IndexVector<LocalNode, Tensor<1, dim>> &velocities, const FluidState<dim> &fluid,
                   const Numbering &numbering, const MPI_Comm &communicator);

    /// ‖w‖ and ‖p‖ or the floor, m/s and Pa.
    double velocity_norm() const
    {
      return norm_of_w;
    }

    double pressure_norm() const
    {
      return norm_of_p;
    }

    /// ‖δw‖/‖w‖ and ‖δp‖/‖p‖, whatever the length is.
    double velocity_increment() const
    {
      return relative_w;
    }

    double pressure_increment() const
    {
      return relative_p;
    }

    /// |δw|/‖w‖ + |δp|/‖p‖ of a node, whose increment of pressure is @p pressure_change.
    double increment_at(const LocalNode node, const double pressure_change) const;

    /// δp, by vertex, Pa.
    const IndexVector<Vertex, double> &pressure_change() const
    {
      return delta_p;
    }

    /// Of the fluid at the end of the step, root of the mean square over the vertices, m/s.
    double mean_speed() const
    {
      return speed;
    }

  private:
    Floors floors = {0., 0.};
    IndexVector<LocalNode, Tensor<1, dim>> base_w, delta_w;
    IndexVector<Vertex, double> base_p, delta_p;
    std::vector<double> volumes;
    std::vector<SymmetricTensor<2, dim>> base_dual, delta_dual;
    double norm_of_w = 0., norm_of_p = 0., relative_w = 0., relative_p = 0., speed = 0.;
  };
} // namespace Lahar

#endif
