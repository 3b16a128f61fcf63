#include <deal.II/base/numbers.h>

#include <lahar/particles/particle_cloud.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  unsigned int ParticleCloud<dim>::append(const Point<dim> &new_position, const ParticleKind new_kind,
                                          const double new_spacing)
  {
    position.push_back(new_position);
    velocity.emplace_back();
    acceleration.emplace_back();
    pressure.push_back(0.);
    pressure_rate.push_back(0.);
    kind.push_back(new_kind);
    spacing.push_back(new_spacing);
    slip_facets.emplace_back();
    slip_facets.back().fill(no_facet);
    return size() - 1;
  }



  template <int dim>
  unsigned int ParticleCloud<dim>::append_midpoint(const unsigned int a, const unsigned int b)
  {
    const unsigned int i = append(position[a] + 0.5 * (position[b] - position[a]), ParticleKind::fluid,
                                  0.5 * (spacing[a] + spacing[b]));
    velocity[i]          = 0.5 * (velocity[a] + velocity[b]);
    acceleration[i]      = 0.5 * (acceleration[a] + acceleration[b]);
    pressure[i]          = 0.5 * (pressure[a] + pressure[b]);
    pressure_rate[i]     = 0.5 * (pressure_rate[a] + pressure_rate[b]);

    unsigned int n_shared = 0;
    for (const int facet : slip_facets[a])
      if (facet != no_facet &&
          std::find(slip_facets[b].begin(), slip_facets[b].end(), facet) != slip_facets[b].end())
        slip_facets[i][n_shared++] = facet;
    return i;
  }



  namespace
  {
    template <typename T>
    void compress(std::vector<T> &values, const std::vector<bool> &removed)
    {
      std::size_t n = 0;
      for (std::size_t i = 0; i < values.size(); ++i)
        if (!removed[i])
          values[n++] = values[i];
      values.resize(n);
    }
  } // namespace



  template <int dim>
  std::vector<unsigned int> ParticleCloud<dim>::remove(const std::vector<bool> &removed)
  {
    std::vector<unsigned int> new_index(size(), numbers::invalid_unsigned_int);
    unsigned int n = 0;
    for (std::size_t i = 0; i < size(); ++i)
      if (!removed[i])
        new_index[i] = n++;

    compress(position, removed);
    compress(velocity, removed);
    compress(acceleration, removed);
    compress(pressure, removed);
    compress(pressure_rate, removed);
    compress(kind, removed);
    compress(spacing, removed);
    compress(slip_facets, removed);
    return new_index;
  }



  template <int dim>
  unsigned int ParticleCloud<dim>::n_particles(const ParticleKind wanted) const
  {
    return std::count(kind.begin(), kind.end(), wanted);
  }



  template <int dim>
  bool ParticleCloud<dim>::on_slip_wall(const unsigned int particle) const
  {
    return slip_facets[particle][0] != no_facet;
  }



  template class ParticleCloud<2>;
  template class ParticleCloud<3>;
} // namespace Lahar
