// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/initial/axis.h>
#include <lahar/initial/initial_geometry.h>
#include <lahar/particles/fluid_set.h>
#include <lahar/utilities/factory.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// The entries of the chosen law in the handler's current section, by name.
    std::map<std::string, std::string> law_entries(const Parameters &prm)
    {
      const std::string law = prm.path("Law"), section = prm.path(prm.get("Law")) + "/";
      std::map<std::string, std::string> entries;
      for (const auto &[path, value] : prm.values())
        if (path == law || path.rfind(section, 0) == 0)
          entries[path.substr(prm.path("").size())] = value;
      return entries;
    }
  } // namespace



  template <int dim>
  void InitialGeometry<dim>::declare_parameters(Parameters &prm, const CaseStructure &structure)
  {
    prm.declare_count(
      "Largest number of particles", "10000000",
      "A case is refused if it asks for more particles than this at the start, 1 to 100000000, as "
      "estimated from the mesh size and the boxes around fluids and boundaries.",
      1, 100000000);
    prm.enter_subsection("Fluids");
    for (const std::string &name : structure.fluids)
    {
      prm.enter_subsection(name);
      Fluid<dim>::declare_parameters(prm);
      prm.leave_subsection();
    }
    prm.leave_subsection();
    prm.enter_subsection("Boundaries");
    for (const std::string &name : structure.boundaries)
    {
      prm.enter_subsection(name);
      Boundary<dim>::declare_parameters(prm);
      prm.leave_subsection();
    }
    prm.leave_subsection();
  }



  template <int dim>
  void InitialGeometry<dim>::parse_parameters(Parameters &prm, const CaseStructure &structure)
  {
    if (structure.fluids.empty() && structure.solids.empty())
      throw InputError(
        "There is no fluid: 'Fluids' and 'Solids' are empty. Allowed: 'set Fluids = NAME' and a "
        "subsection 'Fluids/NAME' with the fluid's 'Shape' and 'Law'.");
    if (structure.fluids.size() > most_fluids)
      throw InputError("Parameter 'Fluids' has " + std::to_string(structure.fluids.size()) +
                       " names. Allowed: at most " + std::to_string(most_fluids) + ".");
    max_particles = prm.get_count("Largest number of particles", 1, 100000000);
    prm.enter_subsection("Fluids");
    std::vector<std::map<std::string, std::string>> laws;
    for (const std::string &name : structure.fluids)
    {
      prm.enter_subsection(name);
      fluids.emplace_back();
      fluids.back().parse_parameters(prm, name);
      laws.push_back(law_entries(prm));
      const unsigned int same = std::find(laws.begin(), laws.end(), laws.back()) - laws.begin();
      material_of.push_back(same + 1 < laws.size() ? material_of[same] : n_materials());
      for (auto &body : fluids.back().bodies())
      {
        bodies.push_back(std::move(body));
        fluid_of.push_back(fluids.size() - 1);
      }
      prm.leave_subsection();
    }
    prm.leave_subsection();
    prm.enter_subsection("Boundaries");
    for (const std::string &name : structure.boundaries)
    {
      prm.enter_subsection(name);
      boundaries.emplace_back();
      boundaries.back().parse_parameters(prm, name);
      if (boundaries.back().outflow() == nullptr) // which is no wall
        for (const WallShape<dim> &wall : boundaries.back().walls(boundaries.size() - 1))
          wall_shapes.push_back(wall);
      if (const Inflow *inflow = boundaries.back().inflow())
        fluid_number(*inflow);
      prm.leave_subsection();
    }
    prm.leave_subsection();
    if constexpr (dim == 2)
      if (Symmetry::is_rotational())
        add_axis(prm);
  }



  template <int dim>
  void InitialGeometry<dim>::add_axis(Parameters &prm)
  {
    std::vector<Point<dim>> points;
    for (const auto &body : bodies)
    {
      const Box<dim> box = body->box();
      if (box.lower[0] < 0.)
      {
        std::ostringstream message;
        message
          << "Fluid " << body->name() << " reaches to x = " << box.lower[0]
          << " m, but 'Geometry' is 'rotational symmetry'. Allowed: x >= 0, the distance from the axis.";
        throw InputError(message.str());
      }
      points.insert(points.end(), {box.lower, box.upper});
    }
    for (const WallShape<dim> &wall : wall_shapes)
      for (const WallFacet<dim> &facet : wall.facets())
        points.insert(points.end(), facet.corners.begin(), facet.corners.end());
    if constexpr (dim == 2)
      boundaries.push_back(make_axis(prm, points));
    for (const WallShape<dim> &wall : boundaries.back().walls(boundaries.size() - 1))
      wall_shapes.push_back(wall);
  }



  template <int dim>
  std::vector<const SurfaceLaw *> InitialGeometry<dim>::surface_laws() const
  {
    std::vector<const SurfaceLaw *> laws;
    for (const Boundary<dim> &boundary : boundaries)
      laws.push_back(boundary.law.get());
    return laws;
  }



  template <int dim>
  TensileStrengths InitialGeometry<dim>::tensile_strengths() const
  {
    TensileStrengths strengths;
    for (const Boundary<dim> &boundary : boundaries)
      strengths.push_back(boundary.tensile_strength);
    return strengths;
  }



  template <int dim>
  std::vector<std::string> InitialGeometry<dim>::warnings(const double h) const
  {
    std::vector<std::string> result;
    for (const Boundary<dim> &boundary : boundaries)
      for (const std::string &text : boundary.warnings(h))
        result.push_back(text);
    return result;
  }



  template <int dim>
  unsigned int InitialGeometry<dim>::fluid_number(const Inflow &inflow) const
  {
    std::string names;
    for (unsigned int n = 0; n < fluids.size(); ++n)
    {
      if (inflow.fluid().empty() || inflow.fluid() == fluids[n].name)
        return material_of[n];
      names += (n == 0 ? "'" : ", '") + fluids[n].name + "'";
    }
    throw InputError("Parameter '" + inflow.path("Fluid") + "' is '" + inflow.fluid() +
                     "'. Allowed: the name of a fluid of the case" + (names.empty() ? "" : ": " + names) +
                     ".");
  }



  template <int dim>
  std::vector<typename Inlets<dim>::Source> InitialGeometry<dim>::inflows() const
  {
    std::vector<typename Inlets<dim>::Source> result;
    for (const Boundary<dim> &boundary : boundaries)
    {
      const Inflow *inflow = boundary.inflow();
      result.push_back({boundary.name, inflow, inflow == nullptr ? 0 : fluid_number(*inflow)});
    }
    return result;
  }



  template <int dim>
  Outlets<dim> InitialGeometry<dim>::outlets() const
  {
    Outlets<dim> result;
    for (unsigned int b = 0; b < boundaries.size(); ++b)
      if (const Outflow *outflow = boundaries[b].outflow())
        for (const WallShape<dim> &wall : boundaries[b].walls(b))
          result.add(boundaries[b].name, *outflow, wall.facets());
    return result;
  }



  template void InitialGeometry<2>::declare_parameters(Parameters &, const CaseStructure &);
  template void InitialGeometry<2>::parse_parameters(Parameters &, const CaseStructure &);
  template void InitialGeometry<2>::add_axis(Parameters &);
  template unsigned int InitialGeometry<2>::fluid_number(const Inflow &) const;
  template std::vector<typename Inlets<2>::Source> InitialGeometry<2>::inflows() const;
  template Outlets<2> InitialGeometry<2>::outlets() const;
  template std::vector<const SurfaceLaw *> InitialGeometry<2>::surface_laws() const;
  template TensileStrengths InitialGeometry<2>::tensile_strengths() const;
  template std::vector<std::string> InitialGeometry<2>::warnings(const double) const;
  template void InitialGeometry<3>::declare_parameters(Parameters &, const CaseStructure &);
  template void InitialGeometry<3>::parse_parameters(Parameters &, const CaseStructure &);
  template unsigned int InitialGeometry<3>::fluid_number(const Inflow &) const;
  template std::vector<typename Inlets<3>::Source> InitialGeometry<3>::inflows() const;
  template Outlets<3> InitialGeometry<3>::outlets() const;
  template std::vector<const SurfaceLaw *> InitialGeometry<3>::surface_laws() const;
  template TensileStrengths InitialGeometry<3>::tensile_strengths() const;
  template std::vector<std::string> InitialGeometry<3>::warnings(const double) const;
} // namespace Lahar
