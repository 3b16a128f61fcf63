// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/boundary_motion.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/time_table.h>

namespace Lahar
{
  /// x = X + d(t), d linear between the rows of a table.
  template <int dim>
  class TabulatedMotion : public BoundaryMotion<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_file(
        "File", std::string("A table of the displacement from where the shape is drawn: lines 't, x, y") +
                  (dim == 3 ? ", z" : "") +
                  "' in s and m, zero at 'Start time', linear in between and constant before and after; its "
                  "name is relative to the parameter file that gives it.");
    }

    void parse_parameters(Parameters &prm) override
    {
      if (prm.get("File").empty())
        prm.throw_wrong_value("File", "the name of a table");
      std::vector<std::string> columns = {"x (m)", "y (m)"};
      if (dim == 3)
        columns.emplace_back("z (m)");
      displacement = TimeTable(prm.get("File"), columns);
    }

    RigidMotion<dim> at(const double time) const override
    {
      RigidMotion<dim> motion;
      const std::vector<double> values = displacement(time);
      for (unsigned int d = 0; d < dim; ++d)
        motion.shift[d] = values[d];
      return motion;
    }

  private:
    TimeTable displacement;
  };



  static const Factory<BoundaryMotion<2>>::Registration<TabulatedMotion<2>>
    table_2d("table", "It is displaced as a file says.");
  static const Factory<BoundaryMotion<3>>::Registration<TabulatedMotion<3>>
    table_3d("table", "It is displaced as a file says.");
} // namespace Lahar
