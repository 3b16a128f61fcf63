// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_assembly_one_cell_h
#define lahar_tests_assembly_one_cell_h

#include <lahar/assembly/fluid_cell.h>

#include "tests.h"

namespace Tests
{
  /// A step of the fluid in one simplex, from which FluidCell is made as in a step of the program. Everything is zero but
  /// for what is given here; the vertices are those of the simplex in its order.
  template <int dim>
  struct OneCell
  {
    FluidState<dim> state;
    const FluidLaw &law;

    explicit OneCell(const FluidLaw &law, const double time_step)
      : law(law)
    {
      constexpr unsigned int n = dim + 1;
      state.time_step          = time_step;
      state.old_position       = std::vector<Point<dim>>(n);
      state.position           = state.old_position;
      state.velocity = state.mean_velocity = state.acceleration = state.old_velocity =
        state.old_acceleration = state.residual_projection = std::vector<Tensor<1, dim>>(n);
      state.pressure = state.old_pressure = state.old_pressure_rate = std::vector<double>(n, 0.);
      state.velocity_factor = state.acceleration_factor = std::vector<double>(n, 0.);
      state.stabilization = state.stabilization_viscosity = {0.};
      state.plastic_dual                                  = {SymmetricTensor<2, dim>()};
      state.sliver = state.left_out = {false};
      if (law.has_exact_yield_stress())
        state.multiplier = {SymmetricTensor<2, dim>()};
    }

    FluidCell<dim> cell() const
    {
      Simplex<dim> vertices;
      for (unsigned int I = 0; I <= dim; ++I)
        vertices[I] = I;
      return {state, 0, vertices, 0, law, true};
    }
  };
} // namespace Tests

#endif
