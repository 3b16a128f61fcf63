// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/output_field.h>
#include <lahar/simulator/ill_posed_cells.h>

#include <sstream>

namespace Lahar
{
  namespace
  {
    /// The part of the cells that flow beyond which the ill-posed ones are a matter for a warning.
    constexpr double largest_quiet_part = 0.1;
  } // namespace



  template <int dim>
  std::string IllPosedCells<dim>::news(const Snapshot<dim> &snapshot)
  {
    if (has_warned || !snapshot.law.may_be_ill_posed())
      return "";
    const auto &cells = snapshot.mesh.particle_cells();
    double n_flowing = 0., n_ill_posed = 0.;
    for_each_cell(snapshot, [&](const unsigned int c, const FluidCell<dim> &cell) {
      const double rate = cell.strain_rate, pressure = cell.confining_pressure();
      if (!snapshot.cloud.is_own(cells[c]) || pressure == 0. || !snapshot.law.is_yielded(rate, pressure))
        return;
      ++n_flowing;
      n_ill_posed += !snapshot.law.is_well_posed(rate, pressure);
    });
    n_flowing   = snapshot.sum_of_ranks(n_flowing);
    n_ill_posed = snapshot.sum_of_ranks(n_ill_posed);
    if (n_ill_posed <= largest_quiet_part * n_flowing)
      return "";
    has_warned = true;
    std::ostringstream text;
    text
      << "Warning: time " << snapshot.time
      << " s: the inertial number is outside the range in which the equations "
      << "of the fluid's law are well-posed in " << 100. * n_ill_posed / n_flowing << " % of the "
      << n_flowing
      << " cells that flow under pressure. Bands of shear there are as wide as the cells, whatever 'Mesh size' is.";
    return text.str();
  }



  template class IllPosedCells<2>;
  template class IllPosedCells<3>;
} // namespace Lahar
