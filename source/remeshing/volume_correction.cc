#include <lahar/remeshing/simplex_geometry.h>
#include <lahar/remeshing/volume_correction.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// No particle moves by more than this times its spacing.
    constexpr double longest_shift = 0.1;

    /// Cells keep this part of their volume.
    constexpr double smallest_part = 0.5;

    /// A cell of one of the meshes that the other one does not have; volumes of old cells are negative.
    template <int dim>
    struct ChangedCell
    {
      Simplex<dim> corners;
      double volume;
    };

    template <int dim>
    Simplex<dim> sorted(Simplex<dim> simplex)
    {
      std::sort(simplex.begin(), simplex.end());
      return simplex;
    }

    /// The cells in which the meshes differ, with sorted corners.
    template <int dim>
    std::vector<ChangedCell<dim>> find_changes(const OldDomain<dim> &old_domain, const FluidMesh<dim> &mesh,
                                               const ParticleCloud<dim> &cloud)
    {
      std::vector<ChangedCell<dim>> changed;
      const auto volume_of = [&](const Simplex<dim> &cell) {
        return signed_volume<dim>(corners_of<dim>(cell, cloud.position));
      };
      // Both meshes' cells are sorted, and particles keep their order when they are renumbered, so what is in both is
      // found in one pass, once the old cells with removed corners are out of the way.
      const std::vector<Simplex<dim>> &cells = mesh.particle_cells();
      auto cell                              = cells.begin();
      for (const auto &[old_cell, old_volume] : old_domain.renumbered_cells(cloud.size()))
      {
        if (*std::max_element(old_cell.begin(), old_cell.end()) < cloud.size())
        {
          for (; cell != cells.end() && *cell < old_cell; ++cell)
            changed.push_back({sorted<dim>(*cell), volume_of(*cell)});
          if (cell != cells.end() && *cell == old_cell)
          {
            const double volume = volume_of(*cell++);
            if (std::abs(volume - old_volume) < 1e-10 * old_volume)
              continue;
            changed.push_back({sorted<dim>(old_cell), volume});
          }
        }
        changed.push_back({sorted<dim>(old_cell), -old_volume});
      }
      for (; cell != cells.end(); ++cell)
        changed.push_back({sorted<dim>(*cell), volume_of(*cell)});
      return changed;
    }



    /// The patches: changed cells joined across common faces. @return the patch of each changed cell.
    template <int dim>
    std::vector<unsigned int> find_patches(const std::vector<ChangedCell<dim>> &changed)
    {
      std::vector<std::pair<std::array<unsigned int, dim>, unsigned int>> faces;
      for (unsigned int c = 0; c < changed.size(); ++c)
        for (unsigned int opposite = 0; opposite <= dim; ++opposite)
        {
          std::array<unsigned int, dim> face;
          for (unsigned int i = 0, n = 0; i <= dim; ++i)
            if (i != opposite)
              face[n++] = changed[c].corners[i];
          faces.emplace_back(face, c);
        }
      std::sort(faces.begin(), faces.end());
      boost::disjoint_sets_with_storage<> partition(changed.size());
      for (unsigned int i = 1; i < faces.size(); ++i)
        if (faces[i].first == faces[i - 1].first)
          partition.union_set(faces[i].second, faces[i - 1].second);
      std::vector<unsigned int> patches;
      for (unsigned int c = 0; c < changed.size(); ++c)
        patches.push_back(partition.find_set(c));
      return patches;
    }

    /// The area vectors of the free surface by particle, outwards: each face gives equal shares to its corners.
    template <int dim>
    std::vector<Tensor<1, dim>> surface_areas(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud)
    {
      std::vector<Tensor<1, dim>> area(cloud.size());
      for (const BoundaryFace &face : mesh.boundary_faces())
        if (face.free_surface)
        {
          const Simplex<dim> &cell = mesh.particle_cells()[face.cell];
          const auto corners       = corners_of<dim>(cell, cloud.position);
          // −d V ∇λ is the area vector of the face opposite to a corner.
          const Tensor<1, dim> face_area = -dim * signed_volume<dim>(corners) *
                                           shape_gradients<dim>(corners)[face.opposite];
          for (unsigned int a = 0; a <= dim; ++a)
            if (a != face.opposite)
              area[cell[a]] += face_area / dim;
        }
      return area;
    }
  } // namespace



  template <int dim>
  void VolumeCorrection<dim>::apply(const OldDomain<dim> &old_domain, const Walls<dim> &walls,
                                    FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud)
  {
    const std::vector<ChangedCell<dim>> changed = find_changes(old_domain, mesh, cloud);
    const std::vector<unsigned int> patches     = find_patches<dim>(changed);
    std::vector<std::vector<unsigned int>> cells_of(cloud.size());
    std::vector<bool> in_contact(cloud.size(), false);
    boost::disjoint_sets_with_storage<> bodies(cloud.size());
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const Simplex<dim> &cell = mesh.particle_cells()[c];
      const bool at_wall       = std::any_of(cell.begin(), cell.end(), [&](const unsigned int i) {
        return cloud.kind[i] != ParticleKind::fluid;
      });
      for (const unsigned int i : cell)
      {
        cells_of[i].push_back(c);
        in_contact[i] = in_contact[i] || at_wall;
        if (cloud.kind[i] == ParticleKind::fluid)
          for (const unsigned int j : cell)
            if (cloud.kind[j] == ParticleKind::fluid)
              bodies.union_set(i, j);
      }
    }

    // The change of each patch, and the body that it belongs to.
    std::vector<double> change(changed.size(), 0.), size(changed.size(), 0.);
    std::vector<unsigned int> body(changed.size(), numbers::invalid_unsigned_int);
    for (unsigned int c = 0; c < changed.size(); ++c)
    {
      change[patches[c]] += changed[c].volume;
      size[patches[c]] += std::abs(changed[c].volume);
      for (const unsigned int i : changed[c].corners)
        if (i < cloud.size() && cloud.kind[i] == ParticleKind::fluid && !cells_of[i].empty())
          body[patches[c]] = bodies.find_set(i);
    }
    std::vector<double> body_change(cloud.size(), 0.);
    for (unsigned int p = 0; p < changed.size(); ++p)
      if (body[p] != numbers::invalid_unsigned_int && std::abs(change[p]) > 1e-10 * size[p])
        body_change[body[p]] += change[p];

    // The whole surface of the body moves by the same distance; if all of it touches walls, that part too.
    const std::vector<Tensor<1, dim>> area = surface_areas(mesh, cloud);
    std::vector<double> free_area(cloud.size(), 0.), whole_area(cloud.size(), 0.);
    const auto is_movable = [&](const unsigned int i) {
      return cloud.kind[i] == ParticleKind::fluid && !cells_of[i].empty() && !cloud.on_slip_wall(i) &&
             area[i].norm() > 0.;
    };
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (is_movable(i))
      {
        whole_area[bodies.find_set(i)] += area[i].norm();
        if (!in_contact[i])
          free_area[bodies.find_set(i)] += area[i].norm();
      }

    std::vector<unsigned int> moved;
    const std::vector<Point<dim>> old_position = cloud.position;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (is_movable(i) && body_change[bodies.find_set(i)] != 0.)
      {
        const unsigned int b = bodies.find_set(i);
        if (in_contact[i] && free_area[b] > 0.)
          continue;
        const double limit         = longest_shift * cloud.spacing[i];
        const double distance      = -body_change[b] / (free_area[b] > 0. ? free_area[b] : whole_area[b]);
        const Tensor<1, dim> shift = std::max(-limit, std::min(limit, distance)) / area[i].norm() * area[i];
        if (!walls.crossed(cloud.position[i], cloud.position[i] + shift, 0.).empty())
          continue;
        cloud.position[i] += shift;
        moved.push_back(i);
      }
    // Particles of cells that would become too flat stay; then others' cells may be: until none is.
    for (bool any = !moved.empty(); any;)
    {
      any = false;
      for (const unsigned int i : moved)
        for (const unsigned int c : cells_of[i])
        {
          const Simplex<dim> &cell = mesh.particle_cells()[c];
          if (cloud.position[i] == old_position[i] ||
              signed_volume<dim>(corners_of<dim>(cell, cloud.position)) >
                smallest_part * signed_volume<dim>(corners_of<dim>(cell, old_position)))
            continue;
          any = true;
          for (const unsigned int j : cell)
            cloud.position[j] = old_position[j];
        }
    }
    if (!moved.empty())
      mesh.move(cloud);
  }



  template class VolumeCorrection<2>;
  template class VolumeCorrection<3>;
} // namespace Lahar
