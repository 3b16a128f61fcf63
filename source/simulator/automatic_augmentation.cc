// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/material/yield_stress_law.h>
#include <lahar/simulator/automatic_augmentation.h>

namespace Lahar
{
  template <int dim>
  void choose_augmentations(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                            const double time_step, const MPI_Comm &communicator,
                            const std::vector<FluidLaw *> &laws)
  {
    std::vector<YieldStressLaw *> that_choose;
    bool any = false;
    for (FluidLaw *law : laws)
    {
      auto *with_yield_stress = dynamic_cast<YieldStressLaw *>(law);
      const bool chooses      = with_yield_stress != nullptr && with_yield_stress->chooses_augmentation();
      that_choose.push_back(chooses ? with_yield_stress : nullptr);
      any = any || chooses;
    }
    if (!any)
      return;

    const auto corners = [&](const unsigned int c) {
      return corners_of<dim>(mesh.particle_cells()[c], cloud.position);
    };
    std::vector<double> sums(2 * laws.size(), 0.); // volume and area of each fluid
    for (const unsigned int c : mesh.own_cells(cloud))
      sums[2 * mesh.fluid(c)] += std::abs(signed_volume<dim>(corners(c)));
    for (const BoundaryFace &face : mesh.boundary_faces())
      if (cloud.is_own(mesh.particle_cells()[face.cell]))
        sums[2 * mesh.fluid(face.cell) + 1] += dim * std::abs(signed_volume<dim>(corners(face.cell))) *
                                               shape_gradients<dim>(corners(face.cell))[face.opposite].norm();
    Utilities::MPI::sum(sums, communicator, sums);
    for (unsigned int fluid = 0; fluid < laws.size(); ++fluid)
      if (that_choose[fluid] != nullptr && sums[2 * fluid] > 0. && sums[2 * fluid + 1] > 0.)
      {
        const double length = 2. * sums[2 * fluid] / sums[2 * fluid + 1];
        that_choose[fluid]->choose_augmentation(laws[fluid]->density() * length * length / time_step);
      }
  }



  template void choose_augmentations(const FluidMesh<2> &, const ParticleCloud<2> &, const double,
                                     const MPI_Comm &, const std::vector<FluidLaw *> &);
  template void choose_augmentations(const FluidMesh<3> &, const ParticleCloud<3> &, const double,
                                     const MPI_Comm &, const std::vector<FluidLaw *> &);
} // namespace Lahar
