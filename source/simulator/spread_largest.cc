// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/spread_largest.h>

#include <algorithm>

namespace Lahar
{
  void spread_largest(boost::disjoint_sets_with_storage<> &parts, const NodePartition &partition,
                      std::vector<double> &values)
  {
    for (bool any_news = true; any_news;)
    {
      std::vector<double> largest(values.size(), -1.);
      for (unsigned int i = 0; i < values.size(); ++i)
      {
        double &of_part = largest[parts.find_set(i)];
        of_part         = std::max(of_part, values[i]);
      }
      bool own_news = false;
      for (unsigned int i = 0; i < values.size(); ++i)
        if (const double of_part = largest[parts.find_set(i)]; of_part > values[i])
        {
          values[i] = of_part;
          own_news  = own_news || i < partition.n_own();
        }
      any_news = Utilities::MPI::max(own_news ? 1U : 0U, partition.communicator()) == 1U;
      if (any_news)
        partition.update(values);
    }
  }
} // namespace Lahar
