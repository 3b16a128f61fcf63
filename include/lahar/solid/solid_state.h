// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_solid_solid_state_h
#define lahar_solid_solid_state_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <boost/serialization/vector.hpp>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// The solids at one time: by node of the SolidMesh, and by its quadrature points (cell by cell).
  template <int dim>
  struct SolidState
  {
    std::vector<Point<dim>> position;         ///< m
    std::vector<Tensor<1, dim>> velocity;     ///< m/s
    std::vector<Tensor<1, dim>> acceleration; ///< m/s²
    std::vector<Tensor<1, dim>>
      algorithmic_acceleration;                ///< of the time integration, m/s², see TimeIntegration
    std::vector<Tensor<1, dim>> reaction;      ///< mean force of fluid and supports in the last step, N
    std::vector<SymmetricTensor<2, 3>> stress; ///< Cauchy stress, Pa

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &position &velocity &acceleration &algorithmic_acceleration &reaction &stress;
    }
  };
} // namespace Lahar

#endif
