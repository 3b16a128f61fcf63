// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /**
   * For each solid the mean force of the fluid on it over the last step, and that of what clamps or drives it, N (N/m in
   * 2D): the sums of the residuals of the discrete momentum equations at its nodes, see TimeIntegration::mean_force().
   */
  template <int dim>
  class SolidForces : public Postprocessor<dim>
  {
  public:
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;
  };



  template <int dim>
  void SolidForces<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    const Solids<dim> &solids = snapshot.solids;
    if (solids.empty())
      return;
    const SolidMesh<dim> &mesh = solids.mesh();
    const unsigned int n       = solids.all_bodies().size();
    // What acts on a prescribed node is the fluid's force and the support's.
    std::vector<Tensor<1, dim>> by_fluid(n), by_support(n);
    for (unsigned int i = 0; i < mesh.n_contour_nodes(); ++i)
      if (snapshot.cloud.is_own(i))
        by_fluid[mesh.body_of_node(i)] -= snapshot.cloud.reaction[i];
    for (Tensor<1, dim> &force : by_fluid)
      force = Utilities::MPI::sum(force, snapshot.communicator());
    for (unsigned int i = 0; i < mesh.n_nodes(); ++i)
      by_support[mesh.body_of_node(i)] += solids.state().reaction[i];
    for (unsigned int b = 0; b < n; ++b)
    {
      const std::string &name = solids.all_bodies()[b].name;
      add_force_columns(statistics, snapshot, name, "fluid force", by_fluid[b]);
      add_force_columns(statistics, snapshot, name, "support force", by_support[b] - by_fluid[b]);
    }
  }



  static const Factory<Postprocessor<2>>::Registration<SolidForces<2>>
    solid_forces_2d("Solid forces", "Forces of the fluid and of the support on each solid.");
  static const Factory<Postprocessor<3>>::Registration<SolidForces<3>>
    solid_forces_3d("Solid forces", "Forces of the fluid and of the support on each solid.");
} // namespace Lahar
