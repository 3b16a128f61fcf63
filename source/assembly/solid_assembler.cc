// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/solid_assembler.h>

namespace Lahar
{
  template <int dim>
  bool SolidAssembler<dim>::assemble(const Solids<dim> &solids, const SolidState<dim> &state,
                                     const SolidFactors &factors, const SolidLoads<dim> &loads,
                                     const IndexVector<SolidNode, RegionNode> &nodes,
                                     BlockSystem<dim> &system) const
  {
    const SolidMesh<dim> &mesh = solids.mesh();
    const unsigned int n = mesh.nodes_per_cell(), n_q = mesh.points_per_cell();
    FullMatrix<double> matrix(n * dim, n * dim);
    Vector<double> residual(n * dim);
    std::vector<Tensor<1, dim>> g(n), traction(n); // ∇N_I, σ ∇N_I

    for (unsigned int k = 0; k < system.solid_cells().size(); ++k)
    {
      const unsigned int c        = system.solid_cells()[k];
      const SolidLaw &law         = solids.law(mesh.body(c));
      const unsigned int *I_nodes = mesh.cell_nodes(c);
      matrix                      = 0.;
      residual                    = 0.;
      for (unsigned int I = 0; I < n; ++I)
        for (unsigned int J = 0; J < n; ++J)
        {
          const double mass          = law.density() * mesh.mass(c, I, J);
          const Tensor<1, dim> force = mass * (state.acceleration[I_nodes[J]] - loads.gravity);
          for (unsigned int a = 0; a < dim; ++a)
          {
            residual[I * dim + a] += force[a];
            matrix(I * dim + a, J * dim + a) += factors.acceleration * mass;
          }
        }

      for (unsigned int q = 0; q < n_q; ++q)
      {
        const Tensor<2, 3> F = mesh.deformation_gradient(c, q, state.position);
        const double J_F     = determinant(F);
        if (!(J_F > 0.))
          return false;
        const auto response = law.evaluate(mesh.deformation_gradient(c, q, solids.state().position), F,
                                           solids.state().stress[c * n_q + q], dim);
        const double volume = J_F * mesh.volume(c, q), s_volume = factors.position * volume;
        const Tensor<2, 3> inverse_F = invert(F);
        const Tensor<1, dim> *G      = mesh.gradients(c, q);
        for (unsigned int I = 0; I < n; ++I)
          for (unsigned int i = 0; i < dim; ++i)
          {
            g[I][i] = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              g[I][i] += inverse_F[j][i] * G[I][j];
          }
        for (unsigned int I = 0; I < n; ++I)
          for (unsigned int a = 0; a < dim; ++a)
          {
            traction[I][a] = 0.;
            for (unsigned int k = 0; k < dim; ++k)
              traction[I][a] += response.stress[a][k] * g[I][k];
          }

        for (unsigned int I = 0; I < n; ++I)
        {
          double contracted[dim][dim][dim] = {}; // A with g_I over its second index
          for (unsigned int a = 0; a < dim; ++a)
            for (unsigned int k = 0; k < dim; ++k)
              for (unsigned int b = 0; b < dim; ++b)
                for (unsigned int l = 0; l < dim; ++l)
                  contracted[a][b][l] += response.tangent[a][k][b][l] * g[I][k];
          for (unsigned int a = 0; a < dim; ++a)
          {
            residual[I * dim + a] += volume * traction[I][a];
            for (unsigned int J = 0; J < n; ++J)
              for (unsigned int b = 0; b < dim; ++b)
              {
                double entry = traction[I][a] * g[J][b] - traction[J][a] * g[I][b];
                for (unsigned int l = 0; l < dim; ++l)
                  entry += contracted[a][b][l] * g[J][l];
                matrix(I * dim + a, J * dim + b) += s_volume * entry;
              }
          }
        }
      }
      system.add_solid(k, matrix, residual);
    }
    for (unsigned int i = 0; i < loads.external_forces.size(); ++i)
      system.add_solid(nodes[SolidNode(i)], -loads.external_forces[i]);
    return true;
  }



  template <int dim>
  void SolidAssembler<dim>::update_stress(const Solids<dim> &solids, SolidState<dim> &state) const
  {
    const SolidMesh<dim> &mesh = solids.mesh();
    const unsigned int n_q     = mesh.points_per_cell();
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      for (unsigned int q = 0; q < n_q; ++q)
        state.stress[c * n_q + q] = solids.law(mesh.body(c))
                                      .evaluate(mesh.deformation_gradient(c, q, solids.state().position),
                                                mesh.deformation_gradient(c, q, state.position),
                                                solids.state().stress[c * n_q + q], 0)
                                      .stress;
  }



  template class SolidAssembler<2>;
  template class SolidAssembler<3>;
} // namespace Lahar
