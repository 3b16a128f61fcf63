// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_fluid_accounts_h
#define lahar_simulator_fluid_accounts_h

#include <lahar/simulator/volume_account.h>

#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * A VolumeAccount of each fluid of a case with several, and what they have exchanged; without fluids where there is one
   * only. Remeshing changes a fluid's volume also where cells of one become cells of another. In each remeshing at least
   *
   *   (Σ_f |ΔV_f| − |Σ_f ΔV_f|)/2
   *
   * has done so. Each function takes the volumes of the fluids on all ranks at present.
   */
  template <int dim>
  class FluidAccounts
  {
  public:
    using Volumes = std::vector<double>; ///< by fluid, m^dim

    void begin(const std::vector<std::string> &fluid_names, const Volumes &volumes);

    void solved(const Volumes &volumes, const Volumes &inflow, const Volumes &left_out);
    void remeshed(const Volumes &volumes);
    /// After interfaces have moved to give back what was exchanged; counts with remeshing.
    void corrected(const Volumes &volumes);
    void went_out(const Volumes &volumes);
    void left(const Volumes &volumes);

    /// By fluid what solver and remeshing have given it too much, m^dim: its change less its part, by its volume, of all
    /// fluids' change. The sum is zero.
    Volumes excess() const;

    /// Of each fluid 'NAME volume (m^dim)', 'NAME volume change by solver' and 'NAME volume change by remeshing', the
    /// changes relative to what there has been of it; and 'Volume exchanged between fluids', relative to all fluid at the
    /// start.
    void add_columns(TableHandler &statistics) const;

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &accounts &exchanged;
    }

  private:
    std::vector<std::string> names;
    std::vector<VolumeAccount<dim>> accounts;
    double exchanged = 0.; ///< m^dim
  };
} // namespace Lahar

#endif
