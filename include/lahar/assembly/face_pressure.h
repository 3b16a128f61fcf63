// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_face_pressure_h
#define lahar_assembly_face_pressure_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>

namespace Lahar
{
  using namespace dealii;

  /// A pressure that is given on a face of the mesh's boundary: p = max(0, p_0 + g·x) at its corners, Pa.
  template <int dim>
  struct FacePressure
  {
    unsigned int face     = 0;  ///< its number among the mesh's boundary faces
    unsigned int boundary = 0;  ///< the number of the case's boundary that presses
    double at_origin      = 0.; ///< p_0, Pa
    Tensor<1, dim> gradient;    ///< g, Pa/m

    double operator()(const Point<dim> &point) const
    {
      return std::max(0., at_origin + gradient * point);
    }
  };
} // namespace Lahar

#endif
