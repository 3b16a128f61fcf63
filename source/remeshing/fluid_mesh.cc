// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/utilities/in_buckets.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  FluidMesh<dim>::FluidMesh()
    : fe(1)
    , map(fe)
    , dofs(tria)
  {}



  template <int dim>
  bool FluidMesh<dim>::reinit(const ParticleCloud<dim> &cloud, std::vector<Simplex<dim>> new_cells,
                              const std::vector<unsigned int> &new_fluids)
  {
    for (Simplex<dim> &cell : new_cells)
      cell = canonical<dim>(cell);
    if (std::none_of(new_fluids.begin(), new_fluids.end(), [](const unsigned int n) { return n > 0; }))
    {
      std::sort(new_cells.begin(), new_cells.end());
      set_cell_fluids({});
    }
    else
    {
      AssertDimension(new_fluids.size(), new_cells.size());
      std::vector<std::pair<Simplex<dim>, unsigned int>> pairs;
      for (unsigned int c = 0; c < new_cells.size(); ++c)
        pairs.emplace_back(new_cells[c], new_fluids[c]);
      std::sort(pairs.begin(), pairs.end());
      std::vector<unsigned int> sorted;
      for (unsigned int c = 0; c < new_cells.size(); ++c)
      {
        new_cells[c] = pairs[c].first;
        sorted.push_back(pairs[c].second);
      }
      set_cell_fluids(sorted);
    }
    const bool changed = new_cells != cells_of_particles;
    if (changed)
    {
      ++n_changes;
      cells_of_particles = std::move(new_cells);

      std::vector<unsigned int> particle_to_vertex(cloud.size(), 0);
      for (const Simplex<dim> &cell : cells_of_particles)
        for (const unsigned int particle : cell)
          particle_to_vertex[particle] = 1;
      vertex_to_particle.clear();
      for (unsigned int i = 0; i < cloud.size(); ++i)
        if (particle_to_vertex[i] == 1)
        {
          particle_to_vertex[i] = vertex_to_particle.size();
          vertex_to_particle.push_back(i);
        }

      vertex_cells = cells_of_particles;
      for (Simplex<dim> &cell : vertex_cells)
        for (unsigned int &corner : cell)
          corner = particle_to_vertex[corner];
    }
    move(cloud);
    find_boundary_faces(cloud);
    return changed;
  }



  template <int dim>
  void FluidMesh<dim>::set_cell_fluids(const std::vector<unsigned int> &new_fluids)
  {
    fluids.clear();
    if (std::any_of(new_fluids.begin(), new_fluids.end(), [](const unsigned int fluid) { return fluid > 0; }))
      fluids = new_fluids;
  }



  template <int dim>
  void FluidMesh<dim>::reinit_part(const FluidMesh<dim> &whole, const std::vector<unsigned int> &vertices,
                                   const std::vector<unsigned int> &cells)
  {
    std::vector<unsigned int> new_vertex(whole.n_vertices(), numbers::invalid_unsigned_int);
    vertex_to_particle.clear();
    positions.clear();
    for (const unsigned int v : vertices)
    {
      new_vertex[v] = vertex_to_particle.size();
      vertex_to_particle.push_back(whole.particle(v));
      positions.push_back(whole.positions[v]);
    }
    ++n_changes;
    cells_of_particles.clear();
    vertex_cells.clear();
    fluids.clear();
    faces.clear();
    auto face = whole.faces.begin();
    for (const unsigned int c : cells)
    {
      for (; face != whole.faces.end() && face->cell <= c; ++face)
        if (face->cell == c)
          faces.push_back({n_cells(), face->opposite, face->free_surface});
      cells_of_particles.push_back(whole.cells_of_particles[c]);
      if (!whole.fluids.empty())
        fluids.push_back(whole.fluids[c]);
      vertex_cells.push_back(whole.vertex_cells[c]);
      for (unsigned int &corner : vertex_cells.back())
        corner = new_vertex[corner];
    }
    has_triangulation = false;
    dofs.clear();
    tria.clear();
  }



  template <int dim>
  void FluidMesh<dim>::make_triangulation() const
  {
    if (has_triangulation)
      return;
    has_triangulation = true;
    if (vertex_cells.empty())
      return;

    std::vector<CellData<dim>> cell_data(n_cells(), CellData<dim>(dim + 1));
    for (unsigned int c = 0; c < n_cells(); ++c)
      std::copy(vertex_cells[c].begin(), vertex_cells[c].end(), cell_data[c].vertices.begin());
    tria.create_triangulation(positions, cell_data, SubCellData());

    dofs.reinit(tria);
    dofs.distribute_dofs(fe);
    std::vector<types::global_dof_index> vertex_of_dof(dofs.n_dofs());
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        vertex_of_dof[cell->vertex_dof_index(v, 0)] = cell->vertex_index(v);
    dofs.renumber_dofs(vertex_of_dof);
  }



  namespace
  {
    /// The corner opposite to each face, in the order of deal.II's reference cells.
    template <int dim>
    constexpr std::array<unsigned int, dim + 1> opposite_corners();

    template <>
    constexpr std::array<unsigned int, 3> opposite_corners<2>()
    {
      return {{2, 0, 1}};
    }

    template <>
    constexpr std::array<unsigned int, 4> opposite_corners<3>()
    {
      return {{3, 2, 1, 0}};
    }

    /// The numbers of the faces that have one cell only, ascending: (dim+1) times the cell's, and the place among
    /// opposite_corners().
    template <int dim>
    std::vector<unsigned int> find_single_faces(const std::vector<Simplex<dim>> &cells,
                                                const unsigned int n_vertices)
    {
      const auto face = [&cells](const unsigned int number) {
        const unsigned int opposite = opposite_corners<dim>()[number % (dim + 1)];
        std::array<unsigned int, dim> vertices;
        for (unsigned int c = 0, n = 0; c <= dim; ++c)
          if (c != opposite)
            vertices[n++] = cells[number / (dim + 1)][c];
        std::sort(vertices.begin(), vertices.end());
        return vertices;
      };
      const auto for_each = [&](const auto &visit) {
        for (unsigned int number = 0; number < cells.size() * (dim + 1); ++number)
          visit(face(number)[0], number);
      };
      // Sort the faces by their vertices; each comes once or twice.
      std::vector<unsigned int> single;
      std::vector<std::pair<std::array<unsigned int, dim>, unsigned int>> faces;
      in_buckets(n_vertices, for_each,
                 [&](const unsigned int, const std::vector<unsigned int> &face_numbers) {
                   faces.clear();
                   for (const unsigned int number : face_numbers)
                     faces.emplace_back(face(number), number);
                   std::sort(faces.begin(), faces.end());
                   for (unsigned int i = 0; i < faces.size(); ++i)
                     if (i + 1 < faces.size() && faces[i].first == faces[i + 1].first)
                       ++i;
                     else
                       single.push_back(faces[i].second);
                 });
      std::sort(single.begin(), single.end());
      return single;
    }
  } // namespace



  template <int dim>
  void FluidMesh<dim>::find_boundary_faces(const ParticleCloud<dim> &cloud)
  {
    const auto share_facet = [&](const unsigned int cell, const unsigned int opposite) {
      for (const int facet : cloud.contact_facets[cells_of_particles[cell][(opposite + 1) % (dim + 1)]])
      {
        bool shared = (facet != ParticleCloud<dim>::no_facet);
        for (unsigned int c = 0; c <= dim && shared; ++c)
          if (c != opposite)
          {
            const auto &others = cloud.contact_facets[cells_of_particles[cell][c]];
            shared             = std::find(others.begin(), others.end(), facet) != others.end();
          }
        if (shared)
          return true;
      }
      return false;
    };

    faces.clear();
    for (const unsigned int number : find_single_faces<dim>(vertex_cells, n_vertices()))
    {
      const unsigned int c = number / (dim + 1), opposite = opposite_corners<dim>()[number % (dim + 1)];
      bool has_fluid = false;
      for (unsigned int v = 0; v <= dim; ++v)
        has_fluid = has_fluid ||
                    (v != opposite && cloud.kind[cells_of_particles[c][v]] == ParticleKind::fluid);
      faces.push_back({c, opposite, has_fluid && !share_facet(c, opposite)});
    }
  }



  template <int dim>
  void FluidMesh<dim>::move(const ParticleCloud<dim> &cloud)
  {
    positions.clear();
    for (const unsigned int particle : vertex_to_particle)
      positions.push_back(cloud.position[particle]);
    has_triangulation = false;
    dofs.clear();
    tria.clear();
  }



  template <int dim>
  std::vector<bool> FluidMesh<dim>::on_free_surface(const unsigned int n_particles) const
  {
    std::vector<bool> on_surface(n_particles, false);
    for (const BoundaryFace &face : faces)
      if (face.free_surface)
        for (unsigned int c = 0; c <= dim; ++c)
          if (c != face.opposite)
            on_surface[cells_of_particles[face.cell][c]] = true;
    return on_surface;
  }



  template <int dim>
  double FluidMesh<dim>::volume(const ParticleCloud<dim> &cloud) const
  {
    double sum = 0.;
    for (const Simplex<dim> &cell : cells_of_particles)
      if (cloud.is_own(cell))
        sum += body_volume<dim>(corners_of<dim>(cell, cloud.position));
    return sum;
  }



  template <int dim>
  std::vector<double> FluidMesh<dim>::volumes(const ParticleCloud<dim> &cloud,
                                              const unsigned int n_fluids) const
  {
    std::vector<double> sums(n_fluids, 0.);
    for (unsigned int c = 0; c < n_cells(); ++c)
      if (cloud.is_own(cells_of_particles[c]))
        sums[fluid(c)] += body_volume<dim>(corners_of<dim>(cells_of_particles[c], cloud.position));
    return sums;
  }



  template <int dim>
  std::vector<unsigned int> FluidMesh<dim>::own_cells(const ParticleCloud<dim> &cloud) const
  {
    std::vector<unsigned int> result;
    for (unsigned int c = 0; c < n_cells(); ++c)
      if (cloud.is_own(cells_of_particles[c]))
        result.push_back(c);
    return result;
  }



  template class FluidMesh<2>;
  template class FluidMesh<3>;
} // namespace Lahar
