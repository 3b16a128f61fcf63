// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/mpi.h>

#include <lahar/boundary/open_floor.h>
#include <lahar/utilities/ranks.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace Lahar
{
  template <int dim>
  std::string warn_of_open_floor(const ParticleCloud<dim> &cloud, const Walls<dim> &obstacles,
                                 const Tensor<1, dim> &gravity, const MPI_Comm &communicator)
  {
    if (obstacles.facets().empty() || gravity.norm() == 0.)
      return "";
    const Tensor<1, dim> down = gravity / gravity.norm();
    std::vector<double> bounds(2 * dim, -std::numeric_limits<double>::max()); // negative lower and upper ones
    for (const Point<dim> &point : cloud.position)
      for (unsigned int d = 0; d < dim; ++d)
      {
        bounds[2 * d]     = std::max(bounds[2 * d], -point[d]);
        bounds[2 * d + 1] = std::max(bounds[2 * d + 1], point[d]);
      }
    Utilities::MPI::max(bounds, communicator, bounds);
    Tensor<1, dim> diagonal;
    for (unsigned int d = 0; d < dim; ++d)
      diagonal[d] = bounds[2 * d] + bounds[2 * d + 1];
    const double far_away = 2. * diagonal.norm();

    unsigned int n_fluid = 0, n_open = 0, first = 0;
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      if (cloud.kind[i] != ParticleKind::fluid)
        continue;
      ++n_fluid;
      // From a little above, since particles may lie on a wall; beside the rim of a wall they slide down. Facets are
      // enlarged, as a line through an edge may miss both by rounding.
      const Point<dim> start = cloud.position[i] - 0.1 * cloud.spacing[i] * down;
      const double rim       = 1e-3 * cloud.spacing[i];
      if (obstacles.crossed(start, start + far_away * down, 0., rim).empty() &&
          obstacles.near(cloud.position[i], cloud.spacing[i]).empty() && n_open++ == 0)
        first = i;
    }
    const Point<dim> place = largest_of_all(n_open > 0 ? -double(cloud.number[first])
                                                       : -std::numeric_limits<double>::max(),
                                            n_open > 0 ? cloud.position[first] : Point<dim>(), communicator)
                               .second;
    n_fluid = Utilities::MPI::sum(n_fluid, communicator);
    n_open  = Utilities::MPI::sum(n_open, communicator);
    if (n_open == 0)
      return "";
    std::ostringstream text;
    text << "Warning: no wall and no solid lies below " << n_open << " of " << n_fluid
         << " fluid particles, the first at (" << place << ") m: they fall without end.";
    return text.str();
  }



  template std::string warn_of_open_floor<2>(const ParticleCloud<2> &, const Walls<2> &, const Tensor<1, 2> &,
                                             const MPI_Comm &);
  template std::string warn_of_open_floor<3>(const ParticleCloud<3> &, const Walls<3> &, const Tensor<1, 3> &,
                                             const MPI_Comm &);
} // namespace Lahar
