// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_ill_posed_cells_h
#define lahar_simulator_ill_posed_cells_h

#include <lahar/postprocess/postprocessor.h>

#include <string>

namespace Lahar
{
  /**
   * Tells once a run if the equations of the fluid's law are ill-posed in many of the cells that flow
   * (FluidLaw::is_well_posed()): what is seen there depends on the mesh.
   */
  template <int dim>
  class IllPosedCells
  {
  public:
    /// A warning at the first call at which there are many of them, and nothing otherwise. Collective.
    std::string news(const Snapshot<dim> &snapshot);

  private:
    bool has_warned = false;
  };
} // namespace Lahar

#endif
