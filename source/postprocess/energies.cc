// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/cell_flow.h>
#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /**
   * Kinetic energy ∫ ρ |v|²/2 and potential energy −∫ ρ g·x of the fluid in the mesh, J (J/m in plane strain).
   */
  template <int dim>
  class Energies : public Postprocessor<dim>
  {
  public:
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;
  };



  template <int dim>
  void Energies<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    double kinetic = 0., potential = 0.;
    for (unsigned int c = 0; c < snapshot.mesh.n_cells(); ++c)
    {
      const Simplex<dim> &cell = snapshot.mesh.particle_cells()[c];
      if (!snapshot.cloud.is_own(cell))
        continue;
      const auto corners   = corners_of<dim>(cell, snapshot.cloud.position);
      const double density = snapshot.law(c).density();
      if (Symmetry::applies<dim>())
      {
        // |v|² and x are linear combinations of shape functions, which are exact with three factors.
        const CellFlow<dim> ring(corners, cell, snapshot.cloud.velocity, snapshot.cloud.pressure);
        if (!(ring.volume() > 0.))
          continue;
        for (unsigned int I = 0; I <= dim; ++I)
        {
          const Tensor<1, dim> &v = ring.velocity()[I];
          for (unsigned int J = 0; J <= dim; ++J)
            kinetic += 0.5 * density * ring.volume() * ring.mass(I, J) * (v * ring.velocity()[J]);
          potential -= density * ring.share(I) * (snapshot.gravity * corners[I]);
        }
        continue;
      }
      const double mass = density * signed_volume<dim>(corners);
      // ∫ N_I N_J = V (1 + δ_IJ)/((dim+1)(dim+2)), so ∫ |v|² = V (|Σ v_I|² + Σ |v_I|²)/((dim+1)(dim+2)).
      Tensor<1, dim> sum;
      double sum_of_squares = 0.;
      for (const unsigned int particle : cell)
      {
        sum += snapshot.cloud.velocity[particle];
        sum_of_squares += snapshot.cloud.velocity[particle].norm_square();
      }
      kinetic += 0.5 * mass * (sum.norm_square() + sum_of_squares) / ((dim + 1) * (dim + 2));
      potential -= mass * (snapshot.gravity * centroid<dim>(corners));
    }
    add_to_column(statistics, "Kinetic energy (J)", snapshot.sum_of_ranks(kinetic));
    add_to_column(statistics, "Potential energy (J)", snapshot.sum_of_ranks(potential));
  }



  static const Factory<Postprocessor<2>>::Registration<Energies<2>>
    energies_2d("Energies", "Kinetic and potential energy of the fluid.");
  static const Factory<Postprocessor<3>>::Registration<Energies<3>>
    energies_3d("Energies", "Kinetic and potential energy of the fluid.");
} // namespace Lahar
