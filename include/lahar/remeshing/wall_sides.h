// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_wall_sides_h
#define lahar_remeshing_wall_sides_h

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>

#include <functional>
#include <vector>

namespace Lahar
{
  /**
   * Thin walls in space, and on which side of them particles are.
   *
   * A facet is thin that has fluid particles nearer than their spacing on both of its sides. Thin facets that go on
   * smoothly into each other are a sheet. What is nearer to a sheet than @p distance is on one of its sides, if the
   * nearest place of the sheet is not on its rim.
   */
  class WallSides
  {
  public:
    /// The arguments must outlive this object. @param distance m
    WallSides(const ParticleCloud<3> &cloud, const Walls<3> &walls, const double distance);

    /// Whether no wall is thin.
    bool empty() const
    {
      return n_sheets == 0;
    }

    /// By sheet the side (1 or −1) on which a particle is, 0 where it is on none; empty if it is far from all sheets.
    const std::vector<signed char> &sides(const unsigned int particle) const
    {
      return all_sides[particle];
    }

    /// Whether no sheet has what is on these sides on both of its own.
    static bool are_together(const std::vector<signed char> &a, const std::vector<signed char> &b);

    /// Whether corners of the simplex are on both sides of a sheet, and a wall lies between them.
    bool parts(const Simplex<3> &simplex) const;

    /// Whether a wall lies between two points.
    bool hides(const Point<3> &from, const Point<3> &point) const;

  private:
    /// The facets with fluid on both sides.
    std::vector<unsigned int> find_thin_facets() const;

    /// Whether @p to goes on smoothly where @p from ends, at one of its corners.
    bool goes_on(const unsigned int from, const unsigned int to) const;

    void find_sheets(const std::vector<unsigned int> &thin_facets);
    void find_sides(const double distance);

    const ParticleCloud<3> &cloud;
    const Walls<3> &walls;
    unsigned int n_sheets = 0;
    std::vector<unsigned int> sheets; ///< by facet, invalid_unsigned_int for those that are not thin
    std::vector<signed char>
      directions; ///< by facet, 1 if its normal points to the side 1 of its sheet, else −1
    std::vector<std::vector<signed char>> all_sides; ///< by particle
  };

  /**
   * Make of a Delaunay triangulation one in which thin walls part what is on their two sides: simplices with corners on
   * both sides go, and those come whose circumball holds no particle but such that a wall hides from their centroid.
   *
   * These are simplices of the triangulation without the particles on other sides, which is made of what is near to the
   * walls for all sides and their combinations that this rank's particles are on. Away from the rims of thin walls the
   * result is the triangulation of each side for itself.
   *
   * @param reach the diameter of the circumball of a simplex that comes is smaller, m.
   * @param matters as of local_delaunay(), which has made @p simplices.
   */
  void part_sides_of_walls(const ParticleCloud<3> &cloud, const Walls<3> &walls, const double reach,
                           const std::function<bool(const Simplex<3> &)> &matters,
                           std::vector<Simplex<3>> &simplices);
} // namespace Lahar

#endif
