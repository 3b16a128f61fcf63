// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/point_lists.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/postprocess/postprocessor.h>
#include <lahar/utilities/factory.h>

#include <limits>

namespace Lahar
{
  /**
   * Pressure and velocity at points fixed in space, interpolated in the cell that holds the point; nan where there is
   * no fluid.
   */
  template <int dim>
  class PointGauges : public Postprocessor<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list("Points", "", ';',
                       "Points in m, 'name: x, y' separated by ';'. Columns '<name> pressure (Pa)' and "
                       "'<name> velocity x (m/s)' ...");
    }

    void parse_parameters(Parameters &prm) override;
    void evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const override;

  private:
    std::vector<NamedPoints<dim>> points;
  };



  template <int dim>
  void PointGauges<dim>::parse_parameters(Parameters &prm)
  {
    points = parse_named_points<dim>(prm, "Points", 1);
  }



  template <int dim>
  void PointGauges<dim>::evaluate(const Snapshot<dim> &snapshot, TableHandler &statistics) const
  {
    constexpr double nowhere   = std::numeric_limits<double>::max();
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(snapshot.communicator());
    for (const auto &[name, place] : points)
    {
      const Point<dim> &point = place[0];
      double pressure         = 0.;
      Tensor<1, dim> velocity;
      // Of the first cell that holds the point, as a double: deal.II 9.4 reduces unsigned 64-bit integers as signed ones.
      double first_corner = nowhere;
      for (const Simplex<dim> &cell : snapshot.mesh.particle_cells())
      {
        if (!snapshot.cloud.is_own(cell))
          continue;
        const auto corners = corners_of<dim>(cell, snapshot.cloud.position);
        bool near          = true;
        for (unsigned int d = 0; d < dim && near; ++d)
        {
          bool below = false, above = false;
          for (const Point<dim> &corner : corners)
            (corner[d] <= point[d] ? below : above) = true;
          for (const Point<dim> &corner : corners)
            above = above || corner[d] == point[d];
          near = below && above;
        }
        if (!near || !(signed_volume<dim>(corners) > 0.))
          continue;

        const auto gradients = shape_gradients<dim>(corners);
        std::array<double, dim + 1> shape_values;
        bool inside = true;
        for (unsigned int c = 0; c <= dim; ++c)
        {
          shape_values[c] = (c == 0 ? 1. : 0.) + gradients[c] * (point - corners[0]);
          inside          = inside && shape_values[c] >= -1e-10;
        }
        if (inside)
        {
          first_corner = snapshot.cloud.number[cell[0]];
          for (unsigned int c = 0; c <= dim; ++c)
          {
            pressure += shape_values[c] * snapshot.cloud.pressure[cell[c]];
            velocity += shape_values[c] * snapshot.cloud.velocity[cell[c]];
          }
          break;
        }
      }

      // A point on a face lies in cells of several ranks.
      const double first_of_all     = Utilities::MPI::min(first_corner, snapshot.communicator());
      const unsigned int rank       = Utilities::MPI::this_mpi_process(snapshot.communicator()),
                         first_rank = Utilities::MPI::min(first_corner == first_of_all ? rank
                                                                                       : rank + n_ranks,
                                                          snapshot.communicator());
      if (rank != first_rank)
      {
        pressure = 0.;
        velocity = Tensor<1, dim>();
      }
      pressure = snapshot.sum_of_ranks(pressure);
      velocity = Utilities::MPI::sum(velocity, snapshot.communicator());
      if (first_of_all == nowhere)
        for (unsigned int d = 0; d < dim; ++d)
          velocity[d] = pressure = std::numeric_limits<double>::quiet_NaN();

      add_to_column(statistics, name + " pressure (Pa)", pressure);
      for (unsigned int d = 0; d < dim; ++d)
        add_to_column(statistics, name + " velocity " + "xyz"[d] + " (m/s)", velocity[d]);
    }
  }



  static const Factory<Postprocessor<2>>::Registration<PointGauges<2>>
    point_gauges_2d("Point gauges", "Pressure and velocity at points.");
  static const Factory<Postprocessor<3>>::Registration<PointGauges<3>>
    point_gauges_3d("Point gauges", "Pressure and velocity at points.");
} // namespace Lahar
