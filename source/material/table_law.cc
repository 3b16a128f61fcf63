// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/table_law.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/number_table.h>

#include <cmath>

namespace Lahar
{
  void TableLaw::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_file(
      "File",
      "A text file (CSV) with a strain rate in 1/s and a stress in Pa in each line, separated by ',', both "
      "growing from line to line; '#' begins a comment. The stress at the strain rate 0 is the yield stress; "
      "a file without that line describes a fluid without one. The file's name is relative to the parameter "
      "file that gives it (on the command line: to the working directory).");
    declare_yield(prm, "μ + m τ0, μ that of the first strain rate above zero");
  }



  void TableLaw::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    parse_yield(prm);
    if (prm.get("File").empty())
      prm.throw_wrong_value("File", "the name of a text file of strain rates and stresses");

    const NumberTable table(prm.get("File"), {"strain rate (1/s)", "stress (Pa)"});
    const auto &rows = table.rows();
    if (rows.size() < 2)
      table.throw_wrong_table("has " + std::to_string(rows.size()) + " lines with numbers", "at least two");
    for (unsigned int i = 0; i < rows.size(); ++i)
    {
      if (rows[i][0] < 0. || rows[i][1] < 0. || (rows[i][1] == 0. && rows[i][0] > 0.))
        table.throw_wrong_row(i, "a strain rate of zero or above and a stress above zero, at rest also zero");
      if (i > 0 && !(rows[i][0] > rows[i - 1][0] && rows[i][1] > rows[i - 1][1]))
        table.throw_wrong_row(i, "a strain rate and a stress that are larger than those of the row before");
    }

    const bool has_rest = rows[0][0] == 0.;
    tau_0               = has_rest ? rows[0][1] : 0.;
    parse_thixotropy(prm);
    std::vector<double> x, y;
    for (unsigned int i = has_rest; i < rows.size(); ++i)
    {
      x.push_back(std::log(rows[i][0]));
      y.push_back(std::log(rows[i][1] - tau_0));
    }
    logarithms      = MonotoneCurve(x, y, 1.);
    first_rate      = rows[has_rest][0];
    first_viscosity = (rows[has_rest][1] - tau_0) / first_rate;
  }



  FluidLaw::Value TableLaw::viscous_part(const double strain_rate, const double /*pressure*/) const
  {
    if (strain_rate <= first_rate)
      return {first_viscosity, 0.};
    const auto [log_stress, slope] = logarithms(std::log(strain_rate));
    const double viscosity         = std::exp(log_stress) / strain_rate;
    return {viscosity, (slope - 1.) * viscosity / strain_rate};
  }



  static const Factory<FluidLaw>::Registration<TableLaw> table_law(
    "table",
    "Stresses at given strain rates from a file; a yield stress, regularised by Papanastasiou or exact.");
} // namespace Lahar
