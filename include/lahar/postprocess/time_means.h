// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_postprocess_time_means_h
#define lahar_postprocess_time_means_h

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

#include <map>
#include <string>

namespace Lahar
{
  /**
   * Means over the steps since the last snapshot that was due, q̄ = Σ q Δt/Σ Δt, of quantities that are told apart by their names.
   * Each step adds each quantity once; a quantity that comes later counts as zero before.
   */
  class TimeMeans
  {
  public:
    /// Begin anew, at a snapshot.
    void restart()
    {
      duration = 0.;
      integrals.clear();
    }

    /// The quantities that are added next are those of a step of length @p new_time_step (s).
    void start_step(const double new_time_step)
    {
      time_step = new_time_step;
      duration += time_step;
    }

    /// Add the value of this step. @return the mean so far.
    double add(const std::string &quantity, const double value)
    {
      double &integral = integrals[quantity];
      integral += value * time_step;
      return integral / duration;
    }

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &duration &integrals;
    }

  private:
    double time_step = 0., duration = 0.;
    std::map<std::string, double> integrals; ///< Σ q Δt
  };
} // namespace Lahar

#endif
