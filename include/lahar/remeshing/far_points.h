// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_far_points_h
#define lahar_remeshing_far_points_h

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/migration.h>
#include <lahar/remeshing/point_tree.h>

#include <map>
#include <memory>
#include <vector>

namespace Lahar
{
  /**
   * Finds particles of other ranks in circumballs that reach beyond the region of which this rank knows all particles.
   */
  template <int dim>
  class FarPoints
  {
  public:
    /// @param margin at the rim of its region where a rank may lack particles, and by which a rank's own particles may
    /// have left their box, m. The arguments must outlive this object.
    FarPoints(const ParticleCloud<dim> &cloud, const Migration<dim> &migration, const double margin);

    /// Whether some of a ball lies where this rank does not know all particles.
    bool is_open(const Point<dim> &centre, const double radius) const;

    /// A simplex, and how many of the particles in its circumball are wanted.
    struct Query
    {
      SimplexCorners<dim> corners;
      unsigned int n_wanted;
    };

    /**
     * Of each rank the particles nearest to the simplices' centroids that lie in the balls and beyond this rank's
     * region, each particle once in the life of this object. Collective.
     */
    std::vector<Point<dim>> find(const std::vector<Query> &queries);

  private:
    /// A box of @p bounds, lower and upper ones by direction.
    static bool is_in_box(const Point<dim> &point, const double *bounds);
    std::vector<double> answer(const unsigned int asker, const std::vector<double> &questions);

    const ParticleCloud<dim> &cloud;
    const Migration<dim> &migration;
    double margin;
    std::vector<double> known; ///< bounds of the region, none if this rank has no particles
    std::unique_ptr<PointTree<dim>> tree;
    std::map<unsigned int, std::vector<bool>> told; ///< by rank and particle
  };
} // namespace Lahar

#endif
