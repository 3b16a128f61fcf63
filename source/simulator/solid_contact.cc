// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/facet_geometry.h>
#include <lahar/particles/fluid_set.h>
#include <lahar/simulator/solid_contact.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// β over what a layer of fluid of one mesh size resists.
    constexpr double stiffness_factor = 1000.;
  } // namespace



  template <int dim>
  void SolidContact<dim>::start_step(const std::vector<SolidTouch<dim>> &touches, const FluidMesh<dim> &mesh,
                                     const ParticleCloud<dim> &cloud, const Materials &materials,
                                     const double new_time_step)
  {
    time_step = new_time_step;
    all.clear();
    for (const SolidTouch<dim> &touch : touches)
    {
      const unsigned int i = mesh.particle(touch.vertex);
      const FluidLaw &law  = materials.law(first_fluid(cloud.part[i]));
      const double h       = cloud.spacing[i],
                   mu      = law.viscous_part(1. / time_step, std::max(-cloud.pressure[i], 0.)).value;
      Contact contact;
      contact.touch      = touch;
      contact.multiplier = -touch.force;
      contact.stiffness  = stiffness_factor * touch.area * (law.density() * h / time_step + mu / h);
      all.push_back(contact);
    }
  }



  template <int dim>
  std::vector<unsigned int> SolidContact<dim>::cells(const IndexVector<SolidNode, RegionNode> &nodes) const
  {
    std::vector<unsigned int> result;
    for (const Contact &contact : all)
    {
      result.push_back(contact.touch.vertex);
      for (const unsigned int corner : contact.touch.corners)
        result.push_back(nodes[SolidNode(corner)].value());
    }
    return result;
  }



  template <int dim>
  void SolidContact<dim>::number(const BlockSystem<dim> &system, const Numbering &numbering)
  {
    known.clear();
    for (const unsigned int k : system.contacts())
    {
      known.push_back(all[k]);
      known.back().vertex = system.fluid_number(numbering.node(RegionVertex(all[k].touch.vertex)));
    }
    is_any = Utilities::MPI::max(known.empty() ? 0U : 1U, system.partition().communicator()) == 1U;
  }



  template <int dim>
  void SolidContact<dim>::close_gaps(const Numbering &numbering,
                                     const IndexVector<LocalNode, NodeConstraint<dim>> &constraints,
                                     IndexVector<LocalNode, Tensor<1, dim>> &velocities) const
  {
    for (const Contact &contact : known)
      if (const LocalNode node = numbering.node(contact.vertex); constraints[node].n_fixed == 0)
        velocities[node] -= contact.gap * contact.normal;
  }



  template <int dim>
  void SolidContact<dim>::move(const FluidStep<dim> &fluid, const SolidStep<dim> &solid)
  {
    for (Contact &contact : known)
    {
      std::array<Point<dim>, dim> corners;
      for (unsigned int v = 0; v < dim; ++v)
        corners[v] = solid.position(SolidNode(contact.touch.corners[v]));
      const Point<dim> &position = fluid.state.position[contact.vertex.value()];
      contact.normal             = facet_normal(corners);
      contact.normal /= contact.normal.norm();
      contact.shares   = foot_shares(corners, position);
      contact.gap      = (contact.normal * (position - corners[0]) - contact.touch.distance) / time_step;
      contact.velocity = Tensor<1, dim>();
      for (unsigned int v = 0; v < dim; ++v)
        contact.velocity += contact.shares[v] * solid.mean_velocity(SolidNode(contact.touch.corners[v]));
    }
  }



  template <int dim>
  void SolidContact<dim>::assemble(BlockSystem<dim> &system) const
  {
    for (unsigned int k = 0; k < known.size(); ++k)
      system.add_contact(k, weights(k), normal_force(k),
                         known[k].stiffness * outer_product(known[k].normal, known[k].normal));
  }



  template <int dim>
  void SolidContact<dim>::iterate()
  {
    for (Contact &contact : known)
      contact.multiplier += contact.stiffness * contact.gap;
  }



  template <int dim>
  unsigned int SolidContact<dim>::find(const unsigned int vertex, const unsigned int facet) const
  {
    auto place = std::lower_bound(known.begin(), known.end(), vertex,
                                  [](const Contact &contact, const unsigned int v) {
                                    return contact.touch.vertex < v;
                                  });
    for (; place != known.end() && place->touch.vertex == vertex; ++place)
      if (place->touch.facet == facet)
        return place - known.begin();
    return numbers::invalid_unsigned_int;
  }



  template <int dim>
  std::array<double, dim + 1> SolidContact<dim>::weights(const unsigned int k) const
  {
    std::array<double, dim + 1> result;
    result[0] = 1.;
    for (unsigned int v = 0; v < dim; ++v)
      result[v + 1] = -known[k].shares[v];
    return result;
  }



  template class SolidContact<2>;
  template class SolidContact<3>;
} // namespace Lahar
