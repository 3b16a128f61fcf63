// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/alpha_shape.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// Simplices below this fraction of h^dim are taken for flat.
    constexpr double flat_volume = 1e-6;

    /// Fluid that moves towards a wall or towards fluid meets it where the gap is below this times h …
    constexpr double closing_gap = 0.15;
    /// … or where the simplex in the gap loses this part of its volume within the next step.
    constexpr double closing_shrinkage = 0.7;
    /// A simplex that loses less than this part of its volume within the next step is at rest.
    constexpr double resting_shrinkage = 1e-6;
    /// A hollow of one free surface closes only where the circumradius is below this times h.
    constexpr double hollow_radius = 0.8;
    /// Fluid that has passed a dry wall particle spreads to it where the gap is below this times h.
    constexpr double spreading_gap = 0.6;

    template <int dim>
    double mean_spacing(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud)
    {
      double sum = 0.;
      for (const unsigned int particle : simplex)
        sum += cloud.spacing[particle];
      return sum / (dim + 1);
    }

    /// Whether the simplex can be no fluid, whatever its size.
    template <int dim>
    bool is_excluded(const Simplex<dim> &simplex, const SimplexCorners<dim> &corners, const double h,
                     const ParticleCloud<dim> &cloud)
    {
      const bool has_fluid = std::any_of(simplex.begin(), simplex.end(), [&](const unsigned int particle) {
        return cloud.kind[particle] == ParticleKind::fluid;
      });
      return !has_fluid || signed_volume<dim>(corners) < flat_volume * std::pow(h, dim);
    }

    /// The rate at which the simplex shrinks, −V'/V = −div v, 1/s; of a ring its section.
    template <int dim>
    double shrinkage(const Simplex<dim> &simplex, const SimplexCorners<dim> &corners,
                     const ParticleCloud<dim> &cloud)
    {
      const auto gradients = shape_gradients<dim>(corners);
      double sum           = 0.;
      for (unsigned int c = 0; c <= dim; ++c)
        sum -= cloud.velocity[simplex[c]] * gradients[c];
      return sum;
    }

    /// The circumradius, but of a simplex that is flat rather than large the longest edge: a particle close to a wall
    /// must not lose its contact.
    template <int dim>
    double extent(const SimplexCorners<dim> &corners)
    {
      double longest = 0.;
      for (unsigned int a = 0; a <= dim; ++a)
        for (unsigned int b = a + 1; b <= dim; ++b)
          longest = std::max(longest, corners[a].distance_square(corners[b]));
      return std::min(circumradius<dim>(corners), std::sqrt(longest));
    }

    /// The gap that the simplex bridges: between its fluid and its wall corners (the sum of the fluid's shape functions
    /// rises from 0 to 1 in it), or, of fluid only, its smallest height.
    template <int dim>
    double gap_in(const Simplex<dim> &simplex, const SimplexCorners<dim> &corners,
                  const ParticleCloud<dim> &cloud)
    {
      double steepest = 0.;
      bool any_wall   = false;
      Tensor<1, dim> rise;
      const auto gradients = shape_gradients<dim>(corners);
      for (unsigned int c = 0; c <= dim; ++c)
      {
        steepest = std::max(steepest, gradients[c].norm());
        if (cloud.kind[simplex[c]] == ParticleKind::fluid)
          rise += gradients[c];
        else
          any_wall = true;
      }
      return 1. / (any_wall ? rise.norm() : steepest);
    }

    /// Whether the simplex lies in what a smooth surface bulges around: its corners have landed on it, and from each of them
    /// a facet is in the way to the centroid. Its edges are chords.
    template <int dim>
    bool is_below_bulge(const Simplex<dim> &simplex, const SimplexCorners<dim> &corners, const double h,
                        const ParticleCloud<dim> &cloud, const Walls<dim> &walls)
    {
      if (!std::all_of(simplex.begin(), simplex.end(),
                       [&](const unsigned int i) { return cloud.in_contact(i); }))
        return false;
      const Point<dim> centre = centroid<dim>(corners);
      return std::all_of(corners.begin(), corners.end(), [&](const Point<dim> &corner) {
        const std::vector<unsigned int> between = walls.crossed(corner, centre, 0., 1e-3 * h);
        return std::any_of(between.begin(), between.end(),
                           [&](const unsigned int facet) { return walls.facets()[facet].lands; });
      });
    }

    /**
     * Whether an edge of the simplex passes through a wall. Particles of walls and solids lie on them; fluid in contact lies
     * off them, on its side. An edge that goes in and out again where a surface is smooth is its chord: fluid, too, unless
     * the whole simplex is below the bulge.
     *
     * @param only_without_particles look at walls without particles only.
     * @param uneven how deep, over h, an edge may pass below a wall that carries particles.
     */
    template <int dim>
    bool crosses_wall(const Simplex<dim> &simplex, const SimplexCorners<dim> &corners,
                      const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                      const bool only_without_particles = false, const double uneven = 1e-3)
    {
      const double h = mean_spacing<dim>(simplex, cloud);
      if (is_below_bulge<dim>(simplex, corners, h, cloud, walls))
        return true;
      // Cells of the old domain in space may pass a little below uneven ground.
      const double aside = dim == 3 && only_without_particles ? 0.1 : 1e-2 * contact_offset;
      // Normals of facets without particles that an edge passes through, and those of them that are not close to their rim.
      std::vector<Tensor<1, dim>> towards_a, must_end;
      for (unsigned int a = 0; a <= dim; ++a)
        for (unsigned int b = a + 1; b <= dim; ++b)
        {
          towards_a.clear();
          must_end.clear();
          for (const unsigned int facet : walls.crossed(corners[a], corners[b], 0., 1e-3 * h))
          {
            const double height_a = walls.signed_distance(facet, corners[a]),
                         height_b = walls.signed_distance(facet, corners[b]);
            const bool lands      = walls.facets()[facet].lands;
            const auto is_beside  = [&](const double height, const unsigned int c) {
              return std::abs(height) >
                     (lands && cloud.kind[simplex[c]] == ParticleKind::fluid ? aside : uneven) *
                       cloud.spacing[simplex[c]];
            };
            if (!is_beside(height_a, a) || !is_beside(height_b, b))
              continue;
            const Point<dim> hit = corners[a] + height_a / (height_a - height_b) * (corners[b] - corners[a]);
            // At the foot of a wall on another one, particles in contact with both pass just inside its rim.
            const bool inside = walls.is_above(facet, hit, (lands ? -0.1 * contact_offset : -1e-3) * h);
            if (lands)
            {
              towards_a.push_back(height_a > 0. ? walls.normal(facet) : -walls.normal(facet));
              if (inside)
                must_end.push_back(towards_a.back());
            }
            else if (inside && !only_without_particles)
              return true;
          }
          for (const Tensor<1, dim> &normal : must_end)
            if (std::none_of(towards_a.begin(), towards_a.end(), [&normal](const Tensor<1, dim> &other) {
                  return normal * other < -smooth_joint;
                }))
              return true;
        }
      return false;
    }
  } // namespace



  template <int dim>
  void AlphaShape<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Alpha shape");
    prm.declare_choice(
      "Rule", "advected", "plain|advected",
      "Which simplices are fluid: 'plain', all with a circumradius below Alpha times the spacing, or "
      "'advected', which remembers the fluid's domain of the step before and so keeps its volume.");
    prm.declare_number("Alpha", dim == 2 ? "1.25" : "1.35",
                       "Largest circumradius of a fluid simplex over the particles' spacing, 1 or above.", 1.,
                       10.);
    prm.declare_number("Alpha inside", "2.5",
                       "Rule 'advected': the same for simplices inside the old domain, Alpha or above.", 1.,
                       100.);
    prm.leave_subsection();
  }



  template <int dim>
  void AlphaShape<dim>::parse_parameters(Parameters &prm)
  {
    prm.enter_subsection("Alpha shape");
    if (prm.get("Rule") != "advected" && prm.get("Rule") != "plain")
      prm.throw_wrong_value("Rule", "plain|advected");
    advected   = prm.get("Rule") == "advected";
    alpha      = prm.get_in_range("Alpha", 1., 10.);
    alpha_keep = prm.get_in_range("Alpha inside", alpha, 100.);
    prm.leave_subsection();
  }



  template <int dim>
  bool AlphaShape<dim>::is_candidate(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud) const
  {
    const auto corners = corners_of<dim>(simplex, cloud.position);
    const double h     = mean_spacing<dim>(simplex, cloud);
    return !is_excluded<dim>(simplex, corners, h, cloud) && extent<dim>(corners) < alpha_keep * h;
  }



  template <int dim>
  bool AlphaShape<dim>::accepts_plain(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                                      const Walls<dim> &walls) const
  {
    const auto corners = corners_of<dim>(simplex, cloud.position);
    const double h     = mean_spacing<dim>(simplex, cloud);
    return !is_excluded<dim>(simplex, corners, h, cloud) && circumradius<dim>(corners) < alpha * h &&
           !crosses_wall<dim>(simplex, corners, cloud, walls);
  }



  template <int dim>
  bool AlphaShape<dim>::accepts_first(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                                      const Walls<dim> &walls) const
  {
    const auto corners = corners_of<dim>(simplex, cloud.position);
    const double h     = mean_spacing<dim>(simplex, cloud);
    // Chords between particles of uneven ground pass a little below it.
    constexpr double uneven = 0.1;
    return circumradius<dim>(corners) < alpha_keep * h &&
           !crosses_wall<dim>(simplex, corners, cloud, walls, false, uneven);
  }



  template <int dim>
  typename AlphaShape<dim>::Verdict
  AlphaShape<dim>::judge(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                         const Walls<dim> &walls, const OldDomain<dim> &old_domain,
                         const double time_step) const
  {
    const auto corners = corners_of<dim>(simplex, cloud.position);
    if (!advected)
    {
      if (!accepts_plain(simplex, cloud, walls))
        return Verdict::no_fluid;
      return old_domain.contains(simplex, centroid<dim>(corners)) ? Verdict::stays_fluid
                                                                  : Verdict::becomes_fluid;
    }

    const double h = mean_spacing<dim>(simplex, cloud);
    if (crosses_wall<dim>(simplex, corners, cloud, walls, true))
      return Verdict::no_fluid;
    if (old_domain.contains(simplex, centroid<dim>(corners)))
      return Verdict::stays_fluid;

    const bool has_isolated = std::any_of(simplex.begin(), simplex.end(), [&](const unsigned int particle) {
      return cloud.kind[particle] == ParticleKind::fluid && !old_domain.was_wet(particle);
    });
    if (has_isolated || crosses_wall<dim>(simplex, corners, cloud, walls))
      return Verdict::no_fluid;
    if (dim == 3 && old_domain.leads_into_hollow(simplex, centroid<dim>(corners), cloud))
      return Verdict::stays_fluid;
    const bool touches_wall = std::any_of(simplex.begin(), simplex.end(), [&](const unsigned int particle) {
      return cloud.kind[particle] != ParticleKind::fluid;
    });
    const double size       = extent<dim>(corners);
    const double shrinking  = shrinkage<dim>(simplex, corners, cloud);
    if (!touches_wall &&
        (size >= alpha * h || (old_domain.joins(simplex) && circumradius<dim>(corners) >= hollow_radius * h)))
      return Verdict::no_fluid;

    const double gap = gap_in<dim>(simplex, corners, cloud);
    if ((shrinking * time_step > resting_shrinkage && gap < closing_gap * h) ||
        shrinking * time_step > closing_shrinkage ||
        (size < alpha * h && gap < spreading_gap * h &&
         spreads_along_wall(simplex, corners, cloud, old_domain)))
      return Verdict::becomes_fluid;
    return Verdict::no_fluid;
  }



  template <int dim>
  bool AlphaShape<dim>::spreads_along_wall(const Simplex<dim> &simplex, const SimplexCorners<dim> &corners,
                                           const ParticleCloud<dim> &cloud,
                                           const OldDomain<dim> &old_domain) const
  {
    // Fluid in contact is a wet place of the wall; where there is no other, it lies round a hollow corner.
    const auto is_fluid = [&](const unsigned int c) { return cloud.kind[simplex[c]] == ParticleKind::fluid; };
    const auto is_wet   = [&](const unsigned int c) {
      return is_fluid(c) ? cloud.in_contact(simplex[c]) : old_domain.was_wet(simplex[c]);
    };
    bool any_wet = false, any_free = false;
    for (unsigned int c = 0; c <= dim; ++c)
    {
      any_wet  = any_wet || is_wet(c);
      any_free = any_free || (is_fluid(c) && !is_wet(c));
    }
    for (unsigned int dry = 0; dry <= dim; ++dry)
    {
      if (is_fluid(dry) || is_wet(dry))
        continue;
      bool reached = !any_free;
      for (unsigned int fluid = 0; fluid <= dim && !reached; ++fluid)
        if (is_fluid(fluid) && !is_wet(fluid))
        {
          reached = true;
          for (unsigned int wet = 0; wet <= dim; ++wet)
            if (is_wet(wet) &&
                corners[fluid].distance_square(corners[wet]) <= corners[fluid].distance_square(corners[dry]))
              reached = false;
        }
      if (!reached)
        return false;
    }
    return any_wet;
  }



  template class AlphaShape<2>;
  template class AlphaShape<3>;
} // namespace Lahar
