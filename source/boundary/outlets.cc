// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/outlets.h>
#include <lahar/remeshing/drop_particles.h>

#include <cmath>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// Behind an outlet fluid is dropped to this times its spacing.
    constexpr double depth = 5.;
  } // namespace



  template <int dim>
  void Outlets<dim>::add(const std::string &name, const Outflow &law,
                         const std::vector<WallFacet<dim>> &facets)
  {
    std::ostringstream given;
    for (const double component : law.direction())
      given << (given.str().empty() ? "" : ", ") << component;
    const auto fail = [&](const std::string &allowed) {
      throw InputError("Parameter '" + law.path() + "' is '" + given.str() + "'. Allowed: " + allowed + ".");
    };
    if (law.direction().size() != dim)
      fail("a vector of " + std::to_string(dim) + " components");
    Tensor<1, dim> direction;
    for (unsigned int d = 0; d < dim; ++d)
      direction[d] = law.direction()[d];

    std::vector<WallFacet<dim>> all_facets = surface.facets();
    all_facets.insert(all_facets.end(), facets.begin(), facets.end());
    surface = Walls<dim>(all_facets);
    for (unsigned int f = directions.size(); f < all_facets.size(); ++f)
    {
      const double along = surface.normal(f) * direction;
      if (!(std::abs(along) > 0.1 * direction.norm()))
        fail("a vector that leads through boundary '" + name + "', not along it");
      directions.push_back(along > 0. ? 1. : -1.);
      names.push_back(name);
    }
  }



  template <int dim>
  unsigned int Outlets<dim>::passed(const unsigned int particle, const ParticleCloud<dim> &cloud) const
  {
    const double h = cloud.spacing[particle];
    if (cloud.kind[particle] == ParticleKind::fluid)
      for (const unsigned int f : surface.near(cloud.position[particle], depth * h))
      {
        const double behind = directions[f] * surface.signed_distance(f, cloud.position[particle]);
        if (behind > 1e-10 * h && behind <= depth * h &&
            surface.is_above(f, cloud.position[particle], 0.5 * h))
          return f;
      }
    return numbers::invalid_unsigned_int;
  }



  template <int dim>
  void Outlets<dim>::check_initial(const ParticleCloud<dim> &cloud) const
  {
    for (unsigned int i = 0; i < cloud.size() && any(); ++i)
      if (const unsigned int f = passed(i, cloud); f != numbers::invalid_unsigned_int)
      {
        std::ostringstream message;
        message << "Boundary '" << names[f]
                << "' lets fluid out, and there is fluid behind it at the start, at (" << cloud.position[i]
                << ") m. Allowed: fluid before it; see its 'Direction'.";
        throw InputError(message.str());
      }
  }



  template <int dim>
  unsigned int Outlets<dim>::drop(ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh) const
  {
    if (!any())
      return 0;
    std::vector<bool> dropped(cloud.size(), false);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      dropped[i] = passed(i, cloud) != numbers::invalid_unsigned_int;
    return drop_particles(dropped, cloud, mesh);
  }



  template class Outlets<2>;
  template class Outlets<3>;
} // namespace Lahar
