// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  template <int dim>
  void Postprocessor<dim>::declare_all(Parameters &prm)
  {
    prm.enter_subsection("Postprocess");
    Factory<Postprocessor<dim>>::declare_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<std::unique_ptr<Postprocessor<dim>>> Postprocessor<dim>::create_all(Parameters &prm)
  {
    std::vector<std::unique_ptr<Postprocessor<dim>>> all;
    prm.enter_subsection("Postprocess");
    for (const std::string &name : split_list(Factory<Postprocessor<dim>>::names(), '|'))
      all.push_back(Factory<Postprocessor<dim>>::create(name, prm));
    prm.leave_subsection();
    return all;
  }



  void add_to_column(TableHandler &statistics, const std::string &column, const double value)
  {
    statistics.add_value(column, value);
    statistics.set_precision(column, 9);
    statistics.set_scientific(column, true);
  }



  template class Postprocessor<2>;
  template class Postprocessor<3>;
} // namespace Lahar
