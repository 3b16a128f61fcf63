#include <lahar/remeshing/simplex_geometry.h>
#include <lahar/remeshing/volume_correction.h>

#include <algorithm>
#include <numeric>

namespace Lahar
{
  namespace
  {
    /// No particle moves by more than this times its spacing.
    constexpr double longest_shift = 0.1;

    /// Cells keep this part of their volume.
    constexpr double smallest_part = 0.5;

    /// What the nearest particles cannot take goes on to their neighbours, this many times.
    constexpr unsigned int n_rounds           = 5;
    constexpr unsigned int n_smoothing_sweeps = 4;

    /// How far particles are sought that touch no wall, in edges of the mesh.
    constexpr unsigned int n_rings = 6;

    /// A cell of one of the meshes that the other one does not have; volumes of old cells are negative.
    template <int dim>
    struct ChangedCell
    {
      Simplex<dim> corners;
      double volume;
    };

    /// Sets of numbers that are joined one after the other.
    class Partition
    {
    public:
      explicit Partition(const unsigned int n)
        : parent(n)
      {
        std::iota(parent.begin(), parent.end(), 0U);
      }

      unsigned int find(unsigned int i)
      {
        for (; parent[i] != i; i = parent[i])
          parent[i] = parent[parent[i]];
        return i;
      }

      void join(const unsigned int i, const unsigned int j)
      {
        parent[find(i)] = find(j);
      }

    private:
      std::vector<unsigned int> parent;
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
      std::vector<ChangedCell<dim>> all, changed;
      for (const auto &[corners, volume] : old_domain.renumbered_cells(cloud.size()))
        all.push_back({sorted<dim>(corners), -volume});
      for (const Simplex<dim> &cell : mesh.particle_cells())
        all.push_back({sorted<dim>(cell), signed_volume<dim>(corners_of<dim>(cell, cloud.position))});
      std::sort(all.begin(), all.end(),
                [](const ChangedCell<dim> &a, const ChangedCell<dim> &b) { return a.corners < b.corners; });
      for (unsigned int i = 0; i < all.size(); ++i)
        if (i + 1 < all.size() && all[i].corners == all[i + 1].corners &&
            std::abs(all[i].volume + all[i + 1].volume) < 1e-10 * std::abs(all[i].volume))
          ++i;
        else
          changed.push_back(all[i]);
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
      Partition partition(changed.size());
      for (unsigned int i = 1; i < faces.size(); ++i)
        if (faces[i].first == faces[i - 1].first)
          partition.join(faces[i].second, faces[i - 1].second);
      std::vector<unsigned int> patches;
      for (unsigned int c = 0; c < changed.size(); ++c)
        patches.push_back(partition.find(c));
      return patches;
    }

    /// The free surface of a mesh, by particle.
    template <int dim>
    class Surface
    {
    public:
      Surface(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud)
        : area(cloud.size())
        , neighbours(cloud.size())
      {
        for (const BoundaryFace &face : mesh.boundary_faces())
          if (face.free_surface)
          {
            const Simplex<dim> &cell = mesh.particle_cells()[face.cell];
            const auto corners       = corners_of<dim>(cell, cloud.position);
            // −d V ∇λ is the outward area vector of the face opposite to a corner.
            const Tensor<1, dim> face_area = -dim * signed_volume<dim>(corners) *
                                             shape_gradients<dim>(corners)[face.opposite];
            for (unsigned int a = 0; a <= dim; ++a)
              if (a != face.opposite)
              {
                area[cell[a]] += face_area / dim;
                for (unsigned int b = 0; b <= dim; ++b)
                  if (b != face.opposite && b != a)
                    neighbours[cell[a]].push_back(cell[b]);
              }
          }
        std::vector<bool> in_contact(cloud.size(), false);
        for (const Simplex<dim> &cell : mesh.particle_cells())
          if (std::any_of(cell.begin(), cell.end(),
                          [&](const unsigned int i) { return cloud.kind[i] != ParticleKind::fluid; }))
            for (const unsigned int i : cell)
              in_contact[i] = true;
        movable.assign(cloud.size(), false);
        preferred.assign(cloud.size(), false);
        for (unsigned int i = 0; i < cloud.size(); ++i)
        {
          movable[i] = cloud.kind[i] == ParticleKind::fluid && !cloud.on_slip_wall(i) && area[i].norm() > 0.;
          preferred[i] = movable[i] && !in_contact[i];
        }
      }

      std::vector<Tensor<1, dim>> area;
      std::vector<std::vector<unsigned int>> neighbours; ///< some twice
      std::vector<bool> movable;
      std::vector<bool>
        preferred; ///< those that touch no wall and no solid: others may be the front of the flow
    };

    /**
     * The preferred particles of the surface nearest to @p start, in steps along the edges of the mesh; where there are
     * none within n_rings, the nearest movable ones.
     */
    template <int dim>
    std::vector<unsigned int> nearest_on_surface(std::vector<unsigned int> start, const Surface<dim> &surface,
                                                 const std::vector<std::vector<unsigned int>> &cells_of,
                                                 const FluidMesh<dim> &mesh, std::vector<bool> &seen)
    {
      std::vector<unsigned int> found, second_choice, all = start;
      for (const unsigned int i : start)
        seen[i] = true;
      for (unsigned int ring = 0;
           found.empty() && !start.empty() && (ring < n_rings || second_choice.empty()); ++ring)
      {
        const bool any_movable = !second_choice.empty();
        std::vector<unsigned int> next;
        for (const unsigned int i : start)
        {
          if (surface.preferred[i])
            found.push_back(i);
          else if (surface.movable[i] && !any_movable)
            second_choice.push_back(i);
          for (const unsigned int cell : cells_of[i])
            for (const unsigned int j : mesh.particle_cells()[cell])
              if (!seen[j])
              {
                seen[j] = true;
                next.push_back(j);
                all.push_back(j);
              }
        }
        start.swap(next);
      }
      for (const unsigned int i : all)
        seen[i] = false;
      return found.empty() ? second_choice : found;
    }

    /// Spread the shares over the surface; their sum stays.
    template <int dim>
    void smooth(const Surface<dim> &surface, std::vector<double> &shares)
    {
      for (unsigned int sweep = 0; sweep < n_smoothing_sweeps; ++sweep)
      {
        std::vector<double> next(shares.size(), 0.);
        for (unsigned int i = 0; i < shares.size(); ++i)
          if (shares[i] != 0.)
          {
            const unsigned int n = std::count_if(surface.neighbours[i].begin(), surface.neighbours[i].end(),
                                                 [&](const unsigned int j) { return surface.preferred[j]; });
            next[i] += (n > 0 ? 0.5 : 1.) * shares[i];
            for (const unsigned int j : surface.neighbours[i])
              if (surface.preferred[j])
                next[j] += 0.5 / n * shares[i];
          }
        shares.swap(next);
      }
    }
  } // namespace



  template <int dim>
  void VolumeCorrection<dim>::apply(const OldDomain<dim> &old_domain, const Walls<dim> &walls,
                                    FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud)
  {
    const std::vector<ChangedCell<dim>> changed = find_changes(old_domain, mesh, cloud);
    const std::vector<unsigned int> patches     = find_patches<dim>(changed);
    std::vector<double> change(changed.size(), 0.), size(changed.size(), 0.);
    std::vector<std::vector<unsigned int>> corners(changed.size());
    for (unsigned int c = 0; c < changed.size(); ++c)
    {
      change[patches[c]] += changed[c].volume;
      size[patches[c]] += std::abs(changed[c].volume);
      for (const unsigned int i : changed[c].corners)
        if (i < cloud.size())
          corners[patches[c]].push_back(i);
    }

    std::vector<std::vector<unsigned int>> cells_of(cloud.size());
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      for (const unsigned int i : mesh.particle_cells()[c])
        cells_of[i].push_back(c);
    const Surface<dim> surface(mesh, cloud);
    std::vector<double> shares(cloud.size(), 0.);
    std::vector<bool> seen(cloud.size(), false);
    for (unsigned int p = 0; p < changed.size(); ++p)
      if (std::abs(change[p]) > 1e-10 * size[p])
      {
        std::sort(corners[p].begin(), corners[p].end());
        corners[p].erase(std::unique(corners[p].begin(), corners[p].end()), corners[p].end());
        const auto takers = nearest_on_surface<dim>(corners[p], surface, cells_of, mesh, seen);
        double sum        = 0.;
        for (const unsigned int i : takers)
          sum += surface.area[i].norm();
        for (const unsigned int i : takers)
          shares[i] += change[p] * surface.area[i].norm() / sum;
      }
    std::vector<double> taken(cloud.size(), 0.);
    for (unsigned int round = 0; round < n_rounds; ++round)
    {
      smooth(surface, shares);
      for (unsigned int i = 0; i < cloud.size(); ++i)
        if (shares[i] != 0.)
        {
          const double limit = longest_shift * cloud.spacing[i] * surface.area[i].norm();
          const double sum   = std::max(-limit, std::min(limit, taken[i] + shares[i]));
          shares[i] -= sum - taken[i];
          taken[i] = sum;
        }
    }

    std::vector<unsigned int> moved;
    const std::vector<Point<dim>> old_position = cloud.position;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (taken[i] != 0.)
      {
        const Tensor<1, dim> shift = -taken[i] / surface.area[i].norm_square() * surface.area[i];
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
