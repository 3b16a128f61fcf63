// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_pore_water_h
#define lahar_material_pore_water_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <lahar/utilities/parameters.h>

#include <algorithm>

namespace Lahar
{
  using namespace dealii;

  /**
   * Water that is at rest in the pores between grains, up to a level (Terzaghi's effective stress with a hydrostatic pore
   * pressure):
   *
   *   p_w = ρ_w max(|g| z_w + g·x, 0),
   *
   * ρ_w its density and z_w its level, a height against the direction of gravity g, measured from the origin. Of the
   * pressure of the mixture of grains and water the grains bear what is above p_w. By default there is no water. Without
   * gravity p_w is zero.
   */
  class PoreWater
  {
  public:
    /// Declare `Pore water level` and `Pore water density`.
    static void declare_parameters(Parameters &prm);

    /// @param density of grains and pores with what is in them, kg/m³. @throws InputError
    void parse_parameters(const Parameters &prm, const double density);

    bool is_there() const
    {
      return rho_w > 0.;
    }

    /// p_w at @p point with @p gravity in m/s², Pa.
    template <int dim>
    double pressure(const Point<dim> &point, const Tensor<1, dim> &gravity) const
    {
      return rho_w * std::max(level * gravity.norm() + gravity * point, 0.);
    }

    /// ∇p_w, Pa/m; zero above the level.
    template <int dim>
    Tensor<1, dim> gradient(const Point<dim> &point, const Tensor<1, dim> &gravity) const
    {
      return pressure(point, gravity) > 0. ? rho_w * gravity : Tensor<1, dim>();
    }

  private:
    double rho_w = 0.; ///< zero where there is no water
    double level = 0.; ///< z_w, m
  };
} // namespace Lahar

#endif
