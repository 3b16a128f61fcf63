// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_structure.h>
#include <lahar/geometry/symmetry.h>
#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The mean structure parameter λ of the cells of thixotropic fluids, weighted by their volumes; no column without such a
  /// fluid.
  template <int dim>
  class MeanStructure : public Postprocessor<dim>
  {
  public:
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;
  };



  template <int dim>
  void MeanStructure<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    if (!snapshot.materials.any_thixotropic())
      return;
    const std::vector<double> structure = FluidStructure<dim>::of_cells(snapshot.mesh, snapshot.materials,
                                                                        snapshot.cloud);
    double sum = 0., volume = 0.;
    for (const unsigned int c : snapshot.mesh.own_cells(snapshot.cloud))
      if (snapshot.law(c).thixotropy().is_there())
      {
        const auto corners = corners_of<dim>(snapshot.mesh.particle_cells()[c], snapshot.cloud.position);
        const double of_the_cell = body_volume<dim>(corners);
        sum += of_the_cell * structure[c];
        volume += of_the_cell;
      }
    sum    = snapshot.sum_of_ranks(sum);
    volume = snapshot.sum_of_ranks(volume);
    add_to_column(statistics, "Mean structure", volume > 0. ? sum / volume : 0.);
  }



  static const Factory<Postprocessor<2>>::Registration<MeanStructure<2>>
    mean_structure_2d("Mean structure", "Mean structure parameter of thixotropic fluids.");
  static const Factory<Postprocessor<3>>::Registration<MeanStructure<3>>
    mean_structure_3d("Mean structure", "Mean structure parameter of thixotropic fluids.");
} // namespace Lahar
