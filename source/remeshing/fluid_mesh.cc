#include <deal.II/grid/reference_cell.h>

#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/simplex_geometry.h>

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
  bool FluidMesh<dim>::reinit(const ParticleCloud<dim> &cloud, std::vector<Simplex<dim>> new_cells)
  {
    for (Simplex<dim> &cell : new_cells)
      cell = canonical<dim>(cell);
    std::sort(new_cells.begin(), new_cells.end());
    const bool changed = new_cells != cells_of_particles;
    if (changed)
    {
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
      make_triangulation(cloud);
    }
    else
      move(cloud);

    find_boundary_faces(cloud);
    return changed;
  }



  template <int dim>
  void FluidMesh<dim>::make_triangulation(const ParticleCloud<dim> &cloud)
  {
    dofs.clear();
    tria.clear();
    if (vertex_cells.empty())
      return;

    std::vector<Point<dim>> vertices;
    vertices.reserve(n_vertices());
    for (const unsigned int particle : vertex_to_particle)
      vertices.push_back(cloud.position[particle]);
    std::vector<CellData<dim>> cell_data(n_cells(), CellData<dim>(dim + 1));
    for (unsigned int c = 0; c < n_cells(); ++c)
      std::copy(vertex_cells[c].begin(), vertex_cells[c].end(), cell_data[c].vertices.begin());
    tria.create_triangulation(vertices, cell_data, SubCellData());

    dofs.reinit(tria);
    dofs.distribute_dofs(fe);
    std::vector<types::global_dof_index> vertex_of_dof(dofs.n_dofs());
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        vertex_of_dof[cell->vertex_dof_index(v, 0)] = cell->vertex_index(v);
    dofs.renumber_dofs(vertex_of_dof);
  }



  template <int dim>
  void FluidMesh<dim>::find_boundary_faces(const ParticleCloud<dim> &cloud)
  {
    const auto share_slip_facet = [&](const unsigned int cell, const unsigned int opposite) {
      for (const int facet : cloud.slip_facets[cells_of_particles[cell][(opposite + 1) % (dim + 1)]])
      {
        bool shared = (facet != ParticleCloud<dim>::no_facet);
        for (unsigned int c = 0; c <= dim && shared; ++c)
          if (c != opposite)
          {
            const auto &others = cloud.slip_facets[cells_of_particles[cell][c]];
            shared             = std::find(others.begin(), others.end(), facet) != others.end();
          }
        if (shared)
          return true;
      }
      return false;
    };

    faces.clear();
    if (vertex_cells.empty())
      return; // deal.II has no iterators for an empty triangulation
    for (const auto &cell : tria.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
        {
          const unsigned int c  = cell->active_cell_index();
          unsigned int opposite = 0, n_fluid = 0;
          bool on_face[dim + 1] = {};
          for (unsigned int v = 0; v < dim; ++v)
            on_face[cell->reference_cell().face_to_cell_vertices(f, v, 1)] = true;
          for (unsigned int v = 0; v <= dim; ++v)
            if (!on_face[v])
              opposite = v;
            else if (cloud.kind[cells_of_particles[c][v]] == ParticleKind::fluid)
              ++n_fluid;
          faces.push_back({c, opposite, n_fluid > 0 && !share_slip_facet(c, opposite)});
        }
  }



  template <int dim>
  void FluidMesh<dim>::move(const ParticleCloud<dim> &cloud)
  {
    if (vertex_cells.empty())
      return;
    for (const auto &cell : tria.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        cell->vertex(v) = cloud.position[cells_of_particles[cell->active_cell_index()][v]];
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
      sum += signed_volume<dim>(corners_of<dim>(cell, cloud.position));
    return sum;
  }



  template class FluidMesh<2>;
  template class FluidMesh<3>;
} // namespace Lahar
