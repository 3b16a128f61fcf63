// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/cell_table.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  typename CellTable<dim>::Key CellTable<dim>::key(const Simplex<dim> &cell, const ParticleCloud<dim> &cloud)
  {
    Key result;
    for (unsigned int c = 0; c <= dim; ++c)
      result[c] = cloud.number[cell[c]];
    std::sort(result.begin(), result.end());
    return result;
  }



  template <int dim>
  void CellTable<dim>::sort()
  {
    std::sort(entries.begin(), entries.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
  }



  template <int dim>
  const typename CellTable<dim>::Value *CellTable<dim>::find(const Key &key) const
  {
    const auto place = std::lower_bound(entries.begin(), entries.end(), key,
                                        [](const auto &entry, const Key &k) { return entry.first < k; });
    return place != entries.end() && place->first == key ? &place->second : nullptr;
  }



  template <int dim>
  void CellTable<dim>::append(const Key &key, const Value &value, std::vector<std::uint64_t> &keys,
                              std::vector<double> &values)
  {
    keys.insert(keys.end(), key.begin(), key.end());
    for (unsigned int i = 0; i < Value::n_independent_components; ++i)
      values.push_back(value.access_raw_entry(i));
  }



  template <int dim>
  void CellTable<dim>::add_all(const std::vector<std::uint64_t> &keys, const std::vector<double> &values)
  {
    constexpr unsigned int n = Value::n_independent_components;
    AssertDimension(keys.size() * n, values.size() * (dim + 1));
    for (unsigned int e = 0; e < keys.size() / (dim + 1); ++e)
    {
      Key key;
      Value value;
      std::copy_n(keys.begin() + e * (dim + 1), dim + 1, key.begin());
      for (unsigned int i = 0; i < n; ++i)
        value.access_raw_entry(i) = values[e * n + i];
      add(key, value);
    }
  }



  template class CellTable<2>;
  template class CellTable<3>;
} // namespace Lahar
