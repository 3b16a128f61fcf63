// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_ill_posed_cells_h
#define lahar_simulator_ill_posed_cells_h

#include <lahar/postprocess/postprocessor.h>

#include <boost/serialization/split_member.hpp>

#include <string>

namespace Lahar
{
  /**
   * Counts the cells that flow under pressure and those of them in which the equations of the fluid's law are ill-posed
   * (FluidLaw::is_well_posed()): what is seen there depends on the mesh.
   */
  template <int dim>
  class IllPosedCells
  {
  public:
    /// Count those of a step.
    void add(const Snapshot<dim> &snapshot);

    /// A warning where many of all that were counted are ill-posed, and nothing otherwise. Collective.
    std::string warning(const MPI_Comm &communicator) const;

    /// What this rank has counted; what several ranks have counted adds up.
    template <typename Archive>
    void save(Archive &archive, const unsigned int /*version*/) const
    {
      archive << n_flowing << n_ill_posed;
    }

    template <typename Archive>
    void load(Archive &archive, const unsigned int /*version*/)
    {
      double flowing = 0., ill_posed = 0.;
      archive >> flowing >> ill_posed;
      n_flowing += flowing;
      n_ill_posed += ill_posed;
    }
    BOOST_SERIALIZATION_SPLIT_MEMBER()

  private:
    double n_flowing = 0., n_ill_posed = 0.; ///< this rank's own
  };
} // namespace Lahar

#endif
