// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_fluid_body_h
#define lahar_geometry_fluid_body_h

#include <lahar/geometry/box.h>
#include <lahar/geometry/mesh_size.h>

#include <string>
#include <utility>
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

    /// Distance of @p point from the contour, negative inside, m; its absolute value is right near the contour.
    virtual double signed_distance(const Point<dim> &point) const = 0;

    /// About how many points fill() works on.
    virtual double estimate_size(const double h) const;

    /// Particles of the body at the distance @p h, on its contour too.
    virtual std::vector<Point<dim>> fill(const MeshSize<dim> &h) const = 0;

    /// Its corners, as far as it has such.
    virtual std::vector<Point<dim>> corners() const
    {
      return {};
    }

  private:
    std::string body_name;
  };

  /// The points of physical groups of a mesh file. Overlaps with other things are not seen: it has no contour.
  template <int dim>
  class MeshBody : public FluidBody<dim>
  {
  public:
    MeshBody(const std::string &name, const std::vector<Point<dim>> &nodes);

    Box<dim> box() const override;

    /// Infinite.
    double signed_distance(const Point<dim> &) const override;

    double estimate_size(const double) const override;

    /// The nodes, whatever the mesh size.
    std::vector<Point<dim>> fill(const MeshSize<dim> &) const override;

  private:
    std::vector<Point<dim>> nodes;
  };

  /// The smallest box around @p points, of which there must be one.
  template <int dim>
  Box<dim> box_around(const std::vector<Point<dim>> &points);
} // namespace Lahar

#endif
