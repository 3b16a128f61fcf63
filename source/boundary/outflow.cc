// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/outflow.h>
#include <lahar/utilities/factory.h>

#include <stdexcept>

namespace Lahar
{
  void Outflow::declare_parameters(Parameters &prm)
  {
    prm.declare_list(
      "Direction", "", ',',
      "A vector 'x, y' (in space 'x, y, z') to the side of the boundary where the fluid goes; only "
      "its side counts.");
  }



  void Outflow::parse_parameters(Parameters &prm)
  {
    entry_path = prm.path("Direction");
    try
    {
      for (const std::string &text : split_list(prm.get("Direction"), ','))
        components.push_back(to_number(text));
    }
    catch (const std::invalid_argument &)
    {
      components.clear();
    }
    if (components.empty())
      prm.throw_wrong_value("Direction", "a vector, as '1, 0', to the side where the fluid goes");
  }



  static const Factory<SurfaceLaw>::Registration<Outflow>
    outflow("outflow", "No wall: fluid that passes through the surface leaves the case.");
} // namespace Lahar
