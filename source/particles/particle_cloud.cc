// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <lahar/particles/fluid_set.h>
#include <lahar/particles/particle_cloud.h>

#include <algorithm>
#include <numeric>

namespace Lahar
{
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

    /// Of the values those of @p order, in this order.
    template <typename T>
    void select(std::vector<T> &values, const std::vector<unsigned int> &order)
    {
      std::vector<T> selected;
      selected.reserve(order.size());
      for (const unsigned int i : order)
        selected.push_back(values[i]);
      values.swap(selected);
    }
  } // namespace



  template <int dim>
  unsigned int ParticleCloud<dim>::append(const Point<dim> &new_position, const ParticleKind new_kind,
                                          const double new_spacing, const unsigned int new_part)
  {
    position.push_back(new_position);
    velocity.emplace_back();
    acceleration.emplace_back();
    algorithmic_acceleration.emplace_back();
    pressure.push_back(0.);
    pressure_rate.push_back(0.);
    owed_volume.push_back(0.);
    reaction.emplace_back();
    friction.emplace_back();
    for (std::vector<double> &of_fluid : structure)
      of_fluid.push_back(no_structure);
    kind.push_back(new_kind);
    part.push_back(new_part);
    spacing.push_back(new_spacing);
    contact_facets.emplace_back();
    contact_facets.back().fill(no_facet);
    number.push_back(next_number++);
    owner.push_back(rank);
    return size() - 1;
  }



  template <int dim>
  unsigned int ParticleCloud<dim>::append_midpoint(const unsigned int a, const unsigned int b)
  {
    const unsigned int i        = append(position[a] + 0.5 * (position[b] - position[a]), ParticleKind::fluid,
                                         0.5 * (spacing[a] + spacing[b]));
    const FluidSet of_a         = kind[a] == ParticleKind::fluid ? part[a] : 0U,
                   of_b         = kind[b] == ParticleKind::fluid ? part[b] : 0U;
    part[i]                     = (of_a & of_b) != 0U ? of_a & of_b : of_a | of_b;
    velocity[i]                 = 0.5 * (velocity[a] + velocity[b]);
    acceleration[i]             = 0.5 * (acceleration[a] + acceleration[b]);
    algorithmic_acceleration[i] = 0.5 * (algorithmic_acceleration[a] + algorithmic_acceleration[b]);
    pressure[i]                 = 0.5 * (pressure[a] + pressure[b]);
    friction[i]                 = 0.5 * (friction[a] + friction[b]);
    pressure_rate[i]            = 0.5 * (pressure_rate[a] + pressure_rate[b]);
    owner[i]                    = owner[a];
    set_mean_structure(i, a, b);

    unsigned int n_shared = 0;
    for (const int facet : contact_facets[a])
      if (facet != no_facet &&
          std::find(contact_facets[b].begin(), contact_facets[b].end(), facet) != contact_facets[b].end())
        contact_facets[i][n_shared++] = facet;
    return i;
  }



  template <int dim>
  void ParticleCloud<dim>::set_mean_structure(const unsigned int particle, const unsigned int a,
                                              const unsigned int b)
  {
    for (std::vector<double> &of_fluid : structure)
      of_fluid[particle] = of_fluid[a] < 0.   ? of_fluid[b]
                           : of_fluid[b] < 0. ? of_fluid[a]
                                              : 0.5 * (of_fluid[a] + of_fluid[b]);
  }



  template <int dim>
  std::vector<unsigned int> ParticleCloud<dim>::remove(const std::vector<bool> &removed)
  {
    std::vector<unsigned int> new_index(size(), numbers::invalid_unsigned_int);
    unsigned int n = 0;
    for (std::size_t i = 0; i < size(); ++i)
      if (!removed[i])
        new_index[i] = n++;

    for_each_array([&removed](auto &values) { compress(values, removed); });
    return new_index;
  }



  template <int dim>
  void ParticleCloud<dim>::append_record(const unsigned int i, std::vector<double> &records) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      records.insert(records.end(),
                     {position[i][d], velocity[i][d], acceleration[i][d], algorithmic_acceleration[i][d],
                      reaction[i][d], friction[i][d], static_cast<double>(contact_facets[i][d])});
    for (const std::vector<double> &of_fluid : structure)
      records.push_back(of_fluid[i]);
    records.insert(records.end(), {pressure[i], pressure_rate[i], owed_volume[i], spacing[i],
                                   static_cast<double>(kind[i]), static_cast<double>(part[i]),
                                   static_cast<double>(number[i]), static_cast<double>(owner[i])});
  }



  template <int dim>
  void ParticleCloud<dim>::set(const unsigned int i, const double *value)
  {
    for (unsigned int d = 0; d < dim; ++d)
    {
      position[i][d]                 = *value++;
      velocity[i][d]                 = *value++;
      acceleration[i][d]             = *value++;
      algorithmic_acceleration[i][d] = *value++;
      reaction[i][d]                 = *value++;
      friction[i][d]                 = *value++;
      contact_facets[i][d]           = static_cast<int>(*value++);
    }
    for (std::vector<double> &of_fluid : structure)
      of_fluid[i] = *value++;
    pressure[i]      = *value++;
    pressure_rate[i] = *value++;
    owed_volume[i]   = *value++;
    spacing[i]       = *value++;
    kind[i]          = static_cast<ParticleKind>(*value++);
    part[i]          = static_cast<unsigned int>(*value++);
    number[i]        = static_cast<std::uint64_t>(*value++);
    owner[i]         = static_cast<unsigned int>(*value++);
  }



  template <int dim>
  void ParticleCloud<dim>::add(std::vector<std::vector<double>> records)
  {
    const unsigned int size_of_record = record_size();
    std::size_t i = size(), n_all = i;
    for (const std::vector<double> &some : records)
    {
      AssertThrow(some.size() % size_of_record == 0, ExcMessage("Records of particles are not whole."));
      n_all += some.size() / size_of_record;
    }
    for_each_array([n_all](auto &values) { values.resize(n_all); });
    for (std::vector<double> &some : records)
    {
      for (std::size_t begin = 0; begin < some.size(); begin += size_of_record)
        set(i++, &some[begin]);
      std::vector<double>().swap(some);
    }

    std::vector<unsigned int> order(n_all);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](const unsigned int a, const unsigned int b) { return number[a] < number[b]; });
    order.erase(std::unique(order.begin(), order.end(),
                            [&](const unsigned int a, const unsigned int b) {
                              return number[a] == number[b];
                            }),
                order.end());
    for_each_array([&order](auto &values) { select(values, order); }); // one copy at a time
  }



  template <int dim>
  void ParticleCloud<dim>::reinit(const std::vector<double> &records)
  {
    for_each_array([](auto &values) { values.clear(); });
    add({records});
  }



  template <int dim>
  unsigned int ParticleCloud<dim>::find(const std::uint64_t particle_number) const
  {
    const auto place = std::lower_bound(number.begin(), number.end(), particle_number);
    return place != number.end() && *place == particle_number ? place - number.begin()
                                                              : numbers::invalid_unsigned_int;
  }



  template <int dim>
  unsigned int ParticleCloud<dim>::owner_of(const std::array<unsigned int, dim + 1> &cell) const
  {
    unsigned int first = numbers::invalid_unsigned_int;
    for (const unsigned int i : cell)
      if (kind[i] == ParticleKind::fluid)
        first = std::min(first, i);
    return owner[first == numbers::invalid_unsigned_int ? *std::min_element(cell.begin(), cell.end())
                                                        : first];
  }



  template <int dim>
  unsigned int ParticleCloud<dim>::n_particles(const ParticleKind wanted) const
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < size(); ++i)
      n += (kind[i] == wanted && is_own(i));
    return n;
  }



  template <int dim>
  bool ParticleCloud<dim>::in_contact(const unsigned int particle) const
  {
    return contact_facets[particle][0] != no_facet;
  }



  template class ParticleCloud<2>;
  template class ParticleCloud<3>;
} // namespace Lahar
