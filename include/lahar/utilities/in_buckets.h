// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_in_buckets_h
#define lahar_utilities_in_buckets_h

#include <numeric>
#include <vector>

namespace Lahar
{
  /**
   * Numbers by their keys, with many small buckets faster and with less memory than pairs can be sorted.
   *
   * @param n_keys keys are smaller than this.
   * @param for_each calls its argument with each key and number, twice in the same order.
   * @param action is called for each key in order with the key and a vector of its numbers, which it may change.
   */
  template <typename ForEach, typename Action>
  void in_buckets(const unsigned int n_keys, const ForEach &for_each, const Action &action)
  {
    std::vector<unsigned int> end(n_keys + 1, 0);
    for_each([&end](const unsigned int key, const unsigned int) { ++end[key + 1]; });
    std::partial_sum(end.begin(), end.end(),
                     end.begin()); // the begin of each bucket, which filling moves to its end
    std::vector<unsigned int> numbers(end.back()), bucket;
    for_each([&](const unsigned int key, const unsigned int number) { numbers[end[key]++] = number; });
    for (unsigned int k = 0, begin = 0; k < n_keys; begin = end[k++])
    {
      bucket.assign(numbers.begin() + begin, numbers.begin() + end[k]);
      action(k, bucket);
    }
  }
} // namespace Lahar

#endif
