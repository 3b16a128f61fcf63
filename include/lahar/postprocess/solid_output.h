// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_postprocess_solid_output_h
#define lahar_postprocess_solid_output_h

#include <deal.II/base/data_out_base.h>

#include <lahar/solid/solids.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The deformed solids as linear simplices for output; quadratic cells are divided at their nodes.
   *
   * Point data: displacement, velocity. Cell data (the mean of a cell, the same at all points of its pieces): the
   * components of the Cauchy stress, von_mises_stress, body (1, 2, ...).
   */
  template <int dim>
  class SolidOutput : public DataOutInterface<dim>
  {
  public:
    explicit SolidOutput(const Solids<dim> &solids);

  private:
    const std::vector<DataOutBase::Patch<dim>> &get_patches() const override;
    std::vector<std::string> get_dataset_names() const override;
    std::vector<std::tuple<unsigned int, unsigned int, std::string,
                           DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override;

    std::vector<DataOutBase::Patch<dim>> patches;
  };
} // namespace Lahar

#endif
