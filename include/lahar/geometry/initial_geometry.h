// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_initial_geometry_h
#define lahar_geometry_initial_geometry_h

#include <lahar/boundary/solid_contour.h>
#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/initial_region.h>
#include <lahar/geometry/narrow_gap.h>
#include <lahar/geometry/wall_shape.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/utilities/parameters.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The initial fluid bodies and the rigid walls of a case.
   *
   * Fluid bodies are boxes, polygons (in the plane), convex polyhedra, truncated cones and cylinders (in space) and
   * physical groups of a gmsh file; walls are polylines (in the plane), plane polygons (in space) and physical groups. Bodies are filled
   * with particles at the mesh size, walls without slip carry particles at the same distance. Where a body touches a
   * wall, the wall's particles are the body's: in the plane its corners, in space all its points on the wall; so a
   * level surface meets the wall at its height. Of a mesh of the plane these are the ends of the rows of its edges along
   * the wall. What lies within 0.1 h of a wall without slip or of a solid touches it: no fluid particle stands there, the
   * wall's particles are the fluid's boundary, whatever the distance of the fluid's own points is. Where a wall passes
   * along a solid's contour, it has no particles; the first ones beside the solid stand at their usual distance from it.
   */
  template <int dim>
  class InitialGeometry
  {
  public:
    /// Declare the entries of subsection "Geometry".
    static void declare_parameters(Parameters &prm);

    /// Read subsection "Geometry". @throws InputError for a text that is no list of points, for an unknown file, or,
    /// unless there are solids, if there is no fluid.
    void parse_parameters(Parameters &prm, const bool has_solids);

    bool has_fluid() const
    {
      return !bodies.empty();
    }

    /**
     * Fill @p walls and, after the solids' particles that are there already, @p cloud with spacing @p h (m).
     * @throws InputError if there is no fluid, if a body is smaller than @p h, if there would be too many particles, if bodies,
     * walls and solids overlap.
     */
    void create(const MeshSize<dim> &h, const SolidContour<dim> &solids, ParticleCloud<dim> &cloud,
                Walls<dim> &walls) const;

    /// Whether a simplex of the particles that create() made belongs to the bodies (InitialRegion), or to the gap below
    /// 0.1 h between one of them and a wall or solid. Valid as long as this object.
    std::function<bool(const Simplex<dim> &, const ParticleCloud<dim> &)> region() const;

    /// How messages call the wall that facet @p facet of create()'s walls belongs to.
    std::string wall_name(unsigned int facet) const;

    /// The narrowest gap between walls and @p solids with fewer than @p most mesh sizes across.
    std::optional<NarrowGap<dim>> narrow_gap(const MeshSize<dim> &h, const SolidContour<dim> &solids,
                                             const double most) const;

    /// Of all bodies (area in 2D).
    double fluid_volume() const
    {
      return InitialRegion<dim>(bodies).volume();
    }

    /// What is odd about the mesh file at the spacing @p h (m): walls out of all proportion to it.
    std::vector<std::string> warnings(const double h) const;

  private:
    void parse_bodies(Parameters &prm);
    void parse_walls(Parameters &prm, const std::string &entry, const bool slip);
    void parse_mesh_file(Parameters &prm);

    /// @throws InputError if the fluid's mesh is far finer or coarser than @p h.
    void check_mesh_scale(const double h) const;

    /// The points of each body.
    using Fillings = std::vector<std::vector<Point<dim>>>;

    void check_body_sizes(const double h) const;
    void check_number_of_particles(const MeshSize<dim> &mesh_size) const;
    void check_overlaps(const Fillings &fillings, const double h) const;
    void check_solids(const Fillings &fillings, const SolidContour<dim> &solids, const double h) const;

    /// Points where bodies and solids touch @p wall.
    std::vector<Point<dim>> contacts(const WallShape<dim> &wall, const Fillings &fillings,
                                     const SolidContour<dim> &solids, const MeshSize<dim> &h) const;

    /// Fill @p walls. @return the particles of those without slip.
    std::vector<Point<dim>> create_walls(const MeshSize<dim> &h, const Fillings &fillings,
                                         const SolidContour<dim> &solids, Walls<dim> &walls) const;

    std::vector<std::unique_ptr<FluidBody<dim>>> bodies;
    std::vector<WallShape<dim>> wall_shapes;
    unsigned int max_particles = 0;
    double mesh_scale          = 1.;
    std::map<std::string, double>
      mesh_edges; ///< of the mesh file's groups of fluid the mean length of edges, m
    std::vector<Point<dim>> mesh_wall_corners; ///< of the walls from the mesh file
  };
} // namespace Lahar

#endif
