// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_assemble_stress_h
#define lahar_assembly_assemble_stress_h

#include <lahar/assembly/fluid_cell.h>

namespace Lahar
{
  /// The derivative of a deviatoric stress with respect to d', 2 μ_t I' + c (A ⊗ B + B ⊗ A); A and B are in-plane parts of
  /// deviators.
  template <int dim>
  struct StressTangent
  {
    double viscosity   = 0.; ///< μ_t, Pa s
    double coefficient = 0.; ///< c
    SymmetricTensor<2, dim> A, B;
  };

  /// A deviatoric stress that is constant in the cell, Pa, in-plane part, and its derivative.
  template <int dim>
  struct CellStress
  {
    SymmetricTensor<2, dim> stress;
    StressTangent<dim> tangent;
  };

  /// Add the momentum rows of a deviatoric stress τ that is constant in the cell, R_I += V τ ∇N_I, and their derivatives
  /// with respect to the velocities. In a ring the hoop adds V η τ_θθ to the radial rows, τ_θθ = −tr τ.
  template <int dim>
  void assemble_stress(const FluidCell<dim> &cell, const SymmetricTensor<2, dim> &stress,
                       const StressTangent<dim> &tangent, CellSystem<dim> &system);

  /// Add the sum of two stresses: at once, in half the time, where the derivative of the first one has no A and B.
  template <int dim>
  void assemble_stress(const FluidCell<dim> &cell, const CellStress<dim> &first,
                       const CellStress<dim> &second, CellSystem<dim> &system);
} // namespace Lahar

#endif
