// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_fluid_state_h
#define lahar_assembly_fluid_state_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <lahar/assembly/face_pressure.h>
#include <lahar/geometry/simplex_geometry.h>

#include <vector>

namespace Lahar
{
  /**
   * The fluid during one step, by vertex of the mesh: the start of the step (old_…) and the present guess of its end;
   * by cell the dual variable Λ of the primal–dual Newton scheme, the stabilisation parameter τ_s and the viscosity in
   * it, whether the cell is a sliver, see find_slivers(), and whether it is left out, see CrushedCells.
   */
  template <int dim>
  struct FluidState
  {
    std::vector<Point<dim>> old_position;
    std::vector<Tensor<1, dim>> old_velocity, old_acceleration, old_algorithmic_acceleration;
    std::vector<double> old_pressure, old_pressure_rate;
    std::vector<double> velocity_factor;     ///< ∂v/∂w
    std::vector<double> acceleration_factor; ///< ∂(dv/dt)/∂w, 1/s

    std::vector<Point<dim>> position;
    std::vector<Tensor<1, dim>> mean_velocity;          ///< w, the unknown; see TimeIntegration
    std::vector<Tensor<1, dim>> velocity, acceleration; ///< at the end of the step
    std::vector<Tensor<1, dim>> algorithmic_acceleration;
    std::vector<double> pressure;

    std::vector<double> stabilization, stabilization_viscosity;
    std::vector<Tensor<1, dim>>
      residual_projection; ///< by vertex for the first fluid, then for the second …; N/m³; see ResidualProjection
    std::vector<SymmetricTensor<2, dim>> plastic_dual;
    std::vector<double> structure; ///< λ by cell, see Thixotropy; empty if no fluid is thixotropic
    std::vector<bool> sliver, left_out;
    std::vector<FacePressure<dim>> face_pressures; ///< ascending by face

    /// Where the yield stress is exact, by cell: Λ_k, see ExactPlasticStress; whether the fluid stands, and π then. Else
    /// empty.
    std::vector<SymmetricTensor<2, dim>> multiplier;
    std::vector<bool> stands;
    std::vector<Tensor<1, dim>> standing_projection;

    double structure_of(const unsigned int c) const
    {
      return structure.empty() ? 0. : structure[c];
    }

    /// π of a cell of the fluid of this number.
    Tensor<1, dim> projection_of(const unsigned int c, const Simplex<dim> &vertices,
                                 const unsigned int fluid) const
    {
      if (!stands.empty() && stands[c])
        return standing_projection[c];
      Tensor<1, dim> sum;
      for (const unsigned int v : vertices)
        sum += residual_projection[fluid * pressure.size() + v] / (dim + 1.);
      return sum;
    }

    /// The corners of a cell whose shape gives its stress and its masses: those of a sliver are of the start of the step.
    SimplexCorners<dim> shape_of(const unsigned int c, const Simplex<dim> &vertices) const
    {
      return corners_of<dim>(vertices, sliver[c] ? old_position : position);
    }

    double time_step = 0.;  ///< Δt, s
    Tensor<1, dim> gravity; ///< m/s²
  };
} // namespace Lahar

#endif
