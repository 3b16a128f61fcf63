// SPDX-License-Identifier: GPL-3.0-or-later

// Test that a floor of two triangles is as a floor of one: a block of fluid on it whose edges are too long gets the same
// particles, those on the floor in contact with it, wherever the line between the triangles runs. And that a floor bent
// along that line is no free surface either, and that particles close to each other on both sides of the line merge.

#include <lahar/remeshing/wall_faces.h>

#include "plain_region.h"

using namespace Tests;

struct Block
{
  ParticleCloud<3> cloud;
  Walls<3> walls;
  FluidMesh<3> mesh;

  /// Stretched and disturbed particles on a square floor of two triangles, divided along one or the other diagonal; or on
  /// a single triangle. The floor's other two corners are lifted by @p bend of their distance from the diagonal.
  explicit Block(const unsigned int kind, const double bend = 0.)
  {
    std::array<Point<3>, 4> c{{{-20., -20., 0.}, {20., -20., 0.}, {20., 20., 0.}, {-20., 20., 0.}}};
    const auto lift = [bend](const Point<3> &p) { return bend * std::abs(p[0] - p[1]) / std::sqrt(2.); };
    for (Point<3> &corner : c)
      corner[2] = lift(corner);
    std::vector<WallFacet<3>> facets;
    if (kind == 0)
      facets = {{{{{-50., -50., 0.}, {100., -50., 0.}, {-50., 100., 0.}}}, true}};
    else if (kind == 1)
      facets = {{{{c[0], c[1], c[2]}}, true}, {{{c[0], c[2], c[3]}}, true}};
    else
      facets = {{{{c[0], c[1], c[3]}}, true}, {{{c[1], c[2], c[3]}}, true}};
    walls = Walls<3>(facets);
    Random random;
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        for (unsigned int k = 0; k < 5; ++k)
        {
          Point<3> p(1.25 * (i - 2.5), 1.25 * (j - 2.5), 0.9 * k);
          p += 0.15 * random.vector<3>();
          // Two close to each other on the two sides of the diagonal.
          if (bend != 0. && k == 0 && i == 2 && j == 2)
            p[0] = p[1] + 0.1;
          p[2] = (k == 0 ? contact_offset : p[2]) + lift(p);
          cloud.append(p, ParticleKind::fluid, 1.);
          if (k == 0)
            for (unsigned int f = 0; f < facets.size() && !cloud.in_contact(cloud.size() - 1); ++f)
              if (walls.is_above(f, p, 0.))
                cloud.contact_facets.back()[0] = f;
        }
    if (bend != 0.)
    {
      Point<3> p = cloud.position[(2 * 6 + 2) * 5];
      std::swap(p[0], p[1]);
      cloud.append(p, ParticleKind::fluid, 1.);
      cloud.contact_facets.back()[0] = walls.is_above(0, p, 0.) ? 0 : 1;
    }
    Remesher<3> remesher;
    parse(remesher);
    remesher.create_mesh(cloud, walls, {}, plain_region<3>(walls), mesh);
    n_faces = free_surface_faces(mesh, cloud, walls).size();
    for (const BoundaryFace &face : free_surface_faces(mesh, cloud, walls))
    {
      const Simplex<3> &cell = mesh.particle_cells()[face.cell];
      bool all               = true;
      for (unsigned int corner = 0; corner < 4; ++corner)
        all = all && (corner == face.opposite || cloud.in_contact(cell[corner]));
      n_of_floor += all;
    }
    n_first = cloud.size();
    Migration<3> alone;
    remesher.adapt_first_particles(cloud, walls, mesh, alone);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        n_close += cloud.in_contact(i) && cloud.in_contact(j) &&
                   cloud.position[i].distance(cloud.position[j]) < 0.3;
  }

  unsigned int n_faces, n_first, n_of_floor = 0, n_close = 0;
};

int main()
{
  const Block one(0);
  check("particles are inserted", one.cloud.size() > one.n_first);
  unsigned int n_on_floor = 0;
  for (unsigned int i = one.n_first; i < one.cloud.size(); ++i)
    n_on_floor += one.cloud.in_contact(i);
  check("some of them on the floor", n_on_floor > 0);
  for (const unsigned int kind : {1, 2})
  {
    const Block two(kind);
    const std::string name = "diagonal " + std::to_string(kind) + ": ";
    check(name + "as many faces of the free surface", two.n_faces == one.n_faces);
    check(name + "as many particles", two.cloud.size() == one.cloud.size());
    double distance   = 0.;
    bool same_contact = true;
    for (unsigned int i = 0; i < std::min(two.cloud.size(), one.cloud.size()); ++i)
    {
      distance     = std::max(distance, two.cloud.position[i].distance(one.cloud.position[i]));
      same_contact = same_contact && two.cloud.in_contact(i) == one.cloud.in_contact(i);
    }
    check(name + "in the same places", distance, 0.);
    check(name + "in contact with the floor", same_contact);
  }
  for (const double bend : {0.15, -0.15})
  {
    const Block bent(1, bend);
    const std::string name = bend > 0. ? "hollow: " : "bulge: ";
    check(name + "no face of the floor is free surface", bent.n_of_floor == 0);
    check(name + "no particles on the floor are close to each other", bent.n_close == 0);
  }
  return n_failed;
}
