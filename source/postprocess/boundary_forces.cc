// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/initial/axis.h>
#include <lahar/postprocess/boundary_reactions.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /**
   * For each boundary the mean force of the fluid on it over the last step, N (N/m in 2D), the sum of
   * for_each_boundary_force(). An outlet with a level has the force of the fluid on what stands behind it.
   */
  template <int dim>
  class BoundaryForces : public Postprocessor<dim>
  {
  public:
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;
  };



  template <int dim>
  void BoundaryForces<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    const std::vector<std::string> &names = snapshot.walls.boundary_names();
    std::vector<Tensor<1, dim>> forces(names.size());
    for_each_boundary_force<dim>(snapshot, [&](const unsigned int boundary, const Tensor<1, dim> &force,
                                               const Point<dim> &) { forces[boundary] += force; });
    std::vector<double> components(dim * names.size());
    for (unsigned int k = 0; k < components.size(); ++k)
      components[k] = forces[k / dim][k % dim];
    Utilities::MPI::sum(components, snapshot.communicator(), components);
    for (unsigned int b = 0; b < names.size(); ++b)
    {
      if (Symmetry::applies<dim>() && names[b] == axis_name)
        continue; // it exerts none
      for (unsigned int d = 0; d < dim; ++d)
        forces[b][d] = components[dim * b + d];
      if (snapshot.outlet_forces != nullptr && !snapshot.outlet_forces->empty())
        forces[b] += (*snapshot.outlet_forces)[b];
      add_force_columns(statistics, snapshot, names[b], "force", forces[b]);
    }
  }



  static const Factory<Postprocessor<2>>::Registration<BoundaryForces<2>>
    forces_2d("Boundary forces", "Force of the fluid on each boundary.");
  static const Factory<Postprocessor<3>>::Registration<BoundaryForces<3>>
    forces_3d("Boundary forces", "Force of the fluid on each boundary.");
} // namespace Lahar
