// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/sliding_friction.h>

#include <lahar/particles/fluid_set.h>

#include <algorithm>
#include <map>

namespace Lahar
{
  namespace
  {
    constexpr double inertia_factor   = 20.;
    constexpr double viscosity_factor = 5.;

    /// In so many iterations of a step the normal stress follows the reaction.
    constexpr unsigned int n_following = 15;
  } // namespace



  template <int dim>
  void SlidingFriction<dim>::start_step(const std::vector<SlidingContact<dim>> &found, const Start &start,
                                        const Numbering &numbering, const MPI_Comm &communicator)
  {
    const auto &[mesh, cloud, materials, gravity, time_step] = start;
    n_iterations                                             = 0;
    contacts.clear();
    std::map<unsigned int, const SlidingContact<dim> *> largest; // by vertex
    for (const SlidingContact<dim> &contact : found)
      if (const auto [place, is_new] = largest.emplace(contact.vertex, &contact);
          !is_new && contact.area > place->second->area)
        place->second = &contact;
    for (const SlidingContact<dim> &contact : found)
    {
      const LocalNode node = numbering.node(RegionVertex(contact.vertex));
      if (!node.is_valid())
        continue;
      const unsigned int particle = mesh.particle(contact.vertex);
      const double h              = cloud.spacing[particle];
      SlidingState<dim> state;
      // Along the edge of two boundaries that resist the particle has the multiplier of the larger one.
      const bool is_main = largest.at(contact.vertex) == &contact;
      if (is_main)
        state.multiplier = cloud.friction[particle];
      if (cloud.reaction[particle].norm() > 0.)
        state.excess_stress = std::max(cloud.reaction[particle] * contact.normal / contact.area, 0.) +
                              cloud.pressure[particle];
      contacts.push_back({contact, node, state, is_main, numbers::invalid_unsigned_int});
      const bool is_fluid     = cloud.kind[particle] == ParticleKind::fluid;
      const FluidLaw &law     = materials.law(is_fluid ? first_fluid(cloud.part[particle]) : 0);
      SlidingContact<dim> &at = contacts.back().at;
      at.stiffness            = inertia_factor * law.density() * h / time_step +
                     viscosity_factor *
                       law.viscous_part(1. / time_step, std::max(-cloud.pressure[particle], 0.)).value / h;
      for (unsigned int fluid = 0; fluid < materials.n_fluids(); ++fluid)
        at.pore_pressure = std::max(at.pore_pressure,
                                    materials.law(fluid).pore_water().pressure(cloud.position[particle],
                                                                               gravity));
    }
    is_any = Utilities::MPI::max(contacts.empty() ? 0U : 1U, communicator) == 1U;
  }



  template <int dim>
  void SlidingFriction<dim>::assemble(const IndexVector<LocalNode, Tensor<1, dim>> &velocities,
                                      const IndexVector<LocalNode, double> &pressures,
                                      const SolidContact<dim> &solids, BlockSystem<dim> &system) const
  {
    for (const Contact &contact : contacts)
    {
      SlidingForce<dim> force = contact.at.force(velocities[contact.node], pressures[contact.node],
                                                 contact.state);
      if (contact.with_solid != numbers::invalid_unsigned_int)
      {
        system.add_contact(contact.with_solid, solids.weights(contact.with_solid), force.value,
                           force.by_velocity);
        force.value       = Tensor<1, dim>();
        force.by_velocity = Tensor<2, dim>();
      }
      system.add_at_node(contact.node, force.value, force.by_velocity, force.by_pressure);
    }
  }



  template <int dim>
  void SlidingFriction<dim>::join(const SolidContact<dim> &solids)
  {
    for (Contact &contact : contacts)
      contact.with_solid = solids.find(contact.at.vertex, contact.at.facet);
  }



  template <int dim>
  void SlidingFriction<dim>::move(const SolidContact<dim> &solids)
  {
    for (Contact &contact : contacts)
      if (contact.with_solid != numbers::invalid_unsigned_int)
      {
        const Tensor<1, dim> &normal = solids.normal(contact.with_solid);
        contact.at.normal            = normal * contact.at.normal < 0. ? -normal : normal;
        contact.at.wall_velocity     = solids.surface_velocity(contact.with_solid);
      }
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  SlidingFriction<dim>::forces_on_solids(const IndexVector<LocalNode, Tensor<1, dim>> &velocities,
                                         const IndexVector<LocalNode, double> &pressures,
                                         const SolidContact<dim> &solids) const
  {
    std::vector<Tensor<1, dim>> result(solids.n_contacts());
    for (const Contact &contact : contacts)
      if (contact.with_solid != numbers::invalid_unsigned_int)
        result[contact.with_solid] +=
          contact.at.force(velocities[contact.node], pressures[contact.node], contact.state).value;
    return result;
  }



  template <int dim>
  void SlidingFriction<dim>::iterate(const IndexVector<LocalNode, Tensor<1, dim>> &velocities,
                                     const IndexVector<LocalNode, double> &pressures,
                                     const IndexVector<LocalNode, Tensor<1, dim>> &reactions)
  {
    const bool follows = n_iterations++ < n_following;
    for (Contact &contact : contacts)
      contact.at.iterate(velocities[contact.node], pressures[contact.node], reactions[contact.node], follows,
                         contact.state);
  }



  template <int dim>
  bool SlidingFriction<dim>::is_settled() const
  {
    return std::none_of(contacts.begin(), contacts.end(),
                        [](const Contact &contact) { return contact.state.held; });
  }



  template <int dim>
  void SlidingFriction<dim>::accept(const IndexVector<LocalNode, Tensor<1, dim>> &velocities,
                                    const IndexVector<LocalNode, double> &pressures,
                                    const FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud) const
  {
    for (Tensor<1, dim> &multiplier : cloud.friction)
      multiplier = Tensor<1, dim>();
    for (const Contact &contact : contacts)
      if (contact.is_main)
        cloud.friction[mesh.particle(contact.at.vertex)] =
          contact.at.force(velocities[contact.node], pressures[contact.node], contact.state).multiplier;
  }



  template class SlidingFriction<2>;
  template class SlidingFriction<3>;
} // namespace Lahar
