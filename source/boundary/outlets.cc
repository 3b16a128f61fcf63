// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/outlets.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/drop_particles.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// Behind an outlet fluid is dropped to this times its spacing.
    constexpr double depth = 5.;

    /// Faces nearer to an outlet than this times their spacing are its own.
    constexpr double reach = 2.;

    /// Parts of gravity below this are none.
    constexpr double rounding = 1e-6;
  } // namespace



  template <int dim>
  void Outlets<dim>::add(const std::string &name, const Outflow &law,
                         const std::vector<WallFacet<dim>> &facets)
  {
    std::ostringstream given;
    for (const double component : law.direction())
      given << (given.str().empty() ? "" : ", ") << component;
    const auto fail = [&](const std::string &allowed) {
      throw InputError("Parameter '" + law.path("Direction") + "' is '" + given.str() +
                       "'. Allowed: " + allowed + ".");
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
      laws.push_back(&law);
    }
  }



  template <int dim>
  Tensor<1, dim> Outlets<dim>::tangential(const unsigned int facet, const Tensor<1, dim> &vector) const
  {
    return vector - (vector * surface.normal(facet)) * surface.normal(facet);
  }



  template <int dim>
  void Outlets<dim>::check_levels(const Tensor<1, dim> &gravity, const unsigned int n_fluids) const
  {
    Tensor<1, dim> up;
    up[dim - 1] = 1.;
    for (unsigned int f = 0; f < laws.size(); ++f)
    {
      if (!laws[f]->has_level())
        continue;
      const auto fail = [&](const std::string &what, const std::string &allowed) {
        throw InputError("Parameter '" + laws[f]->level_path() + "' gives a level behind boundary '" +
                         names[f] + "', " + what + ". Allowed: " + allowed + ".");
      };
      if (n_fluids > 1)
        fail("and the case has " + std::to_string(n_fluids) + " fluids",
             "one fluid, whose density counts there");
      const Tensor<1, dim> g = tangential(f, gravity), e = tangential(f, up);
      if (!(g * e < -0.1 * gravity.norm() * e.norm()) || !(g * e < 0.))
        fail("and gravity does not pull down along the boundary", "a boundary that stands");
      if ((g - (g * e) / e.norm_square() * e).norm() > rounding * gravity.norm())
        fail("and gravity pulls sideways along the boundary",
             std::string("gravity whose part along the boundary goes with that of the axis ") +
               "xyz"[dim - 1]);
    }
  }



  template <int dim>
  std::vector<FacePressure<dim>> Outlets<dim>::pressures(const FluidMesh<dim> &mesh,
                                                         const ParticleCloud<dim> &cloud, const double time,
                                                         const Tensor<1, dim> &weight) const
  {
    std::vector<FacePressure<dim>> result;
    if (!any_level())
      return result;
    for (unsigned int number = 0; number < mesh.boundary_faces().size(); ++number)
    {
      const BoundaryFace &face = mesh.boundary_faces()[number];
      if (!face.free_surface)
        continue;
      std::vector<unsigned int> corners;
      Point<dim> centre;
      double h = 0.;
      for (unsigned int c = 0; c <= dim; ++c)
        if (c != face.opposite)
        {
          corners.push_back(mesh.particle_cells()[face.cell][c]);
          centre += cloud.position[corners.back()] / dim;
          h = std::max(h, cloud.spacing[corners.back()]);
        }
      for (const unsigned int f : surface.near(centre, reach * h))
        if (laws[f]->has_level() && surface.is_above(f, centre, 0.5 * h) &&
            std::all_of(corners.begin(), corners.end(), [&](const unsigned int i) {
              return std::abs(surface.signed_distance(f, cloud.position[i])) < reach * h;
            }))
        {
          // From a corner of the facet along its plane to the level.
          const Tensor<1, dim> gradient = tangential(f, weight);
          const Point<dim> &corner      = surface.facets()[f].corners[0];
          const double way              = (laws[f]->level(time) - corner[dim - 1]) / gradient[dim - 1];
          result.push_back(
            {number, surface.facets()[f].boundary, -(gradient * (corner + way * gradient)), gradient});
          break;
        }
    }
    return result;
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
  void Outlets<dim>::take_forces(const std::vector<FacePressure<dim>> &pressures, const FluidMesh<dim> &mesh,
                                 const ParticleCloud<dim> &cloud, const MPI_Comm &communicator,
                                 const Mean &mean)
  {
    std::vector<Tensor<1, dim>> now(forces.size());
    for (const FacePressure<dim> &pressure : pressures)
    {
      const BoundaryFace &face = mesh.boundary_faces()[pressure.face];
      const Simplex<dim> &cell = mesh.particle_cells()[face.cell];
      if (!cloud.is_own(cell))
        continue;
      const auto corners = corners_of<dim>(cell, cloud.position);
      const double V     = signed_volume<dim>(corners);
      if (V == 0.)
        continue;
      double mean_pressure = 0.;
      for (unsigned int c = 0; c <= dim; ++c)
        if (c != face.opposite)
          mean_pressure += pressure(corners[c]) / dim;
      // Area times n of the face is −dim V ∇N of the corner opposite to it.
      now[pressure.boundary] -= mean_pressure * dim * V * shape_gradients<dim>(corners)[face.opposite];
    }
    for (unsigned int b = 0; b < forces.size(); ++b)
      forces[b] = mean(Utilities::MPI::sum(now[b], communicator), forces[b]);
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
