// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/boundary_shape.h>
#include <lahar/geometry/terrain.h>
#include <lahar/utilities/factory.h>

#include <optional>

namespace Lahar
{
  /// Ground from an elevation grid.
  class TerrainBoundary : public BoundaryShape<3>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      Terrain::declare_parameters(prm);
    }

    void parse_parameters(Parameters &prm) override
    {
      terrain.emplace(prm);
    }

    std::vector<WallShape<3>> walls() const override
    {
      std::vector<WallShape<3>> result(1);
      result[0].mesh_facets = terrain->triangles();
      return result;
    }

    std::vector<std::string> check_scale(const std::string &name, const double h) const override
    {
      return terrain->check_scale(name, h);
    }

  private:
    std::optional<Terrain> terrain;
  };



  static const Factory<BoundaryShape<3>>::Registration<TerrainBoundary>
    terrain("terrain", "The ground of an elevation grid, z over x and y.");
} // namespace Lahar
