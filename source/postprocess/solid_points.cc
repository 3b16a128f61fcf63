// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/point_lists.h>
#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

#include <algorithm>

namespace Lahar
{
  /**
   * Displacement of material points of the solids, m.
   */
  template <int dim>
  class SolidPoints : public Postprocessor<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list("Points", "", ';',
                       "Points of the undeformed solids in m, 'name: x, y' separated by ';'. Columns "
                       "'<name> x (m)', '<name> y (m)' ...: their displacements.");
    }

    void parse_parameters(Parameters &prm) override;
    void initialize(const Snapshot<dim> &start) override;
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;

  private:
    struct MaterialPoint
    {
      std::string name;
      Point<dim> reference;
      std::vector<unsigned int> nodes;
      std::vector<double> shares;
    };

    std::string path;
    std::vector<MaterialPoint> points;
  };



  template <int dim>
  void SolidPoints<dim>::parse_parameters(Parameters &prm)
  {
    path = prm.path("Points");
    for (const auto &[name, place] : parse_named_points<dim>(prm, "Points", 1))
      points.push_back({name, place[0], {}, {}});
  }



  template <int dim>
  void SolidPoints<dim>::initialize(const Snapshot<dim> &start)
  {
    const Solids<dim> &solids = start.solids;
    // A thousandth of a cell outside is rounding.
    constexpr double tolerance = 1e-3;
    for (MaterialPoint &point : points)
    {
      double nearest = tolerance;
      if (!solids.empty())
        for (const auto &cell : solids.mesh().dof_handler().active_cell_iterators())
        {
          Point<dim> unit;
          try
          {
            unit = solids.mesh().mapping().transform_real_to_unit_cell(cell, point.reference);
          }
          catch (const typename Mapping<dim>::ExcTransformationFailed &)
          {
            continue; // the cell is too thin, or the point too far away
          }
          // Inside, all barycentric coordinates are positive.
          double outside = -1.;
          for (unsigned int d = 0; d < dim; ++d)
            outside += unit[d];
          for (unsigned int d = 0; d < dim; ++d)
            outside = std::max(outside, -unit[d]);
          if (outside > nearest)
            continue;
          nearest                   = outside;
          const auto &fe            = solids.mesh().dof_handler().get_fe();
          const unsigned int *nodes = solids.mesh().cell_nodes(cell->active_cell_index());
          point.nodes.assign(nodes, nodes + fe.dofs_per_cell);
          point.shares.clear();
          for (unsigned int I = 0; I < fe.dofs_per_cell; ++I)
            point.shares.push_back(fe.shape_value(I, unit));
        }
      if (point.nodes.empty())
        throw InputError(
          "Parameter '" + path + "': the point '" + point.name +
          "' lies in no solid. Allowed: points of the undeformed solids, up to a thousandth of "
          "an element outside.");
    }
  }



  template <int dim>
  void SolidPoints<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    for (const MaterialPoint &point : points)
    {
      Tensor<1, dim> displacement;
      for (unsigned int I = 0; I < point.nodes.size(); ++I)
        displacement += point.shares[I] * (snapshot.solids.state().position[point.nodes[I]] -
                                           snapshot.solids.mesh().reference_position(point.nodes[I]));
      for (unsigned int d = 0; d < dim; ++d)
        add_to_column(statistics, point.name + " " + "xyz"[d] + " (m)", displacement[d]);
    }
  }



  static const Factory<Postprocessor<2>>::Registration<SolidPoints<2>>
    points_2d("Solid points", "Displacements of material points.");
  static const Factory<Postprocessor<3>>::Registration<SolidPoints<3>>
    points_3d("Solid points", "Displacements of material points.");
} // namespace Lahar
