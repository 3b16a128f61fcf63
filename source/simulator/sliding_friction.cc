// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/sliding_friction.h>

namespace Lahar
{
  namespace
  {
    constexpr double inertia_factor   = 100.;
    constexpr double viscosity_factor = 30.;
  } // namespace



  template <int dim>
  void SlidingFriction<dim>::start_step(const std::vector<SlidingContact<dim>> &found,
                                        const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                        const FluidLaw &law, const double time_step,
                                        const NodePartition &partition)
  {
    contacts.clear();
    for (const SlidingContact<dim> &contact : found)
    {
      const unsigned int node = partition.local(contact.vertex);
      if (node == numbers::invalid_unsigned_int)
        continue;
      const unsigned int particle = mesh.particle(contact.vertex);
      const double h              = cloud.spacing[particle];
      contacts.push_back({contact, node, cloud.friction[particle]});
      contacts.back().at.stiffness = inertia_factor * law.density() * h / time_step +
                                     viscosity_factor * law.viscous_part(1. / time_step).value / h;
    }
  }



  template <int dim>
  void SlidingFriction<dim>::assemble(const std::vector<Tensor<1, dim>> &velocities,
                                      const std::vector<double> &pressures, BlockSystem<dim> &system) const
  {
    for (const Contact &contact : contacts)
    {
      const SlidingForce<dim> force = contact.at.force(velocities[contact.node], pressures[contact.node],
                                                       contact.multiplier);
      system.add_at_node(contact.node, force.value, force.by_velocity, force.by_pressure);
    }
  }



  template <int dim>
  void SlidingFriction<dim>::update(const std::vector<Tensor<1, dim>> &velocities,
                                    const std::vector<double> &pressures)
  {
    for (Contact &contact : contacts)
      contact.multiplier =
        contact.at.force(velocities[contact.node], pressures[contact.node], contact.multiplier).multiplier;
  }



  template <int dim>
  void SlidingFriction<dim>::accept(const FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud) const
  {
    for (Tensor<1, dim> &multiplier : cloud.friction)
      multiplier = Tensor<1, dim>();
    for (const Contact &contact : contacts)
      cloud.friction[mesh.particle(contact.at.vertex)] = contact.multiplier;
  }



  template class SlidingFriction<2>;
  template class SlidingFriction<3>;
} // namespace Lahar
