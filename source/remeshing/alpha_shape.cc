#include <lahar/remeshing/alpha_shape.h>
#include <lahar/remeshing/simplex_geometry.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// Simplices below this fraction of h^dim are taken for flat.
    constexpr double flat_volume = 1e-6;

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

    template <int dim>
    bool crosses_wall(const SimplexCorners<dim> &corners, const double h, const Walls<dim> &walls)
    {
      for (unsigned int a = 0; a <= dim; ++a)
        for (unsigned int b = a + 1; b <= dim; ++b)
          if (!walls.crossed(corners[a], corners[b], 1e-3 * h).empty())
            return true;
      return false;
    }
  } // namespace



  template <int dim>
  void AlphaShape<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Alpha shape");
    prm.declare_entry(
      "Rule", "advected", Patterns::Anything(),
      "Which simplices are fluid: 'plain', all with a circumradius below Alpha times the spacing, or "
      "'advected', which remembers the fluid's domain of the step before and so keeps its volume.");
    prm.declare_entry("Alpha", dim == 2 ? "1.25" : "1.35", Patterns::Double(),
                      "Largest circumradius of a fluid simplex over the particles' spacing, 1 or above.");
    prm.declare_entry("Alpha inside", "2.5", Patterns::Double(),
                      "Rule 'advected': the same for simplices inside the old domain, Alpha or above.");
    prm.declare_entry(
      "Alpha outside", "0.8", Patterns::Double(),
      "Rule 'advected': the same for simplices of fluid particles outside the old domain, 0.6 to Alpha.");
    prm.leave_subsection();
  }



  template <int dim>
  void AlphaShape<dim>::parse_parameters(Parameters &prm)
  {
    prm.enter_subsection("Alpha shape");
    if (prm.get("Rule") != "advected" && prm.get("Rule") != "plain")
      prm.throw_wrong_value("Rule", "plain|advected");
    advected    = prm.get("Rule") == "advected";
    alpha       = prm.get_in_range("Alpha", 1., 10.);
    alpha_keep  = prm.get_in_range("Alpha inside", alpha, 100.);
    alpha_merge = prm.get_in_range("Alpha outside", 0.6, alpha);
    prm.leave_subsection();
  }



  template <int dim>
  bool AlphaShape<dim>::accepts_plain(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                                      const Walls<dim> &walls) const
  {
    const auto corners = corners_of<dim>(simplex, cloud.position);
    const double h     = mean_spacing<dim>(simplex, cloud);
    return !is_excluded<dim>(simplex, corners, h, cloud) && circumradius<dim>(corners) < alpha * h &&
           !crosses_wall<dim>(corners, h, walls);
  }



  template <int dim>
  bool AlphaShape<dim>::accepts(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                                const Walls<dim> &walls, const OldDomain<dim> &old_domain,
                                const double time_step) const
  {
    if (!advected)
      return accepts_plain(simplex, cloud, walls);

    const auto corners = corners_of<dim>(simplex, cloud.position);
    const double h     = mean_spacing<dim>(simplex, cloud);
    if (is_excluded<dim>(simplex, corners, h, cloud))
      return false;
    const double radius = circumradius<dim>(corners);
    if (radius >= alpha_keep * h)
      return false;
    if (old_domain.contains(simplex, centroid<dim>(corners)))
      return true;

    const bool touches_wall = std::any_of(simplex.begin(), simplex.end(), [&](const unsigned int particle) {
      return cloud.kind[particle] != ParticleKind::fluid;
    });
    return radius < (touches_wall ? alpha : alpha_merge) * h && !crosses_wall<dim>(corners, h, walls) &&
           (!touches_wall || is_arriving(simplex, cloud, old_domain, h, time_step));
  }



  template <int dim>
  bool AlphaShape<dim>::is_arriving(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud,
                                    const OldDomain<dim> &old_domain, const double h,
                                    const double time_step) const
  {
    const auto corners = corners_of<dim>(simplex, cloud.position);

    bool any_wet = false, any_dry = false;
    for (const unsigned int particle : simplex)
      if (cloud.kind[particle] != ParticleKind::fluid)
        (old_domain.was_wet(particle) ? any_wet : any_dry) = true;

    if (any_wet && any_dry)
    {
      for (unsigned int dry = 0; dry <= dim; ++dry)
        if (cloud.kind[simplex[dry]] != ParticleKind::fluid && !old_domain.was_wet(simplex[dry]))
        {
          bool reached = false;
          for (unsigned int fluid = 0; fluid <= dim && !reached; ++fluid)
            if (cloud.kind[simplex[fluid]] == ParticleKind::fluid)
            {
              double to_wet = std::numeric_limits<double>::max();
              for (unsigned int wet = 0; wet <= dim; ++wet)
                if (cloud.kind[simplex[wet]] != ParticleKind::fluid && old_domain.was_wet(simplex[wet]))
                  to_wet = std::min(to_wet, corners[fluid].distance_square(corners[wet]));
              reached = corners[fluid].distance_square(corners[dry]) < to_wet;
            }
          if (!reached)
            return false;
        }
      return true;
    }

    if (any_wet)
      return true;

    // The rate at which the simplex shrinks, −V'/V = −div v, and the smallest distance of its fluid corners from the
    // opposite faces, the reciprocal of the shape gradient.
    const auto gradients = shape_gradients<dim>(corners);
    double shrinkage = 0., distance = std::numeric_limits<double>::max();
    for (unsigned int c = 0; c <= dim; ++c)
    {
      shrinkage -= cloud.velocity[simplex[c]] * gradients[c];
      distance = std::min(distance, 1. / gradients[c].norm());
    }
    return shrinkage > 0. && (distance < 0.5 * h || 2. * shrinkage * time_step > 1.);
  }



  template class AlphaShape<2>;
  template class AlphaShape<3>;
} // namespace Lahar
