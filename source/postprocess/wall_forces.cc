// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/box.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

#include <algorithm>

namespace Lahar
{
  /**
   * Mean force of the fluid on the walls inside a box over the last step, N (N/m in 2D): the sum of the reactions of the
   * discrete momentum equation at the wall's particles and at those of the fluid that lie on it, see
   * TimeIntegration::mean_force().
   */
  template <int dim>
  class WallForces : public Postprocessor<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list("Boxes", "", ';',
                       "Boxes in m, 'name: x, y : x, y' by two opposite corners, separated by ';'. Columns "
                       "'<name> force x (N)' ...: the force on the walls inside the box.");
    }

    void parse_parameters(Parameters &prm) override;
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;

  private:
    std::vector<std::pair<std::string, Box<dim>>> boxes;
  };



  template <int dim>
  void WallForces<dim>::parse_parameters(Parameters &prm)
  {
    for (const auto &[name, corners] : parse_named_points<dim>(prm, "Boxes", 2))
      boxes.emplace_back(name, Box<dim>(corners[0], corners[1]));
  }



  template <int dim>
  void WallForces<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    for (const auto &[name, box] : boxes)
    {
      Tensor<1, dim> force;
      for (const unsigned int particle : snapshot.mesh.particles())
      {
        // Facets behind those of the walls are of solids.
        const int n_facets    = snapshot.walls.facets().size();
        const auto &slots     = snapshot.cloud.contact_facets[particle];
        const bool is_on_wall = snapshot.cloud.kind[particle] == ParticleKind::wall ||
                                std::any_of(slots.begin(), slots.end(), [n_facets](const int facet) {
                                  return facet != ParticleCloud<dim>::no_facet && facet < n_facets;
                                });
        if (is_on_wall && snapshot.cloud.is_own(particle) &&
            box.contains(snapshot.cloud.position[particle], 0.))
          force -= snapshot.cloud.reaction[particle];
      }
      add_force_columns(statistics, snapshot, name, "force",
                        Utilities::MPI::sum(force, snapshot.communicator()));
    }
  }



  static const Factory<Postprocessor<2>>::Registration<WallForces<2>>
    wall_forces_2d("Wall forces", "Forces of the fluid on walls in boxes.");
  static const Factory<Postprocessor<3>>::Registration<WallForces<3>>
    wall_forces_3d("Wall forces", "Forces of the fluid on walls in boxes.");
} // namespace Lahar
