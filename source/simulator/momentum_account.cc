// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/simulator/momentum_account.h>

namespace Lahar
{
  namespace
  {
    /// v + @p time a by particle.
    template <int dim>
    std::vector<Tensor<1, dim>> velocities_at(const double time, const ParticleCloud<dim> &cloud)
    {
      std::vector<Tensor<1, dim>> u = cloud.velocity;
      for (unsigned int i = 0; i < u.size(); ++i)
        u[i] += time * cloud.algorithmic_acceleration[i];
      return u;
    }
  } // namespace



  template <int dim>
  std::vector<Tensor<1, dim>> MomentumAccount<dim>::velocities(const ParticleCloud<dim> &cloud) const
  {
    return velocities_at(half_step, cloud);
  }



  template <int dim>
  typename MomentumAccount<dim>::Momenta
  MomentumAccount<dim>::compute(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                const Materials &materials, const MPI_Comm &communicator) const
  {
    Tensor<1, dim> forces;
    for (const unsigned int i : mesh.particles())
      if (cloud.is_own(i) && (cloud.kind[i] != ParticleKind::fluid || cloud.in_contact(i)))
        forces += cloud.reaction[i];
    const double lag = carried_time + half_step;
    return {integrate(velocities_at(-carried_time, cloud), mesh, cloud, materials, communicator),
            integrate(velocities(cloud), mesh, cloud, materials, communicator) -
              lag * Utilities::MPI::sum(forces, communicator)};
  }



  template <int dim>
  Tensor<1, dim> MomentumAccount<dim>::integrate(const std::vector<Tensor<1, dim>> &u,
                                                 const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                                 const Materials &materials, const MPI_Comm &communicator)
  {
    Tensor<1, dim> momentum;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      if (const Simplex<dim> &cell = mesh.particle_cells()[c]; cloud.is_own(cell))
      {
        const double density = materials.law(mesh.fluid(c)).density();
        const auto corners   = corners_of<dim>(cell, cloud.position);
        if (Symmetry::applies<dim>())
        {
          const auto shares = body_volume_shares<dim>(corners);
          for (unsigned int I = 0; I <= dim; ++I)
            momentum += density * shares[I] * u[cell[I]];
          continue;
        }
        Tensor<1, dim> sum;
        for (const unsigned int i : cell)
          sum += u[i];
        momentum += density * signed_volume<dim>(corners) / (dim + 1) * sum;
      }
    return Utilities::MPI::sum(momentum, communicator);
  }



  template <int dim>
  void MomentumAccount<dim>::add_columns(TableHandler &statistics) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      add_to_column(statistics, std::string("Momentum ") + "xyz"[d] + " (N s)", momentum[d]);
    for (unsigned int d = 0; d < dim; ++d)
      add_to_column(statistics, std::string("Momentum change by solver ") + "xyz"[d] + " (N s)",
                    change_by_solver[d]);
    for (unsigned int d = 0; d < dim; ++d)
      add_to_column(statistics, std::string("Momentum change by remeshing ") + "xyz"[d] + " (N s)",
                    change_by_remeshing[d]);
    for (unsigned int d = 0; d < dim; ++d)
      add_to_column(statistics, std::string("Momentum change by lag ") + "xyz"[d] + " (N s)",
                    momentum[d] - end[d] + change_by_times[d]);
  }



  template <int dim>
  void MomentumAccount<dim>::add_inflow_columns(TableHandler &statistics) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      add_to_column(statistics, std::string("Momentum inflow ") + "xyz"[d] + " (N s)", inflow[d]);
  }



  template <int dim>
  void MomentumAccount<dim>::add_outflow_columns(TableHandler &statistics) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      add_to_column(statistics, std::string("Momentum outflow ") + "xyz"[d] + " (N s)", outflow[d]);
  }



  template class MomentumAccount<2>;
  template class MomentumAccount<3>;
} // namespace Lahar
