#ifndef lahar_geometry_initial_geometry_h
#define lahar_geometry_initial_geometry_h

#include <lahar/boundary/solid_contour.h>
#include <lahar/boundary/walls.h>
#include <lahar/geometry/polygon.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/utilities/parameters.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The initial fluid bodies and the rigid walls of a plane case.
   *
   * Fluid bodies are rectangles, polygons and physical groups of a gmsh file; walls are polylines and physical groups.
   * Bodies are filled with particles at the mesh size, walls without slip carry particles at the same distance. Where a
   * body's corner lies on a wall, the wall has a particle there, so that a level surface meets the wall at its height.
   * A fluid particle that would coincide with a wall particle gives way to it, and both to a solid's. Where a wall
   * passes along a solid's contour, it has no particles; the first ones beside the solid stand at their usual distance
   * from it.
   */
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
     * @return by particle, whether a wall particle stands where a body touches the wall (true for fluid particles).
     * @throws InputError if there is no fluid, if a body is smaller than @p h, if bodies, walls and solids overlap.
     */
    std::vector<bool> create(const double h, const SolidContour<2> &solids, ParticleCloud<2> &cloud,
                             Walls<2> &walls) const;

  private:
    struct Body
    {
      std::string name;
      Polygon contour;             ///< empty for a body from a mesh file
      std::vector<Point<2>> nodes; ///< of a body from a mesh file
    };

    struct Line
    {
      std::string name;
      std::vector<Point<2>> corners;
      bool closed = false;
      bool slip   = false;
    };

    void parse_bodies(Parameters &prm);
    void parse_lines(Parameters &prm, const std::string &entry, const bool slip);
    void parse_mesh_file(Parameters &prm);

    void check_body_sizes(const double h) const;
    void check_overlaps(const double h) const;
    void check_solids(const SolidContour<2> &solids, const double h) const;
    /// The line's corners, and the corners of bodies and the ends of solids that lie on it.
    std::vector<Point<2>> with_contact_points(const Line &line, const SolidContour<2> &solids,
                                              const double h) const;

    std::vector<Body> bodies;
    std::vector<Line> lines;
  };
} // namespace Lahar

#endif
