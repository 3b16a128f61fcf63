// SPDX-License-Identifier: GPL-3.0-or-later

// Test that the Delaunay simplices that the ranks find, each around its own points, are together those that one rank
// finds in all points, each once: random clouds, lattices whose points are cospherical, points that stand twice, clouds of
// very different density, points far away, flat simplices of bent surfaces between two bodies; in 2D and 3D, on one rank
// and on several.

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/local_delaunay.h>

#include <algorithm>

#include "tests.h"

using namespace Tests;

template <int dim>
struct Cloud
{
  std::string name;
  double spacing;
  std::vector<Point<dim>> points;
};

/// Integer vectors with n_1, n_2, … entries; the first index runs fastest.
template <int dim>
std::vector<Tensor<1, dim>> grid(const std::array<unsigned int, 3> &n)
{
  std::vector<Tensor<1, dim>> result;
  for (unsigned int k = 0; k < (dim == 3 ? n[2] : 1); ++k)
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
      {
        Tensor<1, dim> x;
        x[0] = i;
        x[1] = j;
        if (dim == 3)
          x[2] = k;
        result.push_back(x);
      }
  return result;
}

template <int dim>
Cloud<dim> scaled(const std::string &name, const double h, const std::vector<Tensor<1, dim>> &places)
{
  Cloud<dim> cloud{name, h, {}};
  for (const Tensor<1, dim> &x : places)
    cloud.points.push_back(Point<dim>(h * x));
  return cloud;
}

template <int dim>
std::vector<Cloud<dim>> clouds()
{
  constexpr double h                      = 0.03;
  const std::array<unsigned int, 3> sizes = dim == 2 ? std::array<unsigned int, 3>{{40, 25, 1}}
                                                     : std::array<unsigned int, 3>{{14, 10, 8}};
  const std::vector<Tensor<1, dim>> cubic = grid<dim>(sizes);
  Random random;
  std::vector<Cloud<dim>> result;

  result.push_back(scaled("cubic lattice", h, cubic));

  std::vector<Tensor<1, dim>> places = cubic;
  for (Tensor<1, dim> &x : places)
    if (dim == 2)
    {
      x[0] += 0.5 * (static_cast<unsigned int>(x[1]) % 2);
      x[1] *= std::sqrt(0.75);
    }
    else
      for (unsigned int d = 1; d < dim; ++d)
        x[d] += 0.5 * (static_cast<unsigned int>(x[d - 1]) % 2);
  result.push_back(scaled(dim == 2 ? "hexagonal lattice" : "sheared lattice", h, places));

  places = cubic;
  Tensor<1, dim> diagonal;
  for (unsigned int d = 0; d < dim; ++d)
    diagonal[d] = 1.;
  for (const Tensor<1, dim> &x : cubic)
    places.push_back(x + 0.5 * diagonal);
  result.push_back(scaled("body-centred lattice", h, places));

  // Every third point of a lattice and of a random cloud twice, the copies in another order.
  places = cubic;
  for (unsigned int i = 0; i < cubic.size(); i += 3)
    places.push_back(cubic[cubic.size() - 1 - i]);
  result.push_back(scaled("lattice with points twice", h, places));

  places.clear();
  for (unsigned int i = 0; i < 1000; ++i)
    places.push_back(10. * random.vector<dim>());
  result.push_back(scaled("random", dim == 2 ? h : 2. * h, places));
  for (unsigned int i = 0; i < 300; ++i)
    places.push_back(places[2 * i + 1]);
  result.push_back(scaled("random with points twice", dim == 2 ? h : 2. * h, places));

  // Ever denser towards the origin.
  for (Tensor<1, dim> &x : places)
    x *= x.norm_square() / 100.;
  result.push_back(scaled("graded", h, places));

  // A lattice in a vortex and shear flow, with drops far away, one of them on the axis of the box.
  places = cubic;
  for (Tensor<1, dim> &x : places)
  {
    const double a = x[0] / 7., b = x[1] / 5.;
    x[0] += 1.7 * std::sin(b) + 0.1 * random.number();
    x[1] += 2.3 * std::cos(a) + 0.1 * random.number();
    x[dim - 1] += 0.3 * std::sin(a + b);
  }
  for (const double far : {-300., 40., 1e4})
  {
    Tensor<1, dim> x;
    x[0] = far;
    x[1] = 12.;
    places.push_back(x);
  }
  result.push_back(scaled("after a flow", h, places));

  // Two bodies with bent surfaces far from each other: circles through three neighbours of one reach the other one.
  places.clear();
  for (const Tensor<1, dim> &x : cubic)
    for (const double side : {-1., 1.})
    {
      Tensor<1, dim> y   = x;
      const double bulge = (x[0] - 0.5 * sizes[0]) * (x[0] - 0.5 * sizes[0]) +
                           (dim == 3 ? (x[2] - 4.) * (x[2] - 4.) : 0.);
      y[1] = side * (x[1] + 40. + 0.002 * bulge) + 0.02 * random.number();
      places.push_back(y);
    }
  result.push_back(scaled("two bodies", h, places));
  return result;
}

template <int dim>
void test(const Cloud<dim> &cloud)
{
  const std::string name  = Utilities::int_to_string(dim) + "D, " + cloud.name + ": ";
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const auto &points      = cloud.points;
  constexpr double alpha  = 2.5;
  const double h          = cloud.spacing;

  // Every fifth point is a wall particle. This rank keeps its own particles and those around.
  const auto is_fluid = [](const unsigned int i) { return i % 5 != 0; };
  ParticleCloud<dim> particles;
  for (unsigned int i = 0; i < points.size(); ++i)
    particles.append(points[i], is_fluid(i) ? ParticleKind::fluid : ParticleKind::wall, h);
  Migration<dim> migration(MPI_COMM_WORLD);
  migration.distribute(particles, 4. * alpha * h, 0);
  std::vector<bool> own;
  for (unsigned int i = 0; i < particles.size(); ++i)
    own.push_back(particles.is_own(i) && particles.kind[i] == ParticleKind::fluid);

  // As for the remesher, but for what makes a simplex fluid.
  const auto is_candidate = [&](const SimplexCorners<dim> &x) {
    double longest = 0.;
    for (unsigned int a = 0; a <= dim; ++a)
      for (unsigned int b = 0; b < a; ++b)
        longest = std::max(longest, x[a].distance(x[b]));
    return signed_volume<dim>(x) > 1e-6 * std::pow(h, dim) &&
           std::min(longest, circumradius<dim>(x)) < alpha * h;
  };

  std::vector<Simplex<dim>> expected, part, found;
  unsigned int n_flat = 0;
  for (const Simplex<dim> &simplex : delaunay(points))
    if (std::any_of(simplex.begin(), simplex.end(), is_fluid) &&
        is_candidate(corners_of<dim>(canonical<dim>(simplex), points)))
    {
      expected.push_back(canonical<dim>(simplex));
      n_flat += circumradius<dim>(corners_of<dim>(simplex, points)) > 20. * h;
    }
  for (Simplex<dim> simplex : local_delaunay<dim>(
         particles, own, 2. * alpha * h,
         [&](const Simplex<dim> &corners) {
           return std::any_of(corners.begin(), corners.end(),
                              [&](const unsigned int i) {
                                return particles.kind[i] == ParticleKind::fluid;
                              }) &&
                  particles.is_own(corners) && is_candidate(corners_of<dim>(corners, particles.position));
         },
         migration))
  {
    for (unsigned int &corner : simplex)
      corner = particles.number[corner];
    part.push_back(simplex);
  }
  for (const auto &simplices : Utilities::MPI::all_gather(MPI_COMM_WORLD, part))
    found.insert(found.end(), simplices.begin(), simplices.end());
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  check(name + "many simplices", expected.size() > 500);
  check(name + "the same simplices", expected == found);
  if (expected != found && rank == 0)
    std::cout << "    " << found.size() << " instead of " << expected.size() << std::endl;
  if (cloud.name == "two bodies")
    check(name + "some are flat", n_flat > 10);
}

template <int dim>
void test_duplicates()
{
  // The first of the points in one place has the simplices, in whatever order they come.
  std::vector<Point<dim>> points = clouds<dim>()[4].points;
  const unsigned int n           = points.size();
  for (unsigned int i = 0; i < n; ++i)
    points.push_back(points[(7 * i) % n]);
  bool first = true;
  for (const Simplex<dim> &simplex : delaunay(points))
    for (const unsigned int i : simplex)
      first = first && i < n;
  check(Utilities::int_to_string(dim) + "D: the first of points in the same place has simplices", first);

  std::vector<Simplex<dim>> parts[2];
  for (const bool reverse : {false, true})
  {
    DelaunayTriangulation<dim> triangulation(points);
    for (unsigned int i = 0; i < points.size(); i += 50)
    {
      std::vector<unsigned int> indices;
      for (unsigned int k = i; k < std::min<unsigned int>(i + 50, points.size()); ++k)
        indices.push_back(reverse ? points.size() - 1 - k : k);
      triangulation.insert(indices);
    }
    for (const Simplex<dim> &simplex : triangulation.simplices())
      parts[reverse].push_back(canonical<dim>(simplex));
    std::sort(parts[reverse].begin(), parts[reverse].end());
  }
  check(Utilities::int_to_string(dim) + "D: the order of insertion is of no effect", parts[0] == parts[1]);
}

template <int dim>
void test_all()
{
  for (const Cloud<dim> &cloud : clouds<dim>())
    test(cloud);
  test_duplicates<dim>();
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_all<2>();
  test_all<3>();
  return n_failed > 0;
}
