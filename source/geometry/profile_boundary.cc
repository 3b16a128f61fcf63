// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/boundary_shape.h>
#include <lahar/geometry/profile.h>
#include <lahar/utilities/factory.h>

#include <optional>

namespace Lahar
{
  /// Ground in the plane from a table.
  class ProfileBoundary : public BoundaryShape<2>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      Profile::declare_parameters(prm);
    }

    void parse_parameters(Parameters &prm) override
    {
      profile.emplace(prm);
    }

    std::vector<WallShape<2>> walls() const override
    {
      std::vector<WallShape<2>> result(1);
      result[0].corners = profile->points();
      return result;
    }

    std::vector<std::string> check_scale(const std::string &name, const double h) const override
    {
      return profile->check_scale(name, h);
    }

  private:
    std::optional<Profile> profile;
  };



  static const Factory<BoundaryShape<2>>::Registration<ProfileBoundary>
    profile_terrain("terrain", "The ground of a profile, y over x.");
} // namespace Lahar
