// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_solid_contour_h
#define lahar_boundary_solid_contour_h

#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>

namespace Lahar
{
  /**
   * The contours of the solids at one time, as facets between their particles.
   *
   * @p facets are particle indices, as they stand in SolidMesh::contour(): normals point out of the solid. As walls they
   * belong to the boundary that has the number of the solid; fluid lands on those whose particles are slick.
   */
  template <int dim>
  class SolidContour
  {
  public:
    using Facet = std::array<unsigned int, dim>;

    /// @param unevenness how far rough walls may reach into a foot that stands on them, m.
    SolidContour(const std::vector<Facet> &facets, const ParticleCloud<dim> &cloud,
                 const double unevenness = 0.);

    /// The facets as particle indices.
    const std::vector<Facet> &facets() const
    {
      return particles;
    }

    /// The facets as walls.
    const std::vector<WallFacet<dim>> &wall_facets() const
    {
      return shapes.facets();
    }

    double unevenness() const
    {
      return uneven;
    }

    /// Those facets on which fluid lands, or the others.
    std::vector<Facet> facets_that_land(const bool lands) const;

    /// The facets on which fluid lands, or the others, as walls.
    std::vector<WallFacet<dim>> wall_facets_that_land(const bool lands) const;

    /// Whether @p point lies in a solid: the contour's winding number around it is not zero.
    bool is_inside(const Point<dim> &point) const;

    /**
     * Keep the fluid particles out of the solids. @p cloud has them after a step in which all particles, the contour's
     * too, came from @p old_position. A particle that has passed through a facet (in the facet's frame, both paths
     * taken as straight) or lies inside is put a tenth of its spacing in front of the contour and takes its velocity.
     * @return how many of them are this rank's own.
     */
    unsigned int keep_out(const std::vector<Point<dim>> &old_position, ParticleCloud<dim> &cloud) const;

  private:
    /// Put the particle in front of facet @p f, at the point of the facet nearest to it.
    void put_before(const unsigned int f, const unsigned int particle, ParticleCloud<dim> &cloud) const;
    unsigned int nearest_facet(const Point<dim> &point) const;

    std::vector<Facet> particles;
    Walls<dim> shapes;
    BoundingBox<dim> box;
    double uneven;
  };
} // namespace Lahar

#endif
