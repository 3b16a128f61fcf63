// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_initial_boundary_h
#define lahar_initial_boundary_h

#include <lahar/boundary/boundary_motion.h>
#include <lahar/boundary/inflow.h>
#include <lahar/boundary/outflow.h>
#include <lahar/boundary/surface_law.h>
#include <lahar/geometry/boundary_shape.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * A named boundary of a case: where it is, how it moves and how fluid moves along it.
   */
  template <int dim>
  class Boundary
  {
  public:
    static void declare_parameters(Parameters &prm);

    /// Read the handler's current section, of the boundary's name. @throws InputError
    void parse_parameters(Parameters &prm, const std::string &name);

    /// @throws InputError if it is not where its shape is drawn at the run's @p start_time (s).
    void check_start(const double start_time) const;

    /// Its walls as facets with the boundary's @p number, with names as "'bed'" or "group 'left' of 'bed'" for messages.
    std::vector<WallShape<dim>> walls(const unsigned int number) const;

    /// What is odd at the mesh size @p h (m): a shape from a file out of all proportion to it. @throws InputError where
    /// that leads nowhere.
    std::vector<std::string> warnings(const double h) const;

    /// Its law, if fluid comes in through it or leaves; null otherwise.
    const Inflow *inflow() const
    {
      return dynamic_cast<const Inflow *>(law.get());
    }

    const Outflow *outflow() const
    {
      return dynamic_cast<const Outflow *>(law.get());
    }

    std::string name, path; ///< the latter of the entry `Motion`
    std::unique_ptr<BoundaryShape<dim>> shape;
    std::unique_ptr<SurfaceLaw> law;
    std::unique_ptr<BoundaryMotion<dim>> motion;
    std::optional<double>
      tensile_strength; ///< Pa; none if fluid does not leave it where it pulls, see WallSeparation
  };
} // namespace Lahar

#endif
