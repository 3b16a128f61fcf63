// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_ground_of_boundary_h
#define lahar_geometry_ground_of_boundary_h

#include <lahar/utilities/parameters.h>

#include <string>
#include <vector>

namespace Lahar
{
  /// Enters the subsection of the shape 'terrain' of the boundary that an entry of the current section names; back to
  /// where the handler was when it goes out of scope.
  class InGroundOfBoundary
  {
  public:
    /// @throws InputError with the names of the boundaries that have the shape.
    explicit InGroundOfBoundary(Parameters &prm, const std::string &entry = "Boundary");
    ~InGroundOfBoundary();

    InGroundOfBoundary(const InGroundOfBoundary &)            = delete;
    InGroundOfBoundary &operator=(const InGroundOfBoundary &) = delete;

  private:
    Parameters &prm;
    std::vector<std::string> here;
  };
} // namespace Lahar

#endif
