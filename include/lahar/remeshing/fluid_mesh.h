// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_fluid_mesh_h
#define lahar_remeshing_fluid_mesh_h

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>

#include <deal.II/grid/tria.h>

#include <lahar/geometry/delaunay.h>
#include <lahar/particles/particle_cloud.h>

#include <vector>

namespace Lahar
{
  /// A face of the mesh with one cell.
  struct BoundaryFace
  {
    unsigned int cell;
    unsigned int opposite; ///< the cell's corner that the face does not have
    bool free_surface;     ///< not all corners are wall or solid particles, or lie on one common facet
  };

  /**
   * The fluid's mesh, made anew from the particles by each remeshing.
   *
   * Its vertices are the particles that have a cell, in the order of the cloud: vertex v is particle(v). The mesh is
   * index arrays, which the assembly runs over. For output and everything that deal.II does on meshes it is a simplex
   * Triangulation with a P1 DoFHandler, too, whose degree of freedom i belongs to vertex i; as that takes longer than
   * the rest of a remeshing, they are made when someone asks for them.
   *
   * Each cell belongs to one of the case's fluids.
   *
   * On several ranks it is the mesh of the particles that this rank knows. Boundary faces at the rim of that region,
   * where cells are missing, are none of the fluid's.
   */
  template <int dim>
  class FluidMesh
  {
  public:
    FluidMesh();

    /**
     * Make the mesh of the given cells (particle indices, positively oriented).
     *
     * If they are the cells that the mesh has already, only the vertices move.
     * @param fluids numbers of the cells' fluids; empty if all are of the first one.
     * @return whether the connectivity changed.
     */
    bool reinit(const ParticleCloud<dim> &cloud, std::vector<Simplex<dim>> cells_of_particles,
                const std::vector<unsigned int> &fluids = {});

    /**
     * Make this a part of the mesh @p whole: some of its @p cells, ascending, and their @p vertices in this order. The
     * boundary faces are those of the whole mesh.
     */
    void reinit_part(const FluidMesh<dim> &whole, const std::vector<unsigned int> &vertices,
                     const std::vector<unsigned int> &cells);

    /// Counts the changes of the connectivity.
    unsigned int connectivity_number() const
    {
      return n_changes;
    }

    /// Find the boundary faces by the present contacts of the particles with walls.
    void find_boundary_faces(const ParticleCloud<dim> &cloud);

    /// Give the vertices the present positions of their particles.
    void move(const ParticleCloud<dim> &cloud);

    unsigned int n_vertices() const
    {
      return vertex_to_particle.size();
    }

    unsigned int n_cells() const
    {
      return vertex_cells.size();
    }

    /// The particle of a vertex.
    unsigned int particle(const unsigned int vertex) const
    {
      return vertex_to_particle[vertex];
    }

    /// The particles of all vertices, ascending.
    const std::vector<unsigned int> &particles() const
    {
      return vertex_to_particle;
    }

    /// The cells as vertex indices.
    const std::vector<Simplex<dim>> &cells() const
    {
      return vertex_cells;
    }

    /// The cells as particle indices.
    const std::vector<Simplex<dim>> &particle_cells() const
    {
      return cells_of_particles;
    }

    /// The number of the fluid of a cell.
    unsigned int fluid(const unsigned int cell) const
    {
      return fluids.empty() ? 0 : fluids[cell];
    }

    /// Those of all cells, as reinit() takes them.
    const std::vector<unsigned int> &cell_fluids() const
    {
      return fluids;
    }

    /// Change them.
    void set_cell_fluids(const std::vector<unsigned int> &new_fluids);

    const std::vector<BoundaryFace> &boundary_faces() const
    {
      return faces;
    }

    /// By particle: whether it is a corner of a free-surface face.
    std::vector<bool> on_free_surface(const unsigned int n_particles) const;

    /// Volume (area in 2D) of this rank's own cells with the particles at their present positions.
    double volume(const ParticleCloud<dim> &cloud) const;

    /// The same of each of @p n_fluids fluids.
    std::vector<double> volumes(const ParticleCloud<dim> &cloud, const unsigned int n_fluids) const;

    /// Numbers of this rank's own cells, ascending.
    std::vector<unsigned int> own_cells(const ParticleCloud<dim> &cloud) const;

    /// Valid until the next reinit() or move().
    const Triangulation<dim> &triangulation() const
    {
      make_triangulation();
      return tria;
    }

    /// Valid until the next reinit() or move().
    const DoFHandler<dim> &dof_handler() const
    {
      make_triangulation();
      return dofs;
    }

    const Mapping<dim> &mapping() const
    {
      return map;
    }

  private:
    /// If it does not exist yet.
    void make_triangulation() const;

    FE_SimplexP<dim> fe;
    MappingFE<dim> map;
    mutable Triangulation<dim> tria;
    mutable DoFHandler<dim> dofs;
    mutable bool has_triangulation = true;

    unsigned int n_changes = 0;
    std::vector<Simplex<dim>> cells_of_particles;
    std::vector<Simplex<dim>> vertex_cells;
    std::vector<unsigned int> vertex_to_particle;
    std::vector<Point<dim>> positions; ///< of the vertices
    std::vector<BoundaryFace> faces;
    std::vector<unsigned int> fluids; ///< by cell; empty if all cells are of the first fluid
  };
} // namespace Lahar

#endif
