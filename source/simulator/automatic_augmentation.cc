// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/material/yield_stress_law.h>
#include <lahar/simulator/automatic_augmentation.h>

namespace Lahar
{
  template <int dim>
  void choose_augmentations(const FluidMesh<dim> &mesh, const Materials &materials,
                            const FluidState<dim> &state, const std::vector<bool> &is_counted,
                            const MPI_Comm &communicator)
  {
    std::vector<const YieldStressLaw *> laws;
    bool any = false;
    for (unsigned int fluid = 0; fluid < materials.n_fluids(); ++fluid)
    {
      const auto *law = dynamic_cast<const YieldStressLaw *>(&materials.law(fluid));
      laws.push_back(law != nullptr && law->chooses_augmentation() ? law : nullptr);
      any = any || laws.back() != nullptr;
    }
    if (!any)
      return;

    const auto corners = [&](const unsigned int c) {
      return corners_of<dim>(mesh.cells()[c], state.old_position);
    };
    std::vector<double> sums(2 * laws.size(), 0.); // volume and area of each fluid
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      if (is_counted[c])
        sums[2 * mesh.fluid(c)] += std::abs(signed_volume<dim>(corners(c)));
    for (const BoundaryFace &face : mesh.boundary_faces())
      if (is_counted[face.cell])
        sums[2 * mesh.fluid(face.cell) + 1] += dim * std::abs(signed_volume<dim>(corners(face.cell))) *
                                               shape_gradients<dim>(corners(face.cell))[face.opposite].norm();
    Utilities::MPI::sum(sums, communicator, sums);
    for (unsigned int fluid = 0; fluid < laws.size(); ++fluid)
      if (laws[fluid] != nullptr && sums[2 * fluid] > 0. && sums[2 * fluid + 1] > 0.)
      {
        const double length = 2. * sums[2 * fluid] / sums[2 * fluid + 1];
        laws[fluid]->choose_augmentation(laws[fluid]->density() * length * length / state.time_step);
      }
  }



  template void choose_augmentations(const FluidMesh<2> &, const Materials &, const FluidState<2> &,
                                     const std::vector<bool> &, const MPI_Comm &);
  template void choose_augmentations(const FluidMesh<3> &, const Materials &, const FluidState<3> &,
                                     const std::vector<bool> &, const MPI_Comm &);
} // namespace Lahar
