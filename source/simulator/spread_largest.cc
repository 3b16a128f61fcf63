// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/spread_largest.h>

#include <algorithm>

namespace Lahar
{
  void spread_largest(boost::disjoint_sets_with_storage<> &parts, const NodePartition &partition,
                      IndexVector<LocalNode, double> &values)
  {
    for (bool any_news = true; any_news;)
    {
      std::vector<double> largest(values.size(), -1.);
      for (const LocalNode i : values.indices())
      {
        double &of_part = largest[parts.find_set(i.value())];
        of_part         = std::max(of_part, values[i]);
      }
      bool own_news = false;
      for (const LocalNode i : values.indices())
        if (const double of_part = largest[parts.find_set(i.value())]; of_part > values[i])
        {
          values[i] = of_part;
          own_news  = own_news || partition.is_own(i);
        }
      any_news = Utilities::MPI::max(own_news ? 1U : 0U, partition.communicator()) == 1U;
      if (any_news)
        partition.update(values);
    }
  }
} // namespace Lahar
