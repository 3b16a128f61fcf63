// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/step_state.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Lahar
{
  template <int dim>
  void StepState<dim>::start_step(const unsigned int n_nodes, const unsigned int n_vertices,
                                  const Floors &new_floors)
  {
    floors = new_floors;
    delta_w.assign(n_nodes, Tensor<1, dim>());
    delta_p.assign(n_vertices, 0.);
  }



  template <int dim>
  void StepState<dim>::start_iteration(IndexVector<LocalNode, Tensor<1, dim>> velocities,
                                       const FluidState<dim> &fluid, std::vector<double> new_volumes,
                                       IndexVector<LocalNode, Tensor<1, dim>> velocity_change,
                                       IndexVector<Vertex, double> pressure_change)
  {
    AssertDimension(velocities.size(), velocity_change.size());
    AssertDimension(fluid.pressure.size(), pressure_change.size());
    base_w  = std::move(velocities);
    base_p  = IndexVector<Vertex, double>(fluid.pressure);
    volumes = std::move(new_volumes);
    delta_w = std::move(velocity_change);
    delta_p = std::move(pressure_change);
  }



  template <int dim>
  void StepState<dim>::start_dual(std::vector<SymmetricTensor<2, dim>> base,
                                  std::vector<SymmetricTensor<2, dim>> change)
  {
    base_dual  = std::move(base);
    delta_dual = std::move(change);
  }



  template <int dim>
  void StepState<dim>::drop_dual()
  {
    for (auto *old : {&base_dual, &delta_dual})
      std::vector<SymmetricTensor<2, dim>>().swap(*old);
  }



  template <int dim>
  IndexVector<LocalNode, Tensor<1, dim>>
  StepState<dim>::velocities(const IndexVector<LocalNode, double> &lengths) const
  {
    AssertDimension(lengths.size(), base_w.size());
    IndexVector<LocalNode, Tensor<1, dim>> result(lengths.size());
    for (const LocalNode node : lengths.indices())
      result[node] = base_w[node] + lengths[node] * delta_w[node];
    return result;
  }



  template <int dim>
  void StepState<dim>::advance(const double length, FluidState<dim> &fluid) const
  {
    for (const Vertex v : base_p.indices())
      fluid.pressure[v.value()] = base_p[v] + length * delta_p[v];
    for (unsigned int c = 0; c < base_dual.size(); ++c)
      fluid.plastic_dual[c] = base_dual[c] + length * delta_dual[c];
  }



  template <int dim>
  void StepState<dim>::set_norms(const IndexVector<LocalNode, Tensor<1, dim>> &velocities,
                                 const FluidState<dim> &fluid, const Numbering &numbering,
                                 const MPI_Comm &communicator)
  {
    double sums[6] = {}; // of w², δw², p², δp², and of the fluid v² and the vertices
    for (const LocalNode node : numbering.own_nodes())
    {
      sums[0] += velocities[node].norm_square();
      sums[1] += delta_w[node].norm_square();
    }
    for (const Vertex v : numbering.own_vertices())
    {
      sums[2] += fluid.pressure[v.value()] * fluid.pressure[v.value()];
      sums[3] += delta_p[v] * delta_p[v];
      sums[4] += fluid.velocity[v.value()].norm_square();
    }
    sums[5] = numbering.n_own_vertices();
    Utilities::MPI::sum(ArrayView<const double>(sums, 6), communicator, ArrayView<double>(sums, 6));
    const auto [w, dw, p, dp, v_end, n_vertices] = sums;

    norm_of_w  = std::max(std::sqrt(w), floors.velocity);
    norm_of_p  = std::max({std::sqrt(p), floors.pressure_by_velocity * norm_of_w, 1e-300});
    relative_w = std::sqrt(dw) / norm_of_w;
    relative_p = std::sqrt(dp) / norm_of_p;
    speed      = std::sqrt(v_end / std::max(1., n_vertices));
  }



  template <int dim>
  double StepState<dim>::increment_at(const LocalNode node, const double pressure_change) const
  {
    return delta_w[node].norm() / norm_of_w + std::abs(pressure_change) / norm_of_p;
  }



  template class StepState<2>;
  template class StepState<3>;
} // namespace Lahar
