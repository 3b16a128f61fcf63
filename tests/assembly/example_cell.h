// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_assembly_example_cell_h
#define lahar_tests_assembly_example_cell_h

#include <deal.II/base/utilities.h>

#include <lahar/geometry/symmetry.h>

#include "assembly/one_cell.h"

namespace Tests
{
  /// A cell during a step of 0.1 s: everything that follows from velocities and pressures at its end. It keeps so much of its
  /// volume that the terms have the derivatives of its geometry.
  template <int dim>
  struct Example : OneCell<dim>
  {
    static constexpr unsigned int n = dim + 1, n_unknowns = n * n;
    using Unknowns = std::array<double, n_unknowns>;
    using OneCell<dim>::state;
    using OneCell<dim>::cell;

    Unknowns unknowns;

    /// @param impulsive whether one node moves impulsively, see TimeIntegration.
    /// @param mean_pressure about which those of the corners lie.
    Example(Random &random, const FluidLaw &law, const bool impulsive = false,
            const double mean_pressure = 0.)
      : OneCell<dim>(law, 0.1)
    {
      do
        draw(random, impulsive, mean_pressure);
      while (cell().motion() == 0.);
      state.gravity                 = random.vector<dim>();
      state.stabilization           = {0.3};
      state.stabilization_viscosity = {0.7};
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = a; b < dim; ++b)
          state.plastic_dual[0][a][b] = random.number();
      if (law.has_exact_yield_stress())
      {
        for (unsigned int a = 0; a < dim; ++a)
          for (unsigned int b = a; b < dim; ++b)
            state.multiplier[0][a][b] = random.number();
        if (dim == 3) // in the plane the out-of-plane component makes a deviator of it
          state.multiplier[0] = deviator(state.multiplier[0]);
      }
    }

    void draw(Random &random, const bool impulsive, const double mean_pressure)
    {
      for (unsigned int I = 0; I < n; ++I)
      {
        state.old_position[I] = Point<dim>();
        if (I > 0)
          state.old_position[I][I - 1] = 1.;
        state.old_position[I] += 0.2 * random.vector<dim>();
        if (Symmetry::applies<dim>())
          state.old_position[I][0] += 0.3;
        state.old_velocity[I]        = 0.5 * random.vector<dim>();
        state.velocity_factor[I]     = (impulsive && I == 1 ? 1. : 1.6);
        state.acceleration_factor[I] = (impulsive && I == 1 ? 10. : 22.);
        state.old_pressure[I]        = random.number();
        state.old_pressure_rate[I]   = random.number();
        for (unsigned int d = 0; d <= dim; ++d)
          unknowns[CellSystem<dim>::index(I, d)] = random.number();
        unknowns[CellSystem<dim>::pressure_index(I)] += mean_pressure;
      }
      set(unknowns);
    }

    void set(const Unknowns &values)
    {
      for (unsigned int I = 0; I < n; ++I)
      {
        Tensor<1, dim> mean;
        for (unsigned int d = 0; d < dim; ++d)
          mean[d] = values[CellSystem<dim>::index(I, d)];
        state.pressure[I] = values[CellSystem<dim>::pressure_index(I)];
        state.velocity[I] = state.old_velocity[I] + state.velocity_factor[I] * (mean - state.old_velocity[I]);
        state.acceleration[I] = state.acceleration_factor[I] * (mean - state.old_velocity[I]);
        state.position[I]     = state.old_position[I] + state.time_step * mean;
      }
    }

    template <typename Assemble>
    CellSystem<dim> system(const Assemble &assemble) const
    {
      CellSystem<dim> result;
      result.clear();
      assemble(cell(), result);
      return result;
    }

    /// Largest difference between the Jacobian and central differences, over the largest entry of the same block.
    template <typename Assemble>
    double jacobian_error(const Assemble &assemble)
    {
      const auto jacobian = system(assemble).matrix;
      double size[2][2] = {{1e-10, 1e-10}, {1e-10, 1e-10}}, error[2][2] = {};
      for (unsigned int j = 0; j < n_unknowns; ++j)
      {
        const double step = 1e-5;
        std::array<std::array<double, n_unknowns>, 2> residual;
        for (unsigned int side = 0; side < 2; ++side)
        {
          Unknowns moved = unknowns;
          moved[j] += (side ? step : -step);
          set(moved);
          residual[side] = system(assemble).residual;
        }
        for (unsigned int i = 0; i < n_unknowns; ++i)
        {
          const double difference = (residual[1][i] - residual[0][i]) / (2. * step);
          double &block_size      = size[i % n == dim][j % n == dim],
                 &block_error     = error[i % n == dim][j % n == dim];
          block_size              = std::max({block_size, std::abs(difference), std::abs(jacobian[i][j])});
          block_error             = std::max(block_error, std::abs(difference - jacobian[i][j]));
        }
      }
      set(unknowns);
      return std::max({error[0][0] / size[0][0], error[0][1] / size[0][1], error[1][0] / size[1][0],
                       error[1][1] / size[1][1]});
    }
  };

  /// How checks call the case.
  template <int dim>
  std::string name_of()
  {
    return Symmetry::applies<dim>() ? "ring" : Utilities::int_to_string(dim) + "D";
  }

  /// The Jacobian of twenty examples against central differences, relative to the largest entry of the block.
  template <int dim, typename Assemble>
  void check_jacobian(const std::string &name, const FluidLaw &law, const Assemble &assemble,
                      const double mean_pressure = 0.)
  {
    Random random;
    double error = 0.;
    for (unsigned int sample = 0; sample < 20; ++sample)
      error = std::max(error, Example<dim>(random, law, sample % 2, mean_pressure).jacobian_error(assemble));
    check(name_of<dim>() + " Jacobian: " + name, error, 1e-6);
  }

  /// Assembles a term, as Example wants it.
  template <typename Term>
  auto assembler(const Term &term)
  {
    return [term](const auto &cell, auto &system) { term.assemble(cell, system); };
  }
} // namespace Tests

#endif
