// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/initial/solid_surfaces.h>
#include <lahar/utilities/factory.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// Laws of rigid boundaries only.
    const Factory<SurfaceLaw>::Names rigid_only = {"inflow", "outflow", "wall particles"};
  } // namespace



  void SolidSurfaces::declare_parameters(Parameters &prm, const std::vector<std::string> &names)
  {
    prm.enter_subsection("Solids");
    for (const std::string &name : names)
    {
      prm.enter_subsection(name);
      prm.enter_subsection("Surface");
      Factory<SurfaceLaw>::declare_models(prm, "Law", "no slip", "How fluid moves along the solid.",
                                          rigid_only);
      prm.leave_subsection();
      prm.leave_subsection();
    }
    prm.leave_subsection();
  }



  void SolidSurfaces::parse_parameters(Parameters &prm, const std::vector<std::string> &names)
  {
    prm.enter_subsection("Solids");
    for (const std::string &name : names)
    {
      prm.enter_subsection(name);
      prm.enter_subsection("Surface");
      all_laws.push_back(Factory<SurfaceLaw>::create_chosen(prm, "Law", rigid_only));
      prm.leave_subsection();
      prm.leave_subsection();
    }
    prm.leave_subsection();
  }



  std::vector<bool> SolidSurfaces::slick() const
  {
    std::vector<bool> result;
    for (const auto &law : all_laws)
      result.push_back(!law->sticks());
    return result;
  }



  bool SolidSurfaces::any_slick() const
  {
    return std::any_of(all_laws.begin(), all_laws.end(), [](const auto &law) { return !law->sticks(); });
  }
} // namespace Lahar
