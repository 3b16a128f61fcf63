// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/output_field.h>
#include <lahar/utilities/factory.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  void OutputField<dim>::declare_all(Parameters &prm)
  {
    prm.enter_subsection("Postprocess");
    prm.declare_list(
      "Fields", "", ',',
      "Fields of the fluid in the files for ParaView, separated by commas; empty: all of them. " +
        Factory<OutputField>::descriptions());
    Factory<OutputField>::declare_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  typename OutputField<dim>::List OutputField<dim>::create_all(Parameters &prm)
  {
    prm.enter_subsection("Postprocess");
    std::vector<std::string> names = prm.get_names("Fields");
    for (const std::string &name : names)
      if (!Factory<OutputField>::contains(name))
        prm.throw_wrong_value("Fields", Factory<OutputField>::names() + ", separated by commas");
    List fields;
    for (const std::string &name : split_list(Factory<OutputField>::names(), '|'))
      if (names.empty() || std::find(names.begin(), names.end(), name) != names.end())
        fields.emplace_back(name, Factory<OutputField>::create(name, prm));
    prm.leave_subsection();
    std::stable_sort(fields.begin(), fields.end(), [](const auto &a, const auto &b) {
      return a.second->position() < b.second->position();
    });
    return fields;
  }



  template class OutputField<2>;
  template class OutputField<3>;
} // namespace Lahar
