// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/interface_correction.h>
#include <lahar/remeshing/interface_faces.h>
#include <lahar/remeshing/volume_correction.h>

#include <Eigen/QR>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// No particle moves by more than this times its spacing.
    constexpr double longest_shift = 0.1;

    /// Fluids that share less than this part of the largest interface do not count as neighbours.
    constexpr double smallest_area = 1e-12;

    /// λ of the given areas (n × n, symmetric) and excesses; fluids without neighbours get zero.
    std::vector<double> solve(const std::vector<double> &areas, const std::vector<double> &excess)
    {
      const unsigned int n   = excess.size();
      const double largest   = *std::max_element(areas.begin(), areas.end());
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
      for (unsigned int f = 0; f < n; ++f)
        for (unsigned int g = 0; g < n; ++g)
          if (areas[f * n + g] > smallest_area * largest)
          {
            matrix(f, g) = -areas[f * n + g];
            matrix(f, f) += areas[f * n + g];
          }
      // Of connected fluids λ is known up to a constant: the smallest one.
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
      factors.setThreshold(1e-10);
      factors.compute(matrix);
      const Eigen::VectorXd lambda = factors.solve(Eigen::Map<const Eigen::VectorXd>(excess.data(), n));
      return {lambda.begin(), lambda.end()};
    }

    /// The two fluids of a set; the same one twice if there are not two.
    std::pair<unsigned int, unsigned int> two_of(const FluidSet fluids)
    {
      const unsigned int first  = first_fluid(fluids);
      const FluidSet without    = fluids & ~fluid_set(first);
      const unsigned int second = without == 0U || has_several(without) ? first : first_fluid(without);
      return {first, second};
    }
  } // namespace



  template <int dim>
  void InterfaceCorrection<dim>::apply(const std::vector<double> &excess, const Walls<dim> &walls,
                                       FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud,
                                       const Migration<dim> &migration)
  {
    const unsigned int n               = excess.size();
    const std::vector<bool> on_surface = mesh.on_free_surface(cloud.size());
    std::vector<bool> at_obstacle(cloud.size(), false);
    for (const Simplex<dim> &cell : mesh.particle_cells())
      if (std::any_of(cell.begin(), cell.end(),
                      [&](const unsigned int i) { return cloud.kind[i] != ParticleKind::fluid; }))
        for (const unsigned int i : cell)
          at_obstacle[i] = true;

    // By particle the area vectors of its faces, from the smaller number to the larger one.
    std::vector<Tensor<1, dim>> area(cloud.size());
    std::vector<FluidSet> sides(cloud.size(), 0U);
    for (const InterfaceFace<dim> &face : find_interface_faces(mesh))
    {
      SimplexCorners<dim> corners;
      double sum_of_radii = 0.;
      for (unsigned int k = 0; k < dim; ++k)
      {
        corners[k] = cloud.position[face.corners[k]];
        sum_of_radii += corners[k][0];
      }
      corners[dim] = cloud.position[face.opposite[0]];
      // −d V ∇λ is the area vector of the face opposite to a corner; V changes its sign with the orientation, ∇λ does not.
      const Tensor<1, dim> face_area = -dim * std::abs(signed_volume<dim>(corners)) *
                                       shape_gradients<dim>(corners)[dim];
      for (const unsigned int i : face.corners)
      {
        area[i] += face_share<dim>(face_area, sum_of_radii, cloud.position[i][0]);
        sides[i] |= face.fluids;
      }
    }
    const auto is_movable = [&](const unsigned int i) {
      const auto [first, second] = two_of(sides[i]);
      return cloud.is_own(i) && cloud.kind[i] == ParticleKind::fluid && first != second && !on_surface[i] &&
             !at_obstacle[i] && !cloud.in_contact(i) && area[i].norm() > 0.;
    };

    std::vector<double> areas(n * n, 0.);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (is_movable(i))
      {
        const auto [first, second] = two_of(sides[i]);
        areas[first * n + second] += area[i].norm();
        areas[second * n + first] += area[i].norm();
      }
    if (!migration.is_alone())
      Utilities::MPI::sum(areas, migration.communicator(), areas);
    if (*std::max_element(areas.begin(), areas.end()) == 0.)
      return;
    const std::vector<double> lambda = solve(areas, excess);

    const std::vector<Point<dim>> old_position = cloud.position;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (is_movable(i))
      {
        const auto [first, second] = two_of(sides[i]);
        const double limit         = longest_shift * cloud.spacing[i];
        const double distance      = std::max(-limit, std::min(limit, lambda[second] - lambda[first]));
        const Tensor<1, dim> shift = distance / area[i].norm() * area[i];
        if (walls.crossed(cloud.position[i], cloud.position[i] + shift, 0., 0.).empty())
          cloud.position[i] += shift;
      }
    migration.update(cloud.position);
    VolumeCorrection<dim>::keep_cells(mesh, old_position, cloud, migration);
    mesh.move(cloud);
  }



  template class InterfaceCorrection<2>;
  template class InterfaceCorrection<3>;
} // namespace Lahar
