// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/grid/reference_cell.h>

#include <lahar/postprocess/solid_output.h>

#include <cmath>

namespace Lahar
{
  namespace
  {
    /// The pieces of a cell by local nodes: deal.II numbers the middles of the edges after the corners, in 2D 01, 12,
    /// 20, in 3D 01, 12, 20, 03, 13, 23.
    std::vector<std::array<unsigned int, 3>> pieces(const std::integral_constant<int, 2>,
                                                    const bool is_quadratic)
    {
      if (!is_quadratic)
        return {{{0, 1, 2}}};
      return {{{0, 3, 5}}, {{3, 1, 4}}, {{5, 4, 2}}, {{3, 4, 5}}};
    }

    std::vector<std::array<unsigned int, 4>> pieces(const std::integral_constant<int, 3>,
                                                    const bool is_quadratic)
    {
      if (!is_quadratic)
        return {{{0, 1, 2, 3}}};
      return {{{0, 4, 6, 7}}, {{4, 1, 5, 8}}, {{6, 5, 2, 9}}, {{7, 8, 9, 3}},
              {{4, 8, 6, 7}}, {{4, 8, 5, 6}}, {{9, 7, 6, 8}}, {{9, 6, 5, 8}}};
    }
  } // namespace



  template <int dim>
  SolidOutput<dim>::SolidOutput(const Solids<dim> &solids)
  {
    const SolidMesh<dim> &mesh   = solids.mesh();
    const SolidState<dim> &state = solids.state();
    const auto cell_pieces = pieces(std::integral_constant<int, dim>(), mesh.nodes_per_cell() > dim + 1);
    const unsigned int n_q = mesh.points_per_cell();
    const unsigned int n_datasets = get_dataset_names().size();
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      SymmetricTensor<2, 3> stress;
      for (unsigned int q = 0; q < n_q; ++q)
        stress += state.stress[c * n_q + q] / n_q;
      const SymmetricTensor<2, 3> s = deviator(stress);

      for (const auto &piece : cell_pieces)
      {
        DataOutBase::Patch<dim> patch;
        patch.reference_cell = ReferenceCells::get_simplex<dim>();
        patch.patch_index    = patches.size();
        patch.n_subdivisions = 1;
        patch.data.reinit(n_datasets, dim + 1);
        for (unsigned int v = 0; v <= dim; ++v)
        {
          const unsigned int node = mesh.cell_nodes(c)[piece[v]];
          patch.vertices[v]       = state.position[node];
          unsigned int k          = 0;
          for (unsigned int d = 0; d < dim; ++d)
            patch.data(k++, v) = state.position[node][d] - mesh.reference_position(node)[d];
          for (unsigned int d = 0; d < dim; ++d)
            patch.data(k++, v) = state.velocity[node][d];
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = i; j < 3; ++j)
              patch.data(k++, v) = stress[i][j];
          patch.data(k++, v) = std::sqrt(1.5 * (s * s));
          patch.data(k++, v) = mesh.body(c) + 1;
        }
        patches.push_back(patch);
      }
    }
  }



  template <int dim>
  const std::vector<DataOutBase::Patch<dim>> &SolidOutput<dim>::get_patches() const
  {
    return patches;
  }



  template <int dim>
  std::vector<std::string> SolidOutput<dim>::get_dataset_names() const
  {
    std::vector<std::string> names(dim, "displacement");
    names.insert(names.end(), dim, "velocity");
    names.insert(names.end(), {"stress_xx", "stress_xy", "stress_xz", "stress_yy", "stress_yz", "stress_zz",
                               "von_mises_stress", "body"});
    return names;
  }



  template <int dim>
  std::vector<std::tuple<unsigned int, unsigned int, std::string,
                         DataComponentInterpretation::DataComponentInterpretation>>
  SolidOutput<dim>::get_nonscalar_data_ranges() const
  {
    const auto vector = DataComponentInterpretation::component_is_part_of_vector;
    return {std::make_tuple(0U, dim - 1U, std::string("displacement"), vector),
            std::make_tuple(0U + dim, 2U * dim - 1U, std::string("velocity"), vector)};
  }



  template class SolidOutput<2>;
  template class SolidOutput<3>;
} // namespace Lahar
