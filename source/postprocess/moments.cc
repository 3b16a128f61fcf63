// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/point_lists.h>
#include <lahar/geometry/symmetry.h>
#include <lahar/postprocess/boundary_reactions.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/factory.h>

#include <algorithm>

namespace Lahar
{
  /**
   * Moments Σ (x − c) × F about points c over the last step, N m (N in the plane, about an axis normal to it): of the mean
   * forces F of the fluid on a boundary or a solid, and of the forces of what clamps or drives the solid. x is where the
   * force acts at the end of the step.
   */
  template <int dim>
  class Moments : public Postprocessor<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list(
        "Points", "", ';',
        "Points in m, 'name: x, y' separated by ';', each with the name of a boundary or of a solid. "
        "Columns '<name> moment (N m)', in space '<name> moment x (N m)' ...: the moment about the point of the "
        "fluid's force on the boundary; '<name> fluid moment', '<name> support moment' for a solid.");
    }

    void parse_parameters(Parameters &prm) override;
    void initialize(const Snapshot<dim> &start) override;
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;

  private:
    /// In the plane the moment about its normal.
    using Moment = Tensor<1, dim == 2 ? 1 : 3>;

    struct Part
    {
      std::string name;
      Point<dim> centre;
      bool is_solid;
      unsigned int number; ///< of the boundary or the solid
    };

    static Moment moment(const Tensor<1, dim> &arm, const Tensor<1, dim> &force);
    static void add_columns(TableHandler &statistics, const Snapshot<dim> &snapshot, const std::string &whose,
                            const std::string &what, const Moment &value);

    std::string path;
    std::vector<Part> parts;
  };



  template <int dim>
  void Moments<dim>::parse_parameters(Parameters &prm)
  {
    path = prm.path("Points");
    for (const auto &[name, points] : parse_named_points<dim>(prm, "Points", 1))
    {
      for (const Part &other : parts)
        if (other.name == name)
          throw InputError("Parameter '" + path + "' has '" + name + "' twice. Allowed: one point for each.");
      parts.push_back({name, points[0], false, 0});
    }
    if (!parts.empty() && Symmetry::applies<dim>())
      throw InputError("Parameter '" + path +
                       "' is given where 'Geometry' is 'rotational symmetry', in which moments are "
                       "zero. Allowed: nothing.");
  }



  template <int dim>
  void Moments<dim>::initialize(const Snapshot<dim> &start)
  {
    std::vector<std::string> boundaries = start.walls.boundary_names(), solids;
    if (!start.solids.empty())
      for (const auto &body : start.solids.all_bodies())
        solids.push_back(body.name);
    for (Part &part : parts)
    {
      const auto boundary = std::find(boundaries.begin(), boundaries.end(), part.name);
      const auto solid    = std::find(solids.begin(), solids.end(), part.name);
      part.is_solid       = boundary == boundaries.end();
      part.number         = part.is_solid ? solid - solids.begin() : boundary - boundaries.begin();
      if (boundary != boundaries.end() || solid != solids.end())
        continue;
      std::string allowed;
      for (const auto *names : {&boundaries, &solids})
        for (const std::string &name : *names)
          allowed += (allowed.empty() ? "'" : ", '") + name + "'";
      throw InputError("Parameter '" + path + "' names '" + part.name +
                       "', which is no boundary and no solid. Allowed: " + allowed + ".");
    }
  }



  template <int dim>
  typename Moments<dim>::Moment Moments<dim>::moment(const Tensor<1, dim> &arm, const Tensor<1, dim> &force)
  {
    Moment result;
    if constexpr (dim == 2)
      result[0] = arm[0] * force[1] - arm[1] * force[0];
    else
      result = cross_product_3d(arm, force);
    return result;
  }



  template <int dim>
  void Moments<dim>::add_columns(TableHandler &statistics, const Snapshot<dim> &snapshot,
                                 const std::string &whose, const std::string &what, const Moment &value)
  {
    const auto column = [](const std::string &begin, const unsigned int d) {
      return begin + (dim == 2 ? "" : std::string(" ") + "xyz"[d]) + " (N m)";
    };
    for (unsigned int d = 0; d < Moment::dimension; ++d)
      add_to_column(statistics, column(whose + ' ' + what, d), value[d]);
    for (unsigned int d = 0; d < Moment::dimension; ++d)
    {
      const std::string mean = column(whose + " mean " + what, d);
      add_to_column(statistics, mean, snapshot.means.add(mean, value[d]));
    }
  }



  template <int dim>
  void Moments<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    if (parts.empty())
      return;
    std::vector<Moment> by_fluid(parts.size()), by_support(parts.size());
    for_each_boundary_force<dim>(snapshot, [&](const unsigned int boundary, const Tensor<1, dim> &force,
                                               const Point<dim> &place) {
      for (unsigned int k = 0; k < parts.size(); ++k)
        if (!parts[k].is_solid && parts[k].number == boundary)
          by_fluid[k] += moment(place - parts[k].centre, force);
    });
    if (!snapshot.solids.empty())
    {
      const SolidMesh<dim> &mesh = snapshot.solids.mesh();
      for (unsigned int k = 0; k < parts.size(); ++k)
        for (unsigned int i = 0; parts[k].is_solid && i < mesh.n_nodes(); ++i)
          if (mesh.body_of_node(i) == parts[k].number)
          {
            const Tensor<1, dim> arm = snapshot.solids.state().position[i] - parts[k].centre;
            // What acts on a prescribed node is the fluid's force and the support's.
            by_support[k] += moment(arm, snapshot.solids.state().reaction[i]);
            if (i < mesh.n_contour_nodes() && snapshot.cloud.is_own(i))
              by_fluid[k] += moment(arm, -snapshot.cloud.reaction[i]);
          }
    }
    for (unsigned int k = 0; k < parts.size(); ++k)
    {
      const Moment fluid = Utilities::MPI::sum(by_fluid[k], snapshot.communicator());
      add_columns(statistics, snapshot, parts[k].name, parts[k].is_solid ? "fluid moment" : "moment", fluid);
      if (parts[k].is_solid)
        add_columns(statistics, snapshot, parts[k].name, "support moment", by_support[k] - fluid);
    }
  }



  static const Factory<Postprocessor<2>>::Registration<Moments<2>>
    moments_2d("Moments", "Moments of the forces on boundaries and solids.");
  static const Factory<Postprocessor<3>>::Registration<Moments<3>>
    moments_3d("Moments", "Moments of the forces on boundaries and solids.");
} // namespace Lahar
