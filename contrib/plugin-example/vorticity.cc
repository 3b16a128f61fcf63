// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The vorticity, rotation of the velocity, 1/s: a number in the plane, a vector in space.
  template <int dim>
  class Vorticity : public OutputField<dim>
  {
  public:
    using Place = typename OutputField<dim>::Place;

    Place place() const override
    {
      return Place::cells;
    }

    unsigned int n_components() const override
    {
      return dim == 2 ? 1 : 3;
    }

    Vector<double> evaluate(const Snapshot<dim> &snapshot) const override
    {
      Vector<double> values(n_components() * snapshot.mesh.n_cells());
      for_each_cell(snapshot, [&](const unsigned int c, const CellFlow<dim> &cell) {
        const Tensor<2, dim> &L = cell.velocity_gradient(); // L_ij = ∂v_i/∂x_j
        if constexpr (dim == 2)
          values[c] = L[1][0] - L[0][1];
        else
          for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int i = (d + 1) % 3, j = (d + 2) % 3;
            values[3 * c + d] = L[j][i] - L[i][j];
          }
      });
      return values;
    }
  };



  static const Factory<OutputField<2>>::Registration<Vorticity<2>> vorticity_2d("vorticity",
                                                                                "Vorticity in 1/s.");
  static const Factory<OutputField<3>>::Registration<Vorticity<3>> vorticity_3d("vorticity",
                                                                                "Vorticity in 1/s.");
} // namespace Lahar
