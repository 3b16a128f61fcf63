// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_residual_projection_h
#define lahar_assembly_residual_projection_h

#include <lahar/assembly/fluid_cell.h>

#include <vector>

namespace Lahar
{
  /**
   * The part of the momentum residual of linear cells that is no error but the divergence of the stress s:
   *
   *   q_c = ∇p + ρ g − ρ ā   in a cell, −div s in the exact solution,
   *   π_I = Σ_c V_c q_c / Σ_c V_c   over the cells at vertex I, the projection with the lumped mass matrix,
   *
   * shortened to 2 max_c |s_c|/h_c where it is longer, h_c the edge of the equilateral simplex of the cell's volume: a
   * stress that changes its sign across a cell has no larger divergence. What impacts leave in pressures and
   * accelerations is thus not taken for a stress, and π vanishes where there is no stress.
   *
   * Stabilisation with q − π: orthogonal subgrid scales, R. Codina, Comput. Methods Appl. Mech. Engrg. 190 (2000)
   * 1579–1599.
   */
  template <int dim>
  class ResidualProjection
  {
  public:
    explicit ResidualProjection(const unsigned int n_vertices);

    /// Add a cell with the corners @p vertices.
    void add(const std::array<unsigned int, dim + 1> &vertices, const FluidCell<dim> &cell);

    /// π of all vertices, N/m³; zero at those without cells.
    std::vector<Tensor<1, dim>> compute() const;

  private:
    std::vector<Tensor<1, dim>> residuals; ///< Σ_c V_c q_c
    std::vector<double> volumes;           ///< Σ_c V_c
    std::vector<double> bounds;            ///< 2 max_c |s_c|/h_c
  };
} // namespace Lahar

#endif
