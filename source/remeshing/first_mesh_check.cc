// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/connected_parts.h>
#include <lahar/remeshing/first_mesh_check.h>
#include <lahar/utilities/ranks.h>

#include <algorithm>
#include <map>

namespace Lahar
{
  namespace
  {
    /// A particle nearer to a facet than this times its spacing is on it, one farther away beside it.
    constexpr double on_facet = 0.1;

    /// Faces whose normals make an angle with a cosine below minus this one face each other.
    constexpr double facing = 0.866;
  } // namespace



  template <int dim>
  FirstMeshCheck<dim>::FirstMeshCheck(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                                      const Migration<dim> &migration)
    : cloud(cloud)
    , mesh(mesh)
    , migration(migration)
  {}



  template <int dim>
  typename FirstMeshCheck<dim>::Places FirstMeshCheck<dim>::between_two_sides(const Walls<dim> &walls) const
  {
    // By particle and facet which sides of the facet have fluid in a cell with the particle.
    std::map<std::pair<unsigned int, unsigned int>, std::array<bool, 2>> sides;
    for (const Simplex<dim> &cell : mesh.particle_cells())
      for (const unsigned int i : cell)
        if (cloud.is_own(i) && cloud.kind[i] == ParticleKind::wall)
          for (const unsigned int f : walls.near(cloud.position[i], on_facet * cloud.spacing[i]))
            for (const unsigned int other : cell)
            {
              const double height = walls.signed_distance(f, cloud.position[other]) / cloud.spacing[i];
              if (!walls.facets()[f].lands &&
                  std::abs(walls.signed_distance(f, cloud.position[i])) < on_facet * cloud.spacing[i] &&
                  cloud.kind[other] == ParticleKind::fluid && std::abs(height) > on_facet &&
                  walls.is_above(f, cloud.position[other], 0.))
                sides[{i, f}][height > 0.] = true;
            }
    Places result;
    unsigned int last = numbers::invalid_unsigned_int;
    for (const auto &[key, has_fluid] : sides)
      if (has_fluid[0] && has_fluid[1] && key.first != last)
      {
        last = key.first;
        result.n += 1.;
        result.place = cloud.position[last];
      }
    result.place = largest_of_all(result.n, result.place, migration.communicator()).second;
    result.n     = Utilities::MPI::sum(result.n, migration.communicator());
    return result;
  }



  template <int dim>
  typename FirstMeshCheck<dim>::Places FirstMeshCheck<dim>::enclosed() const
  {
    ConnectedParts<dim> parts(cloud.size());
    std::vector<double> n_free_faces(cloud.size(), 0.);
    for (const Simplex<dim> &cell : mesh.particle_cells())
      for (const unsigned int i : cell)
        if (cloud.kind[i] == ParticleKind::fluid)
          for (const unsigned int other : cell)
            if (cloud.kind[other] == ParticleKind::fluid)
              parts.join(i, other);
    parts.connect(cloud, migration);
    for (const BoundaryFace &face : mesh.boundary_faces())
      if (const Simplex<dim> &cell = mesh.particle_cells()[face.cell];
          face.free_surface && cloud.is_own(cell))
        for (const unsigned int i : cell)
          if (cloud.kind[i] == ParticleKind::fluid)
            n_free_faces[i] += 1.;
    // Elastic walls give way, too.
    for (const Simplex<dim> &cell : mesh.particle_cells())
      if (cloud.is_own(cell) && std::any_of(cell.begin(), cell.end(), [&](const unsigned int i) {
            return cloud.kind[i] == ParticleKind::solid;
          }))
        for (const unsigned int i : cell)
          n_free_faces[i] += (cloud.kind[i] == ParticleKind::fluid);
    n_free_faces = parts.sum(n_free_faces, migration);

    Places result;
    for (const unsigned int i : mesh.particles())
      if (cloud.is_own(i) && cloud.kind[i] == ParticleKind::fluid && n_free_faces[i] == 0.)
      {
        result.n += 1.;
        result.place = cloud.position[i];
      }
    result.place = largest_of_all(result.n, result.place, migration.communicator()).second;
    result.n     = Utilities::MPI::sum(result.n, migration.communicator());
    return result;
  }



  template <int dim>
  std::pair<double, Point<dim>> FirstMeshCheck<dim>::thinnest(const Walls<dim> &obstacles,
                                                              const double most) const
  {
    // In a hollow edge of walls the mesh has faces between their particles that lie on none.
    std::vector<WallFacet<dim>> facets;
    std::vector<BoundaryFace> faces;
    for (const BoundaryFace &face : mesh.boundary_faces())
    {
      WallFacet<dim> facet;
      Point<dim> middle;
      double spacing = 0.;
      bool has_fluid = false;
      for (unsigned int c = 0, n = 0; c <= dim; ++c)
        if (c != face.opposite)
        {
          const unsigned int i = mesh.particle_cells()[face.cell][c];
          facet.corners[n++]   = cloud.position[i];
          middle += cloud.position[i] / double(dim);
          spacing   = std::max(spacing, cloud.spacing[i]);
          has_fluid = has_fluid || cloud.kind[i] == ParticleKind::fluid;
        }
      const auto near = obstacles.near(middle, on_facet * spacing);
      if (has_fluid || std::any_of(near.begin(), near.end(), [&](const unsigned int f) {
            return std::abs(obstacles.signed_distance(f, middle)) < on_facet * spacing;
          }))
      {
        facets.push_back(facet);
        faces.push_back(face);
      }
    }
    const Walls<dim> boundary(facets);
    double thinnest = most;
    Point<dim> place;
    for (unsigned int f = 0; f < faces.size(); ++f)
    {
      const Simplex<dim> &cell = mesh.particle_cells()[faces[f].cell];
      if (!cloud.is_own(cell))
        continue;
      double spacing = 0.;
      Point<dim> middle;
      for (unsigned int c = 0; c <= dim; ++c)
        if (c != faces[f].opposite)
        {
          spacing += cloud.spacing[cell[c]] / dim;
          middle += cloud.position[cell[c]] / double(dim);
        }
      Tensor<1, dim> inward = boundary.normal(f);
      if (boundary.signed_distance(f, cloud.position[cell[faces[f].opposite]]) < 0.)
        inward *= -1.;
      const Point<dim> start = middle + 1e-3 * spacing * inward;
      for (const unsigned int other : boundary.crossed(start, middle + thinnest * spacing * inward, 0., 0.))
        if (std::abs(inward * boundary.normal(other)) > facing)
        {
          const double along = -boundary.signed_distance(other, middle) / (inward * boundary.normal(other));
          if (along < thinnest * spacing)
          {
            thinnest = along / spacing;
            place    = middle;
          }
        }
    }
    const auto [least, where] = largest_of_all(-thinnest, place, migration.communicator());
    return {-least, where};
  }



  template class FirstMeshCheck<2>;
  template class FirstMeshCheck<3>;
} // namespace Lahar
