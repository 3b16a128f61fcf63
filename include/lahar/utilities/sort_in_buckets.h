// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_sort_in_buckets_h
#define lahar_utilities_sort_in_buckets_h

#include <algorithm>
#include <numeric>
#include <vector>

namespace Lahar
{
  /**
   * Sort @p items as std::sort() does, where their order is first of all that of @p key, a number below @p n_keys: into
   * one bucket a key, and then each bucket. With many small buckets that takes a third of the time.
   */
  template <typename T, typename Key>
  void sort_in_buckets(std::vector<T> &items, const unsigned int n_keys, const Key &key)
  {
    std::vector<unsigned int> begin(n_keys + 1, 0);
    for (const T &item : items)
      ++begin[key(item) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<unsigned int> end(begin.begin(), begin.end() - 1);
    std::vector<T> sorted(items.size());
    for (const T &item : items)
      sorted[end[key(item)]++] = item;
    for (unsigned int k = 0; k < n_keys; ++k)
      std::sort(sorted.begin() + begin[k], sorted.begin() + end[k]);
    items.swap(sorted);
  }
} // namespace Lahar

#endif
