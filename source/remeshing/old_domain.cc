// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/remeshing/old_domain.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace Lahar
{
  namespace
  {
    /// The volume (area) of the simplex of a face and a point, with a sign.
    template <int dim>
    double volume_with(const std::array<Point<dim>, dim> &face, const Point<dim> &tip)
    {
      SimplexCorners<dim> corners;
      std::copy(face.begin(), face.end(), corners.begin());
      corners[dim] = tip;
      return signed_volume<dim>(corners);
    }

    // Plain numbers, whose indices are not checked: most of the time of a search goes into is_inside().
    template <int dim>
    using Vector = std::array<double, dim>;

    template <int dim>
    Vector<dim> from_to(const Point<dim> &a, const Point<dim> &b)
    {
      Vector<dim> difference;
      for (int d = 0; d < dim; ++d)
        difference[d] = b.begin_raw()[d] - a.begin_raw()[d];
      return difference;
    }

    template <int dim>
    double determinant_of(const std::array<Vector<dim>, dim> &rows)
    {
      const Vector<dim> &a = rows[0], &b = rows[1];
      if constexpr (dim == 2)
        return a[0] * b[1] - a[1] * b[0];
      else
        return (a[1] * b[2] - a[2] * b[1]) * rows[2][0] + (a[2] * b[0] - a[0] * b[2]) * rows[2][1] +
               (a[0] * b[1] - a[1] * b[0]) * rows[2][2];
    }

    /// Whether the segment from a to b passes through the face or its rim.
    template <int dim>
    bool cross(const Point<dim> &a, const Point<dim> &b, const std::array<Point<dim>, dim> &face)
    {
      const double volume_a = volume_with<dim>(face, a), volume_b = volume_with<dim>(face, b);
      if (volume_a * volume_b > 0. || volume_a == volume_b)
        return false;
      const Point<dim> place = a + volume_a / (volume_a - volume_b) * (b - a);
      // Inside, to rounding, if the same side of the face is seen past each of its corners.
      const double whole = volume_a - volume_b;
      for (unsigned int c = 0; c < dim; ++c)
      {
        std::array<Point<dim>, dim> part = face;
        part[c]                          = place;
        if ((volume_with<dim>(part, a) - volume_with<dim>(part, b)) / whole < -1e-10)
          return false;
      }
      return true;
    }
  } // namespace



  template <int dim>
  OldDomain<dim>::OldDomain(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh)
    : position(cloud.position)
    , first_around(cloud.size() + 2, 0)
    , closed_faces_of(cloud.size())
  {
    cells.reserve(mesh.n_cells());
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const Simplex<dim> &simplex = mesh.particle_cells()[c];
      const auto corners          = corners_of<dim>(simplex, cloud.position);
      if (!(signed_volume<dim>(corners) > 0.))
        continue;
      for (const unsigned int particle : simplex)
        ++first_around[particle + 2];
      cells.push_back({simplex, body_volume<dim>(corners), mesh.fluid(c), cloud.is_own(simplex)});
    }
    // What is begin + 1 while the cells are filled in becomes the end.
    std::partial_sum(first_around.begin(), first_around.end(), first_around.begin());
    around.resize(first_around.back());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (const unsigned int particle : cells[c].corners)
        around[first_around[particle + 1]++] = c;
    first_around.pop_back();
    for (const BoundaryFace &face : mesh.boundary_faces())
    {
      std::array<Point<dim>, dim> corners;
      bool has_fluid           = false;
      unsigned int n           = 0;
      const Simplex<dim> &cell = mesh.particle_cells()[face.cell];
      for (unsigned int c = 0; c <= dim; ++c)
        if (c != face.opposite)
        {
          has_fluid    = has_fluid || cloud.kind[cell[c]] == ParticleKind::fluid;
          corners[n++] = cloud.position[cell[c]];
        }
      if (has_fluid)
        continue;
      for (unsigned int c = 0; c <= dim; ++c)
        if (c != face.opposite)
          closed_faces_of[cell[c]].push_back(closed_faces.size());
      closed_faces.push_back(corners);
    }
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      seeds.emplace_back(i, i);
      new_index.push_back(i);
    }
  }



  template <int dim>
  void OldDomain<dim>::renumber(const std::vector<unsigned int> &new_indices,
                                const std::vector<std::pair<unsigned int, unsigned int>> &parents,
                                const unsigned int n_particles)
  {
    seeds.assign(n_particles, {numbers::invalid_unsigned_int, numbers::invalid_unsigned_int});
    for (unsigned int i = 0; i < new_indices.size(); ++i)
    {
      const bool is_removed = new_indices[i] == numbers::invalid_unsigned_int;
      new_index[i]          = is_removed ? n_particles + i : new_indices[i];
      if (!is_removed)
        seeds[new_index[i]] = {i, i};
    }
    std::copy(parents.begin(), parents.end(), seeds.end() - parents.size());
  }



  template <int dim>
  bool OldDomain<dim>::is_inside(const unsigned int cell, const Point<dim> &point) const
  {
    constexpr double tolerance = 1e-10;
    const auto &corners        = cells[cell].corners;
    const Vector<dim> to_point = from_to<dim>(position[corners[0]], point);
    std::array<Vector<dim>, dim> edges;
    for (unsigned int d = 0; d < dim; ++d)
      edges[d] = from_to<dim>(position[corners[0]], position[corners[d + 1]]);
    const double all = determinant_of<dim>(edges);
    double sum       = 0.;
    for (unsigned int d = 0; d < dim; ++d)
    {
      auto part           = edges;
      part[d]             = to_point;
      const double lambda = determinant_of<dim>(part) / all;
      if (lambda < -tolerance)
        return false;
      sum += lambda;
    }
    return sum <= 1. + tolerance;
  }



  template <int dim>
  bool OldDomain<dim>::share_cell(const unsigned int a, const unsigned int b) const
  {
    for (const unsigned int seed : {seeds[a].first, seeds[a].second})
      if (seed != numbers::invalid_unsigned_int)
        for (const unsigned int cell : cells_of(seed))
          for (const unsigned int corner : cells[cell].corners)
            if (corner == seeds[b].first || corner == seeds[b].second)
              return true;
    return false;
  }



  template <int dim>
  bool OldDomain<dim>::joins(const Simplex<dim> &simplex) const
  {
    // Grow the set of corners that can be reached from the first one.
    std::array<bool, dim + 1> reached = {};
    reached[0]                        = true;
    for (unsigned int pass = 0; pass < dim; ++pass)
      for (unsigned int a = 0; a <= dim; ++a)
        for (unsigned int b = 0; b <= dim; ++b)
          if (reached[a] && !reached[b] && share_cell(simplex[a], simplex[b]))
            reached[b] = true;
    return std::find(reached.begin(), reached.end(), false) == reached.end();
  }



  template <int dim>
  unsigned int OldDomain<dim>::same_cell(const Simplex<dim> &simplex) const
  {
    Simplex<dim> old_corners;
    for (unsigned int c = 0; c <= dim; ++c)
    {
      const auto [seed, other_parent] = seeds[simplex[c]];
      if (seed == numbers::invalid_unsigned_int || seed != other_parent)
        return numbers::invalid_unsigned_int;
      old_corners[c] = seed;
    }
    const ArrayView<const unsigned int> candidates = cells_of(old_corners[0]);
    const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const unsigned int cell) {
      return cells[cell].corners == old_corners;
    });
    return found == candidates.end() ? numbers::invalid_unsigned_int : *found;
  }



  template <int dim>
  unsigned int OldDomain<dim>::find_cell(const Simplex<dim> &simplex, const Point<dim> &point) const
  {
    if (const unsigned int same = same_cell(simplex); same != numbers::invalid_unsigned_int)
      return same;
    std::set<unsigned int> searched;
    const auto find_around = [&](const unsigned int particle) {
      if (searched.insert(particle).second)
        for (const unsigned int cell : cells_of(particle))
          if (is_inside(cell, point))
            return cell;
      return numbers::invalid_unsigned_int;
    };
    std::vector<unsigned int> first_ring;
    for (const unsigned int particle : simplex)
      for (const unsigned int seed : {seeds[particle].first, seeds[particle].second})
        if (seed != numbers::invalid_unsigned_int)
        {
          if (const unsigned int cell = find_around(seed); cell != numbers::invalid_unsigned_int)
            return cell;
          first_ring.push_back(seed);
        }
    // A removed particle's cells, or those that the point has moved past, are in the second ring.
    for (const unsigned int seed : first_ring)
      for (const unsigned int ring_cell : cells_of(seed))
        for (const unsigned int corner : cells[ring_cell].corners)
          if (const unsigned int cell = find_around(corner); cell != numbers::invalid_unsigned_int)
            return cell;
    return numbers::invalid_unsigned_int;
  }



  template <int dim>
  std::optional<unsigned int> OldDomain<dim>::fluid_at(const Simplex<dim> &simplex,
                                                       const Point<dim> &point) const
  {
    const unsigned int cell = find_cell(simplex, point);
    return cell == numbers::invalid_unsigned_int ? std::nullopt : std::make_optional(cells[cell].fluid);
  }



  template <int dim>
  bool OldDomain<dim>::leads_into_hollow(const Simplex<dim> &simplex, const Point<dim> &centroid,
                                         const ParticleCloud<dim> &cloud) const
  {
    if (!std::all_of(simplex.begin(), simplex.end(), [&](const unsigned int i) { return was_wet(i); }))
      return false;
    for (const unsigned int from : simplex)
      if (cloud.kind[from] == ParticleKind::fluid)
        for (const unsigned int wall : simplex)
          if (cloud.kind[wall] != ParticleKind::fluid)
            for (const unsigned int face : closed_faces_of[seeds[wall].first])
              if (cross<dim>(cloud.position[from], centroid, closed_faces[face]))
                return true;
    return false;
  }



  template <int dim>
  std::vector<typename OldDomain<dim>::OldCell> OldDomain<dim>::renumbered_cells() const
  {
    std::vector<OldCell> result;
    result.reserve(cells.size());
    for (const Cell &cell : cells)
    {
      result.push_back({cell.corners, cell.volume, cell.own});
      for (unsigned int &corner : result.back().corners)
        corner = new_index[corner];
    }
    return result;
  }



  template <int dim>
  std::vector<unsigned int> OldDomain<dim>::old_neighbours(const unsigned int particle) const
  {
    const unsigned int old = particle >= seeds.size() ? particle - seeds.size()
                             : seeds[particle].first == seeds[particle].second
                               ? seeds[particle].first
                               : numbers::invalid_unsigned_int;
    std::vector<unsigned int> result;
    if (old < position.size())
      for (const unsigned int cell : cells_of(old))
        for (const unsigned int corner : cells[cell].corners)
          if (new_index[corner] < seeds.size())
            result.push_back(new_index[corner]);
    return result;
  }



  template class OldDomain<2>;
  template class OldDomain<3>;
} // namespace Lahar
