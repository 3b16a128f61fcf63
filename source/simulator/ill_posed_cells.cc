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
  void IllPosedCells<dim>::add(const Snapshot<dim> &snapshot)
  {
    if (!snapshot.materials.may_be_ill_posed())
      return;
    const auto &cells = snapshot.mesh.particle_cells();
    for_each_cell(snapshot, [&](const unsigned int c, const CellFlow<dim> &cell) {
      const FluidLaw &law = snapshot.law(c);
      const double rate = cell.strain_rate(), pressure = cell.confining_pressure(law, snapshot.gravity);
      if (!law.may_be_ill_posed() || !snapshot.cloud.is_own(cells[c]) || pressure == 0. ||
          !law.is_yielded(rate, pressure))
        return;
      ++n_flowing;
      n_ill_posed += !law.is_well_posed(rate, pressure);
    });
  }



  template <int dim>
  std::string IllPosedCells<dim>::warning(const MPI_Comm &communicator) const
  {
    const double all       = Utilities::MPI::sum(n_flowing, communicator),
                 ill_posed = Utilities::MPI::sum(n_ill_posed, communicator);
    if (ill_posed <= largest_quiet_part * all)
      return "";
    std::ostringstream text;
    text.precision(3);
    text
      << "Warning: in " << 100. * ill_posed / all
      << " % of the cells that flowed under pressure, all steps of this run together, the inertial number was outside the range "
         "in which the equations of the fluid's law are well-posed. Bands of shear there are as wide as the cells, "
         "whatever 'Mesh size' is.";
    return text.str();
  }



  template class IllPosedCells<2>;
  template class IllPosedCells<3>;
} // namespace Lahar
