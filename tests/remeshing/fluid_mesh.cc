// SPDX-License-Identifier: GPL-3.0-or-later

// Test the fluid's mesh: volume, boundary faces, numbering, motion, recognised connectivity and shape gradients; and
// the particles' spacing: removal, insertion, and merging on the free surface without change of area.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <deal.II/fe/fe_values.h>

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/particle_spacing.h>

#include "tests.h"

using namespace Tests;

/// Particles on the lattice {0 … n}^dim h without the last ones in the first direction; walls below.
template <int dim>
ParticleCloud<dim> make_cloud(const unsigned int n, const double h)
{
  ParticleCloud<dim> cloud;
  for (unsigned int i = 0; i < std::pow(n + 1, dim); ++i)
  {
    Point<dim> p;
    for (unsigned int d = 0, k = i; d < dim; ++d, k /= n + 1)
      p[d] = h * (k % (n + 1));
    cloud.append(p, p[dim - 1] == 0. ? ParticleKind::wall : ParticleKind::fluid, h);
  }
  return cloud;
}

template <int dim>
std::vector<Simplex<dim>> cells_with_volume(const ParticleCloud<dim> &cloud)
{
  std::vector<Simplex<dim>> cells;
  for (const Simplex<dim> &simplex : delaunay(cloud.position))
    if (signed_volume<dim>(corners_of<dim>(simplex, cloud.position)) > 1e-12)
      cells.push_back(simplex);
  return cells;
}

template <int dim>
void test_mesh()
{
  const std::string name     = Utilities::int_to_string(dim) + "D ";
  const unsigned int n       = 4;
  const double h             = 0.25;
  ParticleCloud<dim> cloud   = make_cloud<dim>(n, h);
  const unsigned int outside = cloud.append(Point<dim>::unit_vector(0) * 3., ParticleKind::fluid, h);
  const std::vector<bool> no_outside(cloud.size(), false);

  // The particle outside has no cell; one more stands first in the cloud to make vertex and particle numbers differ.
  ParticleCloud<dim> shifted;
  shifted.append(Point<dim>::unit_vector(0) * -3., ParticleKind::fluid, h);
  for (unsigned int i = 0; i < cloud.size(); ++i)
    shifted.append(cloud.position[i], cloud.kind[i], h);
  std::vector<Simplex<dim>> cells;
  cloud.position.pop_back();
  for (Simplex<dim> cell : cells_with_volume<dim>(cloud))
  {
    for (unsigned int &corner : cell)
      ++corner;
    cells.push_back(cell);
  }
  FluidMesh<dim> mesh;
  check(name + "a first mesh is a change", mesh.reinit(shifted, cells));
  check(name + "volume", mesh.volume(shifted) - 1., 1e-13);
  check(name + "particles without a cell are no vertices",
        mesh.n_vertices() == outside && mesh.particle(0) == 1 && mesh.particles().back() == outside);
  check(name + "cells",
        mesh.n_cells() == cells.size() && mesh.triangulation().n_active_cells() == cells.size());
  check(name + "vertices of the triangulation", mesh.triangulation().n_vertices() == mesh.n_vertices());

  // Two parts: they know the boundary faces of the whole, and only these.
  double volume        = 0.;
  unsigned int n_faces = 0, n_free = 0;
  bool is_part = true;
  for (const bool first : {true, false})
  {
    std::vector<unsigned int> part_cells, vertices;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      if ((c < mesh.n_cells() / 3) == first)
        part_cells.push_back(c);
    for (unsigned int v = mesh.n_vertices(); v-- > 0;) // in any order
      if (std::any_of(part_cells.begin(), part_cells.end(), [&](const unsigned int c) {
            return std::count(mesh.cells()[c].begin(), mesh.cells()[c].end(), v) > 0;
          }))
        vertices.push_back(v);
    FluidMesh<dim> part;
    part.reinit_part(mesh, vertices, part_cells);
    volume += part.volume(shifted);
    n_faces += part.boundary_faces().size();
    for (const BoundaryFace &face : part.boundary_faces())
      n_free += face.free_surface;
    is_part = is_part && part.triangulation().n_active_cells() == part_cells.size();
    for (unsigned int c = 0; c < part.n_cells(); ++c)
      for (unsigned int I = 0; I <= dim; ++I)
        is_part = is_part && part.particle(part.cells()[c][I]) == mesh.particle_cells()[part_cells[c]][I] &&
                  part.triangulation().get_vertices()[part.cells()[c][I]] ==
                    shifted.position[part.particle(part.cells()[c][I])];
  }
  check(name + "parts: cells and vertices", is_part);
  check(name + "parts: volume", volume - 1., 1e-13);
  check(name + "parts: boundary faces",
        n_faces == mesh.boundary_faces().size() &&
          n_free == std::count_if(mesh.boundary_faces().begin(), mesh.boundary_faces().end(),
                                  [](const BoundaryFace &face) { return face.free_surface; }));

  const auto is_numbered = [&]() {
    bool numbered = mesh.dof_handler().n_dofs() == mesh.n_vertices();
    for (const auto &cell : mesh.dof_handler().active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        numbered = numbered && cell->vertex_dof_index(v, 0) == cell->vertex_index(v) &&
                   cell->vertex(v) == shifted.position[mesh.particle(cell->vertex_index(v))] &&
                   cell->vertex_index(v) == mesh.cells()[cell->active_cell_index()][v] &&
                   mesh.particle_cells()[cell->active_cell_index()][v] ==
                     mesh.particle(cell->vertex_index(v));
    return numbered;
  };
  check(name + "degree of freedom i is vertex i is its particle", is_numbered());

  const auto count_faces = [&]() {
    double area = 0., free_area = 0.;
    bool ordered = true;
    for (unsigned int f = 0; f < mesh.boundary_faces().size(); ++f)
    {
      const BoundaryFace &face = mesh.boundary_faces()[f];
      ordered                  = ordered && (f == 0 || mesh.boundary_faces()[f - 1].cell <= face.cell);
      const auto corners       = corners_of<dim>(mesh.particle_cells()[face.cell], shifted.position);
      const double face_area   = dim * signed_volume<dim>(corners) *
                               shape_gradients<dim>(corners)[face.opposite].norm();
      area += face_area;
      free_area += face.free_surface ? face_area : 0.;
    }
    AssertThrow(ordered, ExcMessage("Boundary faces must come in the order of their cells."));
    return std::array<double, 2>{{area, free_area}};
  };
  check(name + "area of the boundary", count_faces()[0] - 2. * dim, 1e-12);

  // Each boundary face by its cell and the sum of its vertices, which tells which corner is opposite.
  std::vector<std::array<unsigned int, 2>> faces, expected_faces;
  for (const BoundaryFace &face : mesh.boundary_faces())
  {
    faces.push_back({{face.cell, 0}});
    for (unsigned int c = 0; c <= dim; ++c)
      faces.back()[1] += (c != face.opposite) * mesh.cells()[face.cell][c];
  }
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f))
      {
        expected_faces.push_back({{cell->active_cell_index(), 0}});
        for (unsigned int v = 0; v < dim; ++v)
          expected_faces.back()[1] += cell->face(f)->vertex_index(v);
      }
  check(name + "boundary faces are deal.II's, in its order", faces == expected_faces);
  check(name + "area of the free surface: all but the floor", count_faces()[1] - (2. * dim - 1.), 1e-12);
  unsigned int n_on_surface = 0;
  for (const bool on_surface : mesh.on_free_surface(shifted.size()))
    n_on_surface += on_surface;
  const unsigned int n_inside = std::pow(n - 1, dim), n_inside_floor = std::pow(n - 1, dim - 1);
  check(name + "particles on the free surface",
        n_on_surface == mesh.n_vertices() - n_inside - n_inside_floor);

  // The sides x = 0 slide on slip facet 5, the sides x = 1 on different facets: these stay free.
  for (unsigned int i = 1; i <= outside; ++i)
  {
    if (shifted.position[i][0] == 0.)
      shifted.contact_facets[i][i % 2] = 5;
    if (shifted.position[i][0] == 1.)
      shifted.contact_facets[i][0] = 10 + i;
  }
  check(name + "the same connectivity is recognised", !mesh.reinit(shifted, cells));
  check(name + "faces on one common slip facet are no free surface", count_faces()[1] - (2. * dim - 2.),
        1e-12);

  // The same cells in another order and rotation, with moved particles.
  Random random;
  for (unsigned int i = 0; i < shifted.size(); ++i)
    shifted.position[i] += 0.1 * h * random.vector<dim>();
  std::reverse(cells.begin(), cells.end());
  for (Simplex<dim> &cell : cells)
  {
    std::swap(cell[0], cell[1]);
    std::swap(cell[1], cell[2]);
  }
  check(name + "also in another order", !mesh.reinit(shifted, cells));
  check(name + "vertices have moved", is_numbered());

  const QGaussSimplex<dim> quadrature(1);
  FEValues<dim> fe_values(mesh.mapping(), mesh.dof_handler().get_fe(), quadrature,
                          update_gradients | update_JxW_values);
  double gradient_error = 0., volume_error = 0.;
  for (const auto &cell : mesh.dof_handler().active_cell_iterators())
  {
    fe_values.reinit(cell);
    const auto corners = corners_of<dim>(mesh.particle_cells()[cell->active_cell_index()], shifted.position);
    volume_error = std::max(volume_error, std::abs(fe_values.JxW(0) / signed_volume<dim>(corners) - 1.));
    const auto gradients = shape_gradients<dim>(corners);
    for (unsigned int c = 0; c <= dim; ++c)
      gradient_error = std::max(gradient_error, h * (fe_values.shape_grad(c, 0) - gradients[c]).norm());
  }
  check(name + "FEValues has the gradients of the moved mesh", gradient_error, 1e-12);
  check(name + "FEValues has its volumes", volume_error, 1e-12);

  cells.pop_back();
  check(name + "one cell less is a change", mesh.reinit(shifted, cells) && mesh.n_cells() == cells.size());
  check(name + "numbering of the new mesh", is_numbered());
  check(name + "no cells", mesh.reinit(shifted, {}) && mesh.n_cells() == 0 && mesh.n_vertices() == 0 &&
                             mesh.boundary_faces().empty() && mesh.volume(shifted) == 0.);
}

/// Adapt the spacing of the particles and mesh them again.
template <int dim>
double adapted_volume(ParticleCloud<dim> &cloud, const std::string &longest_edge = "1.5",
                      const Walls<dim> &walls = Walls<dim>())
{
  FluidMesh<dim> mesh;
  mesh.reinit(cloud, cells_with_volume<dim>(cloud));
  OldDomain<dim> old_domain(cloud, mesh);
  ParticleSpacing<dim> spacing;
  parse(spacing, "subsection Particle spacing\n set Longest edge = " + longest_edge + "\nend\n");
  Migration<dim> migration;
  spacing.adapt(cloud, walls, mesh, old_domain, migration);
  mesh.reinit(cloud, cells_with_volume<dim>(cloud));
  return mesh.volume(cloud);
}

void test_spacing()
{
  ParticleCloud<2> cloud = make_cloud<2>(6, 1.);
  const unsigned int n   = cloud.size();
  adapted_volume<2>(cloud);
  check("a regular cloud stays", cloud.size() == n);

  cloud.append({2.4, 3.}, ParticleKind::fluid, 1.);
  check("an inner particle too near goes", (adapted_volume<2>(cloud), cloud.size() == n));
  cloud.append({2.4, 0.3}, ParticleKind::fluid, 1.);
  check("a fluid particle too near to the wall goes",
        (adapted_volume<2>(cloud), cloud.size() == n && cloud.n_particles(ParticleKind::wall) == 7));

  // Between two wall particles, farther from both than the shortest edge.
  WallFacet<2> facet{{{{6., 0.}, {0., 0.}}}};
  WallFacet<2> slip_facet = facet;
  slip_facet.lands        = true;
  ParticleCloud<2> sparse = make_cloud<2>(6, 1.);
  for (unsigned int i = 0; i < n; ++i)
    sparse.position[i][0] *= 1.4;
  sparse.append({2.1, 0.07}, ParticleKind::fluid, 1.);
  check("a particle close to a slip wall stays",
        (adapted_volume<2>(sparse, "10", Walls<2>({slip_facet})), sparse.size() == n + 1));
  check("a particle close to a no-slip wall goes and leaves its volume",
        adapted_volume<2>(sparse, "10", Walls<2>({facet})) - 36. * 1.4, 1e-12);
  check("the other ones stay", sparse.size() == n);

  // Edges of 1.6 h in the x direction: a particle in the middle of some, with the mean state.
  ParticleCloud<2> stretched = make_cloud<2>(6, 1.);
  for (unsigned int i = 0; i < n; ++i)
  {
    stretched.position[i][0] *= 1.6;
    stretched.position[i][1] *= 0.9;
    stretched.velocity[i] = Point<2>(stretched.position[i][1], 2. * stretched.position[i][0]);
    stretched.pressure[i] = stretched.position[i][0] - stretched.position[i][1];
  }
  const double volume = adapted_volume<2>(stretched);
  double error        = 0.;
  for (unsigned int i = n; i < stretched.size(); ++i)
    error = std::max(
      error,
      (stretched.velocity[i] - Point<2>(stretched.position[i][1], 2. * stretched.position[i][0])).norm() +
        std::abs(stretched.pressure[i] - stretched.position[i][0] + stretched.position[i][1]));
  check("long edges get particles", stretched.size() > n + 10);
  check("inserted particles have the linear field's state", error, 1e-13);
  check("insertion keeps the volume", volume - 36. * 1.6 * 0.9, 1e-12);

  // Two near particles on a curved free surface merge into one without change of area.
  ParticleCloud<2> round;
  const unsigned int m = 24;
  for (unsigned int i = 0; i < m; ++i)
  {
    const double angle = 2. * numbers::PI * (i == 1 ? 0.3 : i) / m;
    round.append({std::cos(angle), std::sin(angle)}, ParticleKind::fluid, 2. * numbers::PI / m);
  }
  for (unsigned int i = 0; i < 12; ++i)
    round.append({0.65 * std::cos(0.1 + i * numbers::PI / 6.), 0.65 * std::sin(0.1 + i * numbers::PI / 6.)},
                 ParticleKind::fluid, 2. * numbers::PI / m);
  FluidMesh<2> mesh;
  mesh.reinit(round, cells_with_volume<2>(round));
  const double area         = mesh.volume(round);
  const unsigned int before = round.size();
  const double after        = adapted_volume<2>(round, "10");
  check("two near surface particles merge", round.size() + 1 == before);
  check("merging keeps the area", after - area, 1e-12);

  ParticleCloud<3> cube  = make_cloud<3>(3, 1.);
  const unsigned int n_3 = cube.size();
  cube.append({1.3, 1.1, 1.}, ParticleKind::fluid, 1.);
  check("3D: an inner particle too near goes", (adapted_volume<3>(cube, "10"), cube.size() == n_3));
}

int main()
{
  test_mesh<2>();
  test_mesh<3>();
  test_spacing();
  return n_failed;
}
