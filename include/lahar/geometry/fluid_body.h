// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_fluid_body_h
#define lahar_geometry_fluid_body_h

#include <lahar/geometry/box.h>
#include <lahar/geometry/divided_points.h>
#include <lahar/geometry/mesh_size.h>
#include <lahar/geometry/walls.h>

#include <array>
#include <string>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * A body of fluid at the start. Derived classes know its shape.
   */
  template <int dim>
  class FluidBody
  {
  public:
    /// @param name how messages to the user call it.
    explicit FluidBody(const std::string &name)
      : body_name(name)
    {}

    virtual ~FluidBody() = default;

    const std::string &name() const
    {
      return body_name;
    }

    virtual Box<dim> box() const = 0;

    /// Volume (area in the plane, with rotational symmetry of the whole body).
    virtual double volume() const = 0;

    /// Distance of @p point from the contour, negative inside, m; its absolute value is right near the contour, and never
    /// larger than the distance.
    virtual double signed_distance(const Point<dim> &point) const = 0;

    /// How far the contour may lie off what it stands for, m: chords of a curved wall, say.
    virtual double roughness() const
    {
      return 0.;
    }

    /// About how many points fill() works on.
    virtual double estimate_size(const double h) const;

    /// Particles of the body at the distance @p h, on its contour too; each rank has those in its part of space.
    /// Collective.
    virtual DividedPoints<dim> fill(const MeshSize<dim> &h, const MPI_Comm &communicator) const = 0;

    /// The facets of a contour that is made of many small ones.
    virtual std::vector<std::array<Point<dim>, dim>> contour() const
    {
      return {};
    }

    /// Its corners, as far as it has such.
    virtual std::vector<Point<dim>> corners() const
    {
      return {};
    }

    /**
     * A particle of the body that lies nearer than @p reach (m) to facets on which fluid lands is put onto them: off them
     * by contact_offset times its spacing @p h, on the body's side. Other facets do not lie between it and its place.
     */
    Point<dim> onto_walls(Point<dim> particle, const Walls<dim> &walls, const double h,
                          const double reach) const;

  private:
    std::string body_name;
  };

  /// The smallest box around @p points, of which there must be one.
  template <int dim>
  Box<dim> box_around(const std::vector<Point<dim>> &points);
} // namespace Lahar

#endif
