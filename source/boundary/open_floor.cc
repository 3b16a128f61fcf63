// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/bounding_box.h>

#include <lahar/boundary/open_floor.h>

#include <sstream>

namespace Lahar
{
  template <int dim>
  std::string warn_of_open_floor(const ParticleCloud<dim> &cloud, const Walls<dim> &obstacles,
                                 const Tensor<1, dim> &gravity)
  {
    if (obstacles.facets().empty() || cloud.size() == 0 || gravity.norm() == 0.)
      return "";
    const Tensor<1, dim> down = gravity / gravity.norm();
    const auto corners        = BoundingBox<dim>(cloud.position).get_boundary_points();
    const double far_away     = 2. * corners.first.distance(corners.second);

    unsigned int n_fluid = 0, n_open = 0, first = 0;
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      if (cloud.kind[i] != ParticleKind::fluid)
        continue;
      ++n_fluid;
      // From a little above, since particles may lie on a wall; beside the rim of a wall they slide down.
      const Point<dim> start = cloud.position[i] - 0.1 * cloud.spacing[i] * down;
      if (obstacles.crossed(start, start + far_away * down, 0., 0.).empty() &&
          obstacles.near(cloud.position[i], cloud.spacing[i]).empty() && n_open++ == 0)
        first = i;
    }
    if (n_open == 0)
      return "";
    std::ostringstream text;
    text << "Warning: no wall and no solid lies below " << n_open << " of " << n_fluid
         << " fluid particles, the first at (" << cloud.position[first] << ") m: they fall without end.";
    return text.str();
  }



  template std::string warn_of_open_floor<2>(const ParticleCloud<2> &, const Walls<2> &,
                                             const Tensor<1, 2> &);
  template std::string warn_of_open_floor<3>(const ParticleCloud<3> &, const Walls<3> &,
                                             const Tensor<1, 3> &);
} // namespace Lahar
