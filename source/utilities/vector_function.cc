// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/vector_function.h>

namespace Lahar
{
  template <int dim>
  std::string zero_function()
  {
    return dim == 2 ? "0; 0" : "0; 0; 0";
  }



  template <int dim>
  std::shared_ptr<FunctionParser<dim>> parse_vector_function(const Parameters &prm, const std::string &entry,
                                                             const bool of_time)
  {
    auto function = std::make_shared<FunctionParser<dim>>(dim);
    try
    {
      const std::vector<std::string> components = split_list(prm.get(entry), ';');
      AssertThrow(components.size() == dim, ExcDimensionMismatch(components.size(), dim));
      const std::string coordinates = dim == 2 ? "x,y" : "x,y,z";
      function->initialize(coordinates + (of_time ? ",t" : ""), components, {{"pi", numbers::PI}}, of_time);
      for (unsigned int d = 0; d < dim; ++d)
        function->value(Point<dim>(), d);
    }
    catch (const std::exception &)
    {
      prm.throw_wrong_value(entry, std::to_string(dim) + " functions of the coordinates" +
                                     (of_time ? " and of t" : "") + " separated by ';'");
    }
    return function;
  }



  template std::string zero_function<2>();
  template std::string zero_function<3>();
  template std::shared_ptr<FunctionParser<2>> parse_vector_function(const Parameters &, const std::string &,
                                                                    const bool);
  template std::shared_ptr<FunctionParser<3>> parse_vector_function(const Parameters &, const std::string &,
                                                                    const bool);
} // namespace Lahar
