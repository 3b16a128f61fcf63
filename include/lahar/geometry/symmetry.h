// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_symmetry_h
#define lahar_geometry_symmetry_h

#include <deal.II/base/numbers.h>

#include <lahar/geometry/simplex_geometry.h>

#include <cmath>

namespace Lahar
{
  /**
   * How the program's case in the plane is read: as it is, per metre of depth, or as the half plane x = r ≥ 0, y = z of
   * a body with rotational symmetry about the axis x = 0. In the latter volumes, masses and forces are those of the
   * whole body.
   *
   * Like the space dimension this holds for the whole program. The entry 'Geometry' sets it (RunParameters) before
   * anything is computed.
   */
  class Symmetry
  {
  public:
    static bool is_rotational()
    {
      return rotational;
    }

    static void set_rotational(const bool value)
    {
      rotational = value;
    }

    /// Whether it concerns a case of the dimension @p dim.
    template <int dim>
    static bool applies()
    {
      return dim == 2 && rotational;
    }

  private:
    inline static bool rotational = false;
  };

  /// The component of positions and velocities along r.
  constexpr unsigned int radial = 0;

  /// Volume with sign that a simplex stands for: with rotational symmetry its ring's, 2π |r̄| A, r̄ at the centroid.
  template <int dim>
  inline double body_volume(const SimplexCorners<dim> &x)
  {
    const double volume = signed_volume<dim>(x);
    return Symmetry::applies<dim>() ? 2. * numbers::PI * std::abs(centroid<dim>(x)[0]) * volume : volume;
  }

  /// ∫ N_I over what a simplex stands for: with rotational symmetry 2π A (r_I + Σ_J r_J)/12, where @p size is A.
  inline double ring_share(const double size, const double sum_of_radii, const double radius)
  {
    return 2. * numbers::PI * size * (radius + sum_of_radii) / 12.;
  }

  /// The parts ∫ N_I of body_volume().
  template <int dim>
  inline std::array<double, dim + 1> body_volume_shares(const SimplexCorners<dim> &x)
  {
    std::array<double, dim + 1> shares;
    const double volume = signed_volume<dim>(x);
    double sum_of_radii = 0.;
    for (const Point<dim> &corner : x)
      sum_of_radii += corner[0];
    for (unsigned int I = 0; I <= dim; ++I)
      shares[I] = Symmetry::applies<dim>() ? ring_share(volume, sum_of_radii, x[I][0]) : volume / (dim + 1);
    return shares;
  }

  /// ∫ N of one corner at @p radius over what a face of this @p area stands for: with rotational symmetry
  /// π L (r + Σ r)/3, @p sum_of_radii over the face's corners; else the area over dim. Areas may be vectors.
  template <int dim, typename Area>
  inline Area face_share(const Area &area, const double sum_of_radii, const double radius)
  {
    return Symmetry::applies<dim>() ? numbers::PI / 3. * (radius + sum_of_radii) * area : area / dim;
  }
} // namespace Lahar

#endif
