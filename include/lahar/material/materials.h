// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_materials_h
#define lahar_material_materials_h

#include <lahar/material/fluid_law.h>

#include <algorithm>
#include <vector>

namespace Lahar
{
  /**
   * The laws of a case's fluids, by the fluids' numbers, and what is asked of all of them together. The laws outlive it.
   */
  class Materials
  {
  public:
    /// None yet.
    Materials() = default;

    /// One fluid.
    Materials(const FluidLaw &law) // NOLINT: a law is all that one fluid needs
      : laws{&law}
    {}

    /// @pre not empty.
    explicit Materials(const std::vector<const FluidLaw *> &laws)
      : laws(laws)
    {}

    unsigned int n_fluids() const
    {
      return laws.size();
    }

    const FluidLaw &law(const unsigned int fluid) const
    {
      return *laws[fluid];
    }

    /// kg/m³.
    double largest_density() const
    {
      double largest = 0.;
      for (const FluidLaw *law : laws)
        largest = std::max(largest, law->density());
      return largest;
    }

    /// Whether any fluid has a yield stress.
    bool any_yields() const
    {
      return std::any_of(laws.begin(), laws.end(),
                         [](const FluidLaw *law) { return law->has_yield_stress(); });
    }

    /// Whether any fluid has a yield stress that is not regularised.
    bool any_exact_yield_stress() const
    {
      return std::any_of(laws.begin(), laws.end(),
                         [](const FluidLaw *law) { return law->has_exact_yield_stress(); });
    }

    /// Whether the yield gap is asked of a fluid: of those with an exact yield stress if there are any, else of all that
    /// yield.
    bool counts_in_gap(const unsigned int fluid) const
    {
      return any_exact_yield_stress() ? law(fluid).has_exact_yield_stress() : law(fluid).has_yield_stress();
    }

    /// See FluidLaw::may_be_ill_posed().
    bool may_be_ill_posed() const
    {
      return std::any_of(laws.begin(), laws.end(),
                         [](const FluidLaw *law) { return law->may_be_ill_posed(); });
    }

    /// Whether any fluid has a Thixotropy.
    bool any_thixotropic() const
    {
      return std::any_of(laws.begin(), laws.end(),
                         [](const FluidLaw *law) { return law->thixotropy().is_there(); });
    }

    /// Whether all fluids are incompressible.
    bool all_incompressible() const
    {
      return std::all_of(laws.begin(), laws.end(),
                         [](const FluidLaw *law) { return law->compressibility() == 0.; });
    }

    /// Whether any fluid is incompressible.
    bool any_incompressible() const
    {
      return std::any_of(laws.begin(), laws.end(),
                         [](const FluidLaw *law) { return law->compressibility() == 0.; });
    }

  private:
    std::vector<const FluidLaw *> laws;
  };
} // namespace Lahar

#endif
