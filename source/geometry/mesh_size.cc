// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/mesh_size.h>
#include <lahar/geometry/point_lists.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace Lahar
{
  namespace
  {
    /// G: growth of h with the distance from a refined box.
    constexpr double growth = 0.2;

    /// The spacing of a particle falls to this part of itself at most from step to step.
    constexpr double largest_decrease = 0.85;

    /// From one lattice to the next, as a factor.
    const double level_ratio = std::sqrt(2.);

    /// How far apart two boxes are, a point being a box without extent.
    template <int dim>
    double distance(const Box<dim> &a, const Point<dim> &lower, const Point<dim> &upper)
    {
      double sum = 0.;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double gap = std::max({a.lower[d] - upper[d], lower[d] - a.upper[d], 0.});
        sum += gap * gap;
      }
      return std::sqrt(sum);
    }
  } // namespace



  template <int dim>
  void MeshSize<dim>::declare_parameters(Parameters &prm)
  {
    const std::string point = dim == 2 ? "x, y" : "x, y, z";
    prm.enter_subsection("Remeshing");
    prm.declare_list(
      "Refined boxes", "", ';',
      "Boxes with a smaller mesh size, each as two opposite corners and the distance of "
      "neighbouring particles in it '" +
        point + " : " + point +
        " : mesh size', separated by ';'. Lengths in m. Outside the mesh size grows by 0.2 m per m "
        "of distance from the box up to 'Mesh size'; where boxes overlap the smallest one counts. "
        "It holds for fluid and walls, at the start and as the fluid flows; a solid's box that reaches into one "
        "has its size throughout, unless 'Elements' are given.");
    prm.leave_subsection();
  }



  template <int dim>
  void MeshSize<dim>::parse_parameters(Parameters &prm, const double mesh_size)
  {
    const std::string point = dim == 2 ? "x, y" : "x, y, z";
    boxes.clear();
    sizes = {mesh_size};
    prm.enter_subsection("Remeshing");
    for (const std::string &text : split_list(prm.get("Refined boxes"), ';'))
    {
      const std::string allowed =
        "'" + point + " : " + point +
        " : mesh size' separated by ';', opposite corners that differ in all coordinates, "
        "the size above 0 and at most 'Mesh size', which is " +
        Utilities::to_string(mesh_size) + " (found '" + text + "')";
      const std::size_t end = text.rfind(':');
      std::vector<Point<dim>> corners;
      double size = 0.;
      if (end != std::string::npos)
        try
        {
          corners = parse_points<dim>(prm, "Refined boxes", text.substr(0, end), allowed);
          size    = to_number(text.substr(end + 1));
        }
        catch (const std::invalid_argument &)
        {}
      bool has_volume = corners.size() == 2;
      for (unsigned int d = 0; d < dim && has_volume; ++d)
        has_volume = corners[0][d] != corners[1][d];
      // Smaller ones would make levels without end.
      if (!has_volume || !(size > 1e-9 * mesh_size && size <= mesh_size))
        prm.throw_wrong_value("Refined boxes", allowed);
      boxes.push_back({Box<dim>(corners[0], corners[1]), size});

      const unsigned int n_steps = std::ceil(std::log(mesh_size / size) / std::log(level_ratio) - 1e-10);
      for (unsigned int step = 0; step < n_steps; ++step)
        sizes.push_back(size * std::pow(mesh_size / size, double(step) / n_steps));
    }
    prm.leave_subsection();
    std::sort(sizes.begin(), sizes.end());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  }



  template <int dim>
  double MeshSize<dim>::operator()(const Point<dim> &point) const
  {
    double h = coarsest();
    for (const RefinedBox &refined : boxes)
      h = std::min(h, refined.size + growth * distance<dim>(refined.box, point, point));
    return h;
  }



  template <int dim>
  double MeshSize<dim>::finest_in(const Box<dim> &region) const
  {
    double h = coarsest();
    for (const RefinedBox &refined : boxes)
      h = std::min(h, refined.size + growth * distance<dim>(refined.box, region.lower, region.upper));
    return h;
  }



  template <int dim>
  double MeshSize<dim>::estimate_refinement(const Box<dim> &region, const unsigned int n_directions) const
  {
    double sum = 0.;
    for (const RefinedBox &refined : boxes)
    {
      // At this distance h is twice that of the box.
      const double reach = std::min(refined.size, coarsest() - refined.size) / growth;
      std::vector<double> extents;
      for (unsigned int d = 0; d < dim; ++d)
        extents.push_back(std::min(region.upper[d], refined.box.upper[d] + reach) -
                          std::max(region.lower[d], refined.box.lower[d] - reach));
      std::sort(extents.begin(), extents.end(), std::greater<double>());
      double n = extents.back() < 0. || refined.size == coarsest() ? 0. : dim == 2 ? 1.2 : 1.6;
      for (unsigned int d = 0; d < n_directions; ++d)
        n *= extents[d] / refined.size + 1.;
      sum += n;
    }
    return sum;
  }



  template <int dim>
  void MeshSize<dim>::update(ParticleCloud<dim> &cloud) const
  {
    if (is_uniform())
      return;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.kind[i] == ParticleKind::fluid)
        cloud.spacing[i] = std::max((*this)(cloud.position[i]), largest_decrease * cloud.spacing[i]);
  }



  template class MeshSize<2>;
  template class MeshSize<3>;
} // namespace Lahar
