// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/spread_largest.h>
#include <lahar/simulator/step_problem.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// Fluid stands also below this part of what gravity makes in a step: forces of this size come from the projection that
    /// follows the pressure, and would go on for ever.
    constexpr double standing_acceleration = 1e-4;
  } // namespace



  template <int dim>
  void StepProblem<dim>::start_multipliers(const std::vector<SymmetricTensor<2, dim>> &multipliers)
  {
    // Without pressure, as in the first step, nothing stands.
    FluidState<dim> &state = fluid.state;
    state.multiplier.assign(mesh->n_cells(), SymmetricTensor<2, dim>());
    state.standing_projection.assign(mesh->n_cells(), Tensor<1, dim>());
    state.stands.assign(mesh->n_cells(), false);
    if (!multipliers.empty())
      for (unsigned int c = 0; c < mesh->n_cells(); ++c)
        state.multiplier[c] = multipliers[system.cells()[c]];
    if (integration.is_first_step())
      return;

    const auto is_exact = [&](const unsigned int c) {
      return materials.law(mesh->fluid(c)).has_exact_yield_stress();
    };
    boost::disjoint_sets_with_storage<> parts(numbering.n_nodes());
    for (unsigned int c = 0; c < mesh->n_cells(); ++c)
      if (const Simplex<dim> &cell = system.cells_by_local_number()[c]; is_exact(c))
        for (const unsigned int node : cell)
          parts.union_set(cell[0], node);
    IndexVector<LocalNode, double> speed(numbering.n_nodes(), 0.);
    for (const Vertex v : numbering.vertices())
      speed[numbering.node(v)] = std::max(state.old_velocity[v.value()].norm(),
                                          state.mean_velocity[v.value()].norm());
    spread_largest(parts, system.partition(), speed);
    const double slowest = standing_velocity + standing_acceleration * state.gravity.norm() * state.time_step;
    std::vector<bool> stands(mesh->n_vertices(), true); // all of its cells do
    for (unsigned int c = 0; c < mesh->n_cells(); ++c)
    {
      state.stands[c] = is_exact(c) && speed[LocalNode(system.cells_by_local_number()[c][0])] < slowest;
      if (!state.stands[c])
        for (const unsigned int v : mesh->cells()[c])
          stands[v] = false;
    }
    // What stands is expected to stand: velocities that are errors are not carried on.
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
      if (stands[v])
        state.mean_velocity[v] = state.velocity[v] = Tensor<1, dim>();
  }



  template <int dim>
  std::vector<bool> StepProblem<dim>::counted_cells() const
  {
    std::vector<bool> counted;
    for (const Simplex<dim> &cell : system.cells_by_local_number())
    {
      LocalNode first(cell[0]);
      for (const unsigned int corner : cell)
        if (const LocalNode node(corner); numbering.global_node(node) < numbering.global_node(first))
          first = node;
      counted.push_back(numbering.is_own(first));
    }
    return counted;
  }



  template <int dim>
  double StepProblem<dim>::update_multipliers()
  {
    TimerOutput::Scope scope(timer, "Assemble");
    old_multipliers = fluid.state.multiplier;
    // Without what is held since the system was solved.
    const IndexVector<LocalNode, Tensor<1, dim>> increment(system.velocities(solution));
    const double own = assembler.update_multipliers(*mesh, materials, fluid.state,
                                                    numbering.by_vertex(increment).raw(), counted_cells());
    return Utilities::MPI::sum(own, communicator());
  }



  template <int dim>
  void StepProblem<dim>::take_multipliers_back()
  {
    fluid.state.multiplier.swap(old_multipliers);
  }



  template <int dim>
  void StepProblem<dim>::get_multipliers(std::vector<SymmetricTensor<2, dim>> &multipliers) const
  {
    multipliers.resize(region_mesh->n_cells());
    for (unsigned int c = 0; c < mesh->n_cells(); ++c)
      multipliers[system.cells()[c]] = fluid.state.multiplier[c];
  }



  template <int dim>
  typename FluidAssembler<dim>::YieldGap StepProblem<dim>::yield_gap() const
  {
    const std::vector<bool> counted   = counted_cells();
    auto own                          = assembler.yield_gap(*mesh, materials, fluid.state, counted);
    const std::vector<double> volumes = fluid.new_volumes();
    const double rate = integration.acceleration_factor(false) / integration.velocity_factor(false);
    for (unsigned int c = 0; c < mesh->n_cells(); ++c)
      if (counted[c] && !fluid.state.left_out[c] && materials.counts_in_gap(mesh->fluid(c)))
        own.energy += materials.law(mesh->fluid(c)).density() * volumes[c] * rate * standing_velocity *
                      standing_velocity;
    const double sums[2] = {own.gap, own.energy};
    double all[2];
    Utilities::MPI::sum(ArrayView<const double>(sums, 2), communicator(), ArrayView<double>(all, 2));
    return {all[0], all[1]};
  }



  template void StepProblem<2>::start_multipliers(const std::vector<SymmetricTensor<2, 2>> &);
  template void StepProblem<3>::start_multipliers(const std::vector<SymmetricTensor<2, 3>> &);
  template std::vector<bool> StepProblem<2>::counted_cells() const;
  template std::vector<bool> StepProblem<3>::counted_cells() const;
  template double StepProblem<2>::update_multipliers();
  template double StepProblem<3>::update_multipliers();
  template void StepProblem<2>::take_multipliers_back();
  template void StepProblem<3>::take_multipliers_back();
  template void StepProblem<2>::get_multipliers(std::vector<SymmetricTensor<2, 2>> &) const;
  template void StepProblem<3>::get_multipliers(std::vector<SymmetricTensor<2, 3>> &) const;
  template FluidAssembler<2>::YieldGap StepProblem<2>::yield_gap() const;
  template FluidAssembler<3>::YieldGap StepProblem<3>::yield_gap() const;
} // namespace Lahar
