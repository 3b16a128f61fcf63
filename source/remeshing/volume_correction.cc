// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/connected_parts.h>
#include <lahar/remeshing/volume_correction.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// No particle moves by more than this times its spacing.
    constexpr double longest_surface_shift = 0.1;

    /// Cells keep this part of their volume.
    constexpr double smallest_part = 0.5;

    /// Smaller changes, over the sum of the cells' volumes, are rounding.
    constexpr double smallest_change = 1e-10;

    /// A cell that one of the meshes has and the other one has not; volumes of old cells are negative.
    template <int dim>
    struct ChangedCell
    {
      Simplex<dim> corners;
      double volume;
    };

    /// This rank's own cells in which the meshes differ.
    template <int dim>
    std::vector<ChangedCell<dim>> find_changes(const OldDomain<dim> &old_domain, const FluidMesh<dim> &mesh,
                                               const ParticleCloud<dim> &cloud)
    {
      std::vector<ChangedCell<dim>> changed;
      const auto add_new = [&](const Simplex<dim> &cell) {
        if (cloud.is_own(cell))
          changed.push_back({cell, body_volume<dim>(corners_of<dim>(cell, cloud.position))});
      };
      // Both meshes' cells are sorted, and particles keep their order when they are renumbered, so what is in both is
      // found in one pass, once the old cells with removed corners are out of the way.
      const std::vector<Simplex<dim>> &cells = mesh.particle_cells();
      auto cell                              = cells.begin();
      for (const auto &[old_cell, old_volume, own] : old_domain.renumbered_cells())
      {
        if (*std::max_element(old_cell.begin(), old_cell.end()) < cloud.size())
        {
          for (; cell != cells.end() && *cell < old_cell; ++cell)
            add_new(*cell);
          if (cell != cells.end() && *cell == old_cell)
          {
            // The same cell, but a merged corner may have moved.
            const double volume = body_volume<dim>(corners_of<dim>(*cell++, cloud.position));
            if (own && std::abs(volume - old_volume) >= 1e-10 * old_volume)
              changed.push_back({old_cell, volume - old_volume});
            continue;
          }
        }
        if (own)
          changed.push_back({old_cell, -old_volume});
      }
      for (; cell != cells.end(); ++cell)
        add_new(*cell);
      return changed;
    }

    /// The area vectors of the free surface by particle, outwards: each face gives face_share() to its corners.
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
          double sum_of_radii = 0.;
          for (unsigned int a = 0; a <= dim; ++a)
            sum_of_radii += a != face.opposite ? corners[a][0] : 0.;
          for (unsigned int a = 0; a <= dim; ++a)
            if (a != face.opposite)
              area[cell[a]] += face_share<dim>(face_area, sum_of_radii, corners[a][0]);
        }
      return area;
    }
  } // namespace



  template <int dim>
  void VolumeCorrection<dim>::keep_cells(const FluidMesh<dim> &mesh,
                                         const std::vector<Point<dim>> &old_position,
                                         ParticleCloud<dim> &cloud, const Migration<dim> &migration)
  {
    // Particles of cells that would become too flat stay; then others' cells may be: until none is.
    for (bool any = true; any;)
    {
      std::vector<bool> stays(cloud.size(), false);
      any = false;
      for (const Simplex<dim> &cell : mesh.particle_cells())
        if (std::any_of(cell.begin(), cell.end(),
                        [&](const unsigned int i) { return cloud.position[i] != old_position[i]; }) &&
            !(signed_volume<dim>(corners_of<dim>(cell, cloud.position)) >
              smallest_part * signed_volume<dim>(corners_of<dim>(cell, old_position))))
          for (const unsigned int i : cell)
            stays[i] = true;
      for (unsigned int i = 0; i < cloud.size(); ++i)
        if (stays[i] && cloud.is_own(i) && cloud.position[i] != old_position[i])
        {
          cloud.position[i] = old_position[i];
          any               = true;
        }
      if (!migration.is_alone())
        any = Utilities::MPI::max(any ? 1U : 0U, migration.communicator()) == 1U;
      if (any)
        migration.update(cloud.position);
    }
  }



  namespace
  {
    /// The fluid particle at which a cell's volume is booked: as the cell's owner is that of its first one, whatever the
    /// order of the corners is, the particle is this rank's own.
    template <int dim>
    unsigned int place_of(const Simplex<dim> &cell, const ParticleCloud<dim> &cloud)
    {
      unsigned int place = numbers::invalid_unsigned_int;
      for (const unsigned int i : cell)
        if (cloud.kind[i] == ParticleKind::fluid)
          place = std::min(place, i);
      return place;
    }

    /// By place the growth of this rank's own cells since they had the volumes @p before.
    template <int dim>
    std::vector<double> growth_by_place(const FluidMesh<dim> &mesh, const std::vector<double> &before,
                                        const ParticleCloud<dim> &cloud)
    {
      std::vector<double> growth(cloud.size(), 0.);
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        if (const Simplex<dim> &cell = mesh.particle_cells()[c]; cloud.is_own(cell))
          growth[place_of<dim>(cell, cloud)] +=
            std::max(0., body_volume<dim>(corners_of<dim>(cell, cloud.position))) - before[c];
      return growth;
    }
  } // namespace



  template <int dim>
  std::vector<double> VolumeCorrection<dim>::cell_volumes(const FluidMesh<dim> &mesh,
                                                          const ParticleCloud<dim> &cloud)
  {
    std::vector<double> volumes;
    for (const Simplex<dim> &cell : mesh.particle_cells())
      volumes.push_back(body_volume<dim>(corners_of<dim>(cell, cloud.position)));
    return volumes;
  }



  template <int dim>
  void VolumeCorrection<dim>::owe_growth(const FluidMesh<dim> &mesh, const std::vector<double> &before,
                                         ParticleCloud<dim> &cloud)
  {
    const std::vector<double> growth = growth_by_place(mesh, before, cloud);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      cloud.owed_volume[i] += growth[i];
  }



  namespace
  {
    /// Call @p action with each of this rank's own isolated particles.
    template <int dim, typename Action>
    void for_each_isolated(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud, const Action &action)
    {
      std::vector<bool> in_mesh(cloud.size(), false);
      for (const unsigned int i : mesh.particles())
        in_mesh[i] = true;
      for (unsigned int i = 0; i < cloud.size(); ++i)
        if (!in_mesh[i] && cloud.kind[i] == ParticleKind::fluid && cloud.is_own(i))
          action(i);
    }
  } // namespace



  template <int dim>
  double VolumeCorrection<dim>::carried_volume(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud)
  {
    double carried = 0.;
    for_each_isolated(mesh, cloud, [&](const unsigned int i) { carried -= cloud.owed_volume[i]; });
    return carried;
  }



  template <int dim>
  std::vector<double> VolumeCorrection<dim>::carried_volumes(const FluidMesh<dim> &mesh,
                                                             const ParticleCloud<dim> &cloud,
                                                             const unsigned int n_fluids)
  {
    std::vector<double> carried(n_fluids, 0.);
    for_each_isolated(mesh, cloud, [&](const unsigned int i) {
      carried[first_fluid(cloud.part[i])] -= cloud.owed_volume[i];
    });
    return carried;
  }



  template <int dim>
  bool VolumeCorrection<dim>::is_any_owed(const ParticleCloud<dim> &cloud, const Migration<dim> &migration)
  {
    const bool any = std::any_of(cloud.owed_volume.begin(), cloud.owed_volume.end(),
                                 [](const double volume) { return volume != 0.; });
    return migration.is_alone() ? any : Utilities::MPI::max(any ? 1U : 0U, migration.communicator()) == 1U;
  }



  template <int dim>
  void VolumeCorrection<dim>::apply(const OldDomain<dim> &old_domain, const OutsideVolumes &passed_on,
                                    const Walls<dim> &walls, FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud,
                                    const Migration<dim> &migration)
  {
    std::vector<bool> has_cell(cloud.size(), false), in_contact(cloud.size(), false);
    ConnectedParts<dim> bodies(cloud.size());
    for (const Simplex<dim> &cell : mesh.particle_cells())
    {
      const bool at_wall = std::any_of(cell.begin(), cell.end(), [&](const unsigned int i) {
        return cloud.kind[i] != ParticleKind::fluid;
      });
      for (const unsigned int i : cell)
      {
        has_cell[i]   = true;
        in_contact[i] = in_contact[i] || at_wall;
        if (cloud.kind[i] == ParticleKind::fluid)
          for (const unsigned int j : cell)
            if (cloud.kind[j] == ParticleKind::fluid)
              bodies.join(i, j);
      }
    }
    bodies.connect(cloud, migration);

    // What changed, at a particle of the body that it belongs to; an isolated particle is a body of its own. Where no fluid
    // is left near by, the wall or solid keeps the account.
    const auto is_fluid = [&](const unsigned int i) {
      return i < cloud.size() && cloud.kind[i] == ParticleKind::fluid;
    };
    std::vector<double> n_particles(cloud.size(), 0.), change = n_particles, size = n_particles;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      n_particles[i] = cloud.is_own(i) ? 1. : 0.;
    n_particles     = bodies.sum(n_particles, migration);
    const auto book = [&](const auto &corners, const double volume) {
      unsigned int place  = numbers::invalid_unsigned_int;
      const auto consider = [&](const unsigned int i) {
        if (is_fluid(i) && (place == numbers::invalid_unsigned_int ||
                            std::make_pair(-n_particles[i], i) < std::make_pair(-n_particles[place], place)))
          place = i;
      };
      for (const unsigned int i : corners)
        consider(i);
      if (place == numbers::invalid_unsigned_int)
        for (const unsigned int i : corners)
          for (const unsigned int j : old_domain.old_neighbours(i))
            consider(j);
      if (place == numbers::invalid_unsigned_int)
        place = *std::min_element(corners.begin(), corners.end());
      if (place < cloud.size())
      {
        change[place] += volume;
        size[place] += std::abs(volume);
      }
    };
    for (const auto &[corners, volume] : find_changes(old_domain, mesh, cloud))
      book(corners, volume);
    for (const auto &[number, volume] : passed_on)
      book(std::array<unsigned int, 1>{{cloud.find(number)}}, volume);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i))
      {
        change[i] += cloud.owed_volume[i];
        size[i] += std::abs(cloud.owed_volume[i]);
      }
    change = bodies.sum(change, migration);
    size   = bodies.sum(size, migration);

    // The whole surface of the body moves by the same distance; if all of it touches walls, that part too.
    const std::vector<Tensor<1, dim>> area = surface_areas(mesh, cloud);
    std::vector<double> free_area(cloud.size(), 0.), whole_area(cloud.size(), 0.);
    const auto is_movable = [&](const unsigned int i) {
      return cloud.is_own(i) && is_fluid(i) && has_cell[i] && !cloud.in_contact(i) && area[i].norm() > 0.;
    };
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (is_movable(i))
      {
        whole_area[i] = area[i].norm();
        free_area[i]  = in_contact[i] ? 0. : area[i].norm();
      }
    whole_area = bodies.sum(whole_area, migration);
    free_area  = bodies.sum(free_area, migration);

    const std::vector<Point<dim>> old_position = cloud.position;
    const std::vector<double> volumes          = cell_volumes(mesh, cloud);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (is_movable(i) && std::abs(change[i]) > smallest_change * size[i] &&
          !(in_contact[i] && free_area[i] > 0.))
      {
        const double limit         = longest_surface_shift * cloud.spacing[i];
        const double distance      = -change[i] / (free_area[i] > 0. ? free_area[i] : whole_area[i]);
        const Tensor<1, dim> shift = std::max(-limit, std::min(limit, distance)) / area[i].norm() * area[i];
        if (walls.crossed(cloud.position[i], cloud.position[i] + shift, 0., 0.).empty())
          cloud.position[i] += shift;
      }
    migration.update(cloud.position);
    keep_cells(mesh, old_position, cloud, migration);
    mesh.move(cloud);

    const std::vector<double> given = bodies.sum(growth_by_place(mesh, volumes, cloud), migration);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i))
      {
        const double rest    = change[i] + given[i];
        cloud.owed_volume[i] = std::abs(rest) > smallest_change * size[i] ? rest / n_particles[i] : 0.;
      }
    migration.update(cloud.owed_volume);
  }



  template class VolumeCorrection<2>;
  template class VolumeCorrection<3>;
} // namespace Lahar
