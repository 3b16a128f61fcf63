// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_particle_spacing_h
#define lahar_remeshing_particle_spacing_h

#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>
#include <lahar/remeshing/old_domain.h>
#include <lahar/utilities/parameters.h>

#include <vector>

namespace Lahar
{
  class SurfaceChain;

  /**
   * Keeps the distance of neighbouring particles near the spacing h.
   *
   * Edges of the mesh shorter than c_min h lose a fluid particle: the inner one of the two, so that the domain keeps
   * its shape. Two particles at the end of one edge of a plane free surface are merged into one, which is placed so
   * that the area under the surface stays, with rotational symmetry the volume. Particles nearer than h/10 to a wall
   * that carries particles go: Delaunay simplices between them and the wall would be flat, and those through a thin
   * wall would take their place. In the plane a particle that has landed and one of the free surface come as near to each
   * other as 0.3 c_min h: the bed and the rim of a thin layer stay. Edges longer than c_max h get a particle in their
   * middle.
   *
   * In space a long edge stays as it is where that particle would do harm, see harmful_midpoints().
   *
   * Particles on an interface between fluids give way to others on one only: of a short edge the other particle goes,
   * but one that holds the shape of the domain only where the two are very near. In the plane two neighbours along an
   * interface are merged so that the areas, or volumes, of both fluids stay. Inner particles that an interface face
   * sees in its smallest ball go, too; so such faces are Delaunay. Where fluids have met, the edges between particles
   * of the one and of the other get a particle in their middle, or lose one end if they are short; the new particle, or
   * the other end, belongs to both. A new particle belongs to the fluids of all cells around its edge.
   *
   * Short edges come in the order of their particles, the longest of the long edges first, and each particle is changed
   * once. As what happens to an edge depends on its surroundings only, this goes in rounds: of several short edges that
   * would change the same particle the first one has its way, an edge is divided if it is the longest one at both of its
   * ends, and so on with those that are left. So all ranks come to the same result together.
   */
  template <int dim>
  class ParticleSpacing
  {
  public:
    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /// Of the case; one by default.
    void set_number_of_fluids(const unsigned int n)
    {
      several_fluids = n > 1;
    }

    /**
     * Remove and insert particles along the edges of @p mesh; @p old_domain and @p migration follow. The mesh is of no
     * use afterwards. Collective.
     * @return whether any rank's own particles have changed.
     */
    bool adapt(ParticleCloud<dim> &cloud, const Walls<dim> &walls, const FluidMesh<dim> &mesh,
               OldDomain<dim> &old_domain, Migration<dim> &migration) const;

  private:
    using Edge = std::pair<unsigned int, unsigned int>;

    /// What may become of a short edge.
    struct Removal
    {
      unsigned int removed;
      std::vector<unsigned int> moved;  ///< the particle that takes the place of both, if one does
      std::vector<unsigned int> needed; ///< particles that must stay as they are
      Point<dim> place;                 ///< of the moved particle, m
    };

    /// What has become of the particles so far, as flags to be exchanged.
    struct Changes
    {
      std::vector<double> removed, merged;
    };

    /// The removals that are possible of the @p short_edges, in their order. @param rank by particle, the higher
    /// ones stay. @param chains in the plane the free surface and the interfaces.
    std::vector<Removal> find_candidates(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                         const std::vector<Edge> &short_edges,
                                         const std::vector<unsigned int> &rank,
                                         const std::array<SurfaceChain, 2> &chains,
                                         const Changes &changes) const;

    /// Particles to remove; merges move the surviving ones.
    std::vector<bool> find_removals(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                    const FluidMesh<dim> &mesh, const std::vector<Edge> &edges,
                                    const Migration<dim> &migration) const;

    /// Edges to divide, by their first particle; that is its owner's decision.
    std::vector<Edge> find_insertions(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                      const FluidMesh<dim> &mesh, const std::vector<Edge> &edges,
                                      const std::vector<bool> &removed,
                                      const Migration<dim> &migration) const;

    /// Append the particles in the middle of the @p edges of the mesh, which are sorted: the longest one's has the smallest
    /// number.
    void insert(std::vector<Edge> &edges, const FluidMesh<dim> &mesh, const Migration<dim> &migration,
                ParticleCloud<dim> &cloud) const;

    double shortest = 0.6, longest = 1.5;
    bool several_fluids = false; ///< in the case; a rank may see one of them only
  };
} // namespace Lahar

#endif
