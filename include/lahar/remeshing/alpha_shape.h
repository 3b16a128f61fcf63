#ifndef lahar_remeshing_alpha_shape_h
#define lahar_remeshing_alpha_shape_h

#include <lahar/boundary/walls.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/delaunay.h>
#include <lahar/remeshing/old_domain.h>
#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * Decides which Delaunay simplices are fluid.
   *
   * Always dropped: simplices of wall particles only, simplices without volume, simplices with an edge through a wall.
   *
   * `plain`: the others are fluid if R < α h; R circumradius, h mean spacing of the corners (Franci & Zhang 2018).
   *
   * `advected`: the rule depends on where the simplex lies with respect to the old domain, the cells of the last mesh
   * carried along by the flow.
   * - Inside it, a simplex stays fluid as long as R < α_keep h.
   * - Outside it, a simplex of fluid particles only becomes fluid if R < α_merge h.
   * - Outside it, a simplex with wall particles becomes fluid if R < α h and the fluid has arrived:
   *   - dry and wet wall particles: each dry one has a fluid particle nearer to it than to the simplex's wet ones, so
   *     that fluid climbs or spreads along a wall only as far as it has moved;
   *   - dry wall particles only: the simplex shrinks, and the fluid is nearer to the wall than h/2 or would reach it
   *     within two steps.
   * The first mesh follows the plain rule with α_merge for what touches no wet particle.
   */
  template <int dim>
  class AlphaShape
  {
  public:
    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /// The plain rule.
    bool accepts_plain(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                       const Walls<dim> &walls) const;

    /// The rule chosen by the parameters. @p time_step (s) is the time that the velocities of the cloud will last.
    bool accepts(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                 const OldDomain<dim> &old_domain, const double time_step) const;

  private:
    bool is_arriving(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                     const OldDomain<dim> &old_domain, const double h, const double time_step) const;

    bool advected = true;
    double alpha = 1.25, alpha_keep = 2.5, alpha_merge = 0.8;
  };
} // namespace Lahar

#endif
