// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/normal_parts.h>
#include <lahar/geometry/symmetry.h>
#include <lahar/initial/axis.h>
#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

#include <algorithm>

namespace Lahar
{
  /**
   * For each boundary the mean force of the fluid on it over the last step, N (N/m in 2D): the sum of the reactions of the
   * discrete momentum equation at its particles and at those that slide on it, see TimeIntegration::mean_force().
   *
   * A particle that boundaries share belongs to the first of them. Where a particle slides along facets of several
   * boundaries, each has the part of the reaction along its normal, and the first boundary of the case what is along
   * the edge. An outlet with a level has the force of the fluid on what stands behind it.
   */
  template <int dim>
  class BoundaryForces : public Postprocessor<dim>
  {
  public:
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;

  private:
    using Forces = std::vector<Tensor<1, dim>>;

    /// Add the force of a particle that slides.
    static void add_sliding(const Snapshot<dim> &snapshot, const unsigned int particle, Forces &forces);
  };



  template <int dim>
  void BoundaryForces<dim>::add_sliding(const Snapshot<dim> &snapshot, const unsigned int particle,
                                        Forces &forces)
  {
    const Tensor<1, dim> force = -snapshot.cloud.reaction[particle];
    std::vector<unsigned int> facets;
    bool is_one = true;
    for (const int facet : snapshot.cloud.contact_facets[particle])
      if (facet != ParticleCloud<dim>::no_facet &&
          static_cast<unsigned int>(facet) < snapshot.walls.facets().size()) // else it is one of a solid
      {
        facets.push_back(facet);
        is_one = is_one &&
                 snapshot.walls.facets()[facet].boundary == snapshot.walls.facets()[facets[0]].boundary;
      }
    if (facets.empty())
      return;
    if (is_one)
    {
      forces[snapshot.walls.facets()[facets[0]].boundary] += force;
      return;
    }
    std::vector<Tensor<1, dim>> normals;
    for (const unsigned int facet : facets)
      normals.push_back(snapshot.walls.normal(facet));
    const std::vector<double> shares = normal_parts(normals, force);
    Tensor<1, dim> rest              = force;
    for (unsigned int k = 0; k < facets.size(); ++k)
    {
      const Tensor<1, dim> part = shares[k] * normals[k];
      forces[snapshot.walls.facets()[facets[k]].boundary] += part;
      rest -= part;
    }
    unsigned int first = snapshot.walls.facets()[facets[0]].boundary;
    for (const unsigned int facet : facets)
      first = std::min(first, snapshot.walls.facets()[facet].boundary);
    forces[first] += rest;
  }



  template <int dim>
  void BoundaryForces<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    const std::vector<std::string> &names = snapshot.walls.boundary_names();
    Forces forces(names.size());
    for (const unsigned int particle : snapshot.mesh.particles())
      if (snapshot.cloud.is_own(particle))
      {
        if (snapshot.cloud.kind[particle] == ParticleKind::wall)
          forces[snapshot.cloud.part[particle]] -= snapshot.cloud.reaction[particle];
        else if (snapshot.cloud.in_contact(particle))
          add_sliding(snapshot, particle, forces);
      }
    std::vector<double> components(dim * names.size());
    for (unsigned int k = 0; k < components.size(); ++k)
      components[k] = forces[k / dim][k % dim];
    Utilities::MPI::sum(components, snapshot.communicator(), components);
    for (unsigned int b = 0; b < names.size(); ++b)
    {
      if (Symmetry::applies<dim>() && names[b] == axis_name)
        continue; // it exerts none
      for (unsigned int d = 0; d < dim; ++d)
        forces[b][d] = components[dim * b + d];
      if (snapshot.outlet_forces != nullptr && !snapshot.outlet_forces->empty())
        forces[b] += (*snapshot.outlet_forces)[b];
      add_force_columns(statistics, snapshot, names[b], "force", forces[b]);
    }
  }



  static const Factory<Postprocessor<2>>::Registration<BoundaryForces<2>>
    forces_2d("Boundary forces", "Force of the fluid on each boundary.");
  static const Factory<Postprocessor<3>>::Registration<BoundaryForces<3>>
    forces_3d("Boundary forces", "Force of the fluid on each boundary.");
} // namespace Lahar
