// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_assembly_film_h
#define lahar_tests_assembly_film_h

#include <deal.II/base/utilities.h>

#include <lahar/geometry/delaunay.h>
#include <lahar/particles/particle_cloud.h>

#include <algorithm>
#include <numeric>

#include "tests.h"

namespace Tests
{
  /// A film of @p n layers of squares or cubes, @p n_wide of them along the floor; its points lie layer by layer.
  template <int dim>
  struct Film
  {
    Film(const unsigned int n, const unsigned int n_wide)
      : n(n)
      , n_wide(n_wide)
    {
      for (unsigned int v = 0; v <= n; ++v)
        for (unsigned int w = 0; w < layer_size(); ++w)
        {
          Point<dim> x;
          x[0]       = double(w % (n_wide + 1)) / n;
          x[1]       = double(w / (n_wide + 1)) / n; // 0 in the plane, and overwritten
          x[dim - 1] = double(v) / n;
          cloud.append(x, v == 0 ? ParticleKind::wall : ParticleKind::fluid, 1. / n);
        }
      // Kuhn's simplices of each cube, those of neighbours mirrored: dim! paths from corner to corner along the axes.
      for (unsigned int z = 0; z < n; ++z)
        for (unsigned int y = 0; y < (dim == 3 ? n_wide : 1); ++y)
          for (unsigned int x = 0; x < n_wide; ++x)
          {
            const std::array<unsigned int, 3> cube = {{x, dim == 3 ? y : z, z}};
            std::array<unsigned int, dim> axes;
            std::iota(axes.begin(), axes.end(), 0U);
            do
            {
              std::array<unsigned int, 3> corner = cube;
              for (unsigned int d = 0; d < dim; ++d)
                corner[d] += cube[d] % 2;
              Simplex<dim> cell;
              cell[0] = number(corner);
              for (unsigned int k = 0; k < dim; ++k)
              {
                const unsigned int d = axes[k];
                corner[d]            = 2 * cube[d] + 1 - corner[d];
                cell[k + 1]          = number(corner);
              }
              orient(cell);
              cells.push_back(cell);
            } while (std::next_permutation(axes.begin(), axes.end()));
          }
    }

    unsigned int layer_size() const
    {
      return Utilities::fixed_power<dim - 1>(n_wide + 1);
    }

    /// Number of the point at the given place of the lattice.
    unsigned int number(const std::array<unsigned int, 3> &place) const
    {
      return (place[dim - 1] * (dim == 3 ? n_wide + 1 : 1) + (dim == 3 ? place[1] : 0)) * (n_wide + 1) +
             place[0];
    }

    void orient(Simplex<dim> &cell) const
    {
      Tensor<2, dim> edges;
      for (unsigned int k = 0; k < dim; ++k)
        edges[k] = cloud.position[cell[k + 1]] - cloud.position[cell[0]];
      if (determinant(edges) < 0.)
        std::swap(cell[0], cell[1]);
    }

    unsigned int n, n_wide;
    ParticleCloud<dim> cloud;
    std::vector<Simplex<dim>> cells;
  };
} // namespace Tests

#endif
