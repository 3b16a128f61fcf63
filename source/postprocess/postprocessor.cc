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



  template <int dim>
  void add_force_columns(TableHandler &statistics, const Snapshot<dim> &snapshot, const std::string &whose,
                         const std::string &what, const Tensor<1, dim> &force)
  {
    const auto unit = [](const unsigned int d) { return std::string(" ") + "xyz"[d] + " (N)"; };
    for (unsigned int d = 0; d < dim; ++d)
      add_to_column(statistics, whose + ' ' + what + unit(d), force[d]);
    for (unsigned int d = 0; d < dim; ++d)
    {
      const std::string column = whose + " mean " + what + unit(d);
      add_to_column(statistics, column, snapshot.means.add(column, force[d]));
    }
  }



  void add_to_column(TableHandler &statistics, const std::string &column, const double value)
  {
    statistics.add_value(column, value);
    statistics.set_precision(column, 9);
    statistics.set_scientific(column, true);
  }



  template void add_force_columns(TableHandler &, const Snapshot<2> &, const std::string &,
                                  const std::string &, const Tensor<1, 2> &);
  template void add_force_columns(TableHandler &, const Snapshot<3> &, const std::string &,
                                  const std::string &, const Tensor<1, 3> &);
  template class Postprocessor<2>;
  template class Postprocessor<3>;
} // namespace Lahar
