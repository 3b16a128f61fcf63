// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_alpha_shape_h
#define lahar_remeshing_alpha_shape_h

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/old_domain.h>
#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * Decides which Delaunay simplices are fluid.
   *
   * Always dropped: simplices of wall particles only, simplices without volume, simplices with an edge through a wall
   * but for chords of smooth bulges (through a wall that carries particles: outside the old domain only).
   *
   * `plain`: the others are fluid if R < α h; R circumradius, h mean spacing of the corners (Franci & Zhang 2018).
   *
   * `advected`: the rule depends on where the simplex lies with respect to the old domain, the cells of the last mesh
   * carried along by the flow.
   * - Inside it, a simplex stays fluid as long as R < α_keep h. Here and at walls, the longest edge counts instead of R
   *   if it is shorter: a flat simplex between a particle and the wall before it stays.
   * - Outside it, a simplex becomes fluid where fluid meets a wall, a solid or fluid: it shrinks (by 1e-6 of its
   *   volume or more in the next step), and the gap (between its fluid and its other corners; with fluid corners only,
   *   its smallest height) is below 0.15 h or closes within the next step (with walls R < α_keep h, else R < α h). In a
   *   hollow of one surface, where edges of the last mesh join the corners, R < 0.8 h too: what is flatter is a bent
   *   surface and no gap. A wider gap would turn more air into fluid: with R < 0.8 h alone, a common choice, a splash
   *   gains 20 % of volume, with this rule 1 %.
   * - Or, with dry and wet wall particles, if the fluid has spread along the wall: each dry one has a fluid particle
   *   nearer to it than to the simplex's wet ones, and the gap is below 0.6 h (R < α h).
   * - But never with an isolated particle as a corner: a flat cell would give it hardly any mass, and too little to
   *   resist what the flow asks of it. The old domain takes it up, without any volume, where it passes over it.
   *
   * So the fluid neither climbs a dry wall at rest nor swallows the air that it moves towards.
   */
  template <int dim>
  class AlphaShape
  {
  public:
    enum class Verdict
    {
      no_fluid,
      stays_fluid,  ///< inside the old domain
      becomes_fluid ///< outside it
    };

    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /**
     * Whether a rule may accept the simplex, whatever the walls, the old domain and the velocities are: it is none of
     * those always dropped, and its size, as that counts inside the old domain, is below α_keep h.
     */
    bool is_candidate(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud) const;

    /**
     * No edge of a candidate is longer than this times the largest spacing of its corners: its longest edge or, with
     * it, 2 R is below 2 α_keep h.
     */
    double reach() const
    {
      return 2. * alpha_keep;
    }

    /// For a candidate that the fluid is asked to fill at the start: whether R < α_keep h, and no edge passes through a
    /// wall.
    bool accepts_first(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                       const Walls<dim> &walls) const;

    /// The plain rule.
    bool accepts_plain(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                       const Walls<dim> &walls) const;

    /// The rule chosen by the parameters, for a candidate. @p time_step (s) is the time that the velocities of the
    /// cloud will last.
    Verdict judge(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                  const OldDomain<dim> &old_domain, const double time_step) const;

  private:
    /// Whether the fluid has spread to the dry wall particles of a simplex outside the old domain.
    bool spreads_along_wall(const Simplex<dim> &simplex, const SimplexCorners<dim> &corners,
                            const ParticleCloud<dim> &cloud, const OldDomain<dim> &old_domain) const;

    bool advected = true;
    double alpha = 1.25, alpha_keep = 2.5;
  };
} // namespace Lahar

#endif
