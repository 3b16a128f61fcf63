// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/safeguards.h>
#include <lahar/simulator/undetermined_pressures.h>
#include <lahar/utilities/true_on_all_ranks.h>

#include <algorithm>
#include <utility>

namespace Lahar
{
  namespace
  {
    /// Increments that would invert simplices even at this part of their length are not taken.
    constexpr double shortest_increment = 1e-3;

    /// By this part of the expected velocity vertices of flattened simplices become slower at a time.
    constexpr double slowing = 0.25;
  } // namespace



  template <int dim>
  void Safeguards<dim>::start_step(Start start)
  {
    mesh            = &start.mesh;
    system          = &start.system;
    numbering       = &start.numbering;
    is_solid        = std::move(start.is_solid);
    start_positions = std::move(start.positions);
    find_compressible_nodes(start.materials);
    held_vertices.start_step(start.can_be_held);
    crushed_cells.start_step(mesh->n_cells());
  }



  template <int dim>
  void Safeguards<dim>::find_compressible_nodes(const Materials &materials)
  {
    any_incompressible = materials.any_incompressible();
    is_compressible.assign(is_solid.size(), false);
    for (unsigned int c = 0; c < mesh->n_cells(); ++c)
      if (materials.law(mesh->fluid(c)).compressibility() > 0.)
        for (const unsigned int v : mesh->cells()[c])
          is_compressible[numbering->node(Vertex(v))] = true;
  }



  template <int dim>
  void Safeguards<dim>::fix_pressures(IndexVector<LocalNode, NodeConstraint<dim>> &constraints)
  {
    fix_undetermined_pressures(system->cells_by_local_number(), system->partition(), constraints);
    if (any_incompressible)
      closed_parts.fix_levels(system->cells_by_local_number(), start_positions, system->partition(),
                              is_compressible, constraints);
  }



  template <int dim>
  void Safeguards<dim>::slow_down(const IndexVector<LocalNode, NodeConstraint<dim>> &constraints,
                                  FluidStep<dim> &fluid,
                                  IndexVector<LocalNode, Tensor<1, dim>> &velocities) const
  {
    const NodePartition &partition                        = system->partition();
    const IndexVector<LocalNode, Tensor<1, dim>> expected = velocities;
    const std::vector<double> old_volumes                 = fluid.old_volumes();
    IndexVector<LocalNode, double> motion(constraints.size(), 1.), is_pushed(constraints.size(), 0.);
    IndexVector<LocalNode, Tensor<1, dim>> least(constraints.size());
    for (const LocalNode node : constraints.indices())
      least[node] = constraints[node].velocity;
    fluid.move(numbering->by_vertex(velocities));
    for (bool any = true; any;)
    {
      any = false;
      IndexVector<LocalNode, Tensor<1, dim>> push(constraints.size());
      IndexVector<LocalNode, unsigned int> n_pushes(constraints.size(), 0);
      IndexVector<LocalNode, bool> is_slower(constraints.size(), false);
      for (const unsigned int c : fluid.shrinking_cells(old_volumes))
      {
        Tensor<1, dim> mean;
        unsigned int n = 0;
        for (const unsigned int v : mesh->cells()[c])
          if (const LocalNode node = numbering->node(Vertex(v));
              is_pushed[node] > 0. ||
              (constraints[node].n_fixed == dim && (constraints[node].moves || is_solid[node])))
          {
            // What is pushed has not come down to its velocity yet.
            const Tensor<1, dim> &velocity = is_pushed[node] > 0. ? least[node] : velocities[node];
            mean += velocity;
            n += velocity.norm() > 0. ? 1 : 0; // at the rim of an inflow they are at rest
          }
        for (const unsigned int v : mesh->cells()[c])
          if (const LocalNode node = numbering->node(Vertex(v)); constraints[node].n_fixed < dim)
          {
            is_slower[node] = motion[node] > 0.;
            if (n > 0 && !(is_pushed[node] > 0.))
            {
              push[node] += mean / n;
              ++n_pushes[node];
            }
          }
      }
      for (const LocalNode node : constraints.indices())
      {
        const NodeConstraint<dim> &prescribed = constraints[node];
        if (is_slower[node])
          motion[node] = std::max(0., motion[node] - slowing);
        if (n_pushes[node] > 0)
        {
          is_pushed[node] = 1.;
          for (unsigned int a = prescribed.n_fixed; a < dim; ++a)
            least[node] += (push[node] / n_pushes[node] * prescribed.frame[a]) * prescribed.frame[a];
        }
        any = any || is_slower[node] || n_pushes[node] > 0;
      }
      any = !true_on_all_ranks(!any, partition.communicator());
      if (!any)
        break;
      partition.update(motion);
      partition.update(is_pushed);
      partition.update(least);
      for (const LocalNode node : constraints.indices())
        if (motion[node] < 1.)
          velocities[node] = least[node] + motion[node] * (expected[node] - least[node]);
      fluid.move(numbering->by_vertex(velocities));
    }
  }



  template <int dim>
  IndexVector<LocalNode, Tensor<1, dim>>
  Safeguards<dim>::advance(const StepState<dim> &state, const double length,
                           const IndexVector<LocalNode, NodeConstraint<dim>> &constraints,
                           FluidStep<dim> &fluid)
  {
    IndexVector<LocalNode, double> lengths(constraints.size(), length);
    IndexVector<LocalNode, Tensor<1, dim>> velocities;
    damped = false;
    for (bool any_shorter = true; any_shorter;)
    {
      velocities = state.velocities(lengths);
      fluid.move(numbering->by_vertex(velocities));
      if (length == 1. && !damped)
        crushed_cells.note(crushable_cells(fluid, state.base_volumes(), constraints));
      any_shorter = false;
      for (const Vertex v : fluid.shrinking_vertices(state.base_volumes()))
        if (double &own_length = lengths[numbering->node(v)]; own_length > 0.)
        {
          any_shorter = true;
          own_length  = (own_length > shortest_increment * length ? 0.5 * own_length : 0.);
        }
      any_shorter = !true_on_all_ranks(!any_shorter, system->partition().communicator());
      if (any_shorter)
        system->partition().update(lengths);
      damped = damped || any_shorter;
    }
    if (length == 1.)
      held_vertices.note(lengths);
    return velocities;
  }



  template <int dim>
  std::vector<unsigned int>
  Safeguards<dim>::crushable_cells(const FluidStep<dim> &fluid, const std::vector<double> &volumes,
                                   const IndexVector<LocalNode, NodeConstraint<dim>> &constraints) const
  {
    std::vector<unsigned int> result = fluid.shrinking_cells(volumes);
    const auto gives_way             = [&](const unsigned int c) {
      return std::any_of(mesh->cells()[c].begin(), mesh->cells()[c].end(), [&](const unsigned int v) {
        const LocalNode node = numbering->node(Vertex(v));
        return constraints[node].n_fixed < dim && !is_solid[node];
      });
    };
    result.erase(std::remove_if(result.begin(), result.end(), gives_way), result.end());
    return result;
  }



  template <int dim>
  bool Safeguards<dim>::end_iteration(FluidStep<dim> &fluid,
                                      IndexVector<LocalNode, NodeConstraint<dim>> &constraints)
  {
    crushed_cells.update(fluid.state.left_out);
    if (!held_vertices.update(system->partition(), constraints))
      return false;
    fix_pressures(constraints);
    return true;
  }



  template <int dim>
  void Safeguards<dim>::check_closed_parts(const FluidStep<dim> &fluid) const
  {
    closed_parts.check(system->cells_by_local_number(), start_positions, fluid.old_volumes(),
                       fluid.new_volumes(), system->partition());
  }



  template class Safeguards<2>;
  template class Safeguards<3>;
} // namespace Lahar
