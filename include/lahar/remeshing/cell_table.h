// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_cell_table_h
#define lahar_remeshing_cell_table_h

#include <deal.II/base/symmetric_tensor.h>

#include <lahar/geometry/delaunay.h>
#include <lahar/particles/particle_cloud.h>

#include <utility>
#include <vector>

namespace Lahar
{
  /// Symmetric tensors by cell, where a cell is known by the numbers of its particles, whatever their indices are.
  template <int dim>
  class CellTable
  {
  public:
    using Key   = std::array<std::uint64_t, dim + 1>; ///< numbers of the particles, ascending
    using Value = SymmetricTensor<2, dim>;

    static Key key(const Simplex<dim> &cell, const ParticleCloud<dim> &cloud);

    void clear()
    {
      entries.clear();
    }

    bool empty() const
    {
      return entries.empty();
    }

    /// Add entries, no key twice. After the last one call sort().
    void add(const Key &key, const Value &value)
    {
      entries.emplace_back(key, value);
    }

    void sort();

    /// The value of a cell, none if it is not in the table.
    const Value *find(const Key &key) const;

    /// An entry as numbers, to send it: key and independent components.
    static void append(const Key &key, const Value &value, std::vector<std::uint64_t> &keys,
                       std::vector<double> &values);

    /// Add what append() made.
    void add_all(const std::vector<std::uint64_t> &keys, const std::vector<double> &values);

  private:
    std::vector<std::pair<Key, Value>> entries;
  };
} // namespace Lahar

#endif
