// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /**
   * Kinetic energy ∫ ρ |v|²/2, potential energy −∫ ρ g·x and elastic energy of all solids, J (J/m in 2D); columns only
   * where there are solids.
   */
  template <int dim>
  class SolidEnergies : public Postprocessor<dim>
  {
  public:
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;
  };



  template <int dim>
  void SolidEnergies<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    const Solids<dim> &solids = snapshot.solids;
    if (solids.empty())
      return;
    const SolidMesh<dim> &mesh   = solids.mesh();
    const SolidState<dim> &state = solids.state();
    const unsigned int n = mesh.nodes_per_cell(), n_q = mesh.points_per_cell();
    double kinetic = 0., potential = 0., elastic = 0.;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const SolidLaw &law       = solids.law(mesh.body(c));
      const unsigned int *nodes = mesh.cell_nodes(c);
      for (unsigned int I = 0; I < n; ++I)
        for (unsigned int J = 0; J < n; ++J)
        {
          const double mass = law.density() * mesh.mass(c, I, J);
          kinetic += 0.5 * mass * (state.velocity[nodes[I]] * state.velocity[nodes[J]]);
          potential -= mass * (snapshot.gravity * state.position[nodes[J]]);
        }
      for (unsigned int q = 0; q < n_q; ++q)
      {
        const Tensor<2, 3> F = mesh.deformation_gradient(c, q, state.position);
        elastic += determinant(F) * mesh.volume(c, q) * law.energy_density(F, state.stress[c * n_q + q]);
      }
    }
    add_to_column(statistics, "Solid kinetic energy (J)", kinetic);
    add_to_column(statistics, "Solid potential energy (J)", potential);
    add_to_column(statistics, "Solid elastic energy (J)", elastic);
  }



  static const Factory<Postprocessor<2>>::Registration<SolidEnergies<2>>
    solid_energies_2d("Solid energies", "Kinetic, potential and elastic energy of all solids.");
  static const Factory<Postprocessor<3>>::Registration<SolidEnergies<3>>
    solid_energies_3d("Solid energies", "Kinetic, potential and elastic energy of all solids.");
} // namespace Lahar
