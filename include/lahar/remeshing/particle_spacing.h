#ifndef lahar_remeshing_particle_spacing_h
#define lahar_remeshing_particle_spacing_h

#include <lahar/boundary/walls.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/old_domain.h>
#include <lahar/utilities/parameters.h>

#include <vector>

namespace Lahar
{
  /**
   * Keeps the distance of neighbouring particles near the spacing h.
   *
   * Edges of the mesh shorter than c_min h lose a fluid particle: the inner one of the two, so that the domain keeps
   * its shape. Two particles at the end of one edge of a plane free surface are merged into one, which is placed so
   * that the area under the surface stays. Particles nearer to a no-slip wall than h/10 go: Delaunay simplices between
   * them and the wall would be flat, and those through a thin wall would take their place. Edges longer than c_max h
   * get a particle in their middle.
   */
  template <int dim>
  class ParticleSpacing
  {
  public:
    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /// Remove and insert particles along the edges of @p mesh; @p old_domain follows. The mesh is of no use afterwards.
    void adapt(ParticleCloud<dim> &cloud, const Walls<dim> &walls, const FluidMesh<dim> &mesh,
               OldDomain<dim> &old_domain) const;

  private:
    using Edge = std::pair<unsigned int, unsigned int>;

    /// Particles to remove; merges move the surviving ones.
    std::vector<bool> find_removals(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                    const FluidMesh<dim> &mesh, const std::vector<Edge> &edges) const;

    /// Edges to divide.
    std::vector<Edge> find_insertions(const ParticleCloud<dim> &cloud, const std::vector<Edge> &edges,
                                      const std::vector<bool> &removed) const;

    double shortest = 0.6, longest = 1.5;
  };
} // namespace Lahar

#endif
