// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_solid_shape_h
#define lahar_geometry_solid_shape_h

#include <deal.II/base/point.h>

#include <deal.II/grid/tria_description.h>

#include <lahar/geometry/box.h>
#include <lahar/utilities/parameters.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The undeformed shape of one solid and its simplices.
   *
   * A model of this kind registers itself with Factory<SolidShape<dim>>; its parameters stand in the subsection of its
   * name in that of the solid.
   */
  template <int dim>
  class SolidShape
  {
  public:
    virtual ~SolidShape() = default;

    /// Read the shape's own subsection. @throws InputError for a shape without volume.
    virtual void parse_parameters(Parameters &prm) = 0;

    /// The smallest box around the shape.
    virtual Box<dim> box() const = 0;

    /// About how many nodes of finite elements of the given degree append() makes.
    virtual double estimate_size(const double size, const unsigned int degree) const = 0;

    /**
     * Append vertices and positively oriented cells, with the material id @p body.
     * @param size edge length (m) where the parameters do not give the number of elements.
     */
    virtual void append(const double size, const unsigned int body, std::vector<Point<dim>> &vertices,
                        std::vector<CellData<dim>> &cells) const = 0;

    /// The full path of the parameter that scales a shape from a file; empty for others.
    virtual std::string scale_path() const
    {
      return "";
    }
  };
} // namespace Lahar

#endif
