// SPDX-License-Identifier: GPL-3.0-or-later

// Test that no cell lies inside a solid in space: fluid before the foot of a box and a little below it makes none with
// nodes of the front and of the foot; cells at its faces, over its rims and over chords of a bent plate stay.

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/remesher.h>
#include <lahar/remeshing/solid_interior.h>

#include <map>

#include "../tests.h"

using namespace Tests;

constexpr double h = 0.1;

/// A solid's contour: nodes that stand first in a cloud, and facets with normals out of it.
struct Contour
{
  ParticleCloud<3> cloud;
  std::vector<std::array<unsigned int, 3>> facets;
  std::map<std::array<int, 3>, unsigned int> node;

  /// The surface of n[0] x n[1] x n[2] boxes, of which @p place gives the corners.
  template <typename Place>
  Contour(const std::array<int, 3> &n, const Place &place)
  {
    const auto at = [&](const std::array<int, 3> &index) {
      const auto [entry, is_new] = node.try_emplace(index, cloud.size());
      if (is_new)
        cloud.append(place(index), ParticleKind::solid, h);
      return entry->second;
    };
    for (int axis = 0; axis < 3; ++axis)
      for (const int end : {0, n[axis]})
        for (int i = 0; i < n[(axis + 1) % 3]; ++i)
          for (int j = 0; j < n[(axis + 2) % 3]; ++j)
          {
            const auto corner = [&](const int a, const int b) {
              std::array<int, 3> index;
              index[axis]           = end;
              index[(axis + 1) % 3] = i + a;
              index[(axis + 2) % 3] = j + b;
              return at(index);
            };
            for (std::array<unsigned int, 3> facet :
                 {std::array<unsigned int, 3>{{corner(0, 0), corner(1, 0), corner(1, 1)}},
                  std::array<unsigned int, 3>{{corner(0, 0), corner(1, 1), corner(0, 1)}}})
            {
              if (end == 0)
                std::swap(facet[1], facet[2]);
              facets.push_back(facet);
            }
          }
  }

  unsigned int operator()(const int i, const int j, const int k) const
  {
    return node.at({{i, j, k}});
  }

  Walls<3> walls() const
  {
    std::vector<WallFacet<3>> result;
    for (const auto &facet : facets)
      result.push_back({{{cloud.position[facet[0]], cloud.position[facet[1]], cloud.position[facet[2]]}}});
    return Walls<3>(result);
  }
};

/// On ground that rises along x: a box on it has a sloping foot.
Point<3> on_slope(const double x, const double y, const double z)
{
  return {x, y, z + 0.3 * x};
}

void test_foot()
{
  Contour box({{2, 5, 3}}, [](const std::array<int, 3> &i) {
    return on_slope(-h + 0.5 * h * i[0], 0.83 * h * i[1], 0.63 * h * i[2]);
  });
  const unsigned int front = box(2, 2, 1), foot = box(1, 2, 0), beside = box(1, 3, 0);
  ParticleCloud<3> &cloud  = box.cloud;
  const unsigned int fluid = cloud.append(on_slope(0.2 * h, 2.1 * h, -0.06 * h), ParticleKind::fluid, h);
  const SolidInterior<3> inside(box.facets, cloud);
  check("inside: two nodes of the foot and one of the front",
        inside.holds_edge_of({{front, foot, beside, fluid}}, cloud));
  check("inside: nodes of opposite faces",
        inside.holds_edge_of({{box(0, 2, 1), box(2, 2, 1), box(2, 3, 1), fluid}}, cloud));
  check("no cell at the front is inside",
        !inside.holds_edge_of({{front, box(2, 3, 1), box(2, 2, 0), fluid}}, cloud));
  check("no cell over a rim is inside", !inside.holds_edge_of({{box(2, 2, 0), foot, beside, fluid}}, cloud));
  cloud.position[fluid] = on_slope(-0.3 * h, 2.1 * h, 2.3 * h);
  check("inside: from the front over the crest",
        inside.holds_edge_of({{box(2, 2, 2), box(2, 2, 3), box(2, 3, 3), fluid}}, cloud));
  check("no cell on top is inside",
        !inside.holds_edge_of({{box(2, 2, 3), box(1, 2, 3), box(2, 3, 3), fluid}}, cloud));
  cloud.position[fluid] = on_slope(0.2 * h, 2.1 * h, -0.06 * h);

  // Fluid along the front, its lowest layer a little below the foot.
  for (int layer = 0; layer < 3; ++layer)
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 4; ++row)
        cloud.append(on_slope((0.13 + 0.8 * column) * h, (0.55 + 0.83 * row + 0.1 * column) * h,
                              (0.9 * layer - 0.06) * h),
                     ParticleKind::fluid, h);
  const Walls<3> walls = box.walls();
  Remesher<3> remesher;
  parse(remesher);
  const auto cells_inside = [&](const std::vector<std::array<unsigned int, 3>> &facets) {
    FluidMesh<3> mesh;
    remesher.create_mesh(
      cloud, walls, facets, [](const auto &, const auto &) { return true; }, mesh);
    unsigned int n = 0;
    for (const Simplex<3> &cell : mesh.particle_cells())
    {
      const Point<3> middle = centroid<3>(corners_of<3>(cell, cloud.position));
      n += middle[0] < 0. && middle[0] > -h && middle[2] > 0.3 * middle[0];
    }
    return n;
  };
  check("a mesh that does not know the contour has cells inside the box", cells_inside({}) > 0);
  check("one that knows it has none", cells_inside(box.facets) == 0);
}

void test_bend()
{
  // A plate bent by 8 degrees from node to node: fluid lies on its bulging side over two of them.
  const double radius = 0.7;
  const Contour plate({{6, 6, 1}}, [radius](const std::array<int, 3> &i) {
    const double angle = 8. * numbers::PI / 180. * i[0], r = radius + 0.5 * h * i[2];
    return Point<3>(r * std::sin(angle), h * i[1], r * std::cos(angle));
  });
  ParticleCloud<3> cloud   = plate.cloud;
  const unsigned int fluid = cloud.append({0.22, 0.25, 0.77}, ParticleKind::fluid, h);
  const SolidInterior<3> inside(plate.facets, cloud);
  check("a chord of a bulging face is not inside",
        !inside.holds_edge_of({{plate(1, 2, 1), plate(3, 2, 1), plate(2, 3, 1), fluid}}, cloud));
  check("through the bent plate is inside",
        inside.holds_edge_of({{plate(2, 2, 0), plate(2, 2, 1), plate(2, 3, 1), fluid}}, cloud));
}

int main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_foot();
  test_bend();
  return n_failed > 0;
}
